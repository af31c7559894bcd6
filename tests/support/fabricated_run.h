#pragma once

#include "engine/response/response.h"
#include "studies/results/run_facts.h"

namespace gurney {

/// A made-up but plausible run: a four-caster trolley with one marked point, shaken or pulled.
/// Every number of the response differs from every other, so that mixed-up columns show.
study::RunFacts fabricated_facts(bool pulled = false);
Response fabricated_response(bool pulled = false);

}  // namespace gurney
