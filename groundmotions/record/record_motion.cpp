#include "groundmotions/record/record_motion.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/base/error.h"

namespace gurney::groundmotions {

FloorMotion floor_motion(const Record& record, double scale, double angle,
                         const std::vector<Direction>& use) {
  require(scale > 0 && std::isfinite(scale),
          fmt::format("the scale of a record must be positive and finite, got {}", scale));
  require(std::isfinite(angle), fmt::format("the angle of a record must be finite, got {}", angle));
  require(record.samples() > 0, fmt::format("record '{}' has no component", record.name));
  for (const Direction direction : use)
    require(record[direction].has_value(),
            fmt::format("record '{}' has no {} component", record.name, name_of(direction)));

  Eigen::Matrix3Xd own = Eigen::Matrix3Xd::Zero(3, record.samples());
  for (const Direction direction : kDirections) {
    const bool wanted = use.empty() || std::ranges::find(use, direction) != use.end();
    if (wanted && record[direction])
      own.row(static_cast<int>(direction)) = scale * record[direction]->acceleration.transpose();
  }
  Eigen::Matrix3Xd floor = own;
  floor.row(0) = std::cos(angle) * own.row(0) - std::sin(angle) * own.row(1);
  floor.row(1) = std::sin(angle) * own.row(0) + std::cos(angle) * own.row(1);
  FloorMotion motion(record.time_step(), std::move(floor), record.name);
  if (!record.rotation) return motion;
  Matrix3 turn = scale * Matrix3::Identity();
  turn.topLeftCorner<2, 2>() *= Eigen::Rotation2Dd(angle).toRotationMatrix();
  return motion.with_rotation(
      {turn * record.rotation->angle, turn * record.rotation->acceleration});
}

}  // namespace gurney::groundmotions
