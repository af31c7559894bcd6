#include "studies/doctor/installation.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/data_folder.h"
#include "studies/build_info/build_info.h"
#include "studies/build_info/libraries.h"
#include "studies/picture/rendering.h"
#include "studies/results/hdf5_version.h"

namespace gurney::doctor {
namespace {

/// Reads every file of a kind. @return how many there are
std::size_t read_all(equipment::DataKind kind, std::string& errors) {
  const std::vector<std::string> names = equipment::catalogue_names(kind);
  for (const std::string& name : names) try {
      equipment::check_data_file(equipment::find_data(kind, name, ""));
    } catch (const Error& error) {
      errors += (errors.empty() ? "" : "\n") + std::string(error.what());
    }
  return names.size();
}

}  // namespace

Finding program() {
  const build_info::BuildInfo build = build_info::build_info();
  return ok("program", fmt::format("gurney {}, commit {}, {}", build.program_version,
                                   build.git_commit, build.compiler));
}

Finding libraries() {
  const std::string built = study::hdf5_version_built(), loaded = study::hdf5_version_loaded();
  if (built != loaded)
    return warning("libraries",
                   fmt::format("{}; HDF5 {} is loaded", build_info::libraries(), loaded),
                   "build the program again with the libraries of this machine");
  return ok("libraries", build_info::libraries());
}

Finding data() {
  using equipment::DataKind;
  const equipment::DataFolder folder = equipment::find_data_folder();
  const char* const advice =
      "GURNEY_DATA must name a folder that holds equipment/ as the shipped one does, or not be set";
  std::string errors;
  try {
    const std::size_t items = read_all(DataKind::kItem, errors),
                      casters = read_all(DataKind::kCaster, errors),
                      floors = read_all(DataKind::kFloor, errors),
                      rooms = read_all(DataKind::kRoom, errors);
    if (!errors.empty()) return problem("data", errors, "correct these files, or install again");
    return ok("data",
              fmt::format("{} items, {} casters, {} floor coverings, {} rooms in {} ({})", items,
                          casters, floors, rooms, folder.path, name_of(folder.origin)));
  } catch (const Error& error) {
    return problem("data", error.what(), advice);
  }
}

Finding figures() {
  try {
    picture::png(R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>)", {0.1, 0.1});
    return ok("figures", "SVG, PDF and PNG");
  } catch (const Error& error) {
    return warning("figures", fmt::format("SVG only: {}", error.what()),
                   "for PDF and PNG: apt-get install librsvg2-2");
  }
}

}  // namespace gurney::doctor
