#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

using HeaderFacts = std::vector<std::pair<std::string, std::string>>;

/// Samples of f(t) from 0 s to the first sample at or behind `duration`.
/// @throws Error for more than 10 million samples or fewer than 4.
Eigen::VectorXd sampled(double time_step, double duration,
                        const std::function<double(double)>& function);

/// A component that says it is synthetic. A motion that does not end at rest gets a warning with
/// the velocity and the displacement that are left: more than 1e-6 of its peaks.
Component synthetic_component(Direction direction, double time_step, Eigen::VectorXd acceleration);

/// A record of one component, h1.
Record single_component(double time_step, Eigen::VectorXd acceleration);

/// Writes into every component what made it: that it is synthetic, the kind, its source, the facts.
void describe_synthetic(Record& record, const std::string& kind, const std::string& source,
                        const HeaderFacts& facts);

}  // namespace gurney::groundmotions
