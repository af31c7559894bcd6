#pragma once

#include <string>
#include <vector>

namespace gurney::templates {

/// Kinds of files to begin with: job, item, caster, room, study; a calibration is a folder.
const std::vector<std::string>& kinds();

/// Differences of a new file to its template. Empty: as the template has it.
struct Wishes {
  std::string name = {};       ///< of the file, in its comments and as its name or title
  std::string item = {};       ///< of a job or study: name of the catalogue or path
  std::string caster = {};     ///< of an item
  std::string room = {};       ///< of a job or study
  std::string record = {};     ///< of a job: lines of [excitation.record], of files
  std::string suite = {};      ///< of a study: lines of [excitation.record], of records
  std::string component = {};  ///< of the intensity measure of a study
};

/// @param kind  of kinds(), but no calibration
/// @throws Error for a name that TOML cannot hold, and for a wish that this kind has no use for
std::string file_text(const std::string& kind, const Wishes& wishes);

/// A calculated pull of a calibration: its force and displacement with time.
/// @param resistance  f_r / N
std::string pull_text(double resistance);

}  // namespace gurney::templates
