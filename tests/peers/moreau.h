#pragma once

#include "tests/peers/cross_check.h"

/// Two methods unlike ours on bodies of their own (docs/theory/peers.md); both need very short steps.
namespace gurney::peers {

/// Rigid friction: Moreau's time stepping (Moreau 1988, Unilateral contact and dry friction in finite
/// freedom dynamics, CISM 302) with Coulomb's exact cone and with the rolling resistance as impulses
/// of the same step, solved contact after contact (Jean 1999, Comput. Methods Appl. Mech. Engrg.
/// 177, 235-257). Normal to the floor the treads are springs: four loads of a rigid item are not
/// determined otherwise.
///
/// @throws std::runtime_error where a step is not solved.
Path moreau_path(const CrossCheck& check, double time_step);

/// The tread law with its compliance (docs/theory/tread.md) in explicit steps.
Path explicit_path(const CrossCheck& check, double time_step);

}  // namespace gurney::peers
