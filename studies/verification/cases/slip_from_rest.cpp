#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/verification/cases/slider.h"
#include "studies/verification/family.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/scenes.h"

namespace gurney::verification {
namespace {

using namespace sliding;

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 0.004, kFloorStep = 0.001, kCycles = 30;  // [s], [s], [-]

struct FromRest {
  double rolls, friction, amplitude, frequency, stiffness;  // cart or block, mu, [g], [Hz], [N/m]
};

/// A rigid block on a floor of acceleration a sin(w t), from rest: it slides between events, each
/// found by bisection and passed with the exact integral.
class RigidBlock {
 public:
  RigidBlock(double amplitude, double friction, double w) : a_(amplitude), f_(friction), w_(w) {}

  double displacement(double time) {
    while (next_ <= time) pass_event();
    return direction_ == 0 ? x_ : x_ + moved(time);
  }

 private:
  double floor(double t) const { return a_ * std::sin(w_ * t); }
  double speed(double t) const {
    return a_ / w_ * (std::cos(w_ * t) - std::cos(w_ * start_)) - direction_ * f_ * (t - start_);
  }
  double moved(double t) const {
    const double d = t - start_;
    return a_ / (w_ * w_) * (std::sin(w_ * t) - std::sin(w_ * start_)) -
           a_ / w_ * std::cos(w_ * start_) * d - direction_ * f_ * d * d / 2;
  }
  template <class Test>
  double first(Test over) const {
    const double scan = 2 * kPi / w_ / 1000;
    double high = start_ + scan;
    while (!over(high)) high += scan;
    double low = high - scan;
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (over(middle) ? high : low) = middle;
    }
    return high;
  }
  void find_event() {
    next_ = direction_ == 0 ? first([&](double t) { return std::abs(floor(t)) > f_; })
                            : first([&](double t) { return direction_ * speed(t) < 0; });
  }
  void pass_event() {
    if (direction_ != 0) x_ += moved(next_);
    start_ = next_;
    direction_ = std::abs(floor(start_)) >= f_ * (1 - 1e-12) ? (floor(start_) > 0 ? -1 : 1) : 0;
    find_event();
  }

