#include "engine/record/joint_log.h"

#include <algorithm>
#include <cmath>

namespace gurney {

JointLog::JointLog(const Assembly& assembly, const SceneState& at_start)
    : assembly_(assembly),
      courses_(static_cast<std::size_t>(std::ranges::count_if(
          assembly.joints, [](const JointLaw& law) { return !law.tether(); }))) {
  for (std::size_t j = 0; j < courses_.size(); ++j) {
    courses_[j].peak = std::abs(courses_[j].residual = assembly.joint_motion(j, at_start));
    // Open at rest: it would bear more than it holds.
    if (assembly.joints[j].releases() && !at_start.joints[j].latched) courses_[j].released_at = 0;
  }
}

void JointLog::observe(const Stepper::Step& step) {
  for (std::size_t j : step.island->joints) {
    if (j >= courses_.size()) continue;  // a tether
    const JointState &from = step.from->joints[j], &to = step.to->joints[j];
    Course& course = courses_[j];
    course.residual = assembly_.joint_motion(j, *step.to);
    course.peak = std::max(course.peak, std::abs(course.residual));
    if (from.latched && !to.latched && course.released_at < 0)
      course.released_at = step.time + step.duration;
    const auto stops = assembly_.joints[j].approaches(to, 0);
    for (std::size_t side = 0; side < stops.size(); ++side)
      if (stops[side].compression > 0)
        course.stop_speed = std::max(course.stop_speed, to.approach[side]);
  }
}

void JointLog::finish(std::vector<ItemResponse>& items) const {
  for (std::size_t j = 0; j < courses_.size(); ++j) {
    const JointLaw& law = assembly_.joints[j];
    const Joint& joint = law.joint();
    const Course& course = courses_[j];
    Demands& demands = items[joint.part].demands;
    demands.time_of_release = course.released_at;
    if (law.has_stops()) demands.largest_stop_speed = law.arm() * course.stop_speed;
    if (joint.kind == Joint::Kind::kFixed) continue;
    const bool slides = joint.kind == Joint::Kind::kSlider;
    (slides ? demands.peak_travel : demands.peak_swing) = course.peak;
    (slides ? demands.residual_travel : demands.residual_swing) = course.residual;
  }
}

}  // namespace gurney
