#pragma once

#include <vector>

#include "engine/config/table.h"
#include "engine/scene/scene.h"
#include "equipment/catalogue/assumption.h"
#include "studies/study/job/job.h"

namespace gurney::study {

/// Each reader notes mistakes in its table's document.

/// [[excitation.force]], drop weights, string potentiometers and blocks, appended to `loads`.
void read_loads(config::Table& excitation, std::vector<equipment::Assumption>& assumptions,
                Excitation& loads);

/// [fixture]
Fixture read_fixture(config::Table& fixture, std::vector<equipment::Assumption>& assumptions);

}  // namespace gurney::study
