#include "equipment/catalogue/floor_covering.h"

#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

Uncertain<FloorCovering> read_floor(config::Table table) {
  FloorCovering fixed;
  fixed.name = table.text("name");
  table.text("description", "");
  Uncertain<FloorCovering> floor(fixed);
  Quantities in(table);
  floor.set(&FloorCovering::rolling_resistance_factor,
            in.number("rolling_resistance_factor", config::Range::not_negative()));
  floor.set(&FloorCovering::friction_factor,
            in.number("friction_factor", config::Range::not_negative()));
  return floor;
}

Uncertain<FloorCovering> load_floor_covering(const std::string& file) {
  config::Document document(file);
  document.root().choice("schema", {"gurney-floor/1"});
  Uncertain<FloorCovering> floor = read_floor(document.root());
  document.finish();
  return floor;
}

Uncertain<Levelness> usual_levelness() {
  using config::Range;
  config::Document document(data_file("levelness.toml"));
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
