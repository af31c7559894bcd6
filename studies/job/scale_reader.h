#pragma once

#include <string>

#include "engine/config/table.h"
#include "studies/job/job.h"

namespace gurney::study {

/// A measure that records can be scaled to, and the unit in which its values are stated.
struct ScalingTarget {
  groundmotions::Measure measure;
  groundmotions::Combination combination = groundmotions::Combination::kGeometricMean;
  std::string unit;
  double unit_in_si = 1;
};

/// Reads the keys `measure`, `component` and `unit`. Errors are noted in the table's document.
ScalingTarget read_scaling_target(config::Table& table);

/// Reads the keys `measure` and `component`.
groundmotions::Measure read_measure(config::Table& table);
groundmotions::Combination read_combination(config::Table& table,
                                            const groundmotions::Measure& measure);

/// Reads the key `vertical`.
groundmotions::VerticalScaling read_vertical_scaling(config::Table& table);

/// Reads `scale_to` of a record, such as
/// `{ measure = "Sa(1.0)", component = "RotD50", value = 0.6, unit = "g" }`. Errors are noted in
/// the table's document.
ScaleTo read_scale_to(config::Table& table);

/// The measure of a record, by which it is scaled.
groundmotions::ScalingMeasure scaling_measure(const groundmotions::Measure& measure,
                                              groundmotions::Combination combination);

/// The record scaled so that the measure has the value.
/// @throws Error for a measure that is zero or that scaling does not change.
groundmotions::Record scaled_to(const groundmotions::Record& record, const ScaleTo& request);

}  // namespace gurney::study
