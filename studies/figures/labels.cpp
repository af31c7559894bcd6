#include "studies/figures/labels.h"

#include <fmt/format.h>

#include <cctype>
#include <map>

#include "engine/response/settled.h"
#include "equipment/catalogue/uncertainty.h"

namespace gurney::figures {
namespace {

/// Those whose column is not what the field calls them.
const std::map<std::string, std::string>& special_labels() {
  static const std::map<std::string, std::string> labels{
      {"pfa", "Peak floor acceleration"},
      {"pfv", "Peak floor velocity"},
      {"lifted_time", "Uplift time"},
      {"most_wheels_lifted", "Largest number of wheels off the floor"},
      {"impacts", "Number of impacts"},
      {"largest_approach_speed", "Largest approach speed of impacts"},
      {"largest_impulse", "Largest impulse of impacts"},
      {"displacement", "Displacement relative to the floor"},
      {"velocity", "Velocity relative to the floor"},
      {"acceleration", "Acceleration relative to the floor"},
      {"floor_acceleration", "Floor acceleration"},
      {"point_displacement", "Displacement of marked points"},
      {"point_velocity", "Velocity of marked points"},
      {"point_absolute_acceleration", "Absolute acceleration of marked points"},
      {"wheel_rate", "Wheel rotation rate"},
      {"energy_kinetic", "Kinetic energy"},
      {"energy_gravitational", "Gravitational energy"},
      {"energy_elastic", "Elastic energy"},
      {"energy_of_weights", "Energy of drop weights"},
      {"work_of_floor", "Work of floor motion"},
  };
  return labels;
}

}  // namespace

std::string label_of(const std::string& column) {
  const auto special = special_labels().find(column);
  if (special != special_labels().end()) return special->second;
  std::string label = column;
  const bool loss = label.starts_with("loss_");
  if (loss) label = label.substr(5) + "_loss";
  for (char& c : label)
    if (c == '_') c = ' ';
  if (!label.empty())
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  if (label.ends_with(" x") || label.ends_with(" y") || label.ends_with(" z"))
    label.insert(label.size() - 2, ",");
  return label;
}

std::string input_label(const std::vector<std::string>& names) {
  const std::string& name = names.front();
  const std::size_t slash = name.rfind('/');
  std::string key = slash == std::string::npos ? name : name.substr(slash + 1);
  const std::string unit = equipment::unit_of_key(key);
  std::string ending = "_";
  for (const char c : unit)
    ending += c == ' '   ? "_"
              : c == '/' ? "_per_"
                         : std::string(1, static_cast<char>(std::tolower(c)));
  if (const auto at = key.rfind(ending); unit != "1" && at != std::string::npos)
    key.erase(at, ending.size());
  for (char& c : key)
    if (c == '_' || c == '.') c = ' ';
  if (slash != std::string::npos) key.insert(0, name.substr(0, slash) + ": ");
  return names.size() == 1 ? key : fmt::format("{} and {} equal to it", key, names.size() - 1);
}

std::string unit_label(const study::ReportUnit& unit) {
  const std::string& name = unit.name;
  return name.ends_with("s2") ? name.substr(0, name.size() - 1) + "\u00b2" : name;
}

double least_span(const std::string& si) {
  for (const char* const known : {"m", "rad", "m/s", "m/s2", "N"})
    if (si == known) return size_of_interest(known);
  return si == "J" ? 0.1 : 0;  // 10 N along 1 cm
}

std::string with_unit(const std::string& label, const study::ReportUnit& unit) {
  if (unit.name.empty() || unit.name == "1") return label;
  return label + " (" + unit_label(unit) + ")";
}

}  // namespace gurney::figures
