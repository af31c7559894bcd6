#pragma once

#include <vector>

#include "engine/config/table.h"
#include "engine/scene/scene.h"
#include "equipment/catalogue/assumption.h"
#include "studies/study/job/job.h"

namespace gurney::study {

/// Each reader notes mistakes in its table's document.

/// The forces, drop weights, string potentiometers and blocks of a table [item] or [excitation],
/// appended to `loads`.
void read_loads(config::Table& table, std::vector<equipment::Assumption>& assumptions,
                std::vector<Load>& loads);

/// The tables `fixture` and `initial` of an item or a job.
Fixture read_fixture(config::Table& fixture, std::vector<equipment::Assumption>& assumptions);
void read_initial(config::Table& initial, std::vector<equipment::Assumption>& assumptions,
                  InitialMotion& motion);

}  // namespace gurney::study
