#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "studies/verification/cases.h"
#include "studies/verification/cases/rocking_body.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/scenes.h"

// Steps of the floor's velocity under a block that does not slide. About the edge it turns on, a
// step V gives it w = M h V / I_O, and it falls when that lifts its centre from h to R. An opposite
// step is worst just after the block has come back and changed edges, with eta w left: eta w + w
// fells it.
namespace gurney::verification {
namespace {

constexpr double kSample = 1e-3;         // of the floor's motion [s]
constexpr double kLength = 2 * kSample;  // of a step: a triangle of acceleration
constexpr double kNever = std::numeric_limits<double>::infinity();

struct Steps {
  double alpha, radius, inertia = 4.0 / 3;  // [rad], [m], I_O / (M R^2)
  RockingBody body() const { return {alpha, radius, inertia}; }
  double critical() const {  // V1
    return radius * std::sqrt(2 * kG * radius * (1 - std::cos(alpha)) * inertia) /
           (radius * std::cos(alpha));
  }
};

double still(double) { return 0; }

class SteppedFloor {
 public:
  SteppedFloor(const Steps& c, const Runner& runner, Findings& findings)
      : scene_(c.body().scene()),
        block_(c.body().block()),
        critical_(c.critical()),
        runner_(runner),
        findings_(findings) {}

  /// A step of the floor by `speed` and, `pause` later, one back.
  bool falls(double speed, double pause) const {
    const double end = (std::isfinite(pause) ? pause : 0) + 2 * kLength;
    const auto step = [&](double t) {
      return speed / kSample * std::max(0.0, 1 - std::abs(t - kSample) / kSample);
    };
    const FloorMotion floor = scenes::floor_motion(
        kSample, end, Vector3::UnitX(), [&](double t) { return step(t) - step(t - pause); });
    SimulationSettings settings = blocks::run_for(end + 10 / block_.p, 0.0005, 0);
    settings.follow_overturning = false;
    return runner_(findings_, scene_, floor, settings).outcome == Outcome::kOverturned;
  }

  /// How long after a step of `speed` the rigid block changes edges, to 0.1 ms.
  double time_of_impact(double speed) const {
    RockingReference r(block_);
    r.jump(speed);
    while (r.impacts() == 0 && r.time() < 60) r.advance(still, 1e-4);
    return r.time();
  }
  /// The second step waits `landing` for the edge, and for the next sample of the floor's motion.
  double pause(double speed, double landing) const {
    return kSample * std::ceil((time_of_impact(speed) + landing) / kSample);
  }
  bool rigid_block_falls(double speed, double pause) const {
    RockingReference r(block_);
    r.jump(speed);
    r.advance(still, pause);
    r.jump(-speed);
    r.advance(still, 20 / block_.p);
    return r.fallen();
  }
  /// The least speed of two steps that fell the rigid block.
  double critical_double_step(const std::function<double(double)>& pause) const {
    double low = 0.8 * critical_ / (1 + block_.eta), high = 1.5 * low;
    for (int i = 0; i < 20; ++i) {
      const double speed = 0.5 * (low + high);
      (rigid_block_falls(speed, pause(speed)) ? high : low) = speed;
    }
    return high;
  }

