#include "groundmotions/formats/at2_text.h"

#include <fmt/format.h>

#include "engine/base/units.h"

namespace gurney::groundmotions {

std::string at2_text(const Component& component, const std::string& title,
                     const std::string& event) {
  std::string text = fmt::format(
      "{}\n{}, {}\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= {:6}, DT= {:.10g} SEC\n", title,
      event, component.name, component.acceleration.size(), component.time_step);
  for (Eigen::Index i = 0; i < component.acceleration.size(); ++i)
    text += fmt::format("{:16.7E}{}", component.acceleration[i] / kStandardGravity,
                        i % 5 == 4 ? "\n" : "");
  if (text.back() != '\n') text += "\n";
  return text;
}

}  // namespace gurney::groundmotions
