#include "engine/config/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "engine/config/nearest_name.h"

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

/// Whether one is a switch and the other a number: no key takes both.
bool differ_in_kind(const Node& a, const Node& b) {
  const auto is_number = [](const Node& node) {
    return node.kind == Node::Kind::kInteger || node.kind == Node::Kind::kNumber;
  };
  return (a.kind == Node::Kind::kBoolean && is_number(b)) ||
         (is_number(a) && b.kind == Node::Kind::kBoolean);
}

std::string name_of(const Node& table) {
  const Node* name = table.find("name");
  return name == nullptr ? "" : name->text;
}

void overlay_named(Node& tables, const Node& change, const std::string& array,
                   const std::string& path, Document& document) {
  std::vector<std::string> known;
  bool found = change.key == "*";
  for (const Node& table : tables.elements) {
    found = found || name_of(table) == change.key;
    if (!name_of(table).empty()) known.push_back(name_of(table));
  }
  if (!found) {
    document.note(change.key_place,
                  path + ": no [[" + array + "]] has this name" + suggestion(change.key, known));
  } else if (change.kind != Node::Kind::kTable) {
    document.note(change.place, path + " = " + describe(change) + ": must be a table");
  } else {
    for (Node& table : tables.elements)
      if (change.key == "*" || change.key == name_of(table)) overlay(table, change, path, document);
  }
}

/// `*` first, whatever the order in the file, so that a name overrides it.
void overlay_tables(Node& tables, const Node& patch, const std::string& path, Document& document) {
  for (const bool all : {true, false})
    for (const Node& change : patch.elements)
      if ((change.key == "*") == all)
        overlay_named(tables, change, patch.key, path + '.' + change.key, document);
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
      overlay_tables(*target, change, path + '.' + change.key, document);
    else {
      if (differ_in_kind(*target, change))
        document.note(
            target->place,
            fmt::format("{} = {}: must be {}, as what replaces it", target->key, describe(*target),
                        change.kind == Node::Kind::kBoolean ? "true or false" : "a number"));
      *target = change;
    }
  }
}

}  // namespace gurney::config
