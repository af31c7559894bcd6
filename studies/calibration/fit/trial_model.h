#pragma once

#include "engine/scene/equipment_model.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"
#include "studies/calibration/trials/phases.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// A pull repeated with the engine under the force that was measured.
class TrialModel {
 public:
  /// Unknowns of a trial.
  struct Unknowns {
    double resistance = 0;   ///< Cr / R
    double patch_width = 0;  ///< [m]
    double shift = 0;        ///< start of the motion after Phases::start [s]
    double release = 0;      ///< end of the pull after Phases::release [s]
    double force = 0;        ///< of phase II above what the load cell says [N]
  };

  /// Motion at the times of the trial's samples, since the start; constant after Phases::stop.
  struct Motion {
    std::vector<double> displacement, lateral, yaw;  ///< [m], [m], [rad]
  };

  /// @throws Error where the catalogue does not know the item, its payload or the caster, or the
  /// item
  ///         does not weigh what the trial says within 2 %.
  TrialModel(const Trial& trial, const Phases& phases);

  Unknowns usual() const;  ///< those of the caster's file
  double wheel_width() const { return scene_.items[0].model.casters[0].wheel_width; }
  double friction() const;        ///< mu_s of the first caster
  double swivel_coulomb() const;  ///< of the first caster [N m]
  double load_of_wheel() const;   ///< mean [N]

  /// Phase II has the measured force for its first half second (or half), while the cable swings
  /// and the casters swivel: a line through it would be wrong by some 0.1 N s, 6 % of the torque of
  /// a narrow patch. From then on it has the line nearest to the force, whose noise would add up in
  /// the speed, and none after the release: a sample too many is an impulse that the coasting would
  /// take for resistance. What the noise adds to the impulse at first is taken up by `shift`.
  /// @pre the unknowns are within the engine's ranges
  Motion run(const Unknowns& unknowns) const;

 private:
  const Trial& trial_;
  Scene scene_;
  Phases phases_;
  double settled_;       ///< when the measured force goes over into force_ [s]
  PolynomialFit force_;  ///< of phase II
};

/// The item of a trial from the catalogue, with its payload, casters, floor and headings. A floor
/// that the catalogue does not know has the factor 1.
/// @throws Error where the catalogue does not know the item, its payload or the caster, it has no
///         casters, or it does not weigh what the trial says within 2 % (where it says so)
EquipmentModel item_of(const TrialSetup& setup);

}  // namespace gurney::calibration
