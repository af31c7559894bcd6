#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/verification/cases/slider.h"
#include "studies/verification/family.h"
#include "studies/verification/scenes/scenes.h"
#include "studies/verification/scenes/wind_up.h"

namespace gurney::verification {
namespace {

using namespace sliding;

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 1e-4, kSampling = 1e-3;  // [s]

struct Harmonic {
  double rolls, friction, amplitude, frequency;  // cart or block, mu, [g], [Hz]
};

/// Steady peak-to-peak displacement over g [s2]. With eta = mu g / A: below 1 / sqrt(1 + pi^2 / 4)
/// it always slides; else it sticks twice a cycle and slides from sin t1 = eta to its next stop.
double peak_to_peak(double friction, double amplitude, double frequency) {
  const double w = 2 * kPi * frequency, eta = friction / amplitude;
  if (eta < 1 / std::sqrt(1 + kPi * kPi / 4))
    return 2 * amplitude / (w * w) * std::sqrt(1 - std::pow(kPi * eta / 2, 2));
  const double t1 = std::asin(eta);
  const auto speed = [&](double t) { return std::cos(t) - std::cos(t1) + eta * (t - t1); };
  double low = t1 + 0.1, high = t1 + 2 * kPi;  // one stop between: speed changes sign once
  while (high - low > 1e-14 * high) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (speed(middle) < 0 ? low : high) = middle;
  }
  const double d = low - t1;
  return amplitude / (w * w) *
         std::abs(std::sin(low) - std::sin(t1) - d * std::cos(t1) + eta * d * d / 2);
}

/// Relative velocity in steady motion at t = 0. A block that always slides has, against the mean of
/// the floor's, the triangular velocity of slopes +-mu g; the floor's is -A / w cos(w t). They meet
/// at w t = acos(pi eta / 2) and half a period later. One that sticks forgets its start.
double steady_start(const Harmonic& h) {
  const double a = h.amplitude * kG, w = 2 * kPi * h.frequency;
  const double cosine = kPi * h.friction / h.amplitude / 2;
  if (cosine > 1) return a / w;
  return a / w - h.friction * kG / w * (kPi / 2 - std::acos(cosine));
}

void slip(const Harmonic& h, Runner& runner) {
  const Slider slider = make_slider(h.rolls != 0, h.friction);
  const double w = 2 * kPi * h.frequency, duration = 4 / h.frequency;
  const FloorMotion floor = scenes::floor_motion(0.001, duration, Vector3::UnitX(), [&](double t) {
    return h.amplitude * kG * std::sin(w * t);
  });
  const Response response = shake(slider, floor, scenes::run_for(duration, kStep, kSampling),
                                  slider.scale * steady_start(h), runner);
  double low = INFINITY, high = -INFINITY;
  for (const Sample& s : response.items[0].history) {
    if (s.time < duration - 1.5 / h.frequency) continue;
    low = std::min(low, s.displacement.x());
    high = std::max(high, s.displacement.x());
  }
  const double exact = slider.scale * kG * peak_to_peak(h.friction, h.amplitude, h.frequency);
  const double reversal = 2 * h.friction * kG * kStep;
  const double sampling = (h.amplitude + h.friction) * kG * kSampling * kSampling / 4;
  runner.check("steady displacement, peak to peak", "m", high - low,
               near_to(exact,
                       (reversal + slider.wind_up) / (2 * h.frequency) + sampling +
                           std::pow(w * 0.001, 2) * exact,
                       "a reversal inside a step takes the friction after it for all of it, 2 mu g "
                       "dt, and treads wind up, mu g sqrt(M/k), for half a cycle; extremes between "
                       "samples, (A + mu g) dt_s^2 / 4; the sampled sine, (w dt_f)^2"));

  const FloorMotion gentle =
      scenes::floor_motion(0.001, 5 / h.frequency, Vector3::UnitX(), [&](double t) {
        return 0.95 * h.friction * kG * std::sin(w * t) * std::min(1.0, t * h.frequency);
      });
  const Response still = shake(slider, gentle, scenes::run_for(5 / h.frequency, 0.002), 0, runner);
  const double sway = 0.95 * h.friction * kG * scenes::total_mass(slider.item) / slider.stiffness;
  runner.check("peak displacement at 0.95 of the threshold", "m",
               still.items[0].demands.peak_displacement,
               near_to(0, 2 * sway + 1e-10,
                       "sway of the treads, M a / k, at most twice; 1e-10 m for rounding"));
}

bool slides(const Harmonic& h) {
  return h.amplitude > 1.1 * h.friction && h.amplitude < 25 * h.friction;
}

struct Published {
  double friction, amplitude, frequency, displacement;  // over g [s2]
};

void published(const Published& p, Runner& runner) {
  runner.check("formula, peak to peak over g", "s2",
               peak_to_peak(p.friction, p.amplitude, p.frequency),
               near_to(p.displacement, 5.1e-7, "the digits of the independent integration"));
}

// --- one pulse
//
// Newmark 1965, Geotechnique 15:139: a floor that accelerates for a while and then keeps its speed
// leaves a block of yield acceleration mu g behind.

struct Pulse {
  double rolls, friction, amplitude, duration;  // cart or block, mu, [g], [s]
};

bool slides(const Pulse& p) {
  return p.amplitude > 1.5 * p.friction && p.amplitude < 25 * p.friction;
}

void rectangular(const Pulse& p, Runner& runner) {
  const Slider slider = make_slider(p.rolls != 0, p.friction);
  const double a = p.amplitude * kG, yield = p.friction * kG, speed = a * p.duration;
  const double exact = slider.scale * speed * speed / (2 * yield) * (1 - yield / a);
  const double mass = scenes::total_mass(slider.item);
  const double wound =
      2 * wind_up_speed(mass * a, mass * yield, slider.stiffness, mass) * speed / yield;
  const char* const terms =
      "twice the speed that winding up adds (constant_pull) lasts for the whole slide, V / (mu g); "
      "the stop inside a step, mu g dt^2; 1e-6 of it for the solve";
  for (const double step : {0.004, 0.0005}) {
    const double tolerance = wound + yield * step * step + 1e-6 * exact;
    const Response response = shake(slider, scenes::rectangular_pulse(a, p.duration),
                                    scenes::run_for(speed / yield + 1, step), 0, runner);
    const std::string how = step == 0.004 ? ", 4 ms" : ", 0.5 ms";
    runner.check("displacement left" + how, "m", response.items[0].demands.residual_displacement_x,
                 near_to(-exact, tolerance, terms));
    runner.check("peak displacement" + how, "m", response.items[0].demands.peak_displacement,
                 near_to(exact, tolerance, terms));
  }
}

/// Speed at the end of a half-sine pulse and the distance over g, of a block.
struct HalfSine {
  double speed, distance;  // over g [s], [s2]
  double start;            // [s]

