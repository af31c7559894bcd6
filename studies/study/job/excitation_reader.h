#pragma once

#include "engine/config/table.h"
#include "studies/study/job/job_parts.h"

namespace gurney {

/// Each reader notes mistakes in its table's document.

/// [[excitation.force]], drop weights, string potentiometers and blocks.
void read_loads(config::Table& excitation, JobReading& job);

/// [fixture]
void read_fixture(config::Table& fixture, JobReading& job);

}  // namespace gurney
