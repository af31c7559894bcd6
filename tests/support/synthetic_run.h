#pragma once

#include "engine/response/response.h"
#include "studies/results/run_facts.h"

namespace gurney {

/// A made-up but plausible run: a four-caster trolley with one marked point, shaken or pulled.
/// Every number of the response differs from every other, so that mixed-up columns show.
study::RunFacts synthetic_facts(bool pulled = false);
Response synthetic_response(bool pulled = false);

}  // namespace gurney
