#pragma once

#include <filesystem>
#include <string>

namespace gurney::equipment {

/// The folder of the shipped data: equipment/, groundmotions/ and studies/.
struct DataFolder {
  enum class Origin {
    kEnvironment,    ///< the environment variable GURNEY_DATA
    kBesideProgram,  ///< ../share/gurney, seen from the folder of the program: an installation
    kSource          ///< what the program was built from
  };
  std::string path;
  Origin origin = Origin::kSource;
};
const char* name_of(DataFolder::Origin origin);

/// Names the source folder, in the build folder: an installed program holds no path of the machine
/// that built it.
inline constexpr const char* kSourceFolderFile = "source_folder";

/// The first of the three that is there, else where an installation would have it; the environment
/// counts whatever it says.
/// @param stated   value of GURNEY_DATA; nullptr or empty: not set
/// @param program  path of the running program; empty: not known
DataFolder find_data_folder(const char* stated, const std::filesystem::path& program);

/// Data folder of this program.
DataFolder find_data_folder();

/// For a library in a program of somebody else, before the first look: the place that counts as
/// that of the program.
void take_as_program(const std::filesystem::path& place);

}  // namespace gurney::equipment
