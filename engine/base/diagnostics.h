#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace gurney {

/// Collects the errors of one input, so that a single Error reports all of them, a line each.
class Diagnostics {
 public:
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  /// @param kept  those after so many are only counted
  explicit Diagnostics(std::size_t kept = kAll) : kept_(kept) {}

  void add(const std::string& text) { add(kUnplaced, 0, text); }

  /// One with a place, which comes before those without one where they are sorted.
  void add(int line, int column, const std::string& text);

  /// Each line of `lines` that is not there yet, with `remark` after it.
  void add_new(const std::string& lines, const std::string& remark = "");

  void sort();  ///< by place; the order of equal places stays

  std::size_t count() const { return count_; }
  bool none() const { return count_ == 0; }

  /// @throws Error with all, if there are any.
  void raise() const;

  /// @throws Error with the first `most`, and the number of the rest between `before` and `after`.
  void raise(std::size_t most, const std::string& before, const std::string& after) const;

 private:
  static constexpr int kUnplaced = std::numeric_limits<int>::max();

  struct Entry {
    int line, column;
    std::string text, remark;
  };
  void keep(Entry entry);

  std::size_t kept_, count_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace gurney
