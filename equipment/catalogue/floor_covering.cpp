#include "equipment/catalogue/floor_covering.h"

#include "equipment/catalogue/quantity.h"

namespace gurney::equipment {

FloorCovering read_floor(config::Table table) {
  FloorCovering floor;
  floor.name = table.text("name");
  table.text("description", "");
  Quantities in(table, floor.assumptions);
  floor.rolling_resistance_factor =
      in.number("rolling_resistance_factor", config::Range::not_negative());
  floor.friction_factor = in.number("friction_factor", config::Range::not_negative());
  return floor;
}

FloorCovering load_floor_covering(const std::string& file, const std::optional<Draw>& draw) {
  config::Document document(file);
  document.set_draw(draw);
  document.root().choice("schema", {"gurney-floor/1"});
  FloorCovering floor = read_floor(document.root());
  document.finish();
  return floor;
}

}  // namespace gurney::equipment
