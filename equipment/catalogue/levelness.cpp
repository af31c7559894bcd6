#include "equipment/catalogue/levelness.h"

#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

Levelness usual_levelness(const std::optional<Draw>& draw) {
  using config::Range;
  config::Document document(data_folder() + "/equipment/levelness.toml");
  document.set_draw(draw);
  config::Table root = document.root();
  root.choice("schema", {"gurney-levelness/1"});
  Levelness floor;
  Quantities in(root, floor.assumptions);
  floor.slope = in.number("slope", Range::within(-1, 1));
  floor.cross_slope = in.number("cross_slope", Range::within(-1, 1));
  document.finish();
  return floor;
}

}  // namespace gurney::equipment
