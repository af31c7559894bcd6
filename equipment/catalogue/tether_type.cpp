#include "equipment/catalogue/tether_type.h"

#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

Uncertain<TetherType> load_tether_type(const std::string& file) {
  using config::Range;
  config::Document document(file);
  config::Table root = document.root();
  root.choice("schema", {"gurney-tether/1"});
  TetherType fixed;
  fixed.name = root.text("name");
  root.text("description", "");
  Uncertain<TetherType> type(fixed);
  Quantities in(root);
  type.set(&TetherType::axial_stiffness, in.number("axial_stiffness_n", config::Range::positive()));
  type.set(&TetherType::damping, in.number("damping_n_s_per_m", config::Range::not_negative()));
  type.set(&TetherType::strength,
           in.number("strength_n", config::Range::positive().with_infinity()));
  type.set(&TetherType::slack_pull, in.number("slack_pull_n", config::Range::not_negative(), 0.0));
  document.finish();
  return type;
}

}  // namespace gurney::equipment
