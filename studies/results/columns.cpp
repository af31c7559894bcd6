#include "studies/results/columns.h"

#include <iterator>
#include <limits>

namespace gurney::study {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

constexpr TableColumn<Quality> kQuality[] = {
    {"energy_closure", "1", "largest energy balance error over the energy in play",
     &Quality::energy_closure},
    {"numerical_loss", "1", "energy dissipated by the integrator over the energy in play",
     &Quality::numerical_loss},
    {"largest_residual", "1", "worst accepted momentum residual of a step over M g dt",
     &Quality::largest_residual},
    {"steps", "1", "time steps", &Quality::steps},
    {"subdivided_steps", "1", "steps cut because their solve did not converge",
     &Quality::subdivided_steps},
    {"unconverged_steps", "1", "steps accepted with a residual above the setting",
     &Quality::unconverged_steps},
    {"event_steps", "1", "extra steps that end at a located event", &Quality::event_steps},
    {"rejected_steps", "1", "steps repeated shorter because of their error",
     &Quality::rejected_steps},
    {"newton_iterations", "1", "iterations of the contact solve", &Quality::newton_iterations},
    {"collision_passes", "1", "collision passes of Bullet", &Quality::collision_passes},
    {"step_halvings", "1", "halvings of the time step for settings.peak_error",
     &Quality::step_halvings},
    {"peak_change", "1",
     "largest relative change of a judged demand by the last two of the halvings; infinite: an "
     "outcome changed",
     &Quality::peak_change},
};

constexpr TableColumn<Predictability> kPredictability[] = {
    {"amplification", "1", "largest growth of a change of the masses by 1e-9, over the run",
     &Predictability::amplification},
    {"amplification_at_peaks", "1", "the same until time_of_peaks",
     &Predictability::amplification_at_peaks},
    {"time_of_peaks", "s", "the later of the peaks of displacement and tilt, or the overturning",
     &Predictability::time_of_peaks},
    {"horizon", "s", "from when on the growth has reached 1000; NaN: never",
     &Predictability::horizon, kNaN},
    {"displacement_at_half_step", "m",
     "peak displacement with half the time step and an eighth of the tolerance; NaN: that run "
     "failed",
     [](const Predictability& p) { return p.half_step ? p.half_step->peak_displacement : kNaN; },
     kNaN},
    {"tilt_at_half_step", "rad", "peak tilt of that run",
     [](const Predictability& p) { return p.half_step ? p.half_step->peak_tilt : kNaN; }, kNaN},
};

constexpr TableColumn<SettledDemand> kSettled[] = {
    {"value", "1", "the demand, in its unit; NaN: there is none",
     [](const SettledDemand& d) { return d.number.value; }, kNaN},
    {"at_half_step", "1", "the same with half the time step and an eighth of the tolerance",
     &SettledDemand::at_half_step, kNaN},
    {"of_twin", "1", "the same with masses heavier by 1e-9", &SettledDemand::of_twin, kNaN},
    {"step_change", "1", "its relative change with half the time step; infinite: it comes or goes",
     &SettledDemand::step_change},
    {"twin_change", "1", "its relative change with masses heavier by 1e-9",
     &SettledDemand::twin_change},
    {"settled_to", "1",
     "fraction that it is settled to: 0.01, 0.02, 0.05 or 0.1; infinite: it is not",
     [](const SettledDemand& d) { return d.within(); }},
};

constexpr TableColumn<EnergyAccount> kEnergy[] = {
    {"energy_kinetic", "J", "kinetic energy relative to the floor", &EnergyAccount::kinetic},
    {"energy_gravitational", "J", "gravitational energy relative to the start",
     &EnergyAccount::gravitational},
    {"energy_elastic", "J", "stored in treads, stuck bearings, guides, blocks and cables",
     &EnergyAccount::elastic},
    {"energy_of_weights", "J", "kinetic and gravitational energy of drop weights and pulleys",
     &EnergyAccount::weight_energy},
    {"work_of_floor", "J", "work of the floor's inertia forces", &EnergyAccount::work_of_floor},
    {"work_of_forces", "J", "work of point forces and string potentiometers",
     &EnergyAccount::work_of_forces},
    {"work_of_fixtures", "J", "work of guides that hold or prescribe a motion",
     &EnergyAccount::work_of_fixtures},
    {"work_of_neighbours", "J", "work of other items in contact",
     &EnergyAccount::work_of_neighbours},
    {"loss_rolling", "J", "loss to rolling resistance", &EnergyAccount::rolling_loss},
    {"loss_sliding", "J", "loss to sliding and scrub of the contact patches",
     &EnergyAccount::sliding_loss},
    {"loss_relaxation", "J", "deflection energy that rolls out of the contact patches",
     &EnergyAccount::relaxation_loss},
    {"loss_tread", "J", "loss to damping of the treads, normal and tangential",
     &EnergyAccount::tread_loss},
    {"loss_axle", "J", "loss to axle bearings and brakes", &EnergyAccount::axle_loss},
    {"loss_swivel", "J", "loss to swivel bearings and locks", &EnergyAccount::swivel_loss},
    {"loss_damper", "J", "loss to dampers of guides, blocks and cables, and to weights that land",
     &EnergyAccount::damper_loss},
    {"loss_contact", "J", "loss in contacts other than wheels with the floor",
     &EnergyAccount::contact_loss},
    {"loss_numerical", "J", "dissipated by the integrator, from its own formula",
     &EnergyAccount::numerical_loss},
};

constexpr TableColumn<Impact> kImpact[] = {
    {"time", "s", "time of the first touch", &Impact::time},
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
     &Impact::approach_speed},
    {"impulse", "N s", "impulse of the normal force", &Impact::impulse},
    {"peak_force", "N", "largest normal force; NaN: the law is restitution, which states none",
     &Impact::peak_force, kNaN},
    {"duration", "s", "duration of the impact", &Impact::duration},
};

