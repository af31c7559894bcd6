#include "studies/results/histories.h"

#include "studies/results/column_writer.h"
#include "studies/results/floor_histories.h"
#include "studies/results/names.h"

namespace gurney::study {
namespace {

using Items = std::vector<ItemResponse>;

/// Calls `take` for every sample of every item, in the order in which the file keeps them.
template <class Take>
void each_sample(const Items& items, Take take) {
  for (std::size_t s = 0; s < items.front().history.size(); ++s)
    for (std::size_t i = 0; i < items.size(); ++i) take(i, items[i].history.at(s));
}

/// Names of the casters or points of all items; with several items as "item/caster".
std::vector<std::string> part_names(const Scene& scene,
                                    std::vector<std::string> (*names_of)(const EquipmentModel&)) {
  const std::vector<std::string> items = item_names(scene);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (const std::string& name : names_of(scene.items[i].model))
      names.push_back(items.size() == 1 ? name : items[i] + "/" + name);
  return names;
}

template <class Vector>
void append(std::vector<double>& values, const Vector& vector) {
  values.insert(values.end(), vector.data(), vector.data() + vector.size());
}

void add_body_histories(Hdf5Writer& file, const Items& items) {
  const std::vector<std::string> scales{"/histories/time", "/histories/item"};
  const auto add_vector = [&](const char* name, const char* units, const char* meaning,
                              Vector3 Sample::*member) {
    std::vector<double> values;
    each_sample(items, [&](std::size_t, const Sample& s) { append(values, s.*member); });
    file.add({std::string("/histories/") + name,
              units,
              meaning,
              {"/histories/time", "/histories/item", "/histories/axis"}},
             values);
  };
  add_vector("displacement", "m",
             "displacement of the item's origin relative to the floor since the start",
             &Sample::displacement);
  add_vector("velocity", "m/s", "velocity of the item's origin relative to the floor",
             &Sample::velocity);
  add_vector("acceleration", "m/s2", "acceleration of the item's origin relative to the floor",
             &Sample::acceleration);
  std::vector<Sample> samples;
  std::vector<EnergyAccount> energy;
  std::vector<double> orientation;
  each_sample(items, [&](std::size_t, const Sample& s) {
    samples.push_back(s);
    energy.push_back(s.energy);
    const Quaternion& q = s.orientation;
    orientation.insert(orientation.end(), {q.w(), q.x(), q.y(), q.z()});
  });
  add_columns(file, "/histories/", sample_columns(), scales, samples);
  file.add({"/histories/orientation",
            "1",
            "unit quaternion that turns item axes to floor axes",
            {"/histories/time", "/histories/item", "/histories/component"}},
           orientation);
  add_columns(file, "/histories/", energy_columns(), scales, energy);
}

void add_wheel_histories(Hdf5Writer& file, const Scene& scene, const Items& items) {
  const std::vector<std::string> scales{"/histories/time", "/histories/wheel"};
  std::vector<WheelSample> samples;
  std::vector<std::uint8_t> modes;
  each_sample(items, [&](std::size_t item, const Sample& sample) {
    for (std::size_t i = 0; i < scene.items[item].model.casters.size(); ++i) {
      samples.push_back(sample.wheels[i]);
      modes.push_back(static_cast<std::uint8_t>(sample.wheels[i].mode));
    }
  });
  add_columns(file, "/histories/", wheel_sample_columns(), scales, samples);
  file.add({"/histories/mode", "1", "what the wheel does, coded as flag_meanings says", scales},
           modes);
  std::vector<std::uint8_t> codes;
  std::string meanings;
  for (const WheelMode mode : {WheelMode::kSticks, WheelMode::kRolls, WheelMode::kSkids,
                               WheelMode::kBraked, WheelMode::kLifted}) {
    codes.push_back(static_cast<std::uint8_t>(mode));
    meanings += (meanings.empty() ? "" : " ") + std::string(name_of(mode));
  }
  file.set_attribute("/histories/mode", "flag_values", codes);
  file.set_attribute("/histories/mode", "flag_meanings", meanings);
}

void add_point_histories(Hdf5Writer& file, const Items& items) {
  const std::vector<std::string> scales{"/histories/time", "/histories/point", "/histories/axis"};
  const auto add = [&](const char* name, const char* units, const char* meaning, auto member) {
    std::vector<double> values;
    each_sample(items, [&](std::size_t, const Sample& sample) {
      for (const PointSample& point : sample.points) append(values, point.*member);
    });
    file.add({std::string("/histories/point_") + name, units, meaning, scales}, values);
  };
  add("displacement", "m", "displacement of the point relative to the floor since the start",
      &PointSample::displacement);
  add("velocity", "m/s", "velocity of the point relative to the floor", &PointSample::velocity);
  add("absolute_acceleration", "m/s2", "absolute acceleration of the point, without gravity",
      &PointSample::absolute_acceleration);
}

}  // namespace

void add_histories(Hdf5Writer& file, const RunFacts& facts, const Response& response) {
  const Scene& scene = facts.scene;
  std::vector<double> time;
  for (const Sample& sample : response.items.front().history) time.push_back(sample.time);
  file.add_group("/histories");
  file.add_scale({"/histories/run", "1", "index of the run", {}}, std::vector<std::int64_t>{0});
  file.add_scale({"/histories/time", "s", "time, one run after the other", {}}, time);
  const auto add_names = [&](const char* name, const char* meaning,
                             const std::vector<std::string>& names) {
    file.add_scale({std::string("/histories/") + name, "1", meaning, {}}, names);
  };
  add_names("item", "name of the item", item_names(scene));
  add_names("wheel", "name of the caster; of several items: item/caster",
            part_names(scene, caster_names));
  add_names("point", "name of the marked point; of several items: item/point",
            part_names(scene, point_names));
  add_names("axis", "floor axis", {"x", "y", "z"});
  add_names("component", "component of a quaternion", {"w", "x", "y", "z"});
  std::vector<double> starts;
  for (const PlacedItem& item : scene.items)
    append(starts, Vector3(item.initial.position.x(), item.initial.position.y(), 0));
  file.add({"/histories/start",
            "m",
            "where the item's origin stands on the floor at the start",
            {"/histories/item", "/histories/axis"}},
           starts);
  file.add({"/histories/offset", "1", "first sample of the run", {"/histories/run"}},
           std::vector<std::int64_t>{0});
  file.add({"/histories/count", "1", "number of samples of the run", {"/histories/run"}},
           std::vector<std::int64_t>{static_cast<std::int64_t>(time.size())});
  add_floor_histories(file, facts.floor, time);
  add_body_histories(file, response.items);
  add_wheel_histories(file, scene, response.items);
  add_point_histories(file, response.items);
}

}  // namespace gurney::study
