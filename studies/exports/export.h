#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/exports/fragility_export.h"
#include "studies/units/unit_system.h"

namespace gurney::study {

/// Takes a file of an export: its name, without folder, and its bytes.
using TakeFile = std::function<void(const std::string& name, std::string_view bytes)>;

/// A text as a name of a file or an identifier: what is not a letter, digit or underscore becomes
/// an underscore. Without letters and digits it is `otherwise`.
std::string plain_identifier(const std::string& text, const std::string& otherwise);

/// A cell of a CSV file (RFC 4180): quoted where it must be, control characters as `\x1b`. A text
/// that a spreadsheet would compute, such as `=1+1`, gets an apostrophe before it.
std::string csv_cell(const std::string& text);
/// The shortest text that reads back as the same number; NaN: empty.
std::string csv_cell(double value);

/// Cells and the end of the line.
std::string csv_line(const std::vector<std::string>& cells);

/// Every table of a results file, of a study or of one run, as a CSV file: names, units, rows. A
/// column with more dimensions than rows becomes one for each place in them:
/// `displacement.Trolley.x`. Numbers in SI read back exactly; a number that does not exist is
/// empty.
/// @throws Error for other files
void export_tables(const std::string& path, const TakeFile& take, const UnitSystem& units = {});

/// Samples of demands, run by run, for each configuration.
///
/// `response_CONFIGURATION.csv`, as SimCenter's tools have it: index of the run, a column for each
/// drawn number, intensity measure and demand of each item and point, and ERROR.
///
/// `demands_CONFIGURATION_LEVEL.csv`, as pelicun loads it, for each level of a study (none after a
/// ida): columns TYPE-LOCATION-DIRECTION, units pelicun knows; the floor's PFA and PFV at location
/// 0 in direction 1, demands of items at the item's name.
///
/// The second row has the units. Failed runs have ERROR 1 and no demand; a number that does not
/// exist is empty.
/// @throws Error for an unknown configuration, and unless it is the results file of a study
void export_responses(const StudyData& data, const ExportChoice& choice, const TakeFile& take);

/// Fragility models in NRML 0.5 for OpenQuake: a file for each limit state, since the limit states
/// of one file follow each other there, and in it a function for each configuration: the lognormal
/// curve by mean and standard deviation of the intensity, which is what NRML asks for.
/// @return the curves that were left out, and why
/// @throws Error for unknown names, a measure of the floor and others that NRML does not name, and
///         without any curve
std::vector<std::string> export_nrml(const StudyData& data, const ExportChoice& choice,
                                     const TakeFile& take);

/// Rows of a fragility table of the Damage and Loss Model Library, which pelicun reads, and the
/// file that describes them: fragility.csv and fragility.json. A component for each configuration
/// and limit state, with that one limit state: those of a study may come in any order, but the
/// limit states of one row follow each other in pelicun.
/// @return the curves that were left out, and why
/// @throws Error for unknown names, a measure that DLML does not name, and without any curve
std::vector<std::string> export_pelicun(const StudyData& data, const ExportChoice& choice,
                                        const TakeFile& take);

/// A run as moving shapes, for ParaView and VisIt: NAME.xdmf (XDMF 3) names the times and points
/// into NAME_shapes.h5, where each time has the points of items and casters (turned about their
/// swivel axes), and the room has its points once; cells carry `item`, the index of the item in the
/// file, or -1 for the room.
/// @param name  of both files, without ending
/// @throws Error unless the file is that of one run with histories
void export_xdmf(const std::string& path, const std::string& name, const TakeFile& take);

}  // namespace gurney::study
