#pragma once

#include <map>
#include <string>

#include "studies/study/study_job.h"

namespace gurney {

/// Every file that decides a study's numbers beside the job and the records: items, casters, floor
/// coverings, rooms, tethers, buildings, target spectra, and what those name in turn.
///
/// Found by what the job says, not by what was read: a text that names a file beside the one it
/// stands in, or an entry of the catalogue of any kind. The list may hold a file too many (a caster
/// named like an item), never one too few.
/// @return SHA-256 by name: `equipment/casters/R100.toml` of the catalogue's, others relative to
///         the job's folder
std::map<std::string, std::string> data_files(const StudyJob& job);

}  // namespace gurney
