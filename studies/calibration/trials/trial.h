#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.h"

/// Laboratory test of a wheeled item (docs/formats/trial_file.md). SI units.
namespace gurney::calibration {

enum class TrialKind {
  kPull,           ///< held, pulled by a constant force, let go: rolling resistance
  kStartPull,      ///< pulled ever harder until it rolls: start-up resistance
  kLockedPull,     ///< the same with wheels that cannot turn, until it slides: mu_s, mu_k
  kCrosswisePull,  ///< a pull with casters not in line: scrub and swivel friction
  kImpact,         ///< coasts against a wall: restitution
};
/// Wheels that cannot turn in a locked pull.
enum class LockedWheels { kAll, kFront, kRear };
enum class TrialUse { kCalibration, kValidation };
enum class TrialOrigin { kMeasured, kSimulated };

/// Pulled item and floor.
struct TrialSetup {
  TrialUse use = TrialUse::kCalibration;
  TrialOrigin origin = TrialOrigin::kMeasured;
  std::string caster;       ///< a name of the catalogue, a path, or a name of the laboratory
  std::string floor;        ///< the same for the floor covering
  std::string tread;        ///< material of the tread; empty: not stated
  std::string against;      ///< what an impact is against
  int wheels = 4;           ///< on the floor, >= 1
  double wheel_radius = 0;  ///< R > 0 [m]
  double mass = 0;          ///< M, all that moves with the item but the drop weight, > 0 [kg]
  double payload = 0;       ///< part of the mass, >= 0 [kg]
  double added_mass = 0;    ///< J = sum I_w / R^2, what spinning wheels add to the mass, >= 0 [kg]
  std::optional<double> drop_mass;  ///< m_d of the weight on the cable, > 0 [kg]
  double string_tension = 0;     ///< F_s of the string potentiometer against the motion, >= 0 [N]
  std::vector<double> headings;  ///< of the casters at the start, one for all or for each [rad]
  std::string item;              ///< of the catalogue, or a path; only to simulate the trial
  std::string payload_name;      ///< payload of the item; empty: none
  int payload_count = 0;
  std::vector<double> pull_point;  ///< x, y, z in item axes; empty: not stated [m]
  LockedWheels locked = LockedWheels::kAll;
  // Only for pulls with one axle locked:
  double pull_height = 0;               ///< h of the cable above the floor, >= 0 [m]
  double wheelbase = 0;                 ///< L between the axles, > 0 [m]
  double front_share = 0.5;             ///< of the weight, on the front axle at rest, (0, 1)
  double rolling_ratio = 0;             ///< Cr / R of the wheels that roll, >= 0
  std::optional<double> center_height;  ///< h_cg of M above the floor, >= 0 [m]
};

/// Samples; a series that was not measured is empty. A cell left empty is NaN.
struct TrialSignals {
  std::vector<double> time;          ///< [s]
  std::vector<double> force;         ///< of the cable, in the direction of motion [N]
  std::vector<double> displacement;  ///< in the direction of the pull [m]
  std::vector<double> lateral;       ///< to the left of it [m]
  std::vector<double> acceleration;  ///< in its direction [m/s2]
  std::vector<double> yaw;           ///< anticlockwise from above [rad]
};

struct Trial {
  std::string name;  ///< of the file, without folder and ending
  std::string file;
  TrialKind kind = TrialKind::kPull;
  TrialSetup setup;
  TrialSignals signals;
  std::vector<int> lines;  ///< of the file, one for each sample; empty where there is no file
};

/// Averages over the phases of a pull; what Xu, Ma & Kurata (2022, 5th SPONSE workshop) calculate
/// rolling resistance from. Errors are standard errors, 0 where they are not known.
struct TrialAverages {
  std::string name, file;
  int line = 0;
  TrialSetup setup;
  double pull_force = 0;          ///< F, mean over phase II [N]
  double pull_acceleration = 0;   ///< a_2 of phase II [m/s2]
  double coast_deceleration = 0;  ///< a_3 of phase III, slowing down > 0 [m/s2]
  double pull_speed = 0;          ///< mean over the part of phase II that was used [m/s]
  double coast_speed = 0;         ///< the same of phase III [m/s]
  double force_error = 0;         ///< of pull_force [N]
  double acceleration_error = 0;  ///< of pull_acceleration [m/s2]
  double deceleration_error = 0;  ///< of coast_deceleration [m/s2]
  std::optional<double> slope;    ///< d (deceleration) / d (speed) within phase III [1/s]
  double slope_error = 0;         ///< [1/s]
};

/// Why a trial cannot be used, with its place.
struct TrialFault {
  std::string file;
  int line = 0;  ///< 0: the file as a whole
  std::string reason;

  std::string text() const;  ///< `file:line: reason`
};

/// Thrown for a trial that cannot be used.
struct UnusableTrial : Error {
  explicit UnusableTrial(const TrialFault& of) : Error(of.text()), fault(of) {}
  TrialFault fault;
};

/// @param index  of the sample at fault, whose line the fault names where there is a file
/// @throws UnusableTrial
[[noreturn]] void refuse(const Trial& trial, std::size_t index, const std::string& reason);

/// Standard deviations. The motion capture of Xu, Ma & Kurata (2022, section 3.1) is accurate to
/// +-0.10 mm, which is taken as one; the noise of their load cell is not stated.
inline constexpr double kDisplacementNoise = 1e-4;  ///< [m]
inline constexpr double kForceNoise = 0.5;          ///< assumption [N]

/// The trial with normal noise on displacement, lateral displacement and force; independent from
/// sample to sample, the same for the same seed and stream.
Trial with_noise(Trial trial, std::uint64_t seed, std::uint64_t stream);

/// Rate of a series, by differences over four samples to either side, as a velocity is found from
/// measured positions; NaN at both ends.
std::vector<double> rate(const std::vector<double>& time, const std::vector<double>& series);

}  // namespace gurney::calibration
