#include "studies/study/run/unit_result.h"

#include "studies/study/run/archive.h"

// Not in a nameless namespace, where the archive would not find them.
namespace gurney::study {

template <class A>
void visit(A& a, WheelDemands& d) {
  a(d.peak_normal_force, d.peak_tangential_force, d.lifted_time, d.liftoffs, d.skid_distance,
    d.liftoff_before_overturning);
}

template <class A>
void visit(A& a, PointDemands& d) {
  a(d.peak_displacement, d.peak_absolute_acceleration, d.impact_acceleration,
    d.numerical_acceleration);
}

template <class A>
void visit(A& a, Demands& d) {
  a(d.peak_displacement, d.peak_displacement_x, d.peak_displacement_y, d.time_of_peak_displacement,
    d.residual_displacement, d.residual_displacement_x, d.residual_displacement_y, d.peak_velocity,
    d.path_length, d.peak_yaw, d.residual_yaw, d.peak_tilt, d.time_of_peak_tilt,
    d.peak_normal_force, d.lifted_time, d.most_wheels_lifted, d.time_of_overturning,
    d.direction_of_overturning, d.impacts, d.largest_approach_speed, d.largest_impulse,
    d.peak_impact_force, d.wheels, d.points);
}

template <class A>
void visit(A& a, EnergyAccount& e) {
  a(e.kinetic, e.gravitational, e.elastic, e.weight_energy, e.work_of_floor, e.work_of_forces,
    e.work_of_fixtures, e.work_of_neighbours, e.rolling_loss, e.sliding_loss, e.relaxation_loss,
    e.tread_loss, e.axle_loss, e.swivel_loss, e.damper_loss, e.contact_loss, e.numerical_loss);
}

template <class A>
void visit(A& a, WheelSample& w) {
  a(w.swivel_angle, w.swivel_rate, w.wheel_rate, w.normal_force, w.longitudinal_force,
    w.lateral_force, w.scrub_torque, w.rolling_resistance, w.mode);
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
  a(z.time_of_entry, z.occupied_time, z.occupied_at_end, z.least_free_width, z.free_width_at_end);
}

template <class A>
void visit(A& a, TetherOutcome& t) {
  a(t.time_taut, t.time_broken, t.peak_tension);
}

template <class A>
void visit(A& a, Quality& q) {
  a(q.energy_closure, q.numerical_loss, q.largest_residual, q.steps, q.subdivided_steps,
    q.unconverged_steps, q.event_steps, q.newton_iterations, q.collision_passes);
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

std::string to_bytes(UnitResult& result) {
  ByteWriter writer;
  writer(result.unit, result.drawn, result.runs);
  return writer.take();
}

UnitResult unit_from_bytes(std::string_view bytes) {
  ByteReader reader(bytes);
  UnitResult result;
  reader(result.unit, result.drawn, result.runs);
  require(reader.done(), "there are more bytes than a unit has");
  return result;
}

}  // namespace gurney::study
