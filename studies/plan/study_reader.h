#pragma once

#include "engine/config/table.h"
#include "studies/plan/study.h"

namespace gurney::study {

/// Reads the table [study] of a job. Errors are noted in its document.
/// @param node  the same table, from which the patches of factors are taken
Study read_study(config::Table& study, const config::Node& node);

}  // namespace gurney::study
