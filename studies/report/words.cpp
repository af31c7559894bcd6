#include "studies/report/words.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/base/units.h"

namespace gurney::report {

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

std::string towards(double direction, const study::UnitSystem& units) {
  constexpr const char* kNames[] = {"towards +x",        "between +x and +y", "towards +y",
                                    "between -x and +y", "towards -x",        "between -x and -y",
                                    "towards -y",        "between +x and -y"};
  const long octant = std::lround(direction / (45 * kRadiansPerDegree));
  const std::string angle =
      units.of("rad").name == "deg"
          ? fmt::format("{:.0f} deg", std::round(direction / kRadiansPerDegree) + 0.0)
          : units.fixed(direction, "rad", 0);
  return fmt::format("{} ({} from the x axis)", kNames[((octant % 8) + 8) % 8], angle);
}

}  // namespace gurney::report
