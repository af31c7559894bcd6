#include "groundmotions/scaling/target_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "engine/base/append_all.h"
#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/synthetic/ac156.h"

namespace gurney::groundmotions {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

struct Corners {
  double soil, tb, tc, td;
};

/// Tables 3.2 and 3.3 of EN 1998-1:2004, grounds A to E.
constexpr std::array<Corners, 5> kType1 = {{{1.0, 0.15, 0.4, 2.0},
                                            {1.2, 0.15, 0.5, 2.0},
                                            {1.15, 0.20, 0.6, 2.0},
                                            {1.35, 0.20, 0.8, 2.0},
                                            {1.4, 0.15, 0.5, 2.0}}};
constexpr std::array<Corners, 5> kType2 = {{{1.0, 0.05, 0.25, 1.2},
                                            {1.35, 0.05, 0.25, 1.2},
                                            {1.5, 0.10, 0.25, 1.2},
                                            {1.8, 0.10, 0.30, 1.2},
                                            {1.6, 0.05, 0.25, 1.2}}};
/// Table 3.4; without a soil factor.
constexpr Corners kVertical = {1.0, 0.05, 0.15, 1.0};

/// The equations of table 3.1 in the commentary of NZS 1170.5: at zero period, plateau,
/// a (b / T)^0.75 up to 1.5 s, c / T up to 3 s, 3 c / T^2 beyond.
struct Shape {
  double zero, plateau, a, b, c;
};
constexpr Shape kRock = {1.0, 2.35, 1.6, 0.5, 1.05};
constexpr Shape kShallow = {1.33, 2.93, 2.0, 0.5, 1.32};
constexpr Shape kDeep = {1.12, 3.0, 2.4, 0.75, 2.14};
constexpr Shape kSoft = {1.12, 3.0, 3.0, 1.0, 3.32};
constexpr std::array<Shape, 5> kShapes = {kRock, kRock, kShallow, kDeep, kSoft};

double shape_factor(const Shape& s, double period) {
  constexpr double kPlateau = 0.1;
  if (period < kPlateau) return s.zero + (s.plateau - s.zero) * period / kPlateau;
  if (period <= 1.5) return std::min(s.plateau, s.a * std::pow(s.b / period, 0.75));
  if (period <= 3) return s.c / period;
  return 3 * s.c / (period * period);
}

/// N_max(T) of table 3.7, straight between its rows.
double largest_near_fault_factor(double period) {
  if (period <= 1.5) return 1;
  if (period <= 4) return 0.24 * period + 0.64;
  return std::min(1.72, 0.12 * period + 1.12);
}

double near_fault_factor(double period, double distance, double return_period) {
  if (return_period <= 0.75 || distance >= 20) return 1;
  const double largest = largest_near_fault_factor(period);
  return distance <= 2 ? largest : 1 + (largest - 1) * (20 - distance) / 18;
}

std::size_t letter_index(char letter, const char* what) {
  require(letter >= 'A' && letter <= 'E',
          fmt::format("{} '{}': must be A, B, C, D or E", what, letter));
  return static_cast<std::size_t>(letter - 'A');
}

using config::Range;
using config::Table;

TargetSpectrum read_asce7(Table& in) {
  const double sds = in.number("sds_g", Range::positive()) * kStandardGravity;
  const double sd1 = in.number("sd1_g", Range::positive()) * kStandardGravity;
  return asce7_spectrum(sds, sd1, in.number("tl_s", Range::positive(), 8));
}

char read_letter(Table& in, const char* key) {
  static const std::vector<std::string> kLetters = {"A", "B", "C", "D", "E"};
  return kLetters[in.choice(key, kLetters)][0];
}

TargetSpectrum read_eurocode8(Table& in) {
  Eurocode8 parameters;
  parameters.type = in.integer("type", 1, 2, 1);
  parameters.ground = read_letter(in, "ground");
  parameters.ground_acceleration = in.number("ag_g", Range::positive()) * kStandardGravity;
  parameters.damping =
      in.number("damping_ratio", Range::within(0, 1).open_below().open_above(), 0.05);
  parameters.vertical = in.boolean("vertical", false);
  return eurocode8_spectrum(parameters);
}

TargetSpectrum read_nzs1170(Table& in) {
  Nzs1170 parameters;
  parameters.site_class = read_letter(in, "site_class");
  parameters.hazard = in.number("hazard_factor", Range::positive());
  parameters.return_period = in.number("return_factor", Range::positive(), 1.0);
  parameters.fault_distance = in.number("fault_distance_km", Range::not_negative(), 1e3);
  return nzs1170_spectrum(parameters);
}

TargetSpectrum read_ac156(Table& in) {
  const double sds = in.number("sds_g", Range::positive()) * kStandardGravity;
  const double height = in.number("height_ratio", Range::within(0, 1), 1.0);
  return ac156_spectrum(sds, height, in.boolean("vertical", false));
}

TargetSpectrum read_table(Table& in) { return table_spectrum(SourceFile(target_file(in))); }

}  // namespace

std::filesystem::path target_file(Table& in) {
  return std::filesystem::path(in.document().path()).parent_path() / in.text("file");
}

double TargetSpectrum::at(double period) const {
  require(period >= shortest_period && period <= longest_period,
          fmt::format("{}: is not defined at {:g} s, only from {:g} to {:g} s", name, period,
                      shortest_period, longest_period));
  return acceleration(period);
}

