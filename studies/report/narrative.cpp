#include "studies/report/narrative.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/units.h"
#include "studies/results/names.h"

namespace gurney::report {
namespace {

using study::UnitSystem;

/// In millimetres where no units are stated.
std::string length(double metres, const UnitSystem& units) {
  if (units.chosen()) return units.text(metres, "m");
  const double value = 1000 * metres;
  return std::abs(value) < 10 ? fmt::format("{:.2f} mm", value) : fmt::format("{:.0f} mm", value);
}

constexpr double kNothing = 5e-6;  // half of the last digit shown [m]

std::string motion(const Demands& d, const UnitSystem& units) {
  if (!(d.peak_displacement >= kNothing)) return "The item did not move. ";
  std::string text = fmt::format(
      "The item moved at most {} from its start (at {:.2f} s), at up to {}, on a path of {}. ",
      length(d.peak_displacement, units), d.time_of_peak_displacement,
      units.text(d.peak_velocity, "m/s"), units.text(d.path_length, "m"));
  if (d.peak_yaw / kRadiansPerDegree >= 0.05)
    text += fmt::format("It turned by up to {}. ", units.fixed(d.peak_yaw, "rad", 1));
  return text;
}

std::string lifting(const Demands& d, const UnitSystem& units) {
  if (d.wheels.empty())
    return fmt::format("It tilted by up to {}. ",
                       units.chosen() ? units.text(d.peak_tilt, "rad")
                                      : fmt::format("{:.2g} deg", d.peak_tilt / kRadiansPerDegree));
  if (d.most_wheels_lifted == 0) return "Every wheel stayed on the floor. ";
  return fmt::format(
      "One or more wheels were off the floor for {:.3g} s in all, up to {} at once. ",
      d.lifted_time, d.most_wheels_lifted);
}

std::string ending(const Response& response, const UnitSystem& units) {
  const Demands& d = response.items[0].demands;
  const std::string place =
      fmt::format("{} from its start, turned by {}", length(d.residual_displacement, units),
                  units.fixed(d.residual_yaw, "rad", 1));
  switch (response.outcome) {
    case Outcome::kRested:
      return fmt::format("It was at rest at {:.2f} s, {}.", response.end_time, place);
    case Outcome::kStillMoving:
      return fmt::format(
          "It STILL MOVED when the settling time was over at {:.2f} s, {}: residual "
          "values are not final.",
          response.end_time, place);
    case Outcome::kStopped:
      return fmt::format("The run stopped at {:.2f} s as asked, {}.", response.end_time, place);
    case Outcome::kOverturned:
      return fmt::format("It overturned and lay at {:.2f} s, {}.", response.end_time, place);
    case Outcome::kDiverged:
    case Outcome::kUntrusted:
      break;
  }
  return {};
}

/// How all items together ended.
std::string common_ending(const Response& response) {
  switch (response.outcome) {
    case Outcome::kRested:
      return fmt::format("All items were at rest at {:.2f} s.", response.end_time);
    case Outcome::kStillMoving:
      return fmt::format(
          "Something STILL MOVED when the settling time was over at {:.2f} s: residual values are "
          "not final.",
          response.end_time);
    case Outcome::kStopped:
      return fmt::format("The run stopped at {:.2f} s as asked.", response.end_time);
    case Outcome::kOverturned: {
      long fallen = 0;
      for (const ItemResponse& item : response.items)
        fallen += item.demands.time_of_overturning >= 0 ? 1 : 0;
      return fmt::format("{} of {} items overturned; the run ended at {:.2f} s.", fallen,
                         response.items.size(), response.end_time);
    }
    case Outcome::kDiverged:
    case Outcome::kUntrusted:
      break;
  }
  return {};
}

/// One line for each item that moved; the others in one.
std::string motions(const Response& response, const std::vector<std::string>& names,
                    const UnitSystem& units) {
  std::string text, still;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const Demands& d = response.items[i].demands;
    if (!(d.peak_displacement >= kNothing)) {
      still += (still.empty() ? "" : ", ") + names.at(i);
      continue;
    }
    text +=
        fmt::format("  {} moved at most {} (at {:.2f} s), ended {} from its start, turned by {}",
                    names.at(i), length(d.peak_displacement, units), d.time_of_peak_displacement,
                    length(d.residual_displacement, units), units.fixed(d.residual_yaw, "rad", 1));
    if (d.most_wheels_lifted > 0)
      text += fmt::format("; {} of {} wheels off the floor at once, {:.3g} s in all",
                          d.most_wheels_lifted, d.wheels.size(), d.lifted_time);
    text += "\n";
  }
  if (!still.empty()) text += fmt::format("  did not move: {}\n", still);
  return text;
}

}  // namespace

std::string narrative(const study::RunFacts& facts, const Response& response,
                      const UnitSystem& units) {
  if (is_failure(response.outcome))
    return fmt::format(
        "The run {} at {:.4g} s: {}. Its results must not be used.",
        response.outcome == Outcome::kUntrusted ? "is UNTRUSTED; it ended" : "DIVERGED",
        response.end_time, response.cause);
  const std::vector<std::string> names = study::item_names(facts.scene);
  const Demands& first = response.items[0].demands;
  std::string text =
      response.items.size() == 1
          ? motion(first, units) + lifting(first, units) + ending(response, units) + "\n"
          : common_ending(response) + "\n" + motions(response, names, units);
  text +=
      narrative_of_falls(facts, response, units) + narrative_of_impacts(response, names, units) +
      narrative_of_zones(facts, response, units) + narrative_of_tethers(facts, response, units) +
      narrative_of_trust(response, names) + narrative_of_settled(facts, response);
  text.pop_back();
  return text;
}

}  // namespace gurney::report
