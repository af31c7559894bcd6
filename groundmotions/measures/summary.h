#pragma once

#include <string>
#include <utility>
#include <vector>

#include "groundmotions/measures/combination.h"
#include "groundmotions/measures/measure.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// One intensity measure of a component or a record.
struct SummaryRow {
  Measure measure;
  std::string name;        ///< "Sa(1)"
  std::string unit;        ///< of the values: SI
  std::string definition;  ///< a sentence

  /// The values by the name of the component or combination: "h1", ..., "RotD50"; of a single
  /// component the name is "value".
  std::vector<std::pair<std::string, double>> values;
};

struct Summary {
  std::vector<SummaryRow> rows;
  std::vector<std::string> warnings;  ///< Sa at periods below 10 dt, measures that have no value
};

/// The measures that are printed if none are asked for: all kinds, Sa at 0.2, 0.5, 1 and 2 s, SaAvg
/// and FIV3 at 1 s; PFA and PFV, which are PGA and PGV, are left out.
std::vector<Measure> common_measures();

Summary summary(const Component& component,
                const std::vector<Measure>& measures = common_measures());

/// The components that the record has and, with both horizontals, geomean, RotD50 and RotD100 (of
/// PGA, PGV, PGD, Sa and SaAvg) and the resultant (of PGA, PGV and PGD).
Summary summary(const Record& record, const std::vector<Measure>& measures = common_measures());

}  // namespace gurney::groundmotions
