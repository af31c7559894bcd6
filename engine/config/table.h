#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/vector.h"
#include "engine/config/document.h"
#include "engine/config/range.h"

namespace gurney::config {

/// A table of a Document: typed getters that note every error with its place. A getter without a
/// fallback reads a required key. Handles are cheap and live no longer than their Document.
class Table {
 public:
  Table(Document& document, const Node& node, std::string path);

  double number(const std::string& key, const Range& range, std::optional<double> fallback = {});
  int integer(const std::string& key, int low, int high, std::optional<int> fallback = {});
  bool boolean(const std::string& key, std::optional<bool> fallback = {});
  std::string text(const std::string& key, std::optional<std::string> fallback = {});

  /// One of `allowed`; its index. A near miss gets a suggestion.
  std::size_t choice(const std::string& key, const std::vector<std::string>& allowed,
                     std::optional<std::size_t> fallback = {});

  /// @param size  how many numbers are needed; any count if empty
  std::vector<double> numbers(const std::string& key, const Range& range,
                              std::optional<std::size_t> size = {},
                              std::optional<std::vector<double>> fallback = {});
  std::vector<bool> booleans(const std::string& key, std::size_t size);

  /// One text or an array of texts; empty if absent, or where the array may be empty and is.
  std::vector<std::string> texts(const std::string& key, bool may_be_empty = false);
  Vector3 vector(const std::string& key, const Range& range, std::optional<Vector3> fallback = {});

  /// An array of arrays of three numbers.
  std::vector<Vector3> vectors(const std::string& key, const Range& range);

  /// A sub-table, if it is there.
  std::optional<Table> table(const std::string& key);

  /// An array of tables `[[key]]`; empty if absent.
  std::vector<Table> tables(const std::string& key);

  bool has(const std::string& key) { return find(key) != nullptr; }

  /// Reports none of the keys of `key` as unknown: their meaning depends on something that is in error.
  void set_aside(const std::string& key);

  bool is_table(const std::string& key);
  bool is_array(const std::string& key);
  bool is_text(const std::string& key);
  std::vector<std::string> keys() const;  ///< as the file has them

  /// Notes an error at `key`, or at the table itself where the key is absent: `path.key` and then
  /// `message`, which begins with ": " or " = ".
  void note(const std::string& key, const std::string& message);

  /// Error at number `index` of an array, or of the array `value` of a quantity: `key[2] = 90`
  /// and then `message`.
  void note_element(const std::string& key, std::size_t index, const std::string& message);

  std::string name_of(const std::string& key) const;  ///< with the path before it
  std::string where(const std::string& key) const;    ///< `file:line:column` of its value
  Spot spot(const std::string& key) const;
  Document& document() { return *document_; }

 private:
  const Node* find(const std::string& key);
  const Node* required(const std::string& key, bool has_fallback, const std::string& allowed);
  void note_value(const Node& node, const std::string& key, const std::string& allowed);
  void read_number(const Node& node, const std::string& key, const Range& range, double& value);

  Document* document_;
  const Node* node_;
  std::string path_;
};

}  // namespace gurney::config
