#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "studies/verification/family.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/housner.h"
#include "studies/verification/scenes/scenes.h"

// A block that a half sine sets rocking: how long it swings and what an impact leaves.
namespace gurney::verification {
namespace {

/// A block that rocks without sliding on stiff edges that hardly rebound.
struct RockingBody {
  double alpha, radius;      ///< [rad], from an edge to the centre [m]
  double inertia = 4.0 / 3;  ///< I_O / (M R^2); 4/3: a rectangle that is thin across

  static constexpr double kMass = 200, kStiffness = 1e8, kRebound = 0.01;  // [kg], [N/m], [-]

  double width() const { return 2 * radius * std::sin(alpha); }   ///< [m]
  double height() const { return 2 * radius * std::cos(alpha); }  ///< [m]
  RockingBlock block() const {
    return {alpha, std::sqrt(kG / (inertia * radius)),
            1 - 2 * std::pow(std::sin(alpha), 2) / inertia};
  }
  Scene scene() const {
    // An impulse at the edge leans by up to (4/3 tan + 1/3 cot) alpha: friction 5 holds it.
    Scene scene = blocks::block(kMass, {width(), 1, height()},
                                {.stiffness = kStiffness, .restitution = kRebound, .friction = 5});
    scene.items[0].model.chassis_inertia =
        (inertia - 1) * kMass * radius * radius * Matrix3::Identity();
    return scene;
  }

  /// An edge that lands with v and leaves with e v takes e (1 - eta) from the angular velocity
  /// about it: e v = 2 b e w, up, at the lever b of the centre, and 2 M b^2 e / I_O = e (1 - eta).
  double eta_error() const { return kRebound * (1 - block().eta); }

  /// Time in which an edge takes up a load or gives it back, a quarter of a period [s].
  double loading_time() const { return 0.5 * std::numbers::pi * std::sqrt(kMass / kStiffness); }
};

using std::numbers::pi;
constexpr double kStep = 1e-3;  // [s]

struct Rocking {
  double alpha, radius, inertia;  // [rad], [m], I_O / (M R^2)
  double ratio, strength;         // omega / p, a / (alpha g)

