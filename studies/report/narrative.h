#pragma once

#include <string>

#include "engine/response/response.h"
#include "studies/results/run_facts.h"
#include "studies/units/unit_system.h"

namespace gurney::report {

/// What happened, line by line: how far each item moved and what lifted, what hit what (fastest
/// first), what fell and why, which zones are blocked, which tethers got taut or broke, and how far
/// the numbers can be trusted: predictability, the change with half the time step, and within which
/// fraction each demand is settled. A line that starts with blanks belongs to the heading before it.
std::string narrative(const study::RunFacts& facts, const Response& response,
                      const study::UnitSystem& units = {});

/// Parts of it; empty where there is nothing to report. Each line ends in a line break.
std::string narrative_of_trust(const Response& response, const std::vector<std::string>& items);
/// Of every demand, wheel and marked point, whether half the time step and the twin leave it.
std::string narrative_of_settled(const study::RunFacts& facts, const Response& response);
std::string narrative_of_impacts(const Response& response, const std::vector<std::string>& items,
                                 const study::UnitSystem& units);
std::string narrative_of_falls(const study::RunFacts& facts, const Response& response,
                               const study::UnitSystem& units);
std::string narrative_of_zones(const study::RunFacts& facts, const Response& response,
                               const study::UnitSystem& units);
std::string narrative_of_tethers(const study::RunFacts& facts, const Response& response,
                                 const study::UnitSystem& units);

}  // namespace gurney::report
