#include "equipment/catalogue/levelness.h"

#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

Uncertain<Levelness> usual_levelness() {
  using config::Range;
  config::Document document(data_folder() + "/equipment/levelness.toml");
  config::Table root = document.root();
  root.choice("schema", {"gurney-levelness/1"});
  Uncertain<Levelness> floor;
  Quantities in(root);
  floor.set(&Levelness::slope, in.number("slope", config::Range::within(-1, 1)));
  floor.set(&Levelness::cross_slope, in.number("cross_slope", config::Range::within(-1, 1)));
  document.finish();
  return floor;
}

}  // namespace gurney::equipment