  HalfSine(double mu, double a, double T) {
    const double w = std::numbers::pi / T;
    start = std::asin(mu / a) / w;
    const double left = T - start;
    speed = a / w * (std::cos(w * start) + 1) - mu * left;
    distance = a / w * left * std::cos(w * start) + a / (w * w) * std::sin(w * start) -
               mu * left * left / 2 + speed * speed / (2 * mu);
  }
};

void half_sine(const Pulse& p, Runner& runner) {
  constexpr double kPulseStep = 0.001;
  const Slider slider = make_slider(p.rolls != 0, p.friction);
  const double a = p.amplitude * kG, yield = p.friction * kG, T = p.duration;
  const HalfSine exact(p.friction, p.amplitude, T);
  const FloorMotion floor = scenes::floor_motion(T / 1000, T, Vector3::UnitX(), [&](double t) {
    return a * std::sin(std::numbers::pi * t / T);
  });
  const double slide = exact.speed * kG / yield + T;
  const Response response = shake(slider, floor, scenes::run_for(slide + 1, kPulseStep), 0, runner);
  const double distance = slider.scale * kG * exact.distance;
  // Half of what the floor gains in a step at the start, a w dt^2.
  const double started = a * std::numbers::pi / T * kPulseStep * kPulseStep / 2;
  const double sampled = std::pow(std::numbers::pi / 1000, 2) / 12;
  runner.check(
      "displacement left", "m", response.items[0].demands.residual_displacement_x,
      near_to(-distance,
              (started + slider.wind_up) * slide + 4 * sampled * distance +
                  yield * kPulseStep * kPulseStep,
              "start inside a step, a (pi/T) dt^2 / 2, and wind-up, mu g sqrt(M/k), last for the "
              "slide; the sampled sine has (pi/1000)^2 / 12 less area, 4 times that of the "
              "distance; mu g dt^2 at the stop"));
}

bool slides_on(const Pulse& p) {
  return slides(p) && HalfSine(p.friction, p.amplitude, p.duration).speed > 0;
}

struct PublishedPulse {
  double friction, amplitude, duration, distance;  // [g], [s], over g [s2]
};

void published(const PublishedPulse& p, Runner& runner) {
  runner.check("formula, distance over g", "s2",
               HalfSine(p.friction, p.amplitude, p.duration).distance,
               near_to(p.distance, 5.1e-8, "the digits of the independent integration"));
}

std::vector<Field<Pulse>> pulse_fields(double longest) {
  return {FIELD(Pulse, rolls, "0 block, 1 cart", 0, 1, true),
          FIELD(Pulse, friction, "mu or Cr/R", 0.02, 0.4), FIELD(Pulse, amplitude, "g", 0.1, 0.8),
          FIELD(Pulse, duration, "s", 0.1, longest)};
}

// --- many cycles from rest

constexpr double kDefaultStep = 0.004, kFloorStep = 0.001, kCycles = 30;  // [s], [s], [-]

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

/// Acceleration of the floor at the reversals of steady sliding, a_r = sqrt(a^2 - (pi mu g / 2)^2) [g].
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

void slip(const FromRest& c, Runner& runner) {
  const Slider slider = make_slider(c.rolls != 0, c.friction, c.stiffness);
  const double w = 2 * kPi * c.frequency, duration = kCycles / c.frequency;
  const FloorMotion floor =
      scenes::floor_motion(kFloorStep, duration, Vector3::UnitX(),
                           [&](double t) { return c.amplitude * kG * std::sin(w * t); });
  const Response response =
      shake(slider, floor, scenes::run_for(duration, kDefaultStep, 5 * kDefaultStep), 0, runner);
  // A reversal is located but for 1e-3 of a step, with friction of the wrong sign in it. A step
  // that is longer than the swing of the treads takes it to be anything up to twice as long: evenly
  // spread errors of sigma = 2 swing / sqrt(12), 2 n of them.
  const double swung = swing(c, slider), located = 2 * c.friction * kG * 1e-3 * kDefaultStep;
  const bool resolved =
      kDefaultStep < std::sqrt(scenes::total_mass(slider.item) / slider.stiffness);
  const double reversals = 2 * kCycles;
  const double spread = resolved ? 0 : 3 * std::sqrt(reversals / 3) * swung;
  const double sampled = std::pow(w * kFloorStep, 2) / 12 * c.amplitude * kG / (w * w) * kCycles;
  const double slides_on = memory(c) * (swung + spread + reversals * located);
  // A sticking item forgets its velocity; each stop is off by the deflection of the treads. It starts
  // inside a step, in which it gains up to a w dt^2 / 2: evenly spread, sigma = that over sqrt(12).
  const double deflection = slider.wind_up * slider.wind_up / (c.friction * kG);
  const double start =
      3 * std::sqrt(reversals / 12) * c.amplitude * kG * w * kDefaultStep * kDefaultStep / 2;
  const double stops = reversals * deflection + (reversals * located + start) / (2 * c.frequency);
  const double tolerance = (sticks(c) ? stops : slides_on) + sampled;
  RigidBlock exact(c.amplitude * kG, c.friction * kG, w);
  Track track(
      "displacement", "m",
      "a velocity error lasts for (a_r + mu g) / (4 mu g f): the swing of the treads at a "
      "reversal, s; 3 sqrt(2 n / 3) s where the step does not resolve it, for n cycles; 2 n times "
      "2 mu g 1e-3 dt, to which a reversal is located; where it sticks 2 n times the deflection of "
      "the treads, mu M g / k, and, for half a cycle, the latter and 3 sqrt(2 n / 12) a w dt^2 / "
      "2, of starts inside a step; the sampled sine, (w dt_f)^2 / 12 of a / w^2 in each cycle");
  for (const Sample& s : response.items[0].history)
    track.add(s.time, s.displacement.x(), slider.scale * exact.displacement(s.time), tolerance);
  runner.report(track);
}

bool slides(const FromRest& c) {
  return c.amplitude > 1.1 * c.friction && c.amplitude < 25 * c.friction;
}

}  // namespace

