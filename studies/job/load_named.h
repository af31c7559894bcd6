#pragma once

#include <optional>
#include <string>

#include "engine/config/table.h"
#include "equipment/catalogue/catalogue.h"

namespace gurney::study {

/// Loads what `key` of a job's table names; an error in the name is noted there, errors in the
/// file after ours. Empty without the key or with an error.
template <typename Load>
auto load_named(config::Table& table, const std::string& key, equipment::DataKind kind, Load load)
    -> std::optional<decltype(load(std::string()))> {
  if (!table.has(key)) return {};
  const std::string name = table.text(key);
  if (!table.is_text(key)) return {};
  std::string file;
  try {
    file = equipment::find_data(kind, name, table.document().path());
  } catch (const Error& error) {
    table.note(key, " = \"" + name + "\": " + error.what());
    return {};
  }
  try {
    return load(file);
  } catch (const Error& error) {
    table.document().note(error);
    return {};
  }
}

}  // namespace gurney::study
