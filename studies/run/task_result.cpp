#include "studies/run/task_result.h"

#include "studies/results/columns.h"
#include "studies/run/archive.h"

// Not in a nameless namespace, where the archive would not find them.
namespace gurney::study {

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
  a(s.time, s.displacement, s.velocity, s.acceleration, s.yaw, s.tilt, s.orientation,
    s.cable_tension, s.pull_force, s.points, s.energy);
  for (WheelSample& wheel : s.wheels) a(wheel);
}

template <class A>
void visit(A& a, ItemResponse& item) {
  a(item.demands, item.energy, item.stored_energy_at_start, item.history);
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
