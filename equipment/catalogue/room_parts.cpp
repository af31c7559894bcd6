#include "equipment/catalogue/room_parts.h"

#include <cmath>

#include "engine/config/nearest_name.h"

namespace gurney::equipment {

using config::Range;
using config::Table;

std::array<StatedQuantity, 2> read_plan_point(Quantities& in, const std::string& key) {
  if (!in.table().has(key)) in.table().note(key, ": missing; must be an array of 2 numbers");
  return in.plane(key, Range::any());
}

Uncertain<PlanLine> read_plan_line(Quantities& in) {
  config::Document& document = in.table().document();
  const std::size_t errors = document.errors();
  Uncertain<PlanLine> line;
  line.set(&PlanLine::from, read_plan_point(in, "from_m"));
  line.set(&PlanLine::to, read_plan_point(in, "to_m"));
  if (document.errors() > errors) return Uncertain<PlanLine>();
  line.add(document, [to = in.table().spot("to_m")](PlanLine& of_draw, Sampler& of) {
    if (of_draw.length() > 0) return;
    of.error(to, ": must differ from from_m");
    of_draw = PlanLine();
  });
  return line;
}

RoomShape box_along(const PlanLine& line, double begin, double end, double width, double low,
                    double high) {
  const Vector2 along = (line.to - line.from) / line.length();
  const Vector2 middle = line.from + 0.5 * (begin + end) * along;
  RoomShape shape;
  shape.position = Vector3(middle.x(), middle.y(), 0.5 * (low + high));
  shape.rotation = Eigen::AngleAxisd(std::atan2(along.y(), along.x()), Vector3::UnitZ());
  shape.shape = RoomBox{Vector3(end - begin, width, high - low)};
  return shape;
}

std::string read_material(Table& table, const std::vector<MaterialContact>& contacts,
                          const std::string& fallback) {
  const std::string material = table.text("material", fallback);
  if (!table.is_text("material")) return fallback;
  const std::vector<std::string> known = materials_in(contacts);
  for (const std::string& each : known)
    if (each == material) return material;
  table.note("material", " = \"" + material + "\": no contact names this material" +
                             config::suggestion(material, known));
  return fallback;
}

}  // namespace gurney::equipment
