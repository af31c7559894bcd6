#include "studies/playback/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "engine/response/response.h"

namespace gurney::playback {
namespace {

using study::Hdf5Reader;

bool lifted(const RecordedWheel& wheel, std::size_t sample) {
  return wheel.mode[sample] == static_cast<std::uint8_t>(WheelMode::kLifted);
}

/// Time with one or more wheels off the floor; shorter landings in between are part of it.
struct Uplift {
  double from = 0, until = 0;
  std::size_t most = 0;                      ///< wheels at once
  std::vector<const RecordedWheel*> wheels;  ///< in the order in which they left

  void add(const RecordedItem& item, std::size_t sample) {
    std::size_t now = 0;
    for (const RecordedWheel& wheel : item.wheels) {
      if (!lifted(wheel, sample)) continue;
      ++now;
      if (std::ranges::find(wheels, &wheel) == wheels.end()) wheels.push_back(&wheel);
    }
    most = std::max(most, now);
  }

  std::string text() const {
    std::string names;
    for (const RecordedWheel* wheel : wheels) names += (names.empty() ? "" : ", ") + wheel->name;
    return fmt::format("{} off the floor until {:.2f} s{}: {}",
                       wheels.size() == 1 ? "a wheel" : "one or more wheels", until,
                       wheels.size() == 1 ? "" : fmt::format(", up to {} at once", most), names);
  }
};

std::vector<Uplift> uplifts_of(const RecordedItem& item, const std::vector<double>& time) {
  constexpr double kOneEvent = 0.2;  // lift-offs closer than this [s]
  std::vector<Uplift> all;
  bool before = false;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const bool now =
        std::ranges::any_of(item.wheels, [&](const auto& wheel) { return lifted(wheel, i); });
    if (before) all.back().until = time[i];
    if (now && !before && (all.empty() || time[i] - all.back().until >= kOneEvent))
      all.push_back({time[i], time[i], 0, {}});
    if (now) all.back().add(item, i);
    before = now;
  }
  return all;
}

void add_liftoffs(const RecordedRun& run, std::vector<Moment>& all) {
  for (const RecordedItem& item : run.items)
    for (const Uplift& each : uplifts_of(item, run.time))
      all.push_back({each.from, "lift-off", item.name, each.text()});
}

void add_impacts(const Hdf5Reader& file, std::vector<Moment>& all) {
  const auto items = file.strings("/events/item"), bodies = file.strings("/events/body"),
             others = file.strings("/events/other");
  const auto times = file.numbers("/events/time"), speeds = file.numbers("/events/approach_speed");
  file.require_length({"/events/item", "/events/body", "/events/other", "/events/approach_speed"},
                      times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::string body = bodies[i] == "chassis" ? "" : bodies[i] + " ";
    all.push_back({times[i], "impact", items[i],
                   fmt::format("{}hits {} with {:.2f} m/s", body,
                               others[i] == "floor" ? "the floor" : others[i], speeds[i])});
  }
}

void add_tethers(const Hdf5Reader& file, std::vector<Moment>& all) {
  const auto names = file.strings("/tethers/tether"), items = file.strings("/tethers/item");
  const auto taut = file.numbers("/tethers/time_taut"),
             broken = file.numbers("/tethers/time_broken");
  file.require_length({"/tethers/item", "/tethers/time_taut", "/tethers/time_broken"},
                      names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (taut[i] >= 0) all.push_back({taut[i], "taut", items[i], names[i] + " gets taut"});
    if (broken[i] >= 0)
      all.push_back({broken[i], "unplugged", items[i], names[i] + " breaks or unplugs"});
  }
}

void add_zones(const Hdf5Reader& file, std::vector<Moment>& all) {
  const auto names = file.strings("/zones/zone");
  const auto entries = file.numbers("/zones/time_of_entry");
  file.require_length({"/zones/time_of_entry"}, names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (entries[i] >= 0)
      all.push_back({entries[i], "zone", "",
                     names[i] + (entries[i] > 0 ? ": an item enters"
                                                : ": an item is inside from the start")});
}

void add_items(const Hdf5Reader& file, std::vector<Moment>& all) {
  constexpr double kVisible = 1e-3;  // [m]
  const auto names = file.strings("/items/item");
  const std::vector<std::string> columns{"/items/time_of_overturning", "/items/peak_displacement",
                                         "/items/time_of_peak_displacement", "/items/peak_tilt",
                                         "/items/time_of_peak_tilt"};
  file.require_length(columns, names.size());
  std::vector<std::vector<double>> of;
  for (const std::string& column : columns) of.push_back(file.numbers(column));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (of[0][i] >= 0) all.push_back({of[0][i], "overturned", names[i], "overturns"});
    if (of[1][i] >= kVisible)
      all.push_back({of[2][i], "displacement", names[i],
                     fmt::format("largest displacement, {:.0f} mm", 1000 * of[1][i])});
    if (of[3][i] >= kRadiansPerDegree && of[0][i] < 0)
      all.push_back({of[4][i], "tilt", names[i],
                     fmt::format("largest tilt, {:.1f} deg", of[3][i] / kRadiansPerDegree)});
  }
}

/// Latches that let go and items that fell: of a time of -1 none. Older files have neither.
void add_times(const Hdf5Reader& file, const std::string& column, const std::string& kind,
               const std::string& text, std::vector<Moment>& all) {
  if (!file.has(column)) return;
  const auto names = file.strings("/items/item");
  const auto times = file.numbers(column);
  file.require_length({column}, names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (times[i] >= 0) all.push_back({times[i], kind, names[i], text});
}

}  // namespace

std::vector<Moment> moments(const study::Hdf5Reader& file, const RecordedRun& run) {
  std::vector<Moment> all;
  add_liftoffs(run, all);
  add_impacts(file, all);
  add_tethers(file, all);
  add_zones(file, all);
  add_items(file, all);
  add_times(file, "/items/time_of_release", "released", "its latch lets go", all);
  add_times(file, "/items/time_of_fall", "fell", "falls from what it stood on", all);
  std::ranges::stable_sort(all, {}, &Moment::time);
  return all;
}

}  // namespace gurney::playback
