#include "engine/config/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "engine/base/diagnostics.h"
#include "engine/config/file_snapshot.h"
#include "engine/config/json_reader.h"
#include "engine/config/nearest_name.h"
#include "engine/config/table.h"
#include "engine/config/toml_reader.h"

namespace gurney::config {
namespace {

/// No TOML begins with a brace; a job that results keep has lost the name of its file.
bool is_json(const std::string& text, const std::string& path) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return path.ends_with(".json") || (first != std::string::npos && text[first] == '{');
}

std::string joined(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + '.' + key;
}

void collect_keys(const Node& node, const std::string& path, std::set<std::string>& keys) {
  for (const std::string& key : node.asked) keys.insert(joined(path, key));
  const bool array = node.kind == Node::Kind::kArray;
  for (const Node& element : node.elements)
    collect_keys(element, array ? path + "[]" : joined(path, element.key), keys);
}

}  // namespace

Document::Document(const std::string& path) : Document(FileSnapshot::bytes_of(path), path) {}

Document::Document(const std::string& text, const std::string& path) : path_(path), text_(text) {
  if (is_json(text, path)) {
    JsonTree json = read_json(text, path);
    tree_ = std::move(json.root);
    pointers_ = std::move(json.pointers);
  } else {
    tree_ = read_toml(text, path);
  }
}

Document::Document(Node tree, const Document& origin)
    : path_(origin.path_),
      text_(origin.text_),
      pointers_(origin.pointers_),
      tree_(std::move(tree)) {}

std::optional<Node> Document::take(const std::string& key) {
  const auto found = std::find_if(tree_.elements.begin(), tree_.elements.end(),
                                  [&](const Node& element) { return element.key == key; });
  if (found == tree_.elements.end()) return {};
  std::optional<Node> taken(std::move(*found));
  tree_.elements.erase(found);
  return taken;
}

Node* Document::find_table(const std::string& path) {
  Node* table = &tree_;
  std::istringstream keys(path);
  for (std::string key; std::getline(keys, key, '.');) {
    const auto found = std::ranges::find(table->elements, key, &Node::key);
    if (table->kind != Node::Kind::kTable || found == table->elements.end()) return nullptr;
    table = &*found;
  }
  return table->kind == Node::Kind::kTable ? table : nullptr;
}

std::optional<std::string> Document::rename_key(const std::string& table, const std::string& old,
                                                const std::string& now) {
  Node* const in = find_table(table);
  if (in == nullptr || in->find(now) != nullptr) return {};
  const auto found = std::ranges::find(in->elements, old, &Node::key);
  if (found == in->elements.end()) return {};
  found->key = now;
  return fmt::format("{}: {}: the key is now called {}; the old name is still read",
                     where(found->key_place), joined(table, old), now);
}

std::optional<std::string> Document::rename_text(const std::string& table, const std::string& key,
                                                 const std::string& old, const std::string& now) {
  Node* const in = find_table(table);
  if (in == nullptr) return {};
  const auto found = std::ranges::find(in->elements, key, &Node::key);
  if (found == in->elements.end() || found->kind != Node::Kind::kText || found->text != old)
    return {};
  found->text = now;
  return fmt::format("{}: {} = \"{}\": is now called \"{}\"; the old name is still read",
                     where(found->place), joined(table, key), old, now);
}

Table Document::root() { return Table(*this, tree_, ""); }

std::string Document::where(Place place) const {
  if (!pointers_.empty()) {
    const std::string& pointer = pointers_.at(static_cast<std::size_t>(place.line) - 1);
    return fmt::format("{}:{}", path_, pointer.empty() ? "/" : pointer);
  }
  return fmt::format("{}:{}:{}", path_, place.line, place.column);
}

void Document::note(Place place, const std::string& message) {
  problems_.push_back({place, message});
}

void Document::note(const Spot& spot, const std::string& message) {
  note(spot.place, spot.name + message);
}

void Document::note(const Error& error) { foreign_.push_back(error.what()); }

void Document::finish() {
  note_unread(tree_, "");
  Diagnostics errors;
  for (const auto& [place, message] : problems_)
    errors.add(place.line, place.column, where(place) + ": " + message);
  for (const std::string& text : foreign_) errors.add(text);
  errors.sort();
  errors.raise();
}

std::vector<std::string> Document::asked_keys() const {
  std::set<std::string> keys;
  collect_keys(tree_, "", keys);
  return {keys.begin(), keys.end()};
}

void Document::note_unread(const Node& node, const std::string& path) {
  for (std::size_t i = 0; i < node.elements.size(); ++i) {
    const Node& element = node.elements[i];
    const bool in_table = node.kind == Node::Kind::kTable;
    const std::string name = in_table ? joined(path, element.key) : fmt::format("{}[{}]", path, i);
    if (in_table && !element.read) {
      const std::vector<std::string> known(node.asked.begin(), node.asked.end());
      note(element.key_place, name + ": unknown key" + suggestion(element.key, known));
    } else {
      note_unread(element, name);
    }
  }
}

}  // namespace gurney::config
