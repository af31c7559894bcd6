#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "groundmotions/assembly/place.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// A part of a file's name that can be a component: `E` of S1_E.acc.
struct NameMark {
  std::string text = {};                ///< in capitals
  std::string pattern = {};             ///< the file's name with `*` in its place
  std::optional<Direction> place = {};  ///< none: a letter or digit that is no component
  std::optional<double> azimuth = {};   ///< of N, EW, 318 ... [rad]
  bool points_down = false;             ///< DWN
  unsigned styles = 0;   ///< horizontals of one motion share a bit: X and Y, FN and FP
  bool is_word = false;  ///< separators on both sides, or the extension
  bool is_last = false;  ///< nothing but words such as ACC behind it, or the extension
};

/// Every part of a file's name that can be a component.
std::vector<NameMark> name_marks(const std::filesystem::path& file);

/// The mark of a vertical, known without the files beside it: X_UP.txt, X.UD, X_Z.acc, UP.txt.
std::optional<NameMark> vertical_mark(const std::filesystem::path& file);

/// A file of one component that says no direction.
struct NamedFile {
  std::filesystem::path path;
  std::string site = {};  ///< files of several sites are not joined
  double time_step = 0;   ///< [s]
  Eigen::Index samples = 0;
};

struct NameMatches {
  std::vector<std::optional<NameMark>>
      marks;                        ///< for each file; those of one motion share patterns
  std::vector<std::string> doubts;  ///< files that may be of one motion, and why not
};

/// Files of one folder that are named alike but for the component and can be one motion: two
/// horizontals of one style (E and N, X and Y, H1 and H2, FN and FP, azimuths at a right angle, the
/// pairs of FEMA P-695) and one vertical at most, of one time step and of lengths that differ by
/// 1 % at most (an assumption). Letters that number files (A, B ... N) join none.
NameMatches match_names(const std::vector<NamedFile>& files);

/// Whether the file of a component says nothing but times and numbers.
bool lacks_direction(const Component& component);

/// Directions of the components whose files say none and that nobody stated, from the names of
/// their files (name_marks()), with a warning each. A lone file is a vertical if its name says so.
void orient_by_file_names(std::vector<UnplacedComponent>& components);

/// The name of a record of several files: what their stems begin and end with, without the names of
/// the components and the separators before them. "X_NIS000" and "X_NIS090" are of "X_NIS",
/// "16839_H1.cor" and "16839_V.cor" of "16839". Where that says little all stems, apart by " + ".
std::string common_name(const std::vector<std::string>& stems);

}  // namespace gurney::groundmotions