constexpr TableColumn<ZoneOutcome> kZone[] = {
    {"time_of_entry", "s", "when an item first entered; -1: none did", &ZoneOutcome::time_of_entry,
     -1},
    {"occupied_time", "s", "time during which an item was in the zone",
     &ZoneOutcome::occupied_time},
    {"occupied_at_end", "1", "1: an item is in the zone at the end; 0: none",
     &ZoneOutcome::occupied_at_end},
    {"least_free_width", "m", "least width of the widest free path along the zone",
     &ZoneOutcome::least_free_width},
    {"free_width_at_end", "m", "width of the widest free path along the zone at the end",
     &ZoneOutcome::free_width_at_end},
};

constexpr TableColumn<TetherOutcome> kTether[] = {
    {"time_taut", "s", "when it first got taut; -1: never", &TetherOutcome::time_taut, -1},
    {"time_broken", "s", "when it broke or unplugged; -1: it held", &TetherOutcome::time_broken,
     -1},
    {"peak_tension", "N", "largest tension", &TetherOutcome::peak_tension},
};

constexpr TableColumn<Sample> kSample[] = {
    {"yaw", "rad", "yaw since the start, not wrapped; from overturning on as it was then",
     &Sample::yaw},
    {"tilt", "rad", "angle between the item's z axis and the floor normal", &Sample::tilt},
    {"cable_tension", "N", "tension of the cables, summed over drop weights",
     &Sample::cable_tension},
    {"pull_force", "N", "sum of the point forces", &Sample::pull_force},
};

constexpr TableColumn<WheelSample> kWheelSample[] = {
    {"swivel_angle", "rad", "heading of the fork relative to the item, not wrapped",
     &WheelSample::swivel_angle},
    {"swivel_rate", "rad/s", "rate of swivel_angle", &WheelSample::swivel_rate},
    {"wheel_rate", "rad/s", "rate about the axle relative to the fork, rolling forward > 0",
     &WheelSample::wheel_rate},
    {"normal_force", "N", "normal force of the floor on the wheel", &WheelSample::normal_force},
    {"longitudinal_force", "N", "force of the floor on the wheel along its rolling direction",
     &WheelSample::longitudinal_force},
    {"lateral_force", "N", "force of the floor on the wheel along its axle, to the left",
     &WheelSample::lateral_force},
    {"scrub_torque", "N m", "torque of the floor on the wheel about the vertical",
     &WheelSample::scrub_torque},
    {"rolling_resistance", "N", "rolling-resistance torque over the wheel radius",
     &WheelSample::rolling_resistance_force},
};

// Every member has its column: study parts are written by these tables too.
static_assert(sizeof(EnergyAccount) == std::size(kEnergy) * sizeof(double));
static_assert(sizeof(std::size_t) < sizeof(double) ||
              sizeof(Quality) == std::size(kQuality) * sizeof(double));
static_assert(sizeof(TetherOutcome) == std::size(kTether) * sizeof(double));
static_assert(sizeof(ZoneOutcome) == std::size(kZone) * sizeof(double));

}  // namespace

std::span<const TableColumn<Quality>> quality_columns() { return kQuality; }
std::span<const TableColumn<Predictability>> predictability_columns() { return kPredictability; }
std::span<const TableColumn<SettledDemand>> settled_columns() { return kSettled; }
std::span<const TableColumn<EnergyAccount>> energy_columns() { return kEnergy; }
std::span<const TableColumn<Impact>> impact_columns() { return kImpact; }
std::span<const TableColumn<ZoneOutcome>> zone_columns() { return kZone; }
std::span<const TableColumn<TetherOutcome>> tether_columns() { return kTether; }
std::span<const TableColumn<Sample>> sample_columns() { return kSample; }
std::span<const TableColumn<WheelSample>> wheel_sample_columns() { return kWheelSample; }

}  // namespace gurney::study
