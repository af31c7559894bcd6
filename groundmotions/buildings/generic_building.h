#pragma once

#include <array>

#include "groundmotions/buildings/modal_building.h"

namespace gurney::groundmotions {

/// A kind of frame of ASCE 7-16, Table 12.8-2: approximate period T_a = C_t h_n^x, h_n in metres.
struct FrameKind {
  const char* name;
  double coefficient;  ///< C_t
  double exponent;     ///< x
};

inline constexpr std::array kFrameKinds = {
    FrameKind{"steel_moment_frame", 0.0724, 0.8},
    FrameKind{"concrete_moment_frame", 0.0466, 0.9},
    FrameKind{"steel_eccentrically_braced_frame", 0.0731, 0.75},
    FrameKind{"steel_buckling_restrained_braced_frame", 0.0731, 0.75},
    FrameKind{"other", 0.0488, 0.75},
};

/// @param height  > 0 [m]
/// @return T_a [s]
double approximate_period(const FrameKind& frame, double height);

/// Vertical motion of floors: each floor is a slab that swings on columns. A share of the floor's
/// mass swings with the slab's first mode; the rest is carried by the columns directly.
struct VerticalFloors {
  double floor_omega = 0;    ///< of the slab on rigid columns > 0 [rad/s]
  double column_omega = 0;   ///< first mode of the columns with rigid slabs > 0; infinity: rigid
  double damping = 0;        ///< of all modes, in [0, 1)
  double mass_share = 0;     ///< of the floor's mass in the slab's mode, in (0, 1)
  double participation = 1;  ///< relative acceleration of the place over that of the slab's mode
};

/// Mass share (8 / pi^2)^2 and participation (4 / pi)^2 at the centre of a simply supported
/// rectangular plate, whose first mode is a product of two half sines.
double plate_mass_share();
double plate_participation();

ModalAxis vertical_modes(int storeys, const VerticalFloors& floors);

}  // namespace gurney::groundmotions
