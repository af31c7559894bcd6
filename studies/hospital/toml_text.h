#pragma once

#include <filesystem>
#include <string>

#include "engine/config/node.h"

namespace gurney::study {

/// A value as TOML on one line; texts of the keys `file` and `suite` become paths that hold from
/// anywhere.
/// @param folder  that they are relative to
std::string inline_toml(const config::Node& value, const std::filesystem::path& folder);

/// The element `key` of a table, or of that table of an array of tables whose `name` is `name`.
std::string inline_toml(const config::Node& parent, const std::string& key, const std::string& name,
                        const std::filesystem::path& folder);

}  // namespace gurney::study