  double a_, f_, w_;
  double x_ = 0, start_ = 0, next_ = 0;
  int direction_ = 0;
};

/// Of the floor at the reversals of steady sliding, a_r = sqrt(a^2 - (pi mu g / 2)^2) [g].
double at_reversal(const FromRest& c) {
  const double a = c.amplitude, f = kPi / 2 * c.friction;
  return a > f ? std::sqrt(a * a - f * f) : 0;
}

/// It never sticks once it slides, or it sticks twice in each cycle: a_r above or below mu g.
bool sticks(const FromRest& c) { return at_reversal(c) <= c.friction; }

/// How far a velocity error of 1 m/s, made at a reversal, carries a block that never sticks [s]. It
/// moves the next reversal so that friction gives back 2 mu g / (a_r + mu g) of it.
double memory(const FromRest& c) {
  return (at_reversal(c) + c.friction) / (2 * c.friction) / (2 * c.frequency);
}

/// Velocity that a tread of finite stiffness adds at a reversal. Its force takes the time t to
/// swing from mu N to -mu N, an oscillator from rest under a_r + mu g: cos(w t) = 1 - 2 mu g / (a_r
/// + mu g), and it lacks 2 mu g t - (a_r + mu g) (t - sin(w t) / w).
double swing(const FromRest& c, const Slider& slider) {
  const double drive = at_reversal(c) + c.friction;
  const double angle = std::acos(1 - std::min(2.0, 2 * c.friction / drive));
  return slider.wind_up / c.friction * (2 * c.friction * angle - drive * (angle - std::sin(angle)));
}

Findings slip(const FromRest& c, const Runner& runner) {
  Findings findings;
  const Slider slider = make_slider(c.rolls != 0, c.friction, c.stiffness);
  const double w = 2 * kPi * c.frequency, duration = kCycles / c.frequency;
  const FloorMotion floor =
      scenes::floor_motion(kFloorStep, duration, Vector3::UnitX(),
                           [&](double t) { return c.amplitude * kG * std::sin(w * t); });
  const Response response =
      shake(slider, floor, scenes::run_for(duration, kStep, 5 * kStep), 0, runner, findings);
  // A reversal is located but for 1e-3 of a step, with friction of the wrong sign in it. A step
  // that is longer than the swing of the treads takes it to be anything up to twice as long: evenly
  // spread errors of sigma = 2 swing / sqrt(12), 2 n of them.
  const double swung = swing(c, slider), located = 2 * c.friction * kG * 1e-3 * kStep;
  const bool resolved = kStep < std::sqrt(scenes::total_mass(slider.item) / slider.stiffness);
  const double reversals = 2 * kCycles;
  const double spread = resolved ? 0 : 3 * std::sqrt(reversals / 3) * swung;
  const double sampled = std::pow(w * kFloorStep, 2) / 12 * c.amplitude * kG / (w * w) * kCycles;
  const double slides_on = memory(c) * (swung + spread + reversals * located);
  // What sticks forgets its velocity; each stop is off by the deflection of the treads. It starts
  // inside a step, in which it gains up to a w dt^2 / 2: evenly spread, sigma = that over sqrt(12).
  const double deflection = slider.wind_up * slider.wind_up / (c.friction * kG);
  const double start = 3 * std::sqrt(reversals / 12) * c.amplitude * kG * w * kStep * kStep / 2;
  const double stops = reversals * deflection + (reversals * located + start) / (2 * c.frequency);
  const double tolerance = (sticks(c) ? stops : slides_on) + sampled;
  RigidBlock exact(c.amplitude * kG, c.friction * kG, w);
  Track track(
      "displacement", "m",
      "a velocity error lasts for (a_r + mu g) / (4 mu g f): the swing of the treads at a "
      "reversal, s; 3 sqrt(2 n / 3) s where the step does not resolve it, for n cycles; "
      "2 n times 2 mu g 1e-3 dt, to which a reversal is located; where it sticks 2 n "
      "times the deflection of the treads, mu M g / k, and, for half a cycle, the latter and 3 "
      "sqrt(2 n / 12) a w dt^2 / 2, of starts inside a step; "
      "the sampled sine, (w dt_f)^2 / 12 of a / w^2 in each cycle");
  for (const Sample& s : response.items[0].history)
    track.add(s.time, s.displacement.x(), slider.scale * exact.displacement(s.time), tolerance);
  track.report(findings);
  return findings;
}

bool slides(const FromRest& c) {
  return c.amplitude > 1.1 * c.friction && c.amplitude < 25 * c.friction;
}

}  // namespace

Family slip_from_rest() {
  return make_family<FromRest>(
      {"slip_from_rest", "sliding", "Thirty cycles of sliding from rest, at the default step",
       "x'' = -a sin(w t) - mu g sign(x') from event to event; a cart with mu = Cr/R: times "
       "M / (M + J)",
       "Coulomb's law, integrated exactly between events"},
      {{{"rolls", "0 block, 1 cart", 0, 1, true}, &FromRest::rolls},
       {{"friction", "mu or Cr/R", 0.02, 0.5}, &FromRest::friction},
       {{"amplitude", "g", 0.1, 0.8}, &FromRest::amplitude},
       {{"frequency", "Hz", 0.4, 3}, &FromRest::frequency},
       {{"stiffness", "N/m, each tread", 1e6, 1e9}, &FromRest::stiffness}},
      {{"block_1e6", {0, 0.1, 0.3, 1, 1e6}},
       {"block_1e8", {0, 0.1, 0.3, 1, 1e8}},
       {"block_1e9", {0, 0.1, 0.3, 1, 1e9}},
       {"block_sticks", {0, 0.3, 0.5, 1, 1e8}},
       {"block_2_Hz", {0, 0.15, 0.5, 2, 1e8}},
       {"cart_1e8", {1, 0.1, 0.3, 1, 1e8}},
       {"cart_1e9", {1, 0.1, 0.3, 1, 1e9}}},
      slip, slides);
}

}  // namespace gurney::verification
