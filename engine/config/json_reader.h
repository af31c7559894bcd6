#pragma once

#include <string>
#include <vector>

#include "engine/config/node.h"

namespace gurney::config {

/// A JSON file as the tree that the same TOML gives.
struct JsonTree {
  Node root;
  /// JSON pointers (RFC 6901), such as `/item/position_m/0`. JSON text has no places here: in every
  /// Place of the tree, `line` is the index of the value's pointer, counted from 1.
  std::vector<std::string> pointers;
};

/// @param name  of the file, for messages
/// @throws Error where the text is not JSON, or a key comes twice in one table.
JsonTree read_json(const std::string& text, const std::string& name);

}  // namespace gurney::config
