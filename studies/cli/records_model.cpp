#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/units.h"
#include "groundmotions/models/bssa14.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"

namespace gurney::cli {
namespace {

using groundmotions::Faulting;
using groundmotions::Prediction;

const char* const kSource =
    "Boore, Stewart, Seyhan & Atkinson (2014), Earthquake Spectra 30(3), 1057-1085; RotD50";
const char* const kLeftOut =
    "regional terms (attenuation of China, Turkey, Italy, Japan) and the basin term are not "
    "included";

struct ModelOptions {
  groundmotions::Scenario scenario;
  std::vector<double> periods = {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1, 1.5, 2, 3, 5, 10};
  bool json = false;
};

findings::Section& add_prediction(findings::Section& to, const Prediction& p) {
  to.json("median", p.median).json("tau", p.tau);
  return to.json("phi", p.phi).json("sigma", p.sigma());
}

int print_json(const ModelOptions& options) {
  findings::Section all, pgv("pgv_m_per_s");
  all.json("source", kSource).json("left_out", kLeftOut);
  all.add(add_prediction(pgv, bssa14_pgv(options.scenario)));
  std::vector<findings::Numbers> correlation;
  for (const double a : options.periods) {
    findings::Section row("sa_m_per_s2[]");
    add_prediction(row.json("period_s", a), bssa14_sa(options.scenario, a));
    if (a > 0) row.json("correlation_with_pgv", groundmotions::pgv_correlation(a));
    all.add(std::move(row));
    findings::Numbers& with = correlation.emplace_back();
    for (const double b : options.periods)
      with.push_back(a > 0 && b > 0 ? groundmotions::epsilon_correlation(a, b) : std::nan(""));
  }
  print_findings(all.json("correlation", correlation), true);
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
        const std::vector<std::string>& faulting = groundmotions::faulting_names();
        add.calling<std::string>(
               "--faulting",
               [&](const std::string& name) {
                 options.scenario.faulting =
                     static_cast<Faulting>(std::ranges::find(faulting, name) - faulting.begin());
               },
               "unspecified, strike-slip, normal or reverse")
            ->check(CLI::IsMember(faulting).description(""));
        add("--period", options.periods, "Periods of Sa [s]; repeatable");
        add("--json", options.json, "Print JSON, in SI units, with correlations");
      });
}

}  // namespace gurney::cli
