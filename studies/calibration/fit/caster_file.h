#pragma once

#include <string>
#include <vector>

#include "studies/calibration/fit/calibration.h"

namespace gurney::calibration {

/// A caster file (docs/formats/equipment_file.md) with the constants of one caster on one floor.
struct CasterFile {
  std::string name;  ///< of the file, without folder: "R100_on_polyflor_mystique.toml"
  std::string text;
  std::vector<std::string> calibrated;  ///< keys that come from trials
};

/// One file for each caster and floor. The numbers that no trial gives are those of `base`, or,
/// where it is empty, of the catalogue's caster of that name; a caster that has none is reported in
/// `without`.
///
/// Rolling resistance and friction get their value, 95 % interval (`range`), a source that names
/// the trials, and a lognormal distribution with the scatter between trials where there is some.
/// The patch width is what the swivel torque leaves after the bearing's friction of the base.
/// @throws Error where the base is not known or cannot be read.
std::vector<CasterFile> caster_files(const Calibration& calibration, const std::string& base,
                                     std::vector<std::string>& without);

}  // namespace gurney::calibration
