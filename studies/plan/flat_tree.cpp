#include "studies/plan/flat_tree.h"

#include <fmt/format.h>

#include <algorithm>

namespace gurney::study {
namespace {

using config::Node;

bool is_array_of_tables(const Node& node) {
  return node.kind == Node::Kind::kArray && !node.elements.empty() &&
         std::ranges::all_of(node.elements,
                             [](const Node& each) { return each.kind == Node::Kind::kTable; });
}

}  // namespace

void flatten(const Node& node, const std::string& path,
             std::map<std::string, std::string>& entries) {
  if (node.kind == Node::Kind::kTable) {
    for (const Node& each : node.elements)
      flatten(each, path.empty() ? each.key : path + "." + each.key, entries);
  } else if (is_array_of_tables(node)) {
    for (std::size_t i = 0; i < node.elements.size(); ++i) {
      const Node* name = node.elements[i].find("name");
      flatten(node.elements[i],
              fmt::format("{}[{}]", path, name ? name->text : std::to_string(i + 1)), entries);
    }
  } else {
    entries[path] = config::describe(node);
  }
}

}  // namespace gurney::study
