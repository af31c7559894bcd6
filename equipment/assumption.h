#pragma once

#include <limits>
#include <string>
#include <vector>

namespace gurney {

/// A number, or a choice of words, that no source backs: what a result that uses it rests on.
struct Assumption {
  std::string key;     ///< with its unit, as in the file: `tread.patch_width_mm`
  std::string choice;  ///< of words; empty for a number
  double value = std::numeric_limits<double>::quiet_NaN();  ///< in the key's unit
  double low = std::numeric_limits<double>::quiet_NaN();    ///< low <= value <= high
  double high = std::numeric_limits<double>::quiet_NaN();
  std::string reason;
  std::string file;
};

/// Appends what is not there yet (same file and key).
void add_assumptions(std::vector<Assumption>& list, const std::vector<Assumption>& more);

}  // namespace gurney
