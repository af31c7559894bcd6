#include "equipment/catalogue/unique_names.h"

#include <fmt/format.h>

namespace gurney::equipment {

void UniqueNames::take(config::Table& table, const std::string& name) {
  const std::string stated = table.has("name") ? fmt::format(" = \"{}\"", name)
                                               : fmt::format(": not given, so it is '{}'", name);
  if (name.empty() || name == "floor")
    table.note("name", stated + ": must not be empty or 'floor'");
  else if (const auto [known, is_new] = taken_.emplace(name, table.where("name")); !is_new)
    table.note("name", stated + ": must differ from the name at " + known->second);
}

std::string UniqueNames::read(config::Table& table, const std::string& kind, std::size_t index) {
  const std::string name = table.text("name", fmt::format("{} {}", kind, index + 1));
  take(table, name);
  return name;
}

}  // namespace gurney::equipment