Family harmonic_slip() {
  return make_family<Harmonic>(
      {"harmonic_slip", "sliding", "Sliding on a floor that swings harmonically",
       "eta = mu g / A < 1/sqrt(1 + pi^2/4): (2 A/w^2) sqrt(1 - (pi eta/2)^2), else stick and slip "
       "from sin t1 = eta to the next stop; a cart with mu = Cr/R: times M / (M + J)",
       "Westermo & Udwadia 1983, Earthquake Eng. Struct. Dyn. 11:135; Shao & Tung 1999"},
      fields(FIELD(Harmonic, rolls, "0 block, 1 cart", 0, 1, true),
             FIELD(Harmonic, friction, "mu or Cr/R", 0.02, 0.5),
             FIELD(Harmonic, amplitude, "g", 0.1, 0.8), FIELD(Harmonic, frequency, "Hz", 0.4, 3)),
      cases(at("block_slippery", 0, 0.03, 0.5, 1), at("block_near_stick", 0, 0.3, 0.4, 1),
            at("block_stick", 0, 0.3, 0.5, 1), at("block_2_Hz", 0, 0.15, 0.5, 2),
            at("block_half_Hz", 0, 0.1, 0.25, 0.5), at("block_rough", 0, 0.5, 0.6, 1),
            at("cart_slippery", 1, 0.03, 0.5, 1), at("cart_near_stick", 1, 0.3, 0.4, 1),
            at("cart_stick", 1, 0.3, 0.5, 1), at("cart_2_Hz", 1, 0.15, 0.5, 2),
            at("cart_half_Hz", 1, 0.1, 0.25, 0.5), at("cart_rough", 1, 0.5, 0.6, 1)),
      slip, slides);
}

