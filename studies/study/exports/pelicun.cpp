#include "studies/study/exports/pelicun.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "studies/study/exports/outside_measure.h"
#include "studies/study/exports/sequences.h"

namespace gurney::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLimitStates = 4;  ///< groups of columns in the table of FEMA P-58

std::string header() {
  std::vector<std::string> names{"ID",          "Incomplete",    "Demand-Type",
                                 "Demand-Unit", "Demand-Offset", "Demand-Directional"};
  for (std::size_t i = 1; i <= kLimitStates; ++i)
    for (const char* each : {"Family", "Theta_0", "Theta_1", "DamageStateWeights"})
      names.push_back(fmt::format("LS{}-{}", i, each));
  return csv_line(names);
}

std::string row(const std::string& id, const OutsideMeasure& measure,
                const CurveSequence& sequence) {
  std::vector<std::string> cells{csv_cell(id), "0", csv_cell(measure.name), measure.unit, "0", "0"};
  for (const ChosenCurve& each : sequence.curves)
    for (const std::string& cell :
         {std::string("lognormal"), csv_cell(each.curve.theta / measure.unit_in_si),
          csv_cell(each.curve.beta), std::string()})
      cells.push_back(cell);
  cells.resize(6 + 4 * kLimitStates);
  return csv_line(cells);
}

Json limit_states(const CurveSequence& sequence) {
  Json states = Json::object();
  for (std::size_t i = 0; i < sequence.curves.size(); ++i) {
    const LimitState& state = sequence.curves[i].state;
    states[fmt::format("LS{}", i + 1)] = {{fmt::format("DS{}", i + 1),
                                           {{"Description", state.name + ": " + state.words},
                                            {"RepairAction", "Not part of this study."}}}};
  }
  return states;
}

/// What the curves are fitted to, each by its limit state where there are several.
std::string fitted_text(const CurveSequence& sequence, const ReportUnit& unit) {
  std::string text;
  for (const ChosenCurve& each : sequence.curves)
    text +=
        fmt::format("{}{}itted to {}; {} failed runs are not counted.{}", text.empty() ? "" : " ",
                    sequence.curves.size() > 1 ? each.state.name + ": f" : "F", basis_text(each),
                    each.failed, caution_text(each, unit));
  return sequence.adjusted ? text + fmt::format(" Caution: {}.", kAdjusted) : text;
}

Json description(const StudyData& data, const CurveSequence& sequence, const RunMeasure& measure,
                 const OutsideMeasure& outside) {
  const std::string title = data.file().text_attribute("title");
  const ChosenCurve& first = sequence.curves.front();
  std::vector<std::string> words;
  for (const ChosenCurve& each : sequence.curves) words.push_back(each.state.words);
  return {{"Description", fmt::format("{}{}{}: {}", title.empty() ? "Equipment on casters" : title,
                                      sequence.configuration.empty() ? "" : ", ",
                                      sequence.configuration, fmt::join(words, "; "))},
          {"Comments",
           fmt::format(
               "{} Intensity measure: {}, {:.4g} to {:.4g} {}. It is one number for "
               "both horizontal directions: set pelicun's multiplier for non-directional "
               "demands to 1 where the demand sample is of the same measure. Record-to-record "
               "and drawn scatter only; no dispersion was added. gurney {}, job SHA-256 {}.",
               fitted_text(sequence, {outside.unit, outside.unit_in_si}), measure.name,
               first.audit.lowest / outside.unit_in_si, first.audit.highest / outside.unit_in_si,
               outside.unit, data.file().text_attribute("program_version"),
               data.file().text_attribute("job_sha256"))},
          {"SuggestedComponentBlockSize", "1 EA"},
          {"RoundUpToIntegerQuantity", "True"},
          {"LimitStates", limit_states(sequence)}};
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
  for (const CurveSequence& each : sequences(chosen, choice.sequences)) {
    const std::string id =
        plain_identifier(data.file().text_attribute("job_name"), "study") +
        (each.configuration.empty() ? "" : "." + plain_identifier(each.configuration, "variant")) +
        "." + each.name;
    require(!descriptions.contains(id),
            fmt::format("{}: two components would be named {}; choose one with --configuration or "
                        "--limit",
                        data.file().path(), id));
    require(each.curves.size() <= kLimitStates,
            fmt::format("{}: {} has {} limit states; a component of the library has at most {}",
                        data.file().path(), id, each.curves.size(), kLimitStates));
    table += row(id, outside, each);
    for (const ChosenCurve& curve : each.curves)
      for (const std::string& caution : cautions(curve.audit, {outside.unit, outside.unit_in_si}))
        notes += csv_line({csv_cell(id), csv_cell(caution)});
    if (each.adjusted) notes += csv_line({csv_cell(id), csv_cell(std::string(kAdjusted))});
    descriptions[id] = description(data, each, chosen.measure, outside);
  }
  take("fragility.csv", table);
  take("fragility.json", descriptions.dump(2) + "\n");
  take("fragility_cautions.csv", notes);
  return chosen.left_out;
}

}  // namespace gurney::study
