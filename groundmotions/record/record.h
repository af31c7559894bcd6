#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/floor_motion.h"

namespace gurney::groundmotions {

/// The place of a component in a record: two horizontals at right angles and the vertical (up).
enum class Direction { kH1, kH2, kVertical };
inline constexpr std::array kDirections = {Direction::kH1, Direction::kH2, Direction::kVertical};
const char* name_of(Direction direction);  ///< "h1", "h2", "vertical"

/// One acceleration history as read from a file.
struct Component {
  std::string name;                    ///< as the file calls it: "228", "UP", "x_g"; may be empty
  double time_step = 0;                ///< > 0 [s]
  Eigen::VectorXd acceleration;        ///< at least 2 finite samples, the first at 0 s [m/s2]
  std::optional<Direction> direction;  ///< if the file itself says it
  std::optional<double> azimuth;       ///< clockwise from north, if the file says it [rad]
  std::optional<double> start_time;    ///< of the first sample, if the file says it [s since 1970]
  double scale = 1;                    ///< factor by which the samples of the file were scaled
  std::string file;                    ///< path as given
  std::string format;                  ///< name of the format that was recognised
  std::string unit;                    ///< of the numbers in the file: "g", "cm/s2", ...
  std::string sha256;                  ///< of the bytes of the file, 64 hexadecimal digits
  std::vector<std::pair<std::string, std::string>> header;  ///< facts of the header: name, value
  std::vector<std::string> warnings;

  double duration() const;  ///< from the first to the last sample [s]
};

/// One to three components of one time step and one length.
struct Record {
  std::string name;
  std::array<std::optional<Component>, 3> components;  ///< indexed by Direction; at least one
  /// Rotation of a floor about h1, h2 and the vertical, right-handed, as many samples as the components.
  std::optional<FloorRotation> rotation;
  std::vector<std::string> warnings;    ///< of the files and of their assembly
  std::vector<std::string> processing;  ///< what was done to the samples since, step by step
  /// Files besides those of the components that a floor motion was read from: path, SHA-256.
  std::vector<std::pair<std::string, std::string>> floor_files = {};

  const std::optional<Component>& operator[](Direction direction) const {
    return components[static_cast<std::size_t>(direction)];
  }
  double time_step() const;      ///< [s]; 0 without components
  Eigen::Index samples() const;  ///< 0 without components
};

/// Time steps that a record may have [s]: 1 Hz to 100 kHz. Instruments have 50 to 1000 Hz.
inline constexpr double kShortestTimeStep = 1e-5, kLongestTimeStep = 1;
inline bool is_time_step(double step) {
  return step >= kShortestTimeStep && step <= kLongestTimeStep;
}

}  // namespace gurney::groundmotions
