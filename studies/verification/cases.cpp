#include "studies/verification/family.h"

// The one list: group by group, each family a function of this name in studies/verification/cases.
// clang-format off
#define GURNEY_FAMILIES(FAMILY) \
    /* pulling */ FAMILY(constant_pull) FAMILY(wind_up) FAMILY(drop_weight) \
      FAMILY(drop_weight_grid) FAMILY(drop_weight_slack) FAMILY(slope) \
    /* sliding */ FAMILY(harmonic_slip) FAMILY(harmonic_slip_formula) FAMILY(slip_from_rest) \
      FAMILY(rectangular_pulse) FAMILY(half_sine_pulse) FAMILY(half_sine_pulse_formula) \
      FAMILY(half_locked) FAMILY(isotropy) FAMILY(isotropy_free) FAMILY(static_limit) \
    /* conservation */ FAMILY(free_rolling) FAMILY(coasting) FAMILY(relaxation) \
      FAMILY(sliding_to_rest) FAMILY(braking) FAMILY(swivel_friction) \
    /* casters */ FAMILY(skid_to_roll) FAMILY(alignment) FAMILY(alignment_free) FAMILY(flutter) \
      FAMILY(shimmy) FAMILY(shimmy_formula) FAMILY(step_climb) \
    /* standing */ FAMILY(heave_pitch) FAMILY(static_loads) FAMILY(hold) FAMILY(sway) \
    /* method */ FAMILY(order_towed) FAMILY(order_heave) FAMILY(order_turning) \
      FAMILY(determinism) \
    /* rotation of the floor */ FAMILY(tilted_floor) FAMILY(rocking_floor) \
      FAMILY(rocking_floor_loads) \
    /* impacts */ FAMILY(wall_rebound) FAMILY(wall_spring) FAMILY(wall_friction) \
      FAMILY(edge_impact) FAMILY(obstacle_impact) FAMILY(column_side) FAMILY(partial_wall) \
      FAMILY(cut_corner) FAMILY(collision) FAMILY(pressed_row) FAMILY(cord) FAMILY(weak_cord) \
      FAMILY(wheel_at_wall) \
    /* blocks */ FAMILY(block_stands) FAMILY(block_slides) FAMILY(block_uplift) \
      FAMILY(cart_at_kerb) FAMILY(slider_at_kerb) FAMILY(rocking) FAMILY(rocking_feet) \
      FAMILY(floor_step) FAMILY(floor_double_step) FAMILY(sine_pulse) FAMILY(pulse_spectrum) \
    /* rolling disc */ FAMILY(disc_straight) FAMILY(disc_weight) FAMILY(disc_turning) \
      FAMILY(disc_precession) \
    /* vertical */ FAMILY(flight)
// clang-format on

namespace gurney::verification {

#define GURNEY_DECLARE(name) Family name();
GURNEY_FAMILIES(GURNEY_DECLARE)

std::vector<Family> all_families() {
#define GURNEY_CALL(name) name(),
  return {GURNEY_FAMILIES(GURNEY_CALL)};
}

}  // namespace gurney::verification
