#include "studies/study/exports/pelicun.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "studies/study/exports/outside_measure.h"

namespace gurney::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kLimitStates = 4;  ///< groups of columns in the table of FEMA P-58, of which we use 1

std::string header() {
  std::vector<std::string> names{"ID",          "Incomplete",    "Demand-Type",
                                 "Demand-Unit", "Demand-Offset", "Demand-Directional"};
  for (int i = 1; i <= kLimitStates; ++i)
    for (const char* each : {"Family", "Theta_0", "Theta_1", "DamageStateWeights"})
      names.push_back(fmt::format("LS{}-{}", i, each));
  return csv_line(names);
}

std::string row(const std::string& id, const OutsideMeasure& measure,
                const statistics::LognormalCurve& curve) {
  std::vector<std::string> cells{csv_cell(id),
                                 "0",
                                 csv_cell(measure.name),
                                 measure.unit,
                                 "0",
                                 "0",
                                 "lognormal",
                                 csv_cell(curve.theta / measure.unit_in_si),
                                 csv_cell(curve.beta)};
  cells.resize(6 + 4 * kLimitStates);
  return csv_line(cells);
}

Json description(const StudyData& data, const ChosenCurve& each, const RunMeasure& measure,
                 const OutsideMeasure& outside) {
  const std::string title = data.file().text_attribute("title");
  return {
      {"Description",
       fmt::format("{}{}{}: {}", title.empty() ? "Equipment on casters" : title,
                   each.configuration.empty() ? "" : ", ", each.configuration, each.state.words)},
      {"Comments",
       fmt::format("Fitted to {}; {} failed runs are not counted. Intensity measure: {}, {:.4g} to "
                   "{:.4g} {}. It is one number for "
                   "both horizontal directions: set pelicun's multiplier for non-directional "
                   "demands to 1 where the demand sample is of the same measure. Record-to-record "
                   "and drawn scatter only; no dispersion was added.{} gurney {}, job SHA-256 {}.",
                   basis_text(each), each.failed, measure.name,
                   each.audit.lowest / outside.unit_in_si, each.audit.highest / outside.unit_in_si,
                   outside.unit, caution_text(each, {outside.unit, outside.unit_in_si}),
                   data.file().text_attribute("program_version"),
                   data.file().text_attribute("job_sha256"))},
      {"SuggestedComponentBlockSize", "1 EA"},
      {"RoundUpToIntegerQuantity", "True"},
      {"LimitStates",
       {{"LS1",
         {{"DS1",
           {{"Description", each.state.name + ": " + each.state.words},
            {"RepairAction", "Not part of this study."}}}}}}}};
}

}  // namespace

std::vector<std::string> export_pelicun(const StudyData& data, const ExportChoice& choice,
                                        const TakeFile& take) {
  const RunMeasure measure = data.measure(choice.measure);
  const OutsideMeasure outside =
      outside_measure(data, measure.name, "DLML, whose names pelicun knows,", dlml_measure);
  const ChosenCurves chosen = chosen_curves(data, choice);
  std::string table = header();
  std::string notes = csv_line({"ID", "Caution"});
  Json descriptions = Json::object();
  for (const ChosenCurve& each : chosen.curves) {
    const std::string id =
        plain_identifier(data.file().text_attribute("job_name"), "study") +
        (each.configuration.empty() ? "" : "." + plain_identifier(each.configuration, "variant")) +
        "." + plain_identifier(each.state.name, "limit");
    require(!descriptions.contains(id),
            fmt::format("{}: two components would be named {}; choose one with --configuration or "
                        "--limit",
                        data.file().path(), id));
    table += row(id, outside, each.curve);
    for (const std::string& caution : cautions(each.audit, {outside.unit, outside.unit_in_si}))
      notes += csv_line({csv_cell(id), csv_cell(caution)});
    descriptions[id] = description(data, each, chosen.measure, outside);
  }
  take("fragility.csv", table);
  take("fragility.json", descriptions.dump(2) + "\n");
  take("fragility_cautions.csv", notes);
  return chosen.left_out;
}

}  // namespace gurney::study
