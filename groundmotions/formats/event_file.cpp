#include "groundmotions/formats/event_file.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "engine/base/error.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

std::map<std::string, EventSeries> event_series(const SourceFile& file) {
  std::map<std::string, EventSeries> found;
  std::string name;
  const auto check = [&](bool holds, const std::string& message) {
    require(holds, fmt::format("{}: time series '{}' {}", file.name(), name, message));
  };
  try {
    const nlohmann::json root = nlohmann::json::parse(file.bytes());
    for (const nlohmann::json& event : root.at("Events"))
      for (const nlohmann::json& each : event.at("timeSeries")) {
        name = each.at("name").get<std::string>();
        EventSeries series{each.at("dT").get<double>(), each.at("data").get<std::vector<double>>()};
        check(is_time_step(series.time_step),
              fmt::format("has dT = {:g}: must be in [{:g}, {:g}] s", series.time_step,
                          kShortestTimeStep, kLongestTimeStep));
        check(series.samples.size() >= 2, "must have two samples at least");
        const double factor = each.value("factor", 1.0);
        for (double& sample : series.samples) sample *= factor;
        check(found.emplace(name, std::move(series)).second, "is there twice");
      }
  } catch (const nlohmann::json::exception& error) {
    throw Error(
        fmt::format("{}: {}{}; an event file of SimCenter has Events[].timeSeries[] with "
                    "name, dT and data",
                    file.name(), name.empty() ? "" : "time series '" + name + "': ", error.what()));
  }
  return found;
}

}  // namespace gurney::groundmotions
