#pragma once

#include <set>
#include <string>
#include <vector>

namespace gurney::config {

/// A place in a file, counted from 1.
struct Place {
  int line = 1;
  int column = 1;
};

/// One value of a configuration file with its place; the same tree whatever the file's format.
struct Node {
  enum class Kind { kBoolean, kInteger, kNumber, kText, kArray, kTable, kOther };

  Kind kind = Kind::kTable;
  Place place;
  bool boolean = false;
  long long integer = 0;
  double number = 0;           ///< of kInteger too
  std::string text;            ///< of kText; of kOther as written
  std::vector<Node> elements;  ///< of kArray and kTable

  std::string key;  ///< of an element of a table
  Place key_place;

  mutable bool read = false;            ///< someone asked for this element
  mutable std::set<std::string> asked;  ///< of kTable: every key someone asked for

  bool is_number() const { return kind == Kind::kInteger || kind == Kind::kNumber; }

  /// The element of a table with this key, or nullptr.
  const Node* find(const std::string& wanted) const;
};

/// The value as a message shows it: `-3`, `"text"`, `[1, 2, 3]`, `a table`.
std::string describe(const Node& node);

}  // namespace gurney::config