TargetSpectrum asce7_spectrum(double sds, double sd1, double tl) {
  require(sds > 0 && sd1 > 0 && sd1 / sds <= tl,
          fmt::format("ASCE 7 spectrum with S_DS {:g}, S_D1 {:g} m/s2 and T_L {:g} s: both must be "
                      "> 0 and T_L at least S_D1 / S_DS",
                      sds, sd1, tl));
  const double ts = sd1 / sds, t0 = 0.2 * ts;
  return {fmt::format("ASCE 7, S_DS {:.4g} g, S_D1 {:.4g} g, T_L {:g} s", sds / kStandardGravity,
                      sd1 / kStandardGravity, tl),
          0, kNoEnd, [=](double t) {
            if (t < t0) return sds * (0.4 + 0.6 * t / t0);
            if (t <= ts) return sds;
            return t <= tl ? sd1 / t : sd1 * tl / (t * t);
          }};
}

TargetSpectrum eurocode8_spectrum(const Eurocode8& p) {
  require(p.type == 1 || p.type == 2, fmt::format("type {}: must be 1 or 2", p.type));
  const std::size_t ground = letter_index(p.ground, "ground type");
  require(p.ground_acceleration > 0 && p.damping > 0 && p.damping < 1,
          fmt::format("a_g {:g} m/s2, damping {:g}: a_g must be > 0, damping > 0 and < 1",
                      p.ground_acceleration, p.damping));
  const Corners c = p.vertical ? kVertical : (p.type == 1 ? kType1 : kType2)[ground];
  const double eta = std::max(0.55, std::sqrt(10 / (5 + 100 * p.damping)));
  const double share = !p.vertical ? 1 : p.type == 1 ? 0.9 : 0.45;
  const double level = share * p.ground_acceleration * c.soil;
  const double amplified = eta * (p.vertical ? 3.0 : 2.5);
  return {fmt::format("Eurocode 8 type {}, ground {}, a_g {:.4g} g{}", p.type, p.ground,
                      p.ground_acceleration / kStandardGravity, p.vertical ? ", vertical" : ""),
          0, 4,
          [=](double t) {
            if (t < c.tb) return level * (1 + t / c.tb * (amplified - 1));
            if (t <= c.tc) return level * amplified;
            if (t <= c.td) return level * amplified * c.tc / t;
            return level * amplified * c.tc * c.td / (t * t);
          },
          p.damping};
}

TargetSpectrum nzs1170_spectrum(const Nzs1170& p) {
  constexpr double kLargestHazard = 0.7;
  const Shape shape = kShapes[letter_index(p.site_class, "site subsoil class")];
  require(p.hazard > 0 && p.return_period > 0 && p.fault_distance >= 0,
          fmt::format("Z {:g}, R {:g}, D {:g} km: Z and R must be > 0, D >= 0", p.hazard,
                      p.return_period, p.fault_distance));
  const double level = std::min(kLargestHazard, p.hazard * p.return_period) * kStandardGravity;
  return {fmt::format("NZS 1170.5, site class {}, Z {:g}, R {:g}, D {:g} km", p.site_class,
                      p.hazard, p.return_period, p.fault_distance),
          0, kNoEnd, [=](double t) {
            return shape_factor(shape, t) * level *
                   near_fault_factor(t, p.fault_distance, p.return_period);
          }};
}

TargetSpectrum ac156_spectrum(double sds, double height_ratio, bool vertical) {
  require(sds > 0 && height_ratio >= 0 && height_ratio <= 1,
          fmt::format("AC156 spectrum with S_DS {:g} m/s2 and z/h {:g}: S_DS must be > 0, z/h in "
                      "0..1",
                      sds, height_ratio));
  const RequiredSpectrum required =
      vertical ? required_vertical(sds) : required_horizontal(sds, height_ratio);
  return {fmt::format("AC156, S_DS {:.4g} g, z/h {:g}{}", sds / kStandardGravity, height_ratio,
                      vertical ? ", vertical" : ""),
          0, 10, [=](double t) { return t == 0 ? required.rigid : required.at(1 / t); }};
}

std::optional<TargetSpectrum> read_target(Table& in, const std::vector<std::string>& others) {
  constexpr TargetSpectrum (*kReaders[])(Table&) = {read_asce7, read_eurocode8, read_nzs1170,
                                                    read_ac156, read_table};
  const std::size_t errors = in.document().errors();
  std::vector<std::string> known = {"asce7", "eurocode8", "nzs1170", "ac156", "table"};
  append_all(known, others);
  const std::size_t kind = in.choice("target", known);
  if (in.document().errors() > errors) {
    for (const std::string& key : in.keys()) in.has(key);  // of which target is not known
    return {};
  }
  try {
    TargetSpectrum target = kReaders[kind](in);
    if (in.document().errors() == errors) return target;
  } catch (const Error& error) {
    if (in.document().errors() == errors) note_target(in, error);
  }
  return {};
}

void note_target(Table& in, const Error& error) {
  const std::string what = error.what();
  if (in.has("file") && what.starts_with(target_file(in).string()))
    in.document().note(error);
  else
    in.note("target", ": " + what);
}

}  // namespace gurney::groundmotions
