#pragma once

#include <cstddef>
#include <string>

#include "groundmotions/formats/file_errors.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/plain_rows.h"

namespace gurney::groundmotions {

/// Numbers before the samples that are no samples: their count, the time step, a scale factor.
struct LeadingNumbers {
  double count = 0;      ///< of the samples or rows that follow; 0: not stated
  double time_step = 0;  ///< [s]; 0: not stated
  std::size_t line = 0;  ///< from 1; 0: there are no such numbers
  bool of_rows = false;  ///< the count is that of the rows of a table
  std::string warning;   ///< how they were understood, where that is not sure
};

/// Takes them off the rows: `4684 0.0100` in a row or in two, before samples or before rows of times
/// and values; `1` and `0.01` (a scale factor of 1 and a time step), with a warning; a count alone.
/// A scale factor other than 1 is an error. With options.columns = "samples" all numbers are
/// samples, which is a warning where the first ones look otherwise.
LeadingNumbers take_leading_numbers(PlainRows& rows, const ReadOptions& options,
                                    FileErrors& errors);

}  // namespace gurney::groundmotions
