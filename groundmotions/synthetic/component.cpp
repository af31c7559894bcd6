#include "groundmotions/synthetic/component.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cassert>
#include <cmath>
#include <numbers>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "groundmotions/measures/peaks.h"

namespace gurney::groundmotions {

Eigen::VectorXd sampled(double time_step, double duration,
                        const std::function<double(double)>& function) {
  constexpr double kFewest = 4, kMax = 1e7;
  // A duration that is a whole number of steps but for rounding needs no further step.
  const double steps = std::ceil(duration / time_step - 1e-6);
  require(steps + 1 >= kFewest && steps < kMax,
          fmt::format("duration {:g} s at time step {:g} s: a motion needs {:g} to {:g} samples",
                      duration, time_step, kFewest, kMax));
  Eigen::VectorXd values(static_cast<Eigen::Index>(steps) + 1);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    values[i] = function(static_cast<double>(i) * time_step);
  return values;
}

Component synthetic_component(Direction direction, double time_step, Eigen::VectorXd acceleration) {
  constexpr double kRest = 1e-6;
  Component component;
  component.name = name_of(direction);
  component.direction = direction;
  component.time_step = time_step;
  component.unit = "m/s2";
  component.format = "synthetic";
  component.acceleration = std::move(acceleration);
  const Eigen::Vector2d end = end_state(time_step, component.acceleration);
  const Peaks peak = peaks(time_step, component.acceleration);
  if (!(std::abs(end[0]) <= kRest * peak.velocity && std::abs(end[1]) <= kRest * peak.displacement))
    component.warnings.push_back(fmt::format(
        "{}: this motion does not end at rest where it began: it leaves {:.4g} m/s and {:.4g} m",
        component.name, end[0], end[1]));
  return component;
}

Record single_component(double time_step, Eigen::VectorXd acceleration) {
  Record record;
  record.components[0] = synthetic_component(Direction::kH1, time_step, std::move(acceleration));
  return record;
}

void describe_synthetic(Record& record, const std::string& kind, const std::string& source,
                        const HeaderFacts& facts) {
  record.name = "synthetic " + kind;
  for (auto& component : record.components) {
    if (!component) continue;
    HeaderFacts header = {
        {"synthetic", "never recorded; made by Gurney"}, {"kind", kind}, {"source", source}};
    append_all(header, facts);
    append_all(header, component->header);
    component->header = std::move(header);
    for (const std::string& warning : component->warnings) record.warnings.push_back(warning);
  }
}

Eigen::Vector2d end_state(double time_step, const Eigen::VectorXd& acceleration) {
  const EndMotion end = end_motion(time_step, acceleration);
  return {end.velocity, end.displacement};
}

void set_end_state(double time_step, Eigen::VectorXd& acceleration, const Eigen::Vector2d& wanted) {
  assert(acceleration.size() >= 4);
  const Eigen::ArrayXd phase = Eigen::ArrayXd::LinSpaced(acceleration.size(), 0, std::numbers::pi);
  const Eigen::VectorXd even = phase.sin().square(), odd = phase.sin().square() * phase.cos();
  Eigen::Matrix2d effect;
  effect << end_state(time_step, even), end_state(time_step, odd);
  const Eigen::Vector2d c = effect.inverse() * (end_state(time_step, acceleration) - wanted);
  acceleration -= c[0] * even + c[1] * odd;
}

Eigen::VectorXd acceleration_of(double time_step, const Eigen::VectorXd& displacement) {
  assert(displacement.size() >= 4);
  // Rows (1 4 1), at the ends (2 1) and (1 2), of the second differences; elimination downwards
  // and substitution upwards.
  const Eigen::Index last = displacement.size() - 1;
  const double factor = 6 / (time_step * time_step);
  Eigen::VectorXd a(last + 1), upper(last + 1);
  upper[0] = 0.5;
  a[0] = factor * (displacement[1] - displacement[0]) / 2;
  for (Eigen::Index i = 1; i <= last; ++i) {
    const double forward = i < last ? displacement[i + 1] - displacement[i] : 0;
    const double pivot = (i < last ? 4 : 2) - upper[i - 1];
    upper[i] = 1 / pivot;
    a[i] = (factor * (forward - (displacement[i] - displacement[i - 1])) - a[i - 1]) / pivot;
  }
  for (Eigen::Index i = last; i-- > 0;) a[i] -= upper[i] * a[i + 1];
  return a;
}

}  // namespace gurney::groundmotions