Family harmonic_slip_formula() {
  return never_drawn(make_family<Published>(
      {"harmonic_slip_formula", "sliding", "The formula of harmonic_slip gives known numbers",
       "as harmonic_slip", "an independent integration with a high resolution"},
      fields(FIELD(Published, friction, "mu", 0, 1), FIELD(Published, amplitude, "g", 0, 1),
             FIELD(Published, frequency, "Hz", 1, 1), FIELD(Published, displacement, "s2", 0, 1)),
      cases(at("slippery", 0.03, 0.5, 1, 0.0252171), at("near_stick", 0.3, 0.4, 1, 0.0030071),
            at("stick", 0.3, 0.5, 1, 0.0099847), at("rough", 0.5, 0.6, 1, 0.0019674)),
      published));
}

Family rectangular_pulse() {
  return make_family<Pulse>(
      {"rectangular_pulse", "sliding", "Sliding after one rectangular pulse of the floor",
       "D = V^2 / (2 mu g) (1 - mu g / A), V = A t0; a cart: times M / (M + J)",
       "Newmark 1965, Geotechnique 15:139"},
      pulse_fields(0.6),
      cases(at("block", 0, 0.1, 0.5, 0.3), at("block_slippery", 0, 0.03, 0.4, 0.25),
            at("block_odd_duration", 0, 0.2, 0.35, 0.415),  // no whole number of steps
            at("block_weak", 0, 0.02, 0.1, 0.5), at("cart", 1, 0.1, 0.5, 0.3),
            at("cart_slippery", 1, 0.03, 0.4, 0.25), at("cart_odd_duration", 1, 0.2, 0.35, 0.415),
            at("cart_weak", 1, 0.02, 0.1, 0.5)),
      rectangular, slides);
}

