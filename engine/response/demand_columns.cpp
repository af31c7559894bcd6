#include "engine/response/demand_columns.h"

#include <iterator>
#include <limits>

namespace gurney {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

constexpr TableColumn<Demands> kDemands[] = {
    {"peak_displacement", "m", "largest horizontal displacement relative to the floor",
     &Demands::peak_displacement},
    {"peak_displacement_x", "m", "largest |x| of the displacement", &Demands::peak_displacement_x},
    {"peak_displacement_y", "m", "largest |y| of the displacement", &Demands::peak_displacement_y},
    {"time_of_peak_displacement", "s", "time of peak_displacement",
     &Demands::time_of_peak_displacement},
    {"residual_displacement", "m", "horizontal displacement at the end",
     &Demands::residual_displacement},
    {"residual_displacement_x", "m", "x of the displacement at the end",
     &Demands::residual_displacement_x},
    {"residual_displacement_y", "m", "y of the displacement at the end",
     &Demands::residual_displacement_y},
    {"peak_velocity", "m/s", "largest horizontal velocity relative to the floor",
     &Demands::peak_velocity},
    {"path_length", "m", "length of the horizontal path", &Demands::path_length},
    {"peak_yaw", "rad", "largest |yaw| since the start, until the item overturns",
     &Demands::peak_yaw},
    {"residual_yaw", "rad", "yaw at the end, or when the item overturned", &Demands::residual_yaw},
    {"peak_tilt", "rad", "largest angle between the item's z axis and the floor normal",
     &Demands::peak_tilt},
    {"time_of_peak_tilt", "s", "time of peak_tilt", &Demands::time_of_peak_tilt},
    {"peak_normal_force", "N", "largest normal force of any wheel", &Demands::peak_normal_force},
    {"lifted_time", "s", "time during which at least one wheel is off the floor",
     &Demands::lifted_time},
    {"most_wheels_lifted", "1", "largest number of wheels off the floor at once",
     &Demands::most_wheels_lifted},
    {"time_of_overturning", "s",
     "time at which the item overturned; -1: it did not, or stands on another",
     &Demands::time_of_overturning, -1},
    {"direction_of_overturning", "rad",
     "direction in which the item overturned or toppled, from the floor's x axis; NaN: it did not",
     &Demands::direction_of_overturning, kNaN},
    {"impacts", "1", "number of impacts of the item, but for those with what stands on it",
     &Demands::impacts},
    {"largest_approach_speed", "m/s", "largest approach speed of its impacts",
     &Demands::largest_approach_speed},
    {"largest_impulse", "N s", "largest impulse of its impacts", &Demands::largest_impulse},
    {"peak_impact_force", "N", "largest force of its impacts with a stated stiffness; NaN: none",
     &Demands::peak_impact_force, kNaN},
    {"peak_slide", "m",
     "largest distance along the surface above the floor that the item stands on, until it falls; "
     "NaN: it stands on the floor",
     &Demands::peak_slide, kNaN},
    {"time_of_fall", "s",
     "time at which its centre of mass is below that surface, or has come down with it below half "
     "of its height; -1: it did not fall",
     &Demands::time_of_fall, -1},
    {"time_of_toppling", "s",
     "time at which an item that stands on another has tipped over, there or on its way down; "
     "-1: it did not",
     &Demands::time_of_toppling, -1},
    {"peak_travel", "m", "largest travel of a part on its slider; NaN: it is on none",
     &Demands::peak_travel, kNaN},
    {"residual_travel", "m", "travel at the end", &Demands::residual_travel, kNaN},
    {"peak_swing", "rad",
     "largest angle of a part on its hinge, ball joint or flexible joint; NaN: it is on none",
     &Demands::peak_swing, kNaN},
    {"residual_swing", "rad", "that angle at the end", &Demands::residual_swing, kNaN},
    {"time_of_release", "s", "when the latch of a part first let go; -1: it held, or it has none",
     &Demands::time_of_release, -1},
    {"largest_stop_speed", "m/s",
     "largest speed of a part's centre of mass as it meets a stop of its joint; NaN: it has none",
     &Demands::largest_stop_speed, kNaN},
};

constexpr TableColumn<WheelDemands> kWheelDemands[] = {
    {"peak_normal_force", "N", "largest normal force", &WheelDemands::peak_normal_force},
    {"peak_tangential_force", "N", "largest force in the plane of the floor",
     &WheelDemands::peak_tangential_force},
    {"lifted_time", "s", "total time off the floor", &WheelDemands::lifted_time},
    {"liftoffs", "1", "number of times the wheel left the floor", &WheelDemands::liftoffs},
    {"skid_distance", "m", "path of the contact patch while it slides",
     &WheelDemands::skid_distance},
    {"liftoff_before_overturning", "s",
     "when a wheel that was in the air as the item overturned had left the floor; -1: there is "
     "none",
     &WheelDemands::liftoff_before_overturning, -1},
};

constexpr TableColumn<PointDemands> kPointDemands[] = {
    {"peak_displacement", "m", "largest horizontal displacement relative to the floor",
     &PointDemands::peak_displacement},
    {"peak_absolute_acceleration", "m/s2",
     "largest absolute acceleration, all directions, outside impacts whose law is restitution",
     &PointDemands::peak_absolute_acceleration},
    {"impact_acceleration", "m/s2",
     "the same during impacts with a stated stiffness, as uncertain as that; NaN: there were none",
     &PointDemands::impact_acceleration, kNaN},
    {"numerical_acceleration", "m/s2",
     "during impacts whose law is restitution: numerical, no demand; NaN: there were none",
     &PointDemands::numerical_acceleration, kNaN},
};

// Every member has its column: study parts are written by these tables too.
static_assert(sizeof(PointDemands) == std::size(kPointDemands) * sizeof(double));
static_assert(sizeof(WheelDemands) == std::size(kWheelDemands) * sizeof(double));
static_assert(sizeof(Demands) == std::size(kDemands) * sizeof(double) + sizeof(Demands::wheels) +
                                     sizeof(Demands::points));

}  // namespace

std::span<const TableColumn<Demands>> demand_columns() { return kDemands; }
std::span<const TableColumn<WheelDemands>> wheel_demand_columns() { return kWheelDemands; }
std::span<const TableColumn<PointDemands>> point_demand_columns() { return kPointDemands; }
std::span<const TableColumn<PointDemands>> judged_point_columns() {
  return point_demand_columns().first(3);
}

}  // namespace gurney
