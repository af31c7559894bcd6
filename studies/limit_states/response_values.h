#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "studies/limit_states/limit_state.h"

namespace gurney::study {

/// The values of a run that was just made.
Values values_of(const Scene& scene, const Response& response);

}  // namespace gurney::study