 private:
  Scene scene_;
  RockingBlock block_;
  double critical_;
  const Runner& runner_;
  Findings& findings_;
};

constexpr double kBracket = 0.002;  // of a located speed

Findings one_step(const Steps& c, const Runner& runner) {
  Findings findings;
  const SteppedFloor floor(c, runner, findings);
  const double V = c.critical(), p = c.body().block().p;
  const double share =
      p * (std::sqrt(RockingBody::kMass / RockingBody::kStiffness) + 0.5 * kLength);
  const double found = locate(V * (1 - 3 * share), V * (1 + 3 * share), kBracket * V,
                              [&](double speed) { return floor.falls(speed, kNever); });
  findings.checks.push_back(
      {"speed of the step that fells it", "m/s", found, V, (share + kBracket / 2) * V,
       "p times the delay, sqrt(M / k) in which the edge takes up the impulse and half of the 2 ms "
       "of the step; half of the last bracket, 0.1 %"});
  return findings;
}

Findings two_steps(const Steps& c, const Runner& runner) {
  Findings findings;
  const SteppedFloor floor(c, runner, findings);
  const RockingBody body = c.body();
  const RockingBlock block = body.block();
  const double critical = c.critical() / (1 + block.eta);
  const double at_impact =
      floor.critical_double_step([&](double v) { return floor.time_of_impact(v); });
  findings.checks.push_back({"speed of two steps, of the equation integrated", "m/s", at_impact,
                             critical, 1e-3 * critical,
                             "0.1 ms of the impact and of a bracket: 0.1 %"});
  // The edge lands in pi sqrt(M / k), and is given that time.
  const double landing = 2 * body.loading_time();
  const auto later = [&](double wait) {
    return floor.critical_double_step([&](double v) { return floor.pause(v, wait); });
  };
  const double expected = later(landing), uncertain = later(2 * landing) - expected;
  const double share =
      block.p * (std::sqrt(RockingBody::kMass / RockingBody::kStiffness) + 0.5 * kLength);
  const double tolerance =
      uncertain + (body.eta_error() / (1 + block.eta) + share + kBracket / 2) * expected;
  const double found =
      locate(expected - 2 * tolerance, expected + 2 * tolerance, kBracket * expected,
             [&](double speed) { return floor.falls(speed, floor.pause(speed, landing)); });
  findings.checks.push_back({"speed of two steps that overturns it", "m/s", found, expected,
                             tolerance,
                             "what a pause longer by the time of landing, pi sqrt(M / k), adds; "
                             "the rebound, e (1 - eta) / "
                             "(1 + eta); p times the delay of a step; half of the last bracket"});
  // Far from the impact the second step works against the block or against gravity.
  const double speed = 1.04 * critical, impact = floor.time_of_impact(speed);
  double fell = 0, ought = 0;
  for (const double part : {0.4, 0.7, 0.85, 1.2, 1.4}) {
    const double pause = kSample * std::round(part * impact / kSample);
    // Near a boundary nothing is asked: 4 %.
    if (floor.rigid_block_falls(0.96 * speed, pause) !=
        floor.rigid_block_falls(1.04 * speed, pause))
      continue;
    ought += floor.rigid_block_falls(speed, pause) ? 1 : 0;
    fell += floor.falls(speed, pause) ? 1 : 0;
  }
  findings.checks.push_back({"overturns for steps at another time", "", fell, ought, 0,
                             "as the rigid block, at 0.4 to 1.4 of the time of the impact"});
  return findings;
}

std::vector<Field<Steps>> fields() {
  return {{{"alpha", "rad", 0.2, 0.45}, &Steps::alpha},
          {{"radius", "m", 0.4, 1.6}, &Steps::radius},
          {{"inertia", "I_O over M R^2", 1.15, 1.6}, &Steps::inertia}};
}
const std::vector<std::pair<std::string, Steps>> kBlocks{{"tall", {0.351, 0.799}},
                                                         {"stocky", {0.448, 0.693}},
                                                         {"slender", {0.319, 0.685}},
                                                         {"small", {0.359, 0.427}},
                                                         {"large", {0.322, 1.265, 1.233}}};

}  // namespace

Family floor_step() {
  return make_family<Steps>(
      {"floor_step", "blocks", "The floor's velocity steps once under a block",
       "overturns from V1 = (1/h) sqrt(2 g (R - h) I_O / M) on",
       "Mallet 1862, The Great Neapolitan Earthquake of 1857, part I"},
      fields(), kBlocks, one_step);
}

Family floor_double_step() {
  return make_family<Steps>(
      {"floor_double_step", "blocks", "The floor's velocity steps and steps back under a block",
       "overturns from V1 / (1 + eta) on when the second step is just after the impact",
       "Nabeshima, Taniguchi, Kojima & Takewaki 2016, Frontiers in Built Environment 2"},
      fields(), kBlocks, two_steps);
}

}  // namespace gurney::verification