  RockingBody body() const { return {alpha, radius, inertia}; }
  double length() const { return pi / (ratio * body().block().p); }
  double acceleration(double t) const {
    return t < length() ? strength * alpha * kG * std::sin(pi * t / length()) : 0;
  }
};

/// Tops of the tilt after the pulse.
struct Tops {
  std::vector<double> tilt, time;
};

Tops tops(const Rocking& c, const std::vector<Sample>& h) {
  Tops found;
  for (std::size_t i = 1; i + 1 < h.size(); ++i)
    if (h[i].time > c.length() && h[i].tilt > h[i - 1].tilt && h[i].tilt >= h[i + 1].tilt &&
        h[i].tilt > 0.1 * c.alpha) {
      found.tilt.push_back(h[i].tilt);
      found.time.push_back(h[i].time);
    }
  return found;
}

void rock(const Rocking& c, Runner& runner) {
  const RockingBody body = c.body();
  const RockingBlock block = body.block();
  const FloorMotion floor = scenes::floor_motion(kStep, c.length(), Vector3::UnitX(),
                                                 [&](double t) { return c.acceleration(t); });
  SimulationSettings settings = blocks::run_for(c.length() + 8 / block.p, kStep, kStep);
  settings.follow_overturning = false;
  const Response response = runner(body.scene(), floor, settings);
  const Tops found = tops(c, response.items[0].history);
  const auto energy = [&](double tilt) {
    return std::cos(block.alpha - tilt) - std::cos(block.alpha);
  };
  const double sink = RockingBody::kMass * kG / (2 * RockingBody::kStiffness) / c.radius;
  const auto count = std::min<std::size_t>(found.tilt.size(), 4);
  if (count < 2)
    runner.check("swings above 0.1 alpha", "", count, exactly(2, "two at least, to compare them"));
  for (std::size_t n = 0; n + 1 < count; ++n) {
    const std::string which = ", impact " + std::to_string(n + 1);
    const double after = energy(found.tilt[n + 1]);
    runner.check("angular velocity after over before" + which, "",
                 std::sqrt(after / energy(found.tilt[n])),
                 near_to(block.eta, body.eta_error() + sink / after,
                         "e (1 - eta) for an edge that rebounds with e = 0.01; the edges sink by W "
                         "/ 2 k, over the height of the swing"));
    runner.check(
        "time between tops" + which, "s", found.time[n + 1] - found.time[n],
        near_to(quarter_period(block, found.tilt[n]) + quarter_period(block, found.tilt[n + 1]),
                2 * kStep + 2 * body.loading_time(),
                "samples of 1 ms, two; an edge unloads and one loads, pi/2 sqrt(M / k) each"));
  }
  runner.check(
      "energy balance error", "", response.quality.energy_closure,
      near_to(0, 0.01, "1 %: 32 steps in the loading of an edge lose (pi/32)^2 of what it takes"));
}

/// It swings to between 0.4 and 0.9 alpha, and so for a while, and does not fall.
bool swings(const Rocking& c) {
  RockingReference r(c.body().block());
  double highest = 0;
  for (double t = 0; t < c.length() + 8 / c.body().block().p; t += 0.01) {
    r.advance([&](double s) { return c.acceleration(s); }, 0.01);
    if (t > c.length()) highest = std::max(highest, std::abs(r.theta()));
  }
  return !r.fallen() && highest > 0.4 * c.alpha && highest < 0.9 * c.alpha;
}

// --- the floor steps once and twice
//
// Steps of the floor's velocity under a block that does not slide. About the edge it turns on, a
// step V gives it w = M h V / I_O, and it falls when that lifts its centre from h to R. An opposite
// step is worst just after the block has come back and changed edges, with eta w left: eta w + w
// fells it.

constexpr double kFloorSample = 1e-3;         // of the floor's motion [s]
constexpr double kLength = 2 * kFloorSample;  // of a step: a triangle of acceleration
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
  SteppedFloor(const Steps& c, Runner& runner)
      : scene_(c.body().scene()),
        block_(c.body().block()),
        critical_(c.critical()),
        runner_(runner) {}

