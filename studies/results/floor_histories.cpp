#include "studies/results/floor_histories.h"

#include <string>

namespace gurney::study {

/// Between samples of the record the velocity is quadratic in time, so Simpson's rule
/// h / 6 (v_0 + 4 v_1/2 + v_1) is its integral but for rounding.
std::vector<Vector3> floor_displacement(const FloorMotion& floor,
                                        const std::vector<double>& times) {
  std::vector<Vector3> result;
  Vector3 displacement = Vector3::Zero();
  double now = 0;
  Eigen::Index next = 1;
  const auto move_to = [&](double time) {
    displacement += (time - now) / 6 *
                    (floor.velocity_at(now) + 4 * floor.velocity_at((now + time) / 2) +
                     floor.velocity_at(time));
    now = time;
  };
  for (const double time : times) {
    for (; next < floor.acceleration().cols(); ++next) {
      const double sample = floor.time_step() * static_cast<double>(next);
      if (sample >= time) break;
      move_to(sample);
    }
    if (time > now) move_to(time);
    result.push_back(displacement);
  }
  return result;
}

void add_floor_histories(Hdf5Writer& file, const FloorMotion& floor,
                         const std::vector<double>& times) {
  const auto add = [&](const char* name, const char* units, const char* meaning, const auto& at) {
    std::vector<double> values;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Vector3 value = at(i);
      values.insert(values.end(), value.data(), value.data() + value.size());
    }
    file.add({std::string("/histories/floor_") + name,
              units,
              meaning,
              {"/histories/time", "/histories/axis"}},
             values);
  };
  const std::vector<Vector3> displacement = floor_displacement(floor, times);
  add("displacement", "m", "displacement of the floor since the start of the record",
      [&](std::size_t i) { return displacement[i]; });
  add("velocity", "m/s", "velocity of the floor",
      [&](std::size_t i) { return floor.velocity_at(times[i]); });
  add("acceleration", "m/s2", "acceleration of the floor, without gravity",
      [&](std::size_t i) { return floor.acceleration_at(times[i]); });
}

}  // namespace gurney::study
