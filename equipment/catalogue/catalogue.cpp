#include "equipment/catalogue/catalogue.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/error.h"
#include "engine/config/file_snapshot.h"
#include "engine/config/nearest_name.h"
#include "equipment/catalogue/data_folder.h"

namespace gurney::equipment {
namespace {

namespace fs = std::filesystem;

struct KindNames {
  const char* folder;  ///< below data_folder()
  const char* noun;
};

KindNames names_of(DataKind kind) {
  switch (kind) {
    case DataKind::kItem:
      return {"equipment/items", "item"};
    case DataKind::kCaster:
      return {"equipment/casters", "caster"};
    case DataKind::kFloor:
      return {"equipment/floors", "floor covering"};
    case DataKind::kRoom:
      return {"equipment/rooms", "room"};
    case DataKind::kTether:
      return {"equipment/tethers", "kind of tether"};
    case DataKind::kBuilding:
      break;
  }
  return {"groundmotions/buildings", "building"};
}

fs::path folder_of(DataKind kind) { return fs::path(data_folder()) / names_of(kind).folder; }

void require_folder(const fs::path& folder) {
  std::error_code ignored;
  require(fs::is_directory(folder, ignored),
          folder.string() +
              ": the catalogue is not there; the environment variable GURNEY_DATA names "
              "the folder that holds equipment/");
}

/// `; 'R100' is a caster`; empty: no name of the catalogue.
std::string of_another_kind(const std::string& name) {
  for (const DataKind kind : {DataKind::kItem, DataKind::kCaster, DataKind::kFloor, DataKind::kRoom,
                              DataKind::kTether, DataKind::kBuilding})
    if (config::FileSnapshot::exists(folder_of(kind) / (name + ".toml")))
      return "; '" + name + "' is the name of another kind: " + noun_of(kind);
  return {};
}

}  // namespace

const char* noun_of(DataKind kind) { return names_of(kind).noun; }

std::string data_folder() { return find_data_folder().path; }

std::string data_file(const std::string& name) {
  const fs::path folder = fs::path(data_folder()) / "equipment";
  require_folder(folder);
  return (folder / name).string();
}

std::vector<std::string> catalogue_names(DataKind kind) {
  const fs::path folder = folder_of(kind);
  require_folder(folder);
  std::vector<std::string> names;
  for (const fs::directory_entry& file : fs::directory_iterator(folder))
    if (file.path().extension() == ".toml") names.push_back(file.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_data(DataKind kind, const std::string& name, const std::string& named_in) {
  const std::string noun =
      noun_of(kind) + std::string(kind == DataKind::kItem ? " of equipment" : "");
  if (name.find('/') != std::string::npos || fs::path(name).extension() == ".toml") {
    const fs::path path = (fs::path(named_in).parent_path() / name).lexically_normal();
    std::error_code ignored;
    const bool there = config::FileSnapshot::exists(path) && !fs::is_directory(path, ignored);
    require(there, "no such file: " + path.string());
    return path.string();
  }
  const std::string file = (folder_of(kind) / (name + ".toml")).string();
  if (config::FileSnapshot::exists(file)) return file;
  const std::vector<std::string> names = catalogue_names(kind);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    const fs::path beside = fs::path(named_in).parent_path() / (name + ".toml");
    const std::string file_beside =
        config::FileSnapshot::exists(beside) ? "; for the file write " + name + ".toml" : "";
    std::string known = of_another_kind(name);
    if (known.empty()) known = config::near_name(name, names);
    if (known.empty() && file_beside.empty()) {
      for (const std::string& each : names) known += (known.empty() ? "" : ", ") + each;
      known = " (the catalogue has " + known + ")";
    }
    throw Error("unknown " + noun + known + file_beside);
  }
  return file;
}

}  // namespace gurney::equipment
