#include "studies/study/results/columns.h"

#include <limits>

namespace gurney::study {
namespace {

constexpr bool kWhole = true;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

constexpr TableColumn<Demands> kDemands[] = {
    {"peak_displacement", "m", "largest horizontal displacement relative to the floor",
     [](const Demands& d) { return d.peak_displacement; }},
    {"peak_displacement_x", "m", "largest |x| of the displacement",
     [](const Demands& d) { return d.peak_displacement_x; }},
    {"peak_displacement_y", "m", "largest |y| of the displacement",
     [](const Demands& d) { return d.peak_displacement_y; }},
    {"time_of_peak_displacement", "s", "time of peak_displacement",
     [](const Demands& d) { return d.time_of_peak_displacement; }},
    {"residual_displacement", "m", "horizontal displacement at the end",
     [](const Demands& d) { return d.residual_displacement; }},
    {"residual_displacement_x", "m", "x of the displacement at the end",
     [](const Demands& d) { return d.residual_displacement_x; }},
    {"residual_displacement_y", "m", "y of the displacement at the end",
     [](const Demands& d) { return d.residual_displacement_y; }},
    {"peak_velocity", "m/s", "largest horizontal velocity relative to the floor",
     [](const Demands& d) { return d.peak_velocity; }},
    {"path_length", "m", "length of the horizontal path",
     [](const Demands& d) { return d.path_length; }},
    {"peak_yaw", "rad", "largest |yaw| since the start",
     [](const Demands& d) { return d.peak_yaw; }},
    {"residual_yaw", "rad", "yaw at the end", [](const Demands& d) { return d.residual_yaw; }},
    {"peak_tilt", "rad", "largest angle between the item's z axis and the floor normal",
     [](const Demands& d) { return d.peak_tilt; }},
    {"time_of_peak_tilt", "s", "time of peak_tilt",
     [](const Demands& d) { return d.time_of_peak_tilt; }},
    {"peak_normal_force", "N", "largest normal force of any wheel",
     [](const Demands& d) { return d.peak_normal_force; }},
    {"lifted_time", "s", "time during which at least one wheel is off the floor",
     [](const Demands& d) { return d.lifted_time; }},
    {"most_wheels_lifted", "1", "largest number of wheels off the floor at once",
     [](const Demands& d) { return double(d.most_wheels_lifted); }, kWhole},
    {"time_of_overturning", "s", "time at which the item overturned; -1: it did not",
     [](const Demands& d) { return d.time_of_overturning; }, !kWhole, -1},
    {"direction_of_overturning", "rad",
     "where the item fell to, from the floor's x axis; NaN: it did not",
     [](const Demands& d) { return d.direction_of_overturning; }, !kWhole, kNaN},
    {"impacts", "1", "number of impacts of the item",
     [](const Demands& d) { return double(d.impacts); }, kWhole},
    {"largest_approach_speed", "m/s", "largest approach speed of its impacts",
     [](const Demands& d) { return d.largest_approach_speed; }},
    {"largest_impulse", "N s", "largest impulse of its impacts",
     [](const Demands& d) { return d.largest_impulse; }},
    {"peak_impact_force", "N", "largest force of its impacts with a stated stiffness; NaN: none",
     [](const Demands& d) { return d.peak_impact_force; }, !kWhole, kNaN},
};

constexpr TableColumn<WheelDemands> kWheelDemands[] = {
    {"peak_normal_force", "N", "largest normal force",
     [](const WheelDemands& w) { return w.peak_normal_force; }},
    {"peak_tangential_force", "N", "largest force in the plane of the floor",
     [](const WheelDemands& w) { return w.peak_tangential_force; }},
    {"lifted_time", "s", "total time off the floor",
     [](const WheelDemands& w) { return w.lifted_time; }},
    {"liftoffs", "1", "number of times the wheel left the floor",
     [](const WheelDemands& w) { return double(w.liftoffs); }, kWhole},
    {"skid_distance", "m", "path of the contact patch while it slides",
     [](const WheelDemands& w) { return w.skid_distance; }},
    {"liftoff_before_overturning", "s",
     "when a wheel that was in the air as the item overturned had left the floor; -1: there is "
     "none",
     [](const WheelDemands& w) { return w.liftoff_before_overturning; }, !kWhole, -1},
};

constexpr TableColumn<PointDemands> kPointDemands[] = {
    {"peak_displacement", "m", "largest horizontal displacement relative to the floor",
     [](const PointDemands& p) { return p.peak_displacement; }},
    {"peak_absolute_acceleration", "m/s2",
     "largest absolute acceleration, all directions, outside impacts whose law is restitution",
     [](const PointDemands& p) { return p.peak_absolute_acceleration; }},
    {"impact_acceleration", "m/s2",
     "the same during impacts with a stated stiffness, as uncertain as that; NaN: there were none",
     [](const PointDemands& p) { return p.impact_acceleration; }, !kWhole, kNaN},
    {"numerical_acceleration", "m/s2",
     "during impacts whose law is restitution: numerical, no demand; NaN: there were none",
     [](const PointDemands& p) { return p.numerical_acceleration; }, !kWhole, kNaN},
};

constexpr TableColumn<Quality> kQuality[] = {
    {"energy_closure", "1", "largest closure error of the energy account over the energy in play",
     [](const Quality& q) { return q.energy_closure; }},
    {"numerical_loss", "1", "energy dissipated by the integrator over the energy in play",
     [](const Quality& q) { return q.numerical_loss; }},
    {"largest_residual", "1", "worst accepted momentum residual of a step over M g dt",
     [](const Quality& q) { return q.largest_residual; }},
    {"steps", "1", "time steps", [](const Quality& q) { return double(q.steps); }, kWhole},
    {"subdivided_steps", "1", "steps cut because their solve did not converge",
     [](const Quality& q) { return double(q.subdivided_steps); }, kWhole},
    {"unconverged_steps", "1", "steps accepted with a residual above the setting",
     [](const Quality& q) { return double(q.unconverged_steps); }, kWhole},
    {"event_steps", "1", "extra steps that end at a located event",
     [](const Quality& q) { return double(q.event_steps); }, kWhole},
    {"newton_iterations", "1", "iterations of the contact solve",
     [](const Quality& q) { return double(q.newton_iterations); }, kWhole},
    {"collision_passes", "1", "collision passes of Bullet",
     [](const Quality& q) { return double(q.collision_passes); }, kWhole},
};

constexpr TableColumn<EnergyAccount> kEnergy[] = {
    {"energy_kinetic", "J", "kinetic energy relative to the floor",
     [](const EnergyAccount& e) { return e.kinetic; }},
    {"energy_gravitational", "J", "gravitational energy relative to the start",
     [](const EnergyAccount& e) { return e.gravitational; }},
    {"energy_elastic", "J", "stored in treads, stuck bearings, guides, blocks and cables",
     [](const EnergyAccount& e) { return e.elastic; }},
    {"energy_of_weights", "J", "kinetic and gravitational energy of drop weights and pulleys",
     [](const EnergyAccount& e) { return e.weight_energy; }},
    {"work_of_floor", "J", "work of the floor's inertia forces",
     [](const EnergyAccount& e) { return e.work_of_floor; }},
    {"work_of_forces", "J", "work of point forces and string potentiometers",
     [](const EnergyAccount& e) { return e.work_of_forces; }},
    {"work_of_fixtures", "J", "work of guides that hold or prescribe a motion",
     [](const EnergyAccount& e) { return e.work_of_fixtures; }},
    {"work_of_neighbours", "J", "work of other items in contact",
     [](const EnergyAccount& e) { return e.work_of_neighbours; }},
    {"loss_rolling", "J", "loss to rolling resistance",
     [](const EnergyAccount& e) { return e.rolling_loss; }},
    {"loss_sliding", "J", "loss to sliding and scrub of the contact patches",
     [](const EnergyAccount& e) { return e.sliding_loss; }},
    {"loss_relaxation", "J", "deflection energy that rolls out of the contact patches",
     [](const EnergyAccount& e) { return e.relaxation_loss; }},
    {"loss_tread", "J", "loss to damping of the treads, normal and tangential",
     [](const EnergyAccount& e) { return e.tread_loss; }},
    {"loss_axle", "J", "loss to axle bearings and brakes",
     [](const EnergyAccount& e) { return e.axle_loss; }},
    {"loss_swivel", "J", "loss to swivel bearings and locks",
     [](const EnergyAccount& e) { return e.swivel_loss; }},
    {"loss_damper", "J", "loss to dampers of guides, blocks and cables, and to weights that land",
     [](const EnergyAccount& e) { return e.damper_loss; }},
    {"loss_contact", "J", "loss in contacts other than wheels with the floor",
     [](const EnergyAccount& e) { return e.contact_loss; }},
    {"loss_numerical", "J", "dissipated by the integrator, from its own formula",
     [](const EnergyAccount& e) { return e.numerical_loss; }},
};

constexpr TableColumn<Impact> kImpact[] = {
    {"time", "s", "time of the first touch", [](const Impact& i) { return i.time; }},
    {"point_x", "m", "x of the point touched first, floor axes",
     [](const Impact& i) { return i.point.x(); }},
    {"point_y", "m", "y of the point touched first, floor axes",
     [](const Impact& i) { return i.point.y(); }},
    {"point_z", "m", "z of the point touched first, floor axes",
     [](const Impact& i) { return i.point.z(); }},
    {"normal_x", "1", "x of the normal, towards the item",
     [](const Impact& i) { return i.normal.x(); }},
    {"normal_y", "1", "y of the normal, towards the item",
     [](const Impact& i) { return i.normal.y(); }},
    {"normal_z", "1", "z of the normal, towards the item",
     [](const Impact& i) { return i.normal.z(); }},
    {"approach_speed", "m/s", "largest approach speed of the points that came to touch",
     [](const Impact& i) { return i.approach_speed; }},
    {"impulse", "N s", "impulse of the normal force", [](const Impact& i) { return i.impulse; }},
    {"peak_force", "N", "largest normal force; NaN: the law is restitution, which states none",
     [](const Impact& i) { return i.peak_force; }, !kWhole, kNaN},
    {"duration", "s", "duration of the impact", [](const Impact& i) { return i.duration; }},
};

constexpr TableColumn<ZoneOutcome> kZone[] = {
    {"time_of_entry", "s", "when an item first entered; -1: none did",
     [](const ZoneOutcome& z) { return z.time_of_entry; }, !kWhole, -1},
    {"occupied_time", "s", "time during which an item was in the zone",
     [](const ZoneOutcome& z) { return z.occupied_time; }},
    {"occupied_at_end", "1", "1: an item is in the zone at the end; 0: none",
     [](const ZoneOutcome& z) { return z.occupied_at_end ? 1.0 : 0.0; }, kWhole},
    {"least_free_width", "m", "least width of the widest way along the zone",
     [](const ZoneOutcome& z) { return z.least_free_width; }},
    {"free_width_at_end", "m", "width of the widest way along the zone at the end",
     [](const ZoneOutcome& z) { return z.free_width_at_end; }},
};

constexpr TableColumn<TetherOutcome> kTether[] = {
    {"time_taut", "s", "when it first got taut; -1: never",
     [](const TetherOutcome& t) { return t.time_taut; }, !kWhole, -1},
    {"time_broken", "s", "when it broke or unplugged; -1: it held",
     [](const TetherOutcome& t) { return t.time_broken; }, !kWhole, -1},
    {"peak_tension", "N", "largest tension", [](const TetherOutcome& t) { return t.peak_tension; }},
};

constexpr TableColumn<Sample> kSample[] = {
    {"yaw", "rad", "yaw since the start, not wrapped", [](const Sample& s) { return s.yaw; }},
    {"tilt", "rad", "angle between the item's z axis and the floor normal",
     [](const Sample& s) { return s.tilt; }},
    {"cable_tension", "N", "tension of the cables, summed over drop weights",
     [](const Sample& s) { return s.cable_tension; }},
    {"pull_force", "N", "sum of the point forces", [](const Sample& s) { return s.pull_force; }},
};

constexpr TableColumn<WheelSample> kWheelSample[] = {
    {"swivel_angle", "rad", "heading of the fork relative to the item, not wrapped",
     [](const WheelSample& w) { return w.swivel_angle; }},
    {"swivel_rate", "rad/s", "rate of swivel_angle",
     [](const WheelSample& w) { return w.swivel_rate; }},
    {"wheel_rate", "rad/s", "rate about the axle relative to the fork, rolling forward > 0",
     [](const WheelSample& w) { return w.wheel_rate; }},
    {"normal_force", "N", "normal force of the floor on the wheel",
     [](const WheelSample& w) { return w.normal_force; }},
    {"longitudinal_force", "N", "force of the floor on the wheel along its rolling direction",
     [](const WheelSample& w) { return w.longitudinal_force; }},
    {"lateral_force", "N", "force of the floor on the wheel along its axle, to the left",
     [](const WheelSample& w) { return w.lateral_force; }},
    {"scrub_torque", "N m", "torque of the floor on the wheel about the vertical",
     [](const WheelSample& w) { return w.scrub_torque; }},
    {"rolling_resistance", "N", "rolling-resistance torque over the wheel radius",
     [](const WheelSample& w) { return w.rolling_resistance; }},
};

}  // namespace

std::span<const TableColumn<Demands>> demand_columns() { return kDemands; }
std::span<const TableColumn<WheelDemands>> wheel_demand_columns() { return kWheelDemands; }
std::span<const TableColumn<PointDemands>> point_demand_columns() { return kPointDemands; }
std::span<const TableColumn<Quality>> quality_columns() { return kQuality; }
std::span<const TableColumn<EnergyAccount>> energy_columns() { return kEnergy; }
std::span<const TableColumn<Impact>> impact_columns() { return kImpact; }
std::span<const TableColumn<ZoneOutcome>> zone_columns() { return kZone; }
std::span<const TableColumn<TetherOutcome>> tether_columns() { return kTether; }
std::span<const TableColumn<Sample>> sample_columns() { return kSample; }
std::span<const TableColumn<WheelSample>> wheel_sample_columns() { return kWheelSample; }

}  // namespace gurney::study
