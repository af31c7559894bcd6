#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "groundmotions/measures/response_spectrum.h"

namespace gurney::groundmotions {

/// One mode of a linear building along one direction. With phi its shape, 1 a vector of ones and
/// Gamma = phi' M 1 / (phi' M phi), the floors move by Gamma phi q relative to the base, and
///
///     q'' + 2 zeta omega q' + omega^2 q = -a_base     (Chopra, Dynamics of Structures, ch. 13)
struct Mode {
  double omega = 0;                 ///< > 0 [rad/s]
  double damping = 0;               ///< zeta in [0, 1)
  Eigen::VectorXd effective_shape;  ///< Gamma phi at floors 0 (the base: 0) to n [-]
  /// Gamma theta: rotation of the floors as the building deforms, positive where a floor dips towards
  /// its displacement, at floors 0 to n [rad/m]; empty: floors stay level.
  Eigen::VectorXd effective_rotation;
  double effective_mass = 0;  ///< Gamma phi' M 1 as a share of the building's mass, in [0, 1]
};

/// A linear building along one direction, by its modes in rising order; without modes it is rigid.
/// Modes that are left out follow the base rigidly: they have no relative acceleration, so no mass
/// is missing.
using ModalAxis = std::vector<Mode>;

/// Modes of lumped masses on springs, without damping, from K phi = omega^2 M phi.
/// @param mass       of each degree of freedom > 0 [kg]
/// @param stiffness  symmetric positive definite [N/m]
/// @param floors     one row for each floor above the base: its displacement in the degrees of
///                   freedom; a row sums to 1
ModalAxis modes_of(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                   const Eigen::MatrixXd& floors);
ModalAxis modes_of(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness);

/// All frequencies times one factor, so that the first period is `period` > 0 [s].
void scale_to_period(ModalAxis& axis, double period);

void set_damping(ModalAxis& axis, double ratio);

/// Effective rotation at a floor; 0 without any [rad/m].
double rotation_of(const Mode& mode, Eigen::Index floor);

/// Floors that rotate by `share` of the slope of the mode shapes: all of it where plane sections of
/// the building stay plane and normal to its axis (a cantilever in bending), none of it where storeys
/// shear. Floors are equally high.
/// @param height  of the roof above the base, > 0 [m]
void set_rotation(ModalAxis& axis, double height, double share);

/// Rayleigh damping, zeta_i = alpha / (2 omega_i) + beta omega_i / 2, with `ratio` at the two modes
/// (Chopra, section 11.4.1).
/// @param first, second  indices of modes with different frequencies
void set_rayleigh_damping(ModalAxis& axis, double ratio, std::size_t first, std::size_t second);

/// Largest difference of two displacements that follow each other.
/// @param floors  displacements of floors 0 to n, relative to the base [m]
double largest_storey_drift(const Eigen::VectorXd& floors);

/// The absolute acceleration of one floor,
///
///     a = a_base + sum_i Gamma_i phi_i q_i'',
///
/// with the exact step for a base acceleration that is linear between samples.
class ModalResponse {
 public:
  /// @param floor      0 (the base) to the number of storeys
  /// @param time_step  > 0 [s]
  ModalResponse(const ModalAxis& axis, Eigen::Index floor, double time_step);

  /// Moves on by one time step; the floor's absolute acceleration at its end [m/s2].
  /// @param base0, base1  acceleration of the base at the begin and the end of the step [m/s2]
  double step(double base0, double base1);

  /// Rotation of the floor now, and its second derivative under a base acceleration.
  double rotation() const;                          ///< [rad]
  double rotation_acceleration(double base) const;  ///< [rad/s2]

  /// Largest difference of the displacements of two floors that follow each other, now [m].
  double storey_drift() const;

  /// The floor's acceleration at rest under a sudden acceleration of the base: that of the modes
  /// left out [m/s2].
  double at_rest(double base) const { return rigid_share_ * base; }

 private:
  ModalAxis axis_;
  Eigen::Index floor_;
  double rigid_share_ = 1;  ///< 1 - sum Gamma phi
  std::vector<Oscillator> oscillators_;
};

/// Stiffness matrix of a shear building: floors joined to their neighbours by storey springs.
/// @param storeys  stiffness of each storey from the ground up, > 0 [N/m]
Eigen::MatrixXd shear_stiffness(const Eigen::VectorXd& storeys);

/// Stiffness of `storeys` equal storeys, scaled: 1 at the bottom, falling linearly to `top_ratio`.
/// @param top_ratio  > 0
Eigen::VectorXd tapered_storeys(int storeys, double top_ratio);

/// Stiffness matrix of a uniform cantilever that bends beside a uniform shear frame, both taking
/// the same displacement at `storeys` equally high floors; height and bending stiffness are 1:
///
///     K = F^-1 + K_shear,   F_ij = x_i^2 (3 x_j - x_i) / 6 for x_i <= x_j,   GA = alpha0^2.
///
/// With many storeys this is the continuum of Miranda & Taghavi (2005), Journal of Structural
/// Engineering 131(2), 203-211: alpha0 = 0 bends like a wall, infinity shears like a frame.
/// @param alpha0  >= 0; infinity: the shear frame alone, with GA = 1
Eigen::MatrixXd shear_flexure_stiffness(int storeys, double alpha0);

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
