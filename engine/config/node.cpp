#include "engine/config/node.h"

#include <fmt/format.h>

#include "engine/base/printable.h"

namespace gurney::config {

const Node* Node::find(const std::string& wanted) const {
  for (const Node& element : elements)
    if (element.key == wanted) return &element;
  return nullptr;
}

std::string describe(const Node& node) {
  constexpr std::size_t kShown = 8;
  switch (node.kind) {
    case Node::Kind::kBoolean:
      return node.boolean ? "true" : "false";
    case Node::Kind::kInteger:
      return std::to_string(node.integer);
    case Node::Kind::kNumber:
      return fmt::format("{}", node.number);
    case Node::Kind::kText:
      return '"' + printable(node.text) + '"';
    case Node::Kind::kOther:
      return node.text;
    case Node::Kind::kTable:
      return "a table";
    case Node::Kind::kArray:
      break;
  }
  std::string list;
  for (std::size_t i = 0; i < node.elements.size() && i < kShown; ++i)
    list += (i == 0 ? "" : ", ") + describe(node.elements[i]);
  return '[' + list + (node.elements.size() > kShown ? ", ...]" : "]");
}

}  // namespace gurney::config
