#include "equipment/catalogue/data_folder.h"

#include <cstdlib>
#include <fstream>

namespace gurney::equipment {

namespace fs = std::filesystem;

namespace {

fs::path& stated_program() {
  static fs::path place;
  return place;
}

}  // namespace

const char* name_of(DataFolder::Origin origin) {
  switch (origin) {
    case DataFolder::Origin::kEnvironment:
      return "environment variable GURNEY_DATA";
    case DataFolder::Origin::kBesideProgram:
      return "installed with the program";
    case DataFolder::Origin::kSource:
      break;
  }
  return "source folder of the build";
}

DataFolder find_data_folder(const char* stated, const fs::path& program) {
  if (stated != nullptr && *stated != '\0') return {stated, DataFolder::Origin::kEnvironment};
  const fs::path bin = program.empty() ? "/usr/bin" : program.parent_path();
  const fs::path installed = bin.parent_path() / "share" / "gurney";
  std::error_code ignored;
  std::string source;
  if (!fs::is_directory(installed / "equipment", ignored))
    std::getline(std::ifstream(bin / kSourceFolderFile), source);
  if (source.empty()) return {installed.string(), DataFolder::Origin::kBesideProgram};
  return {source, DataFolder::Origin::kSource};
}

DataFolder find_data_folder() {
  std::error_code unknown;
  const fs::path program =
      stated_program().empty() ? fs::read_symlink("/proc/self/exe", unknown) : stated_program();
  return find_data_folder(std::getenv("GURNEY_DATA"), program);
}

void take_as_program(const fs::path& place) { stated_program() = place; }

}  // namespace gurney::equipment
