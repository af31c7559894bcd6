#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/base/units.h"
#include "studies/calibration/trials/setup_reader.h"
#include "studies/calibration/trials/trial_file.h"

namespace gurney::calibration {
namespace {

std::string key(const char* name, const std::string& value) {
  return value.empty() ? "" : fmt::format("# {} = {}\n", name, value);
}

std::string key(const char* name, double value) {
  return value == 0 ? "" : fmt::format("# {} = {:.10g}\n", name, value);
}

std::string key(const char* name, const std::vector<double>& values, double unit) {
  std::string text;
  for (const double value : values) text += fmt::format(" {:.10g}", value / unit);
  return text.empty() ? "" : fmt::format("# {} ={}\n", name, text);
}

std::string setup_text(const TrialSetup& setup) {
  const double mm = 1 / kMillimetersPerMeter;
  return key("use", names_of_uses()[static_cast<std::size_t>(setup.use)]) +
         key("origin", names_of_origins()[static_cast<std::size_t>(setup.origin)]) +
         key("caster", setup.caster) + key("floor", setup.floor) + key("tread", setup.tread) +
         key("against", setup.against) + key("wheels", setup.wheels) +
         key("wheel_diameter_mm", 2 * setup.wheel_radius / mm) + key("mass_kg", setup.mass) +
         key("payload_kg", setup.payload) +
         fmt::format("# added_mass_kg = {:.10g}\n", setup.added_mass) +
         key("drop_mass_kg", setup.drop_mass.value_or(0)) +
         key("string_tension_n", setup.string_tension) +
         key("headings_deg", setup.headings, kRadiansPerDegree) + key("item", setup.item) +
         (setup.payload_count > 0
              ? key("payload_name", setup.payload_name) + key("payload_count", setup.payload_count)
              : "") +
         key("pull_point_mm", setup.pull_point, mm) +
         (setup.locked == LockedWheels::kAll
              ? ""
              : key("locked", names_of_locked()[static_cast<std::size_t>(setup.locked)]) +
                    fmt::format("# pull_height_mm = {:.10g}\n", setup.pull_height / mm) +
                    key("wheelbase_mm", setup.wheelbase / mm) +
                    key("front_share", setup.front_share) +
                    fmt::format("# rolling_ratio = {:.10g}\n", setup.rolling_ratio));
}

struct WrittenColumn {
  const char* name;
  const std::vector<double>* series;
  double unit;
  int digits;
};

}  // namespace

std::string trial_file_text(const Trial& trial, const std::string& note) {
  std::string text = "# schema = gurney-trial/1\n";
  text += key("note", note);
  text += key("kind", names_of_kinds()[static_cast<std::size_t>(trial.kind)]);
  text += setup_text(trial.setup);
  const TrialSignals& s = trial.signals;
  const std::array<WrittenColumn, 6> all = {
      {{"time_s", &s.time, 1, 6},
       {"force_n", &s.force, 1, 3},
       {"displacement_mm", &s.displacement, 1 / kMillimetersPerMeter, 4},
       {"lateral_mm", &s.lateral, 1 / kMillimetersPerMeter, 4},
       {"acceleration_mps2", &s.acceleration, 1, 5},
       {"yaw_deg", &s.yaw, kRadiansPerDegree, 4}}};
  std::string header;
  for (const WrittenColumn& column : all)
    if (!column.series->empty())
      header += fmt::format("{}{}", header.empty() ? "" : ",", column.name);
  text += header + "\n";
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    std::string row;
    for (const WrittenColumn& column : all) {
      if (column.series->empty()) continue;
      const double value = (*column.series)[i] / column.unit;
      row += row.empty() ? "" : ",";
      if (std::isfinite(value)) row += fmt::format("{:.{}f}", value, column.digits);
    }
    text += row + "\n";
  }
  return text;
}

}  // namespace gurney::calibration
