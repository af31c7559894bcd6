#pragma once

#include <vector>

#include "studies/verification/family.h"

/// The list of all closed forms that the engine is held against: `gurney verify` and
/// tests/verification run it. Each has its file in studies/verification/cases.
namespace gurney::verification {

std::vector<Family> all_families();

// pulling
Family constant_pull();
Family wind_up();
Family drop_weight();
Family drop_weight_grid();
Family drop_weight_slack();
Family slope();

// sliding
Family harmonic_slip();
Family harmonic_slip_formula();
Family slip_from_rest();
Family rectangular_pulse();
Family half_sine_pulse();
Family half_sine_pulse_formula();
Family half_locked();
Family isotropy();
Family isotropy_free();
Family static_limit();

// conservation
Family free_rolling();
Family coasting();
Family relaxation();
Family sliding_to_rest();
Family braking();
Family swivel_friction();

// casters
Family skid_to_roll();
Family alignment();
Family alignment_free();
Family flutter();
Family shimmy();
Family shimmy_formula();
Family step_climb();

// standing
Family heave_pitch();
Family static_loads();
Family hold();
Family sway();

// method
Family order_towed();
Family order_heave();
Family order_turning();
Family determinism();

// rotation of the floor
Family tilted_floor();
Family rocking_floor();
Family rocking_floor_loads();

// impacts
Family wall_rebound();
Family wall_spring();
Family wall_friction();
Family edge_impact();
Family obstacle_impact();
Family column_side();
Family partial_wall();
Family cut_corner();
Family collision();
Family pressed_row();
Family cord();
Family weak_cord();
Family wheel_at_wall();

// blocks
Family block_stands();
Family block_slides();
Family block_uplift();
Family cart_at_kerb();
Family slider_at_kerb();
Family rocking();
Family rocking_feet();
Family floor_step();
Family floor_double_step();
Family sine_pulse();
Family pulse_spectrum();

// rolling disc
Family disc_straight();
Family disc_weight();
Family disc_turning();
Family disc_precession();

// vertical
Family flight();

}  // namespace gurney::verification
