#include "studies/page/json_value.h"

#include <limits>

#include "engine/base/error.h"

namespace gurney::page {

using config::Node;

void JsonValue::refuse(const std::string& what) const {
  const std::string& pointer = tree_->pointers.at(static_cast<std::size_t>(node_->place.line) - 1);
  throw Error(file_ + ":" + (pointer.empty() ? "/" : pointer) + ": " + what);
}

const Node& JsonValue::require_kind(Node::Kind kind, const char* what) const {
  if (node_->kind != kind) refuse(std::string("must be ") + what);
  return *node_;
}

bool JsonValue::is_null() const {
  return node_->kind == Node::Kind::kOther && node_->text == "null";
}

JsonValue JsonValue::at(const std::string& key) const {
  const Node* const found = require_kind(Node::Kind::kTable, "an object").find(key);
  if (found == nullptr) refuse("lacks \"" + key + "\"");
  return {*tree_, *found, file_};
}

double JsonValue::as_number() const {
  if (is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (!node_->is_number()) refuse("must be a number");
  return node_->number;
}

double JsonValue::number(const std::string& key) const { return at(key).as_number(); }

std::vector<double> JsonValue::numbers(const std::string& key) const {
  std::vector<double> result;
  for (const JsonValue& each : at(key).elements()) result.push_back(each.as_number());
  return result;
}

std::size_t JsonValue::count(const std::string& key) const {
  const JsonValue value = at(key);
  if (value.require_kind(Node::Kind::kInteger, "a whole number").integer < 0)
    value.refuse("must not be negative");
  return static_cast<std::size_t>(value.node_->integer);
}

std::string JsonValue::text(const std::string& key) const {
  const JsonValue value = at(key);
  return value.is_null() ? "" : value.require_kind(Node::Kind::kText, "a text").text;
}

bool JsonValue::flag(const std::string& key) const {
  return at(key).require_kind(Node::Kind::kBoolean, "true or false").boolean;
}

std::vector<std::string> JsonValue::texts(const std::string& key) const {
  std::vector<std::string> result;
  for (const JsonValue& each : at(key).elements())
    result.push_back(each.require_kind(Node::Kind::kText, "a text").text);
  return result;
}

std::vector<JsonValue> JsonValue::objects(const std::string& key) const {
  const std::vector<JsonValue> result = at(key).elements();
  for (const JsonValue& each : result) each.require_kind(Node::Kind::kTable, "an object");
  return result;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members(const std::string& key) const {
  const JsonValue value = at(key);
  std::vector<std::pair<std::string, JsonValue>> result;
  for (const Node& each : value.require_kind(Node::Kind::kTable, "an object").elements)
    result.emplace_back(each.key, JsonValue(*tree_, each, file_));
  return result;
}

std::vector<JsonValue> JsonValue::elements() const {
  std::vector<JsonValue> result;
  for (const Node& each : require_kind(Node::Kind::kArray, "an array").elements)
    result.push_back({*tree_, each, file_});
  return result;
}

}  // namespace gurney::page