Family half_sine_pulse() {
  return make_family<Pulse>(
      {"half_sine_pulse", "sliding", "Sliding after one half-sine pulse of the floor",
       "starts at sin(w t1) = mu g / a, has v = a/w (cos(w t1) + 1) - mu g (T - t1) at its end and "
       "slides on for v^2 / (2 mu g); a cart: times M / (M + J)",
       "Newmark 1965, Geotechnique 15:139, integrated"},
      pulse_fields(1),
      cases(at("block", 0, 0.05, 0.5, 0.5), at("block_short", 0, 0.3, 0.8, 0.3),
            at("block_long", 0, 0.02, 0.2, 1), at("cart", 1, 0.05, 0.5, 0.5),
            at("cart_short", 1, 0.3, 0.8, 0.3), at("cart_long", 1, 0.02, 0.2, 1)),
      half_sine, slides_on);
}

Family half_sine_pulse_formula() {
  return never_drawn(make_family<PublishedPulse>(
      {"half_sine_pulse_formula", "sliding", "The formula of half_sine_pulse gives a known number",
       "as half_sine_pulse", "an independent integration with a high resolution"},
      fields(
          FIELD(PublishedPulse, friction, "mu", 0, 1), FIELD(PublishedPulse, amplitude, "g", 0, 1),
          FIELD(PublishedPulse, duration, "s", 0, 1), FIELD(PublishedPulse, distance, "s2", 0, 1)),
      cases(at("plain", 0.05, 0.5, 0.5, 0.21478124)), published));
}

Family slip_from_rest() {
  return make_family<FromRest>(
      {"slip_from_rest", "sliding", "Thirty cycles of sliding from rest, at the default step",
       "x'' = -a sin(w t) - mu g sign(x') from event to event; a cart with mu = Cr/R: times M / (M "
       "+ J)",
       "Coulomb's law, integrated exactly between events"},
      fields(FIELD(FromRest, rolls, "0 block, 1 cart", 0, 1, true),
             FIELD(FromRest, friction, "mu or Cr/R", 0.02, 0.5),
             FIELD(FromRest, amplitude, "g", 0.1, 0.8), FIELD(FromRest, frequency, "Hz", 0.4, 3),
             FIELD(FromRest, stiffness, "N/m, each tread", 1e6, 1e9)),
      cases(at("block_1e6", 0, 0.1, 0.3, 1, 1e6), at("block_1e8", 0, 0.1, 0.3, 1, 1e8),
            at("block_1e9", 0, 0.1, 0.3, 1, 1e9), at("block_sticks", 0, 0.3, 0.5, 1, 1e8),
            at("block_2_Hz", 0, 0.15, 0.5, 2, 1e8), at("cart_1e8", 1, 0.1, 0.3, 1, 1e8),
            at("cart_1e9", 1, 0.1, 0.3, 1, 1e9)),
      slip, slides);
}

}  // namespace gurney::verification
