#pragma once

#include <limits>
#include <string>
#include <vector>

#include "engine/base/random/draw.h"

namespace gurney::equipment {

/// A number, or a choice of words, that no source backs or that was drawn from a distribution: what
/// a result that uses it rests on.
struct Assumption {
  std::string key;     ///< with its unit, as in the file: `tread.patch_width_mm`; of a drawn number
                       ///< with the part before it: `front left/tread.patch_width_mm`
  std::string choice;  ///< of words; empty for a number
  double value = std::numeric_limits<double>::quiet_NaN();  ///< in the key's unit
  double low = std::numeric_limits<double>::quiet_NaN();    ///< low <= value <= high
  double high = std::numeric_limits<double>::quiet_NaN();
  std::string reason;  ///< empty: a drawn number whose distribution has a source
  std::string file;
  std::string distribution;  ///< that it was drawn from; empty: not drawn
  Draw::Streams streams{};   ///< random numbers that a drawn one rests on
  bool in_use =
      true;  ///< false: drawn, but nothing rests on it, such as the torque of a brake that
             ///< is off in this draw
};

/// Appends what is not there yet (same file, key and value).
void add_assumptions(std::vector<Assumption>& list, const std::vector<Assumption>& more);

}  // namespace gurney::equipment