  /// A step of the floor by `speed` and, `pause` later, one back.
  bool falls(double speed, double pause) const {
    const double end = (std::isfinite(pause) ? pause : 0) + 2 * kLength;
    const auto step = [&](double t) {
      return speed / kFloorSample * std::max(0.0, 1 - std::abs(t - kFloorSample) / kFloorSample);
    };
    const FloorMotion floor = scenes::floor_motion(
        kFloorSample, end, Vector3::UnitX(), [&](double t) { return step(t) - step(t - pause); });
    SimulationSettings settings = blocks::run_for(end + 10 / block_.p, 0.0005, 0);
    settings.follow_overturning = false;
    return runner_(scene_, floor, settings).outcome == Outcome::kOverturned;
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
    return kFloorSample * std::ceil((time_of_impact(speed) + landing) / kFloorSample);
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
  Runner& runner_;
};

constexpr double kBracket = 0.002;  // of a located speed

void one_step(const Steps& c, Runner& runner) {
  const SteppedFloor floor(c, runner);
  const double V = c.critical(), p = c.body().block().p;
  const double share =
      p * (std::sqrt(RockingBody::kMass / RockingBody::kStiffness) + 0.5 * kLength);
  const double found = locate(V * (1 - 3 * share), V * (1 + 3 * share), kBracket * V,
                              [&](double speed) { return floor.falls(speed, kNever); });
  runner.check("speed of the step that fells it", "m/s", found,
               near_to(V, (share + kBracket / 2) * V,
                       "p times the delay, sqrt(M / k) in which the edge takes up the impulse and "
                       "half of the 2 ms of the step; half of the last bracket, 0.1 %"));
}

void two_steps(const Steps& c, Runner& runner) {
  const SteppedFloor floor(c, runner);
  const RockingBody body = c.body();
  const RockingBlock block = body.block();
  const double critical = c.critical() / (1 + block.eta);
  const double at_impact =
      floor.critical_double_step([&](double v) { return floor.time_of_impact(v); });
  runner.check("speed of two steps, of the equation integrated", "m/s", at_impact,
               near_to(critical, 1e-3 * critical, "0.1 ms of the impact and of a bracket: 0.1 %"));
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
  runner.check(
      "speed of two steps that overturns it", "m/s", found,
      near_to(expected, tolerance,
              "what a pause longer by the time of landing, pi sqrt(M / k), adds; the rebound, e (1 "
              "- eta) / (1 + eta); p times the delay of a step; half of the last bracket"));
  // Far from the impact the second step works against the block or against gravity.
  const double speed = 1.04 * critical, impact = floor.time_of_impact(speed);
  double fell = 0, ought = 0;
  for (const double part : {0.4, 0.7, 0.85, 1.2, 1.4}) {
    const double pause = kFloorSample * std::round(part * impact / kFloorSample);
    // Near a boundary nothing is asked: 4 %.
    if (floor.rigid_block_falls(0.96 * speed, pause) !=
        floor.rigid_block_falls(1.04 * speed, pause))
      continue;
    ought += floor.rigid_block_falls(speed, pause) ? 1 : 0;
    fell += floor.falls(speed, pause) ? 1 : 0;
  }
  runner.check("overturns for steps at another time", "", fell,
               exactly(ought, "as the rigid block, at 0.4 to 1.4 of the time of the impact"));
}

const auto kFields =
    fields(FIELD(Steps, alpha, "rad", 0.2, 0.45), FIELD(Steps, radius, "m", 0.4, 1.6),
           FIELD(Steps, inertia, "I_O over M R^2", 1.15, 1.6));
const auto kBlocks =
    cases(at("tall", 0.351, 0.799), at("stocky", 0.448, 0.693), at("slender", 0.319, 0.685),
          at("small", 0.359, 0.427), at("large", 0.322, 1.265, 1.233));

// --- one cycle of a sine

Response shake(const RockingBody& body, double ratio, double strength, double cycles,
               Runner& runner) {
  const RockingBlock block = body.block();
  const double omega = ratio * block.p, length = 2 * pi / omega * cycles;
  const FloorMotion floor = scenes::floor_motion(
      length / 1000, length, Vector3::UnitX(),
      [&](double t) { return strength * block.alpha * kG * std::sin(omega * t); });
  SimulationSettings settings = blocks::run_for(length + 12 / block.p, 0.002, 0);
  settings.follow_overturning = false;
  return runner(body.scene(), floor, settings);
}

// --- the regions of one cycle

struct Sine {
  double alpha, radius, inertia, ratio;  // [rad], [m], I_O / (M R^2), omega / p
  RockingBody body() const { return {alpha, radius, inertia}; }
};

void find_regions(const Sine& c, Runner& runner) {
  const RockingBody body = c.body();
  const RockingBlock block = body.block();
  const SineRegions regions(block, c.ratio);
  const auto end = [&](double strength) {
    const Response response = shake(body, c.ratio, strength, 1, runner);
    if (response.outcome != Outcome::kOverturned) return RockingEnd::kStands;
    // A floor that starts along +x throws the block towards -x: without impact it falls there.
    return std::cos(response.items[0].demands.direction_of_overturning) > 0
               ? RockingEnd::kAfterImpact
               : RockingEnd::kWithoutImpact;
  };
  const double loading = block.p * body.loading_time();
  const auto check = [&](const char* quantity, double reference, double moved, bool from,
                         RockingEnd wanted) {
    const double share = loading + moved, bracket = share / 4;
    const double found =
        locate((1 - 2 * share) * reference, (1 + 2 * share) * reference, bracket * reference,
               [&](double strength) { return (end(strength) == wanted) == from; });
    runner.check(quantity, "alpha g", found,
                 near_to(reference, (share + bracket / 2) * reference,
                         "p times the time in which an edge takes up its load, pi/2 sqrt(M / k); "
                         "how much the boundary moves with the rebound of an edge, e (1 - eta) of "
                         "eta; half of the last bracket, an eighth of these"));
  };
  check("overturns without impact from", regions.c, 0, true, RockingEnd::kWithoutImpact);
  if (regions.a == 0) {
    runner.check("overturns at 0.6 of it", "",
                 end(0.6 * regions.c) == RockingEnd::kStands ? 0. : 1.,
                 exactly(0, "no impact helps it to overturn"));
    return;
  }
  const double inside = 0.5 * (regions.a + regions.b);
  const auto moved = [&](double boundary, double without) {
    double worst = 0;
    for (const double sign : {-1.0, 1.0}) {
      RockingBlock other = block;
      other.eta += sign * body.eta_error();
      const double there =
          SineRegions::boundary(other, c.ratio, RockingEnd::kAfterImpact, without, inside);
      worst = std::max(worst, std::abs(there / boundary - 1));
    }
    return worst;
  };
  const double at_a = moved(regions.a, 0.9 * regions.a);
  const double at_b = moved(regions.b, 0.5 * (regions.b + regions.c));
  check("overturns after an impact from", regions.a, at_a, true, RockingEnd::kAfterImpact);
  check("overturns after an impact up to", regions.b, at_b, false, RockingEnd::kAfterImpact);
}

/// The regions are wider than what they are uncertain by, and the edge stays on the floor, which
/// the equation takes for granted: it is not thrown up where the floor pulls it back with a and
/// its centre falls with a sin(alpha) / (I_O / M R^2) < g.
bool asks(const Sine& c) {
  const SineRegions regions(c.body().block(), c.ratio);
  if (regions.c * c.alpha * std::sin(c.alpha) / c.inertia > 0.9) return false;
  const double share = 2.2 * c.body().block().p * c.body().loading_time();
  if (regions.a == 0) return true;
  return regions.b - regions.a > 0.1 * regions.a && regions.c - regions.b > 3 * share * regions.c &&
         c.body().eta_error() < 0.002;
}

// --- many pulses of the floor

struct Spectrum {
  double alpha, radius, inertia = 4.0 / 3;  // [rad], [m], I_O / (M R^2)
  RockingBody body() const { return {alpha, radius, inertia}; }
};

struct Pulse {
  double cycles, ratio, strength;
  bool overturns;  // the rigid block
};

/// Those of 36 pulses that end the same with 4 % more or less: edges that deflect and rebound
/// move the boundary.
std::vector<Pulse> clear_pulses(const Spectrum& c) {
  const RockingBlock block = c.body().block();
  std::vector<Pulse> pulses;
  for (const double cycles : {0.5, 1.0})
    for (const double ratio : {2.0, 5.0, 9.0})
      for (const double strength : {1.2, 2.0, 3.0, 4.5, 6.5, 9.0}) {
        const double omega = ratio * block.p;
        const auto falls = [&](double scale) {
          RockingReference r(block);
          r.advance(
              [&](double t) { return scale * strength * block.alpha * kG * std::sin(omega * t); },
              2 * pi / omega * cycles);
          r.advance([](double) { return 0.0; }, 12 / block.p);
          return r.fallen();
        };
        const bool expected = falls(1);
        if (falls(0.96) == expected && falls(1.04) == expected)
          pulses.push_back({cycles, ratio, strength, expected});
      }
  return pulses;
}

void overturn(const Spectrum& c, Runner& runner) {
  double wrong = 0;
  for (const Pulse& p : clear_pulses(c)) {
    const Response response = shake(c.body(), p.ratio, p.strength, p.cycles, runner);
    if ((response.outcome == Outcome::kOverturned) != p.overturns) ++wrong;
  }
  runner.check("pulses that end otherwise than for the rigid block", "", wrong,
               exactly(0, "those whose end is the same with 4 % more or less"));
}

/// Eight pulses at least that overturn it, and eight that do not.
bool both_ends(const Spectrum& c) {
  const std::vector<Pulse> pulses = clear_pulses(c);
  const auto overturning =
      std::ranges::count_if(pulses, [](const Pulse& p) { return p.overturns; });
  return overturning >= 8 && std::ssize(pulses) - overturning >= 8;
}

}  // namespace

Family rocking() {
  return make_family<Rocking>(
      {"rocking", "blocks", "A block rocks freely after a half sine of the floor",
       "eta = 1 - 2 M R^2 sin(alpha)^2 / I_O; theta'' = -p^2 sin(alpha - theta), p^2 = M g R / I_O",
       "Housner 1963, Bull. Seism. Soc. Am. 53"},
      fields(FIELD(Rocking, alpha, "rad", 0.15, 0.4), FIELD(Rocking, radius, "m", 0.4, 2),
             FIELD(Rocking, inertia, "I_O over M R^2", 1.15, 1.6),
             FIELD(Rocking, ratio, "omega over p", 3, 12),
             FIELD(Rocking, strength, "a over alpha g", 1.5, 8)),
      cases(at("slender", 0.245, 0.618, 4.0 / 3, 4, 2.2),
            at("stocky", 0.322, 0.79, 4.0 / 3, 4, 2.2), at("tall", 0.25, 1.749, 1.224175, 6, 3.5),
            at("small", 0.25, 0.7, 4.0 / 3, 6, 3.5), at("very_slender", 0.2, 1, 4.0 / 3, 6, 3.5),
            at("broad", 0.33, 0.9, 1.5, 6, 3.5)),
      rock, swings);
}

Family floor_step() {
  return make_family<Steps>(
      {"floor_step", "blocks", "The floor's velocity steps once under a block",
       "overturns from V1 = (1/h) sqrt(2 g (R - h) I_O / M) on",
       "Mallet 1862, The Great Neapolitan Earthquake of 1857, part I"},
      kFields, kBlocks, one_step);
}

Family floor_double_step() {
  return make_family<Steps>(
      {"floor_double_step", "blocks", "The floor's velocity steps and steps back under a block",
       "overturns from V1 / (1 + eta) on when the second step is just after the impact",
       "Nabeshima, Taniguchi, Kojima & Takewaki 2016, Frontiers in Built Environment 2"},
      kFields, kBlocks, two_steps);
}

Family sine_pulse() {
  return make_family<Sine>(
      {"sine_pulse", "blocks", "One cycle of a sine of the floor overturns a block, or does not",
       "theta'' = -p^2 (sin(alpha s - theta) + a/g cos(alpha s - theta)), theta' -> eta theta' at "
       "impacts",
       "Housner 1963; Zhang & Makris 2001, J. Engineering Mechanics 127"},
      fields(FIELD(Sine, alpha, "rad", 0.15, 0.35), FIELD(Sine, radius, "m", 0.6, 2),
             FIELD(Sine, inertia, "I_O over M R^2", 1.15, 1.6),
             FIELD(Sine, ratio, "omega over p", 2, 9)),
      cases(at("tall_slow", 0.25, 1.749, 1.224175, 2), at("tall_4", 0.25, 1.749, 1.224175, 4),
            at("tall_5", 0.25, 1.749, 1.224175, 5), at("tall_7", 0.25, 1.749, 1.224175, 7),
            at("tall_8", 0.25, 1.749, 1.224175, 8), at("small_3", 0.25, 0.7, 4.0 / 3, 3),
            at("small_5", 0.25, 0.7, 4.0 / 3, 5.5), at("small_6", 0.25, 0.7, 4.0 / 3, 6.5),
            at("slender_4", 0.2, 1, 4.0 / 3, 4.5), at("slender_9", 0.2, 1, 4.0 / 3, 9),
            at("broad_3", 0.33, 0.9, 1.5, 3.5), at("broad_6", 0.33, 0.9, 1.5, 6)),
      find_regions, asks);
}

Family pulse_spectrum() {
  return make_family<Spectrum>(
      {"pulse_spectrum", "blocks",
       "Half sines and cycles of the floor of all strengths and lengths", "as sine_pulse",
       "Housner 1963; Zhang & Makris 2001, J. Engineering Mechanics 127"},
      fields(FIELD(Spectrum, alpha, "rad", 0.15, 0.35), FIELD(Spectrum, radius, "m", 0.6, 2),
             FIELD(Spectrum, inertia, "I_O over M R^2", 1.15, 1.6)),
      cases(at("plain", 0.245, 0.618)), overturn, both_ends);
}

}  // namespace gurney::verification
