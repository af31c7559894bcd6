#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/random/normal_draw.h"
#include "engine/base/units.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// A rigid trolley on the pulling rig: uniform acceleration, then uniform deceleration.
struct SyntheticPull {
  double resistance = 0.02;  ///< Cr / R
  double force = 45;         ///< F of phase II [N]
  double start = 0.5, pull = 2, end = 12;
  double mass = 96.5, added_mass = 0.5, string = 1;
  double displacement_noise = 1e-4;  ///< standard deviation [m]
  double force_noise = 0.5;          ///< [N]
  unsigned seed = 1;

  double resisting() const { return resistance * mass * kStandardGravity; }
  double a2() const { return (force - resisting() - string) / (mass + added_mass); }
  double a3() const { return (resisting() + string) / (mass + added_mass); }
  double stop() const { return start + pull + a2() * pull / a3(); }
};

inline Trial make_pull(const SyntheticPull& p) {
  constexpr double kRate = 120;  // as the motion capture of the paper [Hz]
  Trial trial;
  trial.name = "made";
  trial.file = "made.csv";
  trial.setup.caster = "R100";
  trial.setup.floor = "polyflor_mystique";
  trial.setup.wheel_radius = 0.05;
  trial.setup.mass = p.mass;
  trial.setup.added_mass = p.added_mass;
  trial.setup.string_tension = p.string;
  trial.setup.origin = TrialOrigin::kSimulated;
  for (std::size_t i = 0; static_cast<double>(i) <= p.end * kRate; ++i) {
    const double t = static_cast<double>(i) / kRate;
    const double pulled = std::clamp(t - p.start, 0.0, p.pull);
    const double coasted = std::clamp(t - p.start - p.pull, 0.0, p.a2() * p.pull / p.a3());
    const double x =
        p.a2() * pulled * pulled / 2 + p.a2() * pulled * coasted - p.a3() * coasted * coasted / 2;
    const double force = t > p.start + p.pull ? 0 : t < p.start ? 1.05 * p.force : p.force;
    trial.signals.time.push_back(t);
    trial.signals.displacement.push_back(x + p.displacement_noise * normal_draw(p.seed, 0, i));
    trial.signals.force.push_back(force + p.force_noise * normal_draw(p.seed, 1, i));
    trial.lines.push_back(static_cast<int>(i) + 2);
  }
  return trial;
}

}  // namespace gurney::calibration
