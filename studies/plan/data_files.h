#pragma once

#include <map>
#include <string>

#include "studies/plan/study_job.h"

namespace gurney::study {

/// Every file that decides a study's numbers beside the job and the records: items, casters, floor
/// coverings, rooms, tethers, buildings, target spectra, lists of records. They are those that were
/// read, with the bytes that were used; the motions (StudyMotions) are to be there, too.
/// @return SHA-256 by name: `equipment/casters/R100.toml` of the catalogue's, others relative to
///         the job's folder
std::map<std::string, std::string> data_files(const StudyJob& job);

}  // namespace gurney::study
