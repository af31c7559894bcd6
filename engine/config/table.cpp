#include "engine/config/table.h"

#include <fmt/format.h>

#include <utility>

#include "engine/base/printable.h"
#include "engine/config/nearest_name.h"
#include "engine/config/unit_limit.h"

namespace gurney::config {
namespace {

void note_control_character(Document& document, const Node& node, const std::string& name) {
  if (node.kind == Node::Kind::kText && find_control_character(node.text) != std::string::npos)
    document.note(node.place,
                  name + " = " + describe(node) + ": must be text without control characters");
}

void mark_read(const Node& node) {
  for (const Node& element : node.elements) {
    element.read = true;
    mark_read(element);
  }
}

}  // namespace

Table::Table(Document& document, const Node& node, std::string path)
    : document_(&document), node_(&node), path_(std::move(path)) {}

double Table::number(const std::string& key, const Range& range, std::optional<double> fallback) {
  double value = fallback.value_or(0);
  if (const Node* node = required(key, fallback.has_value(), range.text()))
    read_number(*node, key, range, value);
  return value;
}

int Table::integer(const std::string& key, int low, int high, std::optional<int> fallback) {
  const std::string allowed = fmt::format("a whole number in {}..{}", low, high);
  const Node* node = required(key, fallback.has_value(), allowed);
  if (node == nullptr) return fallback.value_or(low);
  if (node->kind == Node::Kind::kInteger && node->integer >= low && node->integer <= high)
    return static_cast<int>(node->integer);
  note_value(*node, key, allowed);
  return fallback.value_or(low);
}

bool Table::boolean(const std::string& key, std::optional<bool> fallback) {
  const Node* node = required(key, fallback.has_value(), "true or false");
  if (node == nullptr) return fallback.value_or(false);
  if (node->kind != Node::Kind::kBoolean) note_value(*node, key, "true or false");
  return node->boolean;
}

std::string Table::text(const std::string& key, std::optional<std::string> fallback) {
  const Node* node = required(key, fallback.has_value(), "text in quotes");
  if (node == nullptr) return fallback.value_or("");
  if (node->kind != Node::Kind::kText) note_value(*node, key, "text in quotes");
  note_control_character(*document_, *node, name_of(key));
  return node->text;
}

std::size_t Table::choice(const std::string& key, const std::vector<std::string>& allowed,
                          std::optional<std::size_t> fallback) {
  std::string list;
  for (const std::string& name : allowed) list += (list.empty() ? "" : ", ") + name;
  const Node* node = required(key, fallback.has_value(),
                              allowed.size() == 1 ? '"' + list + '"' : "one of " + list);
  if (node == nullptr) return fallback.value_or(0);
  for (std::size_t i = 0; i < allowed.size(); ++i)
    if (node->kind == Node::Kind::kText && node->text == allowed[i]) return i;
  constexpr std::size_t kMany = 12;  // names that make more than a line
  const std::string near = allowed.size() > 1 ? near_name(node->text, allowed) : "";
  note_value(*node, key,
             allowed.size() == 1                       ? '"' + list + '"'
             : near.empty() || allowed.size() <= kMany ? "one of " + list + near
                                                       : "a known name" + near);
  return fallback.value_or(0);
}

std::vector<double> Table::numbers(const std::string& key, const Range& range,
                                   std::optional<std::size_t> size,
                                   std::optional<std::vector<double>> fallback) {
  std::vector<double> values = fallback.value_or(std::vector<double>(size.value_or(0)));
  const std::string allowed =
      size ? fmt::format("an array of {} numbers", *size) : "an array of numbers";
  const Node* node = required(key, fallback.has_value(), allowed);
  if (node == nullptr) return values;
  if (node->kind != Node::Kind::kArray || (size && node->elements.size() != *size)) {
    note_value(*node, key, allowed);
    return values;
  }
  values.assign(node->elements.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i)
    read_number(node->elements[i], fmt::format("{}[{}]", key, i), range, values[i]);
  return values;
}

std::vector<bool> Table::booleans(const std::string& key, std::size_t size) {
  std::vector<bool> values(size);
  const std::string allowed = fmt::format("an array of {} times true or false", size);
  const Node* node = required(key, false, allowed);
  if (node == nullptr) return values;
  bool right = node->kind == Node::Kind::kArray && node->elements.size() == size;
  for (std::size_t i = 0; right && i < size; ++i) {
    right = node->elements[i].kind == Node::Kind::kBoolean;
    values[i] = node->elements[i].boolean;
  }
  if (!right) note_value(*node, key, allowed);
  return values;
}

std::vector<std::string> Table::texts(const std::string& key, bool may_be_empty) {
  const Node* node = find(key);
  if (node == nullptr) return {};
  if (node->kind == Node::Kind::kText) return {text(key)};
  std::vector<std::string> values;
  bool right = node->kind == Node::Kind::kArray && (may_be_empty || !node->elements.empty());
  for (std::size_t i = 0; right && i < node->elements.size(); ++i) {
    right = node->elements[i].kind == Node::Kind::kText;
    note_control_character(*document_, node->elements[i], fmt::format("{}[{}]", name_of(key), i));
    values.push_back(node->elements[i].text);
  }
  if (!right) note_value(*node, key, "a text or an array of texts");
  return values;
}

Vector3 Table::vector(const std::string& key, const Range& range, std::optional<Vector3> fallback) {
  std::optional<std::vector<double>> list;
  if (fallback) list = std::vector<double>(fallback->begin(), fallback->end());
  const std::vector<double> values = numbers(key, range, 3, list);
  return Vector3(values[0], values[1], values[2]);
}

std::vector<Vector3> Table::vectors(const std::string& key, const Range& range) {
  const std::string allowed = "an array of arrays of 3 numbers";
  const Node* node = required(key, false, allowed);
  if (node == nullptr) return {};
  std::vector<Vector3> list;
  bool right = node->kind == Node::Kind::kArray;
  for (std::size_t i = 0; right && i < node->elements.size(); ++i) {
    const Node& each = node->elements[i];
    each.read = true;
    right = each.kind == Node::Kind::kArray && each.elements.size() == 3;
    Vector3& vector = list.emplace_back(Vector3::Zero());
    for (int k = 0; right && k < 3; ++k)
      read_number(each.elements[static_cast<std::size_t>(k)], fmt::format("{}[{}][{}]", key, i, k),
                  range, vector[k]);
  }
  if (right) return list;
  note_value(*node, key, allowed);
  return {};
}

std::optional<Table> Table::table(const std::string& key) {
  const Node* node = find(key);
  if (node == nullptr) return {};
  if (node->kind == Node::Kind::kTable) return Table(*document_, *node, name_of(key));
  note_value(*node, key, "a table [" + name_of(key) + "]");
  return {};
}

std::vector<Table> Table::tables(const std::string& key) {
  std::vector<Table> list;
  const Node* node = find(key);
  if (node == nullptr) return list;
  bool right = node->kind == Node::Kind::kArray;
  for (std::size_t i = 0; right && i < node->elements.size(); ++i) {
    right = node->elements[i].kind == Node::Kind::kTable;
    if (right)
      list.emplace_back(*document_, node->elements[i], fmt::format("{}[{}]", name_of(key), i));
  }
  if (right) return list;
  note_value(*node, key, "an array of tables [[" + name_of(key) + "]]");
  return {};
}

void Table::set_aside(const std::string& key) {
  if (const Node* node = find(key)) mark_read(*node);
}

bool Table::is_table(const std::string& key) {
  const Node* node = find(key);
  return node != nullptr && node->kind == Node::Kind::kTable;
}

bool Table::is_array(const std::string& key) {
  const Node* node = find(key);
  return node != nullptr && node->kind == Node::Kind::kArray;
}

bool Table::is_text(const std::string& key) {
  const Node* node = find(key);
  return node != nullptr && node->kind == Node::Kind::kText;
}

std::vector<std::string> Table::keys() const {
  std::vector<std::string> keys;
  for (const Node& element : node_->elements) keys.push_back(element.key);
  return keys;
}

void Table::note(const std::string& key, const std::string& message) {
  const Node* node = node_->find(key);
  document_->note(node == nullptr ? node_->place : node->place, name_of(key) + message);
}

void Table::note_element(const std::string& key, std::size_t index, const std::string& message) {
  const Node* node = node_->find(key);
  if (node != nullptr && node->kind == Node::Kind::kTable) node = node->find("value");
  if (node == nullptr || index >= node->elements.size()) return note(key, message);
  const Node& element = node->elements[index];
  document_->note(element.place,
                  fmt::format("{}[{}] = {}{}", name_of(key), index, describe(element), message));
}

std::string Table::name_of(const std::string& key) const {
  return path_.empty() ? key : path_ + '.' + key;
}

std::string Table::where(const std::string& key) const { return spot(key).where; }

Spot Table::spot(const std::string& key) const {
  const Node* node = node_->find(key);
  const Place place = node == nullptr ? node_->place : node->place;
  return {place, document_->path(), document_->where(place), name_of(key)};
}

const Node* Table::find(const std::string& key) {
  node_->asked.insert(key);
  const Node* node = node_->find(key);
  if (node != nullptr) node->read = true;
  return node;
}

const Node* Table::required(const std::string& key, bool has_fallback, const std::string& allowed) {
  const Node* node = find(key);
  if (node == nullptr && !has_fallback) note(key, ": missing; must be " + allowed);
  return node;
}

void Table::note_value(const Node& node, const std::string& key, const std::string& allowed) {
  document_->note(node.place, name_of(key) + " = " + describe(node) + ": must be " + allowed);
}

void Table::read_number(const Node& node, const std::string& key, const Range& range,
                        double& value) {
  if (!node.is_number() || !range.contains(node.number)) {
    note_value(node, key, range.text());
  } else if (const std::string allowed = beyond_unit(name_of(key), range, node.number);
             !allowed.empty()) {
    note_value(node, key, allowed);
  } else {
    value = node.number;
  }
}

}  // namespace gurney::config
