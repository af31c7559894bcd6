#pragma once

#include <string>
#include <vector>

namespace gurney::equipment {

enum class DataKind { kItem, kCaster, kFloor, kRoom, kTether, kBuilding };
const char* noun_of(DataKind kind);  ///< "floor covering"

/// Where the shipped data are (data_folder.h). It holds equipment/ with a folder for each kind,
/// contacts.toml and levelness.toml, and groundmotions/buildings/.
std::string data_folder();

/// The path of a file of its folder equipment/.
/// @throws Error if the folder is missing.
std::string data_file(const std::string& name);

/// Names in the catalogue, sorted.
/// @throws Error if the folder is missing.
std::vector<std::string> catalogue_names(DataKind kind);

/// The file of an item, a caster, a floor covering, a room, a tether or a building. A name that
/// ends in `.toml` or has a slash is a path relative to the folder of `named_in`; any other is
/// looked up in the catalogue.
/// @throws Error for an unknown name, with the nearest one and the list; the caller adds the place.
std::string find_data(DataKind kind, const std::string& name, const std::string& named_in);

}  // namespace gurney::equipment
