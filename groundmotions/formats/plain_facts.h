#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/formats/column_title.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/plain_rows.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/formats/stated.h"

namespace gurney::groundmotions {

/// Statements of the free text above plain numbers. Lines are counted from 1.
struct PlainFacts {
  std::optional<AccelerationUnit> unit;
  std::size_t unit_line = 0;
  std::optional<double> time_step;  ///< [s]
  std::size_t step_line = 0;
  std::optional<double> count;  ///< of the samples of a component
  std::size_t count_line = 0;
  std::string component;        ///< its direction, where the text states one
  std::size_t factor_line = 0;  ///< of a factor for the numbers; 0: none
  double time_unit = 1;         ///< of a column of times without a title of its own [s]
};

/// Errors: samples that are velocity or displacement as the text says, a unit that is none of
/// acceleration or has a factor behind it, and lines that contradict each other.
/// @param titles  lines of the header (from 0) that name the columns and are not looked at
PlainFacts plain_facts(const PlainRows& rows, const std::vector<std::size_t>& titles,
                       FileErrors& errors);

/// An error if `step` [s], which `what` gives, is farther from that of the text than its rounding
/// explains: 1 %, an assumption.
void check_step(const PlainFacts& facts, double step, std::string_view what, FileErrors& errors);

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

/// Spectra lie beside the records in many folders and look like them.
/// @throws Error if the text above the numbers speaks of spectra; other errors do not matter then.
void refuse_spectra(const PlainRows& rows, const SourceFile& file);

/// @throws Error if the titles are those of a spectrum, `T(s),Sa(g)`, `f (Hz),FAS (g)`, or such a
///         line of text if the table has no titles.
/// @param all  whether all columns are looked at, not only the first
void refuse_spectra(const TableTitles& titles, bool all, const PlainRows& rows,
                    const SourceFile& file);

}  // namespace gurney::groundmotions
