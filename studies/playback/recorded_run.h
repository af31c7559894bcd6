#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/vector.h"

namespace gurney::playback {

struct RecordedShape {
  std::string name;
  std::string kind;             ///< box, prism or hull, see /shapes of the results file
  std::vector<Vector3> points;  ///< in the axes of its body [m]
};

struct RecordedWheel {
  std::string name;
  Vector3 pivot = Vector3::Zero();                    ///< origin of the fork's axes, item axes [m]
  Vector3 center = Vector3::Zero();                   ///< of the wheel, fork axes [m]
  double radius = 0, width = 0;                       ///< [m]
  std::vector<double> swivel;                         ///< angle of the fork from the item [rad]
  std::vector<double> roll;                           ///< integral of the wheel's rate [rad]
  std::vector<double> normal, longitudinal, lateral;  ///< force of the floor [N]
  std::vector<std::uint8_t> mode;                     ///< WheelMode
};

struct RecordedItem {
  std::string name, model;
  std::vector<RecordedShape> boxes;  ///< item axes
  std::vector<RecordedWheel> wheels;
  Vector3 origin = Vector3::Zero();  ///< from the point whose displacement is stored, item axes [m]
  std::vector<Vector3> position;     ///< of its origin, floor axes [m]
  std::vector<Quaternion> orientation;  ///< item axes in floor axes
};

struct RecordedZone {
  std::string name;
  double center_x = 0, center_y = 0, length = 0, width = 0, angle = 0;
};

struct RecordedTether {
  std::string name, item;
  Vector3 point = Vector3::Zero(), anchor = Vector3::Zero();
  double slack_length = 0, time_broken = -1;
  std::string anchor_item = {};  ///< in whose axes the anchor is; empty: the floor's
};

/// What happened at a time of a run.
struct Moment {
  double time = 0;   ///< [s]
  std::string kind;  ///< lift-off, impact, taut, unplugged, zone, overturned, displacement, tilt
  std::string item;  ///< empty: of the room
  std::string text;
};

/// One run of a results file with full histories, as it is drawn.
struct RecordedRun {
  std::string title, record, outcome, cause;
  std::vector<double> time;  ///< [s]
  std::vector<RecordedItem> items;
  std::vector<RecordedShape> room;
  std::vector<RecordedZone> zones;
  std::vector<RecordedTether> tethers;
  /// Of the floor; empty where the file does not have them or the floor is at rest.
  std::vector<Vector3> floor_acceleration, floor_displacement;
  std::vector<Moment> moments;  ///< by time
};

/// @throws Error unless `path` is the results file of a single run, with histories
RecordedRun read_recorded_run(const std::string& path);

}  // namespace gurney::playback
