#include "studies/playback/recorded_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/polygon.h"
#include "engine/base/units.h"
#include "engine/response/response.h"
#include "studies/explanation/footprint.h"
#include "studies/results/hdf5_reader.h"

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
    const bool alike = fmt::format("{:.2f}", from) == fmt::format("{:.2f}", until);
    const std::string when =
        alike ? fmt::format("for {:.2g} s", until - from) : fmt::format("until {:.2f} s", until);
    return fmt::format("{} off the floor {}{}: {}",
                       wheels.size() == 1 ? "a wheel" : "one or more wheels", when,
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

/// Items whose outline is in a zone at the first sample at or after a time; an item that was in it
/// between two samples only is not among them.
std::vector<std::string> items_in(const RecordedRun& run, const RecordedZone& zone, double time) {
  const auto at = std::ranges::lower_bound(run.time, time - 1e-9);
  std::vector<std::string> inside;
  if (at == run.time.end()) return inside;
  const auto sample = static_cast<std::size_t>(at - run.time.begin());
  Zone place;
  place.center = {zone.center_x, zone.center_y};
  place.length = zone.length;
  place.width = zone.width;
  place.angle = zone.angle;
  const Polygon area = explanation::footprint(place);
  for (const RecordedItem& item : run.items)
    if (std::ranges::any_of(item.boxes, [&](const RecordedShape& box) {
          std::vector<Vector2> points;
          for (const Vector3& point : box.points) {
            const Vector3 there = item.position[sample] + item.orientation[sample] * point;
            points.emplace_back(there.head<2>());
          }
          return explanation::overlap(convex_polygon(points), area);
        }))
      inside.push_back(item.name);
  return inside;
}

void add_zones(const Hdf5Reader& file, const RecordedRun& run, std::vector<Moment>& all) {
  const auto names = file.strings("/zones/zone");
  const auto entries = file.numbers("/zones/time_of_entry");
  file.require_length({"/zones/time_of_entry"}, names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (entries[i] >= 0) {
      const auto inside = i < run.zones.size() ? items_in(run, run.zones[i], entries[i])
                                               : std::vector<std::string>();
      const std::string who =
          inside.empty() ? "an item" : fmt::format("{}", fmt::join(inside, " and "));
      const bool one = inside.size() < 2;
      const bool later = entries[i] > 0;
      all.push_back({entries[i], "zone", "",
                     fmt::format("{}: {} {}{}", names[i], who,
                                 later ? (one ? "enters" : "enter") : (one ? "is" : "are"),
                                 later ? "" : " inside from the start")});
    }
}

/// A time of each item, -1 for never, as in older files that do not have the column.
std::vector<double> times_of_items(const Hdf5Reader& file, const std::string& column,
                                   std::size_t items) {
  if (!file.has(column)) return std::vector<double>(items, -1);
  file.require_length({column}, items);
  return file.numbers(column);
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
  const auto toppled = times_of_items(file, "/items/time_of_toppling", names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (of[0][i] >= 0) all.push_back({of[0][i], "overturned", names[i], "overturns"});
    if (of[1][i] >= kVisible)
      all.push_back({of[2][i], "displacement", names[i],
                     fmt::format("largest displacement, {:.0f} mm", 1000 * of[1][i])});
    if (of[3][i] >= kRadiansPerDegree && of[0][i] < 0 && toppled[i] < 0)
      all.push_back({of[4][i], "tilt", names[i],
                     fmt::format("largest tilt, {:.1f} deg", of[3][i] / kRadiansPerDegree)});
  }
}

/// Latches that let go and items that fell or toppled.
void add_times(const Hdf5Reader& file, const std::string& column, const std::string& kind,
               const std::string& text, std::vector<Moment>& all) {
  const auto names = file.strings("/items/item");
  const auto times = times_of_items(file, column, names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (times[i] >= 0) all.push_back({times[i], kind, names[i], text});
}

/// A history, whose samples have `width` numbers each.
class History {
 public:
  History(const Hdf5Reader& file, const std::string& name, std::size_t samples, std::size_t width)
      : values_(file.numbers("/histories/" + name)), width_(width) {
    require(values_.size() == samples * width,
            fmt::format("{}: /histories/{} is not as long as its scales", file.path(), name));
  }

  std::vector<double> series(std::size_t column) const {
    std::vector<double> result;
    for (std::size_t i = column; i < values_.size(); i += width_) result.push_back(values_[i]);
    return result;
  }

  std::vector<Vector3> vectors(std::size_t part) const {
    std::vector<Vector3> result;
    for (std::size_t i = 3 * part; i < values_.size(); i += width_)
      result.emplace_back(values_[i], values_[i + 1], values_[i + 2]);
    return result;
  }

  std::vector<Quaternion> quaternions(std::size_t part) const {
    std::vector<Quaternion> result;
    for (std::size_t i = 4 * part; i < values_.size(); i += width_)
      result.emplace_back(values_[i], values_[i + 1], values_[i + 2], values_[i + 3]);
    return result;
  }

 private:
  std::vector<double> values_;
  std::size_t width_;
};

/// Trapezoidal rule.
std::vector<double> integral(const std::vector<double>& time, const std::vector<double>& rate) {
  std::vector<double> result{0};
  for (std::size_t i = 1; i < time.size(); ++i)
    result.push_back(result.back() + (time[i] - time[i - 1]) * (rate[i] + rate[i - 1]) / 2);
  return result;
}

/// Centre, radius and width of a wheel whose shape is two rings about its axle.
RecordedWheel wheel_of(const RecordedShape& shape, const Vector3& pivot) {
  RecordedWheel wheel;
  wheel.name = shape.name;
  wheel.pivot = pivot;
  const std::size_t sides = shape.points.size() / 2;
  Vector3 ends[2] = {Vector3::Zero(), Vector3::Zero()};
  for (std::size_t i = 0; i < 2 * sides; ++i)
    ends[i / sides] += shape.points[i] / static_cast<double>(sides);
  wheel.center = (ends[0] + ends[1]) / 2;
  wheel.width = (ends[1] - ends[0]).norm();
  wheel.radius = (shape.points.front() - ends[0]).norm();
  return wheel;
}

void read_shapes(const Hdf5Reader& file, RecordedRun& run) {
  const auto items = file.strings("/shapes/item"), bodies = file.strings("/shapes/body"),
             kinds = file.strings("/shapes/kind");
  const auto first = file.numbers("/shapes/first"), count = file.numbers("/shapes/count"),
             pivots = file.numbers("/shapes/pivot"), points = file.numbers("/shapes/point");
  file.require_length({"/shapes/body", "/shapes/kind", "/shapes/first", "/shapes/count"},
                      items.size());
  require(pivots.size() == 3 * items.size(), file.path() + ": /shapes/pivot has another length");
  for (std::size_t i = 0; i < items.size(); ++i) {
    require(first[i] >= 0 && count[i] >= 4 && 3 * (first[i] + count[i]) <= double(points.size()),
            fmt::format("{}: /shapes: shape {} has points that are not there", file.path(), i));
    RecordedShape shape{bodies[i], kinds[i], {}};
    const auto from = static_cast<std::size_t>(first[i]);
    for (std::size_t k = from; k < from + static_cast<std::size_t>(count[i]); ++k)
      shape.points.emplace_back(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
    if (items[i].empty()) {
      run.room.push_back(std::move(shape));
      continue;
    }
    const auto item = std::ranges::find(run.items, items[i], &RecordedItem::name);
    require(
        item != run.items.end(),
        fmt::format("{}: /shapes names the item '{}', /histories does not", file.path(), items[i]));
    const Vector3 pivot(pivots[3 * i], pivots[3 * i + 1], pivots[3 * i + 2]);
    if (bodies[i] == "chassis") {
      item->boxes.push_back(std::move(shape));
      item->origin = pivot;
    } else {
      item->wheels.push_back(wheel_of(shape, pivot));
    }
  }
}

void read_bodies(const Hdf5Reader& file, RecordedRun& run) {
  const std::size_t samples = run.time.size(), items = run.items.size();
  const std::vector<double> start = file.numbers("/histories/start");
  require(start.size() == 3 * items, file.path() + ": /histories/start has another length");
  const History displacement(file, "displacement", samples, 3 * items);
  const History orientation(file, "orientation", samples, 4 * items);
  for (std::size_t i = 0; i < items; ++i) {
    RecordedItem& item = run.items[i];
    item.position = displacement.vectors(i);
    item.orientation = orientation.quaternions(i);
    for (std::size_t k = 0; k < samples; ++k)
      item.position[k] += Vector3(start[3 * i], start[3 * i + 1], start[3 * i + 2]) +
                          item.orientation[k] * item.origin;
  }
}

void read_wheels(const Hdf5Reader& file, RecordedRun& run) {
  const std::size_t samples = run.time.size();
  const std::size_t wheels = file.strings("/histories/wheel").size();
  const History swivel(file, "swivel_angle", samples, wheels);
  const History rate(file, "wheel_rate", samples, wheels);
  const History normal(file, "normal_force", samples, wheels);
  const History longitudinal(file, "longitudinal_force", samples, wheels);
  const History lateral(file, "lateral_force", samples, wheels);
  const History mode(file, "mode", samples, wheels);
  std::size_t column = 0;
  for (RecordedItem& item : run.items)
    for (RecordedWheel& wheel : item.wheels) {
      require(column < wheels, file.path() + ": /shapes has more wheels than /histories");
      wheel.swivel = swivel.series(column);
      wheel.roll = integral(run.time, rate.series(column));
      wheel.normal = normal.series(column);
      wheel.longitudinal = longitudinal.series(column);
      wheel.lateral = lateral.series(column);
      for (const double code : mode.series(column))
        wheel.mode.push_back(static_cast<std::uint8_t>(code));
      ++column;
    }
  require(column == wheels, file.path() + ": /histories has more wheels than /shapes");
}

void read_floor(const Hdf5Reader& file, RecordedRun& run) {
  if (!file.has("/histories/floor_acceleration")) return;
  const std::size_t samples = run.time.size();
  const auto acceleration = History(file, "floor_acceleration", samples, 3).vectors(0);
  const auto displacement = History(file, "floor_displacement", samples, 3).vectors(0);
  const auto at_rest = [](const Vector3& v) { return v.isZero(0); };
  if (std::ranges::all_of(acceleration, at_rest) && std::ranges::all_of(displacement, at_rest))
    return;
  run.floor_acceleration = acceleration;
  run.floor_displacement = displacement;
}

Vector3 vector_at(const Hdf5Reader& file, const std::string& name, std::size_t row) {
  return {file.numbers(name + "_x").at(row), file.numbers(name + "_y").at(row),
          file.numbers(name + "_z").at(row)};
}

void read_places(const Hdf5Reader& file, RecordedRun& run) {
  if (!file.has("/zones/center_x") || !file.has("/tethers/anchor_x")) return;
  const auto zones = file.strings("/zones/zone");
  const auto zone_number = [&](const char* name, std::size_t row) {
    return file.numbers(std::string("/zones/") + name).at(row);
  };
  for (std::size_t i = 0; i < zones.size(); ++i)
    run.zones.push_back({zones[i], zone_number("center_x", i), zone_number("center_y", i),
                         zone_number("length", i), zone_number("width", i),
                         zone_number("angle", i)});
  const auto tethers = file.strings("/tethers/tether"), items = file.strings("/tethers/item");
  const auto slack = file.numbers("/tethers/slack_length"),
             broken = file.numbers("/tethers/time_broken");
  file.require_length({"/tethers/item", "/tethers/slack_length", "/tethers/time_broken",
                       "/tethers/point_x", "/tethers/point_y", "/tethers/point_z",
                       "/tethers/anchor_x", "/tethers/anchor_y", "/tethers/anchor_z"},
                      tethers.size());
  std::vector<std::string> anchors(tethers.size());
  if (file.has("/tethers/anchor_item")) {
    file.require_length({"/tethers/anchor_item"}, tethers.size());
    anchors = file.strings("/tethers/anchor_item");
  }
  for (std::size_t i = 0; i < tethers.size(); ++i)
    run.tethers.push_back({tethers[i], items[i], vector_at(file, "/tethers/point", i),
                           vector_at(file, "/tethers/anchor", i), slack[i], broken[i], anchors[i]});
}

/// Samples of a run that diverged may end in what are no numbers.
std::size_t finite_samples(const RecordedRun& run) {
  std::size_t count = 0;
  const auto finite = [&](const RecordedItem& item) {
    return item.position[count].allFinite() && item.orientation[count].coeffs().allFinite();
  };
  while (count < run.time.size() && std::ranges::all_of(run.items, finite)) ++count;
  return count;
}

void cut(RecordedRun& run, std::size_t count) {
  const auto shorten = [count](auto& values) {
    if (values.size() > count) values.resize(count);
  };
  shorten(run.time);
  shorten(run.floor_acceleration);
  shorten(run.floor_displacement);
  for (RecordedItem& item : run.items) {
    shorten(item.position);
    if (item.orientation.size() > count) item.orientation.resize(count, Quaternion::Identity());
    for (RecordedWheel& wheel : item.wheels) {
      for (auto* values :
           {&wheel.swivel, &wheel.roll, &wheel.normal, &wheel.longitudinal, &wheel.lateral})
        shorten(*values);
      shorten(wheel.mode);
    }
  }
}

std::string text_or_nothing(const Hdf5Reader& file, const std::string& path) {
  const std::vector<std::string> texts = file.strings(path);
  return texts.empty() ? std::string() : texts.front();
}

/// What happened, by time: impacts, overturnings, tethers that got taut or unplugged, entries of
/// zones and peaks as the tables of the file state them; lift-offs at the samples of the histories,
/// one for each time from the first wheel that leaves the floor until all are back for 0.2 s.
std::vector<Moment> moments(const study::Hdf5Reader& file, const RecordedRun& run) {
  std::vector<Moment> all;
  add_liftoffs(run, all);
  add_impacts(file, all);
  add_tethers(file, all);
  add_zones(file, run, all);
  add_items(file, all);
  add_times(file, "/items/time_of_release", "released", "its latch lets go", all);
  add_times(file, "/items/time_of_fall", "fell", "falls from what it stood on", all);
  add_times(file, "/items/time_of_toppling", "toppled", "topples", all);
  std::ranges::stable_sort(all, {}, &Moment::time);
  return all;
}

}  // namespace

RecordedRun read_recorded_run(const std::string& path) {
  const Hdf5Reader file(path);
  const auto attributes = file.attributes();
  require(std::ranges::find(attributes, "filetype") != attributes.end() &&
              file.text_attribute("filetype") == "gurney-results",
          path + ": not the results file of a single run");
  RecordedRun run;
  run.title = file.text_attribute("title");
  run.record = text_or_nothing(file, "/runs/record");
  run.outcome = text_or_nothing(file, "/runs/outcome");
  run.cause = text_or_nothing(file, "/runs/cause");
  run.time = file.numbers("/histories/time");
  require(run.time.size() > 1,
          path + ": holds no histories; settings.history_step_s of its job is their spacing");
  const auto models = file.strings("/items/model");
  for (const std::string& name : file.strings("/histories/item")) {
    RecordedItem& item = run.items.emplace_back();
    item.name = name;
    if (run.items.size() <= models.size()) item.model = models[run.items.size() - 1];
  }
  read_shapes(file, run);
  read_bodies(file, run);
  read_wheels(file, run);
  read_floor(file, run);
  read_places(file, run);
  cut(run, finite_samples(run));
  require(!run.time.empty(), path + ": its histories hold no numbers");
  run.moments = moments(file, run);
  return run;
}

}  // namespace gurney::playback
