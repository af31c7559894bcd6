#pragma once

#include <optional>

#include "studies/calibration/trials/trial.h"

/// Trials made with the engine: nothing here knows the formulas that the calibration uses.
namespace gurney::calibration {

/// What is pulled and what the instruments do.
struct VirtualPull {
  double resistance = 0.02;   ///< Cr / R of every wheel
  int pavers = 0;             ///< on the trolley of Xu, Ma & Kurata (2022)
  double drop_mass = 6;       ///< [kg]
  double string_tension = 1;  ///< [N]
  double drop_height = 1;     ///< [m]
  double heading = 0;         ///< of every caster at the start [rad]
  double patch_width = -1;    ///< of every wheel; < 0: as the caster's file has it [m]
};

/// A pull as the job studies/jobs/pulling_test.toml, sampled at 120 Hz, without noise.
Trial virtual_pull(const VirtualPull& pull);

/// A winch of 0.1 m/s that pulls ever harder.
struct VirtualWinch {
  double ramp = 60;                    ///< [N/s]
  std::optional<LockedWheels> locked;  ///< that cannot turn; empty: all roll
  double static_friction = 0.6, kinetic_friction = 0.6;
  double resistance = 0.02;  ///< Cr / R of the wheels that roll
};
Trial virtual_winch(const VirtualWinch& winch);

/// Rolls against a wall with `speed` and leaves with `restitution` times it.
Trial virtual_impact(double speed, double restitution);

}  // namespace gurney::calibration
