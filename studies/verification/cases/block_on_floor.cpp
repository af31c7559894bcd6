#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/contact/impact_law.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/wind_up.h"

// Items without casters: a rigid block on the floor that stands, slides and begins to rock. Its
// corners are springs of k down and 0.8 k along (docs/theory/impact.md).
namespace gurney::verification {
namespace {

constexpr double kTangential = 0.8, kRestitution = 0.05;

ContactConstants floor_of(double friction, double stiffness) {
  return {.stiffness = stiffness, .restitution = kRestitution, .friction = friction};
}

Response shake(const Scene& scene, const FloorMotion& floor, double duration, double step,
               Runner& runner) {
  SimulationSettings settings = blocks::run_for(duration, step, 0.1);
  settings.follow_overturning = false;
  return runner(scene, floor, settings);
}

/// A slow rise holds no shock: half a cosine in `rise`, then held.
FloorMotion rising_floor(double level, double rise, double duration) {
  return scenes::floor_motion(0.01, duration, Vector3::UnitX(), [=](double t) {
    return level * 0.5 * (1 - std::cos(std::numbers::pi * std::min(t / rise, 1.0)));
  });
}

// --- below friction

struct Standing {
  double friction, share, mass = 120, width = 0.6, height = 0.8;  // a over mu g, [kg], [m], [m]
};

void stand(const Standing& c, Runner& runner) {
  constexpr double kStiffness = 1e7, kRise = 0.5, kFall = 1.5;  // [N/m], [s], [s]
  const Scene scene =
      blocks::block(c.mass, {c.width, 0.5, c.height}, floor_of(c.friction, kStiffness));
  const double acceleration = c.share * c.friction * kG;
  const auto ramp = [](double t) {
    return 0.5 * (1 - std::cos(std::numbers::pi * std::clamp(t / kRise, 0.0, 1.0)));
  };
  const FloorMotion floor = scenes::floor_motion(0.004, 2 * kFall, Vector3::UnitX(), [&](double t) {
    return acceleration * (ramp(t) - ramp(t - kFall));
  });
  const Response response = shake(scene, floor, 2 * kFall, 0.004, runner);
  const Demands& demands = response.items[0].demands;
  const auto at = [&](double t) {
    return response.items[0]
        .history[static_cast<std::size_t>(std::lround(t / 0.1))]
        .displacement.x();
  };
  // Moments unload two corners to N. They slip where mu N is less than a quarter of the force, by
  // s, and the others hold the rest; unloaded again, all four meet in the middle, at s / 2.
  const double force = c.mass * acceleration, k = kTangential * kStiffness;
  const double least = (c.mass * kG - force * c.height / c.width) / 4;
  const double hold = std::min(c.friction * least, force / 4);
  const double deflection = (force - 2 * hold) / (2 * k), slipped = deflection - hold / k;
  // Sway and rocking are springs in series; a rise in kRise sets them swinging by 2 (pi / T w)^2.
  const double soft = 1 / (1 / (4 * k) + std::pow(c.height / c.width, 2) / (4 * kStiffness));
  const double rising = 2 * std::pow(std::numbers::pi / kRise, 2) * c.mass / soft * deflection;
  // Where corners begin to slip the rate of the others jumps, by what they had or less, x' / w.
  const double jump = std::numbers::pi / (2 * kRise) * deflection * std::sqrt(c.mass / soft);
  const double swing = rising + (slipped > 1e-12 ? jump : 0);
  // Dampers of T = x d / v0 times the tangential stiffness (docs/theory/impact.md) hold the swinging:
  // what is left of the rise relaxes with the T of the corner that carries most.
  const double most = (c.mass * kG + force * c.height / c.width) / 4;
  const double damper =
      ImpactLaw::damping_number(kRestitution) * most / kStiffness / ImpactLaw::kLeastApproach;
  const double lag = std::numbers::pi / (2 * kRise) * deflection * damper;
  const auto left = [&](double of, double time) { return of * std::exp(-time / damper); };
  const char* const rise =
      "what a rise and fall in T leave swinging, 2 (pi / (T w))^2 of it; where corners slip, pi / "
      "(2 T w) of it: their rate jumps; what the dampers still hold back, as for the creep";
  runner.check("displacement while the floor accelerates", "m", at(1.4),
               near_to(-deflection, swing + left(lag, 1.4 - kRise), rise));
  runner.check(
      "creep from 1.0 s to 1.4 s", "m", at(1.4) - at(1.0),
      near_to(0, left(lag + swing, 1 - kRise) + 1e-6 * c.mass * kG / (4 * k),
              "what the dampers, of T = x d / v0 at the corner that carries most, hold back of the "
              "rise and its swinging, and leave 0.5 s after it, exp(-0.5 s / T); a thousand times "
              "the residual of the solve, 1e-9 M g, on the corners"));
  runner.check("displacement that stays", "m", demands.residual_displacement,
               near_to(slipped / 2, swing + left(lag, kFall - kRise), rise));
  runner.check("largest displacement", "m", demands.peak_displacement,
               near_to(deflection, swing + left(lag, kFall - kRise), rise));
  runner.check("impacts", "", demands.impacts, exactly(0, "resting contact is none"));
}

/// It stays on all corners, also while it swings.
bool stands(const Standing& c) { return 2 * c.share * c.friction * c.height < 0.9 * c.width; }

// --- sliding

struct Sliding {
  double friction, acceleration;                              // [-], [g]
  double pulse = 0.3, mass = 120, width = 0.9, height = 0.3;  // [s], [kg], [m], [m]
};

void slip(const Sliding& c, Runner& runner) {
  constexpr double kStiffness = 1e8, kStep = 0.002;  // [N/m], [s]
  const Scene scene =
      blocks::block(c.mass, {c.width, 0.9, c.height}, floor_of(c.friction, kStiffness));
  const double hold = c.friction * kG, a = c.acceleration * kG, T = c.pulse;
  const double deflection = c.mass * hold / (4 * kTangential * kStiffness);
  const auto slides = [&](double acceleration, double pulse) {
    const double stop = pulse * acceleration / hold;
    return shake(scene, scenes::rectangular_pulse(acceleration, pulse), std::max(pulse, stop) + 0.2,
                 kStep, runner)
        .items[0]
        .demands;
  };
  // Relative to the floor it gains (a - mu g) T, then stops at mu g.
  const double s = (a - hold) * T * T / 2 * a / hold;
  const Demands demands = slides(a, T);
  // Corners along, and up and down under the height of the centre, are springs in series.
  const double k =
      1 / (1 / (4 * kTangential * kStiffness) + std::pow(c.height / c.width, 2) / (4 * kStiffness));
  const double late = wind_up_speed(c.mass * a, c.mass * hold, k, c.mass);
  runner.check(
      "distance", "m", demands.residual_displacement,
      near_to(s, 2 * deflection + a * kStep * kStep / 2 + late * T * a / hold,
              "the corners give back their deflection d = mu m g / (4 k_t), twice; a dt^2 / 2 of "
              "the step in which the pulse begins; the speed that winding up adds, (sqrt(f (2 F - "
              "f)) - (F - f) acos(1 - f / F)) / sqrt(k M), times T a / (mu g)"));
  runner.check("impacts", "", demands.impacts, exactly(0, "sliding contact is none"));
  // A slow rise does not push the block off: loaded at once it would swing and slide on from there.
  constexpr double kMoved = 1e-4, kRise = 0.5, kHeld = 1, kBracket = 0.002;  // [m], [s], of mu g
  const double threshold = locate(0.98 * hold, 1.02 * hold, kBracket * hold, [&](double level) {
    const FloorMotion rise = rising_floor(level, kRise, kRise + kHeld);
    return shake(scene, rise, kRise + kHeld, kStep, runner).items[0].demands.peak_displacement >
           kMoved;
  });
  runner.check(
      "acceleration from which it slides", "g", threshold / kG,
      near_to(c.friction, kBracket / 2 * c.friction + 2 * kMoved / (kG * kHeld * kHeld),
              "half of the last bracket, 0.1 %, and what it takes to slide 0.1 mm in 1 s"));
}

/// It slides, and stays on all corners when friction begins at once.
bool slides_flat(const Sliding& c) {
  return c.acceleration > 1.2 * c.friction && 2 * c.friction * c.height < 0.9 * c.width;
}

// --- uplift

struct Uplift {
  double width, height = 1.2, mass = 150;  // [m], [m], [kg]
};

void uplift(const Uplift& c, Runner& runner) {
  constexpr double kStiffness = 1e8, kRise = 1, kTilt = 1e-3;  // [N/m], [s], [rad]
  const Vector3 size(c.width, 0.6, c.height);
  const Scene scene = blocks::block(c.mass, size, floor_of(3, kStiffness));
  const double alpha = std::atan(c.width / c.height), R = 0.5 * std::hypot(c.width, c.height);
  const double about_edge = solid_box_inertia(c.mass, size)(1, 1) + c.mass * R * R;
  const double p = std::sqrt(c.mass * kG * R / about_edge), hold = 3 / p;
  const double reference = c.width / c.height;
  const auto rocks = [&](double level) {
    const FloorMotion floor = rising_floor(level * kG, kRise, kRise + hold);
    return shake(scene, floor, kRise + hold, 0.004, runner).items[0].demands.peak_tilt > kTilt;
  };
  constexpr double kBracket = 0.002;
  const double found = locate(0.98 * reference, 1.02 * reference, kBracket * reference, rocks);
  const double springs = 2 * c.mass * kG / (kStiffness * c.width);
  runner.check(
      "acceleration from which it rocks", "g", found,
      near_to(reference,
              (kBracket / 2 + springs / alpha + kTilt / (alpha * (std::cosh(3) - 1))) * reference,
              "of it: half of the last bracket, 0.1 %; the tilt of the corners' springs, 2 W / (k "
              "b), over alpha; what grows to 1 mrad in 3 / p, 1 mrad / (alpha (cosh 3 - 1))"));
}

}  // namespace

Family block_stands() {
  return make_family<Standing>(
      {"block_stands", "blocks", "The floor accelerates under a block by less than friction holds",
       "x = -m a / (4 k_t), and back; where two corners slip first, (m a - 2 mu N) / (2 k_t)",
       "statics of springs; Coulomb"},
      fields(FIELD(Standing, friction, "", 0.1, 0.8),
             FIELD(Standing, share, "a over mu g", 0.1, 0.8), FIELD(Standing, mass, "kg", 20, 400),
             FIELD(Standing, width, "m", 0.3, 1), FIELD(Standing, height, "m", 0.2, 1.5)),
      cases(at("plain", 0.4, 0.75), at("holds", 0.6, 0.4)), stand, stands);
}

Family block_slides() {
  return make_family<Sliding>(
      {"block_slides", "blocks", "The floor accelerates under a block by more than friction holds",
       "s = (a - mu g) T^2 / 2 a / (mu g); it slides from a = mu g on", "Newton and Coulomb"},
      fields(FIELD(Sliding, friction, "", 0.1, 0.7), FIELD(Sliding, acceleration, "g", 0.3, 1),
             FIELD(Sliding, pulse, "s", 0.1, 0.6), FIELD(Sliding, mass, "kg", 20, 400),
             FIELD(Sliding, width, "m", 0.3, 1.2), FIELD(Sliding, height, "m", 0.1, 1)),
      cases(at("smooth", 0.2, 0.5), at("smooth_strong", 0.2, 0.8), at("rough", 0.35, 0.5),
            at("rough_strong", 0.35, 0.8)),
      slip, slides_flat);
}

Family block_uplift() {
  return make_family<Uplift>(
      {"block_uplift", "blocks", "The floor's acceleration rises slowly until a block rocks",
       "a / g = width / height", "West's formula, Milne 1885, Trans. Seism. Soc. Japan 8"},
      fields(FIELD(Uplift, width, "m", 0.15, 0.6), FIELD(Uplift, height, "m", 0.6, 2),
             FIELD(Uplift, mass, "kg", 30, 300)),
      cases(at("slender", 0.2), at("plain", 0.3)), uplift,
      [](const Uplift& c) { return c.width < 0.6 * c.height; });
}

}  // namespace gurney::verification
