#include "equipment/catalogue/tether_type.h"

#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

TetherType load_tether_type(const std::string& file, const std::optional<Draw>& draw) {
  using config::Range;
  config::Document document(file);
  document.set_draw(draw);
  config::Table root = document.root();
  root.choice("schema", {"gurney-tether/1"});
  TetherType type;
  type.name = root.text("name");
  root.text("description", "");
  Quantities in(root, type.assumptions);
  type.axial_stiffness = in.number("axial_stiffness_n", Range::positive());
  type.damping = in.number("damping_n_s_per_m", Range::not_negative());
  type.strength = in.number("strength_n", Range::positive().with_infinity());
  type.slack_pull = in.number("slack_pull_n", Range::not_negative(), 0.0);
  document.finish();
  return type;
}

}  // namespace gurney::equipment
