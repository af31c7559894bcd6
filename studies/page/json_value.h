#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/config/json_reader.h"

namespace gurney::page {

/// A value of a JSON file that the program wrote. What is not as it was written is an Error
/// `file:/constants/0/value: must be a number`.
class JsonValue {
 public:
  JsonValue(const config::JsonTree& tree, std::string file)
      : JsonValue(tree, tree.root, std::move(file)) {}

  JsonValue at(const std::string& key) const;
  double number(const std::string& key) const;                ///< null: NaN
  std::size_t count(const std::string& key) const;            ///< a whole number, not negative
  std::string text(const std::string& key) const;             ///< null: empty
  bool flag(const std::string& key) const;                    ///< true or false
  std::vector<double> numbers(const std::string& key) const;  ///< null: NaN
  std::vector<std::string> texts(const std::string& key) const;
  std::vector<JsonValue> objects(const std::string& key) const;  ///< an array of them
  std::vector<std::pair<std::string, JsonValue>> members(const std::string& key) const;
  std::vector<JsonValue> elements() const;  ///< of an array

  [[noreturn]] void refuse(const std::string& what) const;  ///< with its place

 private:
  JsonValue(const config::JsonTree& tree, const config::Node& node, std::string file)
      : tree_(&tree), node_(&node), file_(std::move(file)) {}

  const config::Node& require_kind(config::Node::Kind kind, const char* what) const;
  double as_number() const;
  bool is_null() const;

  const config::JsonTree* tree_;
  const config::Node* node_;
  std::string file_;
};

}  // namespace gurney::page
