#include "groundmotions/buildings/generic_building.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "groundmotions/buildings/shear_building.h"

namespace gurney::groundmotions {

using std::numbers::pi;

double approximate_period(const FrameKind& frame, double height) {
  assert(height > 0);
  return frame.coefficient * std::pow(height, frame.exponent);
}

double plate_mass_share() { return std::pow(8 / (pi * pi), 2); }
double plate_participation() { return std::pow(4 / pi, 2); }

namespace {

ModalAxis slab_modes(int storeys, const VerticalFloors& floors) {
  Mode slab;
  slab.omega = floors.floor_omega;
  slab.effective_shape = Eigen::VectorXd::Constant(storeys + 1, floors.participation);
  slab.effective_shape[0] = 0;
  slab.effective_mass = floors.mass_share;
  return {slab};
}

}  // namespace

ModalAxis vertical_modes(int storeys, const VerticalFloors& floors) {
  assert(storeys > 0 && floors.floor_omega > 0 && floors.column_omega > 0);
  ModalAxis axis;
  if (std::isinf(floors.column_omega)) {
    axis = slab_modes(storeys, floors);
  } else {
    const Eigen::Index n = storeys;
    const auto ones = Eigen::VectorXd::Ones(n);
    ModalAxis rigid_slabs = modes_of(ones, shear_stiffness(ones));
    const double storey = std::pow(floors.column_omega / rigid_slabs.front().omega, 2);
    const double slab = floors.mass_share * floors.floor_omega * floors.floor_omega;
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd mass(2 * n);  // columns, then slabs
    mass << (1 - floors.mass_share) * ones, floors.mass_share * ones;
    Eigen::MatrixXd stiffness(2 * n, 2 * n), place(n, 2 * n);
    stiffness << storey * shear_stiffness(ones) + slab * identity, -slab * identity,
        -slab * identity, slab * identity;
    place << (1 - floors.participation) * identity, floors.participation * identity;
    axis = modes_of(mass, stiffness, place);
  }
  set_damping(axis, floors.damping);
  return axis;
}

}  // namespace gurney::groundmotions
