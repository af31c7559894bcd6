#include "studies/verification/cases.h"

namespace gurney::verification {

std::vector<Family> all_families() {
  return {
      constant_pull(),
      wind_up(),
      drop_weight(),
      drop_weight_grid(),
      drop_weight_slack(),
      slope(),
      harmonic_slip(),
      harmonic_slip_formula(),
      rectangular_pulse(),
      half_sine_pulse(),
      half_sine_pulse_formula(),
      half_locked(),
      isotropy(),
      isotropy_free(),
      static_limit(),
      free_rolling(),
      coasting(),
      relaxation(),
      sliding_to_rest(),
      braking(),
      swivel_friction(),
      skid_to_roll(),
      alignment(),
      alignment_free(),
      flutter(),
      shimmy(),
      shimmy_formula(),
      step_climb(),
      heave_pitch(),
      static_loads(),
      hold(),
      sway(),
      order_towed(),
      order_heave(),
      order_turning(),
      determinism(),
  };
}

}  // namespace gurney::verification
