#include <fmt/format.h>

#include <cmath>

#include "engine/base/units.h"
#include "studies/report/summary.h"

namespace gurney {
namespace {

std::string millimetres(double metres) {
  const double value = 1000 * metres;
  return std::abs(value) < 10 ? fmt::format("{:.2f} mm", value) : fmt::format("{:.0f} mm", value);
}

std::string motion(const Demands& d) {
  constexpr double kNothing = 5e-6;  // half of the last digit shown [m]
  if (!(d.peak_displacement >= kNothing)) return "The item did not move. ";
  std::string text = fmt::format(
      "The item moved at most {} from its start (at {:.2f} s), at up to {:.3g} m/s, on a path of "
      "{:.3g} m. ",
      millimetres(d.peak_displacement), d.time_of_peak_displacement, d.peak_velocity,
      d.path_length);
  const double yaw = d.peak_yaw / kRadiansPerDegree;
  if (yaw >= 0.05) text += fmt::format("It turned by up to {:.1f} deg. ", yaw);
  return text;
}

std::string lifting(const Demands& d) {
  if (d.most_wheels_lifted == 0) return "Every wheel stayed on the floor. ";
  return fmt::format("Wheels left the floor for {:.3g} s in all, {} at once at most. ",
                     d.lifted_time, d.most_wheels_lifted);
}

std::string ending(const Response& response) {
  const Demands& d = response.items[0].demands;
  const std::string place =
      fmt::format("{} from its start, turned by {:.1f} deg", millimetres(d.residual_displacement),
                  d.residual_yaw / kRadiansPerDegree);
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
      return fmt::format("It OVERTURNED at {:.2f} s.", d.time_of_overturning);
    case Outcome::kDiverged:
      break;
  }
  return {};
}

}  // namespace

std::string story(const Response& response) {
  if (response.outcome == Outcome::kDiverged)
    return fmt::format("The run DIVERGED at {:.4g} s: {}. Its numbers must not be used.",
                       response.end_time, response.cause);
  return motion(response.items[0].demands) + lifting(response.items[0].demands) + ending(response);
}

}  // namespace gurney
