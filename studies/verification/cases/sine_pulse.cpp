#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "studies/verification/cases.h"
#include "studies/verification/cases/rocking_body.h"
#include "studies/verification/gravity.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/scenes.h"

namespace gurney::verification {
namespace {

using std::numbers::pi;

Response shake(const RockingBody& body, double ratio, double strength, double cycles,
               const Runner& runner, Findings& findings) {
  const RockingBlock block = body.block();
  const double omega = ratio * block.p, length = 2 * pi / omega * cycles;
  const FloorMotion floor = scenes::floor_motion(
      length / 1000, length, Vector3::UnitX(),
      [&](double t) { return strength * block.alpha * kG * std::sin(omega * t); });
  SimulationSettings settings = blocks::run_for(length + 12 / block.p, 0.002, 0);
  settings.follow_overturning = false;
  return runner(findings, body.scene(), floor, settings);
}

// --- the regions of one cycle

struct Sine {
  double alpha, radius, inertia, ratio;  // [rad], [m], I_O / (M R^2), omega / p
  RockingBody body() const { return {alpha, radius, inertia}; }
};

Findings find_regions(const Sine& c, const Runner& runner) {
  Findings findings;
  const RockingBody body = c.body();
  const RockingBlock block = body.block();
  const SineRegions regions(block, c.ratio);
  const auto end = [&](double strength) {
    const Response response = shake(body, c.ratio, strength, 1, runner, findings);
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
    findings.checks.push_back(
        {quantity, "alpha g", found, reference, (share + bracket / 2) * reference,
         "p times the time in which an edge takes up its load, pi/2 sqrt(M / k); how much the "
         "boundary moves with the rebound of an edge, e (1 - eta) of eta; half of the last "
         "bracket, an eighth of these"});
  };
  check("overturns without impact from", regions.c, 0, true, RockingEnd::kWithoutImpact);
  if (regions.a == 0) {
    findings.checks.push_back({"overturns at 0.6 of it", "",
                               end(0.6 * regions.c) == RockingEnd::kStands ? 0. : 1., 0, 0,
                               "no impact helps it to overturn"});
    return findings;
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
  return findings;
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

Findings overturn(const Spectrum& c, const Runner& runner) {
  Findings findings;
  double wrong = 0;
  for (const Pulse& p : clear_pulses(c)) {
    const Response response = shake(c.body(), p.ratio, p.strength, p.cycles, runner, findings);
    if ((response.outcome == Outcome::kOverturned) != p.overturns) ++wrong;
  }
  findings.checks.push_back({"pulses that end otherwise than for the rigid block", "", wrong, 0, 0,
                             "those whose end is the same with 4 % more or less"});
  return findings;
}

/// Eight pulses at least that overturn it, and eight that do not.
bool both_ends(const Spectrum& c) {
  const std::vector<Pulse> pulses = clear_pulses(c);
  const auto overturning =
      std::ranges::count_if(pulses, [](const Pulse& p) { return p.overturns; });
  return overturning >= 8 && std::ssize(pulses) - overturning >= 8;
}

}  // namespace

Family sine_pulse() {
  return make_family<Sine>(
      {"sine_pulse", "blocks", "One cycle of a sine of the floor overturns a block, or does not",
       "theta'' = -p^2 (sin(alpha s - theta) + a/g cos(alpha s - theta)), theta' -> eta theta' at "
       "impacts",
       "Housner 1963; Zhang & Makris 2001, J. Engineering Mechanics 127"},
      {{{"alpha", "rad", 0.15, 0.35}, &Sine::alpha},
       {{"radius", "m", 0.6, 2}, &Sine::radius},
       {{"inertia", "I_O over M R^2", 1.15, 1.6}, &Sine::inertia},
       {{"ratio", "omega over p", 2, 9}, &Sine::ratio}},
      {{"tall_slow", {0.25, 1.749, 1.224175, 2}},
       {"tall_4", {0.25, 1.749, 1.224175, 4}},
       {"tall_5", {0.25, 1.749, 1.224175, 5}},
       {"tall_7", {0.25, 1.749, 1.224175, 7}},
       {"tall_8", {0.25, 1.749, 1.224175, 8}},
       {"small_3", {0.25, 0.7, 4.0 / 3, 3}},
       {"small_5", {0.25, 0.7, 4.0 / 3, 5.5}},
       {"small_6", {0.25, 0.7, 4.0 / 3, 6.5}},
       {"slender_4", {0.2, 1, 4.0 / 3, 4.5}},
       {"slender_9", {0.2, 1, 4.0 / 3, 9}},
       {"broad_3", {0.33, 0.9, 1.5, 3.5}},
       {"broad_6", {0.33, 0.9, 1.5, 6}}},
      find_regions, asks);
}

Family pulse_spectrum() {
  return make_family<Spectrum>(
      {"pulse_spectrum", "blocks",
       "Half sines and cycles of the floor of all strengths and lengths", "as sine_pulse",
       "Housner 1963; Zhang & Makris 2001, J. Engineering Mechanics 127"},
      {{{"alpha", "rad", 0.15, 0.35}, &Spectrum::alpha},
       {{"radius", "m", 0.6, 2}, &Spectrum::radius},
       {{"inertia", "I_O over M R^2", 1.15, 1.6}, &Spectrum::inertia}},
      {{"plain", {0.245, 0.618}}}, overturn, both_ends);
}

}  // namespace gurney::verification
