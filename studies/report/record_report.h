#pragma once

#include <string>
#include <utility>
#include <vector>

#include "groundmotions/measures/summary.h"
#include "groundmotions/record/record.h"
#include "studies/findings/findings.h"

namespace gurney::report {

/// Name and value of something known of a record besides its files, such as magnitude.
using RecordFact = std::pair<std::string, std::string>;

/// Everything about one record: files, samples, header, processing, intensity measures of the
/// components and of RotD50, what is left at the end, warnings.
findings::Section record_report(
    const groundmotions::Record& record, const std::vector<RecordFact>& facts,
    const std::vector<groundmotions::Measure>& measures = groundmotions::common_measures());

/// What looks wrong: warnings of reading, of amplitudes, of what is left at the end.
std::vector<std::string> record_findings(const groundmotions::Record& record);

}  // namespace gurney::report
