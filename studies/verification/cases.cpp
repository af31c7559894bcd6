#include "studies/verification/cases.h"

namespace gurney::verification {

std::vector<Family> all_families() {
  return {constant_pull(),     wind_up(),      drop_weight(),    drop_weight_grid(),
          drop_weight_slack(), slope(),        skid_to_roll(),   alignment(),
          wall_rebound(),      wall_spring(),  wall_friction(),  edge_impact(),
          obstacle_impact(),   column_side(),  partial_wall(),   cut_corner(),
          collision(),         pressed_row(),  cord(),           weak_cord(),
          wheel_at_wall(),     flight(),       rocking(),        floor_step(),
          floor_double_step(), sine_pulse(),   pulse_spectrum(), block_stands(),
          block_slides(),      block_uplift(), cart_at_kerb(),   slider_at_kerb(),
          disc_straight(),     disc_weight(),  disc_turning(),   disc_precession()};
}

}  // namespace gurney::verification
