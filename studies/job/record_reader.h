#pragma once

#include <optional>

#include "engine/config/table.h"
#include "studies/job/job.h"

namespace gurney::study {

/// [excitation.record], if it is there; the files it names exist. Errors are noted in the table's
/// document.
std::optional<RecordRequest> read_record_request(config::Table& excitation);

}  // namespace gurney::study
