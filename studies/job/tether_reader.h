#pragma once

#include "engine/config/table.h"
#include "studies/job/job_parts.h"

namespace gurney::study {

/// The tables [[tether]] of a job; the items must be placed and the room read, where a tether may
/// end. Errors are noted in the document.
void read_tethers(config::Table& root, JobReading& job);

}  // namespace gurney::study
