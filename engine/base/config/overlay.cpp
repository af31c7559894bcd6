#include "engine/base/config/overlay.h"

#include <algorithm>
#include <vector>

#include "engine/base/config/nearest_name.h"

namespace gurney::config {
namespace {

bool is_section(const Node& node) {
  return node.kind == Node::Kind::kTable && node.find("value") == nullptr;
}

bool is_array_of_tables(const Node& node) {
  return node.kind == Node::Kind::kArray && !node.elements.empty() &&
         std::all_of(node.elements.begin(), node.elements.end(),
                     [](const Node& each) { return each.kind == Node::Kind::kTable; });
}

std::string name_of(const Node& table) {
  const Node* name = table.find("name");
  return name == nullptr ? "" : name->text;
}

void overlay_named(Node& tables, const Node& patch, const std::string& path, Document& document) {
  for (const Node& change : patch.elements) {
    const std::string change_path = path + '.' + change.key;
    bool found = false;
    std::vector<std::string> known;
    for (Node& table : tables.elements) {
      if (change.key == "*" || change.key == name_of(table)) {
        found = true;
        if (change.kind == Node::Kind::kTable) overlay(table, change, change_path, document);
      }
      if (!name_of(table).empty()) known.push_back(name_of(table));
    }
    if (!found)
      document.note(change.key_place, change_path + ": no [[" + patch.key + "]] has this name" +
                                          suggestion(change.key, known));
    else if (change.kind != Node::Kind::kTable)
      document.note(change.place, change_path + " = " + describe(change) + ": must be a table");
  }
}

}  // namespace

void overlay(Node& base, const Node& patch, const std::string& path, Document& document) {
  for (const Node& change : patch.elements) {
    const auto target = std::find_if(base.elements.begin(), base.elements.end(),
                                     [&](const Node& each) { return each.key == change.key; });
    if (target == base.elements.end())
      base.elements.push_back(change);
    else if (is_section(*target) && is_section(change))
      overlay(*target, change, path + '.' + change.key, document);
    else if (is_array_of_tables(*target) && change.kind == Node::Kind::kTable)
      overlay_named(*target, change, path + '.' + change.key, document);
    else
      *target = change;
  }
}

}  // namespace gurney::config
