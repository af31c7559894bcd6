#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/models/bssa14.h"
#include "studies/cli/commands.h"

namespace gurney::cli {
namespace {

using groundmotions::Faulting;
using groundmotions::Prediction;
using Json = nlohmann::ordered_json;

const char* const kSource =
    "Boore, Stewart, Seyhan & Atkinson (2014), Earthquake Spectra 30(3), 1057-1085; RotD50";
const char* const kLeftOut =
    "regional terms (attenuation of China, Turkey, Italy, Japan) and the basin term are not "
    "included";
const std::map<std::string, Faulting> kFaulting = {{"unspecified", Faulting::kUnspecified},
                                                   {"strike-slip", Faulting::kStrikeSlip},
                                                   {"normal", Faulting::kNormal},
                                                   {"reverse", Faulting::kReverse}};

struct ModelOptions {
  groundmotions::Scenario scenario;
  std::vector<double> periods = {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1, 1.5, 2, 3, 5, 10};
  bool json = false;
};

Json prediction_json(const Prediction& p) {
  return {{"median", p.median}, {"tau", p.tau}, {"phi", p.phi}, {"sigma", p.sigma()}};
}

int print_json(const ModelOptions& options) {
  Json spectrum = Json::array(), correlation = Json::array();
  for (const double period : options.periods) {
    Json row = {{"period_s", period}};
    row.update(prediction_json(bssa14_sa(options.scenario, period)));
    if (period > 0) row["correlation_with_pgv"] = groundmotions::pgv_correlation(period);
    spectrum.push_back(row);
  }
  for (const double a : options.periods) {
    Json row = Json::array();
    for (const double b : options.periods)
      row.push_back(a > 0 && b > 0 ? Json(groundmotions::epsilon_correlation(a, b)) : Json());
    correlation.push_back(row);
  }
  const Json result = {{"source", kSource},
                       {"left_out", kLeftOut},
                       {"pgv_m_per_s", prediction_json(bssa14_pgv(options.scenario))},
                       {"sa_m_per_s2", spectrum},
                       {"correlation", correlation}};
  fmt::print("{}\n", result.dump(2));
  return 0;
}

int print(const ModelOptions& options) {
  if (options.json) return print_json(options);
  fmt::print("{}\n\n{:<10}{:>10}{:>7}{:>7}{:>7}\n", kSource, "", "median", "tau", "phi", "sigma");
  const auto line = [](const std::string& name, const Prediction& p, double unit,
                       const char* unit_name) {
    fmt::print("{:<10}{:>10.4g}{:>7.3f}{:>7.3f}{:>7.3f}  {}\n", name, p.median / unit, p.tau, p.phi,
               p.sigma(), unit_name);
  };
  line("PGV", bssa14_pgv(options.scenario), 1, "m/s");
  line("PGA", bssa14_sa(options.scenario, 0), kStandardGravity, "g");
  for (const double period : options.periods)
    line(fmt::format("Sa({:g})", period), bssa14_sa(options.scenario, period), kStandardGravity,
         "g");
  fmt::print("\nnote: {}\n", kLeftOut);
  return 0;
}

}  // namespace

void add_records_model(Commands& commands) {
  commands.add<ModelOptions>(
      {"model", "Spectrum of a published ground-motion model, with its scatter",
       "gurney records model --magnitude 7 --distance 20 --vs30 400\n"
       "gurney records model --magnitude 7 --distance 20 --vs30 400 --json"},
      print, [](Options& add, ModelOptions& options) {
        add.required("--magnitude", options.scenario.magnitude, "Moment magnitude, 3 to 8.5");
        add.required(
            "--distance", options.scenario.distance,
            "Distance to the surface projection of the rupture (Joyner-Boore), 0 to 400 km");
        add("--vs30", options.scenario.vs30,
            "Shear wave velocity of the upper 30 m, 150 to 1500 m/s (default: 760)");
        add("--faulting", options.scenario.faulting, "unspecified, strike-slip, normal or reverse")
            ->transform(CLI::CheckedTransformer(kFaulting).description(""));
        add("--period", options.periods, "Periods of Sa [s]; repeatable");
        add("--json", options.json, "Print JSON, in SI units, with correlations");
      });
}

}  // namespace gurney::cli
