#include "studies/run/task_result.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/vector.h"
#include "studies/results/columns.h"

// Not in a nameless namespace, where the archive would not find them.

/// Plain values as bytes, for files that only this program on this class of machine reads back.
/// A type T takes part by a function `template <class Archive> void visit(Archive&, T&)`, which
/// names its members once for both directions.

namespace gurney::study {

static_assert(std::endian::native == std::endian::little);

class ByteWriter {
 public:
  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    else
      visit(*this, value);
  }
  void operator()(std::string& text) {
    std::uint64_t size = text.size();
    (*this)(size);
    bytes_ += text;
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    std::uint64_t size = list.size();
    (*this)(size);
    for (T& each : list) (*this)(each);
  }
  template <class T, class U, class... More>
  void operator()(T& first, U& second, More&... more) {
    (*this)(first);
    (*this)(second, more...);
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      std::memcpy(&value, take(sizeof value).data(), sizeof value);
    else
      visit(*this, value);
  }
  void operator()(std::string& text) {
    std::uint64_t size = 0;
    (*this)(size);
    text = take(size);
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    std::uint64_t size = 0;
    (*this)(size);
    require(size <= bytes_.size(), "the bytes end too early");
    list.resize(size);
    for (T& each : list) (*this)(each);
  }
  template <class T, class U, class... More>
  void operator()(T& first, U& second, More&... more) {
    (*this)(first);
    (*this)(second, more...);
  }

  bool done() const { return bytes_.empty(); }

 private:
  std::string_view take(std::uint64_t size) {
    require(size <= bytes_.size(), "the bytes end too early");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

  std::string_view bytes_;
};

template <class Archive>
void visit(Archive& archive, Vector3& v) {
  archive(v.x(), v.y(), v.z());
}

template <class Archive>
void visit(Archive& archive, Quaternion& q) {
  archive(q.w(), q.x(), q.y(), q.z());
}

template <class A>
void visit(A& a, WheelDemands& d) {
  visit_members(a, d, wheel_demand_columns());
}

template <class A>
void visit(A& a, PointDemands& d) {
  visit_members(a, d, point_demand_columns());
}

template <class A>
void visit(A& a, Demands& d) {
  visit_members(a, d, demand_columns());
  a(d.wheels, d.points);
}

template <class A>
void visit(A& a, EnergyAccount& e) {
  visit_members(a, e, energy_columns());
}

template <class A>
void visit(A& a, WheelSample& w) {
  a(w.swivel_angle, w.swivel_rate, w.wheel_rate, w.normal_force, w.longitudinal_force,
    w.lateral_force, w.scrub_torque, w.rolling_resistance_force, w.mode);
}

template <class A>
void visit(A& a, PointSample& p) {
  a(p.displacement, p.velocity, p.absolute_acceleration);
}

template <class A>
void visit(A& a, Sample& s) {
  a(s.time, s.displacement, s.to_origin, s.velocity, s.acceleration, s.yaw, s.tilt, s.orientation,
    s.cable_tension, s.pull_force, s.points, s.energy);
  for (WheelSample& wheel : s.wheels) a(wheel);
}

template <class A>
void visit(A& a, ItemResponse& item) {
  a(item.demands, item.energy, item.stored_energy_at_start, item.tracked, item.history);
}

template <class A>
void visit(A& a, Impact& i) {
  a(i.time, i.item, i.wheel, i.body, i.other_item, i.other, i.other_body, i.point, i.normal,
    i.approach_speed, i.impulse, i.peak_force, i.duration);
}

template <class A>
void visit(A& a, ZoneOutcome& z) {
  visit_members(a, z, zone_columns());
}

template <class A>
void visit(A& a, TetherOutcome& t) {
  visit_members(a, t, tether_columns());
}

template <class A>
void visit(A& a, Quality& q) {
  visit_members(a, q, quality_columns());
}

template <class A>
void visit(A& a, Response& r) {
  a(r.outcome, r.cause, r.end_time, r.quality, r.items, r.impacts, r.zones, r.tethers);
}

template <class A>
void visit(A& a, StudyRun& run) {
  a(run.scale, run.intensity, run.pfa, run.pfv, run.until, run.warnings, run.response,
    run.at_half_step);
}

template <class A>
void visit(A& a, TaskCost& c) {
  a(c.record, c.cpu_seconds, c.attempt, c.ended);
}

void RunCounts::add(const TaskResult& result) {
  runs += result.runs.size();
  for (const StudyRun& run : result.runs) {
    failed += is_failure(run.response.outcome);
    untrusted += run.response.outcome == Outcome::kUntrusted;
    overturned += run.response.outcome == Outcome::kOverturned;
  }
}

std::string to_bytes(TaskResult& result) {
  ByteWriter writer;
  writer(result.task, result.drawn, result.runs, result.cost);
  return writer.take();
}

TaskResult task_from_bytes(std::string_view bytes) {
  ByteReader reader(bytes);
  TaskResult result;
  reader(result.task, result.drawn, result.runs, result.cost);
  require(reader.done(), "there are more bytes than an analysis case has");
  return result;
}

}  // namespace gurney::study
