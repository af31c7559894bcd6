#pragma once

#include <map>
#include <string>

#include "engine/config/table.h"

namespace gurney::equipment {

/// Names that must differ from each other, and from "floor", which events use.
class UniqueNames {
 public:
  bool has(const std::string& name) const { return taken_.contains(name); }

  /// Takes `name` for the table; a name that is empty, "floor" or taken is noted at its key `name`.
  void take(config::Table& table, const std::string& name);

  /// The key `name`, or `kind 2` where it is absent, and takes it.
  std::string read(config::Table& table, const std::string& kind, std::size_t index);

 private:
  std::map<std::string, std::string> taken_;  ///< and where
};

}  // namespace gurney::equipment
