#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "studies/exports/chosen_curves.h"
#include "studies/exports/export.h"

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
  std::vector<std::string> cells{
      csv_cell(id), is_incomplete(sequence) ? "1" : "0", csv_cell(measure.name), measure.unit, "0",
      "0"};
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

/// Data behind the curves, each by its limit state where there are several.
std::string fitted_text(const CurveSequence& sequence, const ReportUnit& unit) {
  std::string text;
  for (const ChosenCurve& each : sequence.curves)
    text +=
        fmt::format("{}{}itted to {}; {} failed runs are not counted.{}", text.empty() ? "" : " ",
                    sequence.curves.size() > 1 ? each.state.name + ": f" : "F", basis_text(each),
                    each.failed, caution_text(each, unit));
  return sequence.adjusted ? text + fmt::format(" Caution: {}.", kAdjusted) : text;
}

constexpr const char* kBaker =
    "Baker, J. W. (2015). Efficient analytical fragility function fitting using dynamic structural "
    "analysis. Earthquake Spectra 31(1), 579-599.";
constexpr const char* kVamvatsikos =
    "Vamvatsikos, D. & Cornell, C. A. (2002). Incremental dynamic analysis. Earthquake Engineering "
    "& Structural Dynamics 31(3), 491-514.";
constexpr const char* kCornell =
    "Cornell, C. A., Jalayer, F., Hamburger, R. O. & Foutch, D. A. (2002). Probabilistic basis for "
    "2000 SAC FEMA steel moment frame guidelines. Journal of Structural Engineering 128(4), "
    "526-533.";
constexpr const char* kPorter =
    "Porter, K., Kennedy, R. & Bachman, R. (2007). Creating fragility functions for "
    "performance-based earthquake engineering. Earthquake Spectra 23(2), 471-489.";

/// Keys of the publications whose methods the curves rest on.
std::map<std::string, std::string> references(const CurveSequence& sequence) {
  std::map<std::string, std::string> all;
  for (const ChosenCurve& each : sequence.curves) {
    if (each.audit.of_demands)
      all["Cornell2002"] = kCornell;
    else if (each.audit.of_capacities)
      all["Vamvatsikos2002"] = kVamvatsikos;
    else
      all["Baker2015"] = kBaker;
  }
  if (sequence.adjusted) all["Porter2007"] = kPorter;
  return all;
}

std::string incomplete_text(const CurveSequence& sequence, bool has_supported) {
  if (!is_incomplete(sequence)) return "";
  return std::string(" Incomplete: the runs do not support every curve, see the cautions.") +
         (has_supported ? " The component of the same name with fewer states has the others." : "");
}

Json description(const StudyData& data, const CurveSequence& sequence, const RunMeasure& measure,
                 const OutsideMeasure& outside, bool has_supported) {
  const std::string title = data.file().text_attribute("title");
  const ChosenCurve& first = sequence.curves.front();
  std::vector<std::string> words;
  for (const ChosenCurve& each : sequence.curves) words.push_back(each.state.words);
  Json keys = Json::array();
  for (const auto& [key, citation] : references(sequence)) keys.push_back(key);
  return {{"Description", fmt::format("{}{}{}: {}", title.empty() ? "Equipment on casters" : title,
                                      sequence.configuration.empty() ? "" : ", ",
                                      sequence.configuration, fmt::join(words, "; "))},
          {"Comments",
           fmt::format(
               "{}{} Intensity measure: {}, {:.4g} to {:.4g} {}. It is one number for "
               "both horizontal directions: set pelicun's multiplier for non-directional "
               "demands to 1 where the demand sample is of the same measure. Record-to-record "
               "and drawn scatter only; no dispersion was added. gurney {}, job SHA-256 {}.",
               fitted_text(sequence, {outside.unit, outside.unit_in_si}),
               incomplete_text(sequence, has_supported), measure.name,
               first.audit.lowest / outside.unit_in_si, first.audit.highest / outside.unit_in_si,
               outside.unit, data.file().text_attribute("program_version"),
               data.file().text_attribute("job_sha256"))},
          {"Reference", keys},
          {"SuggestedComponentBlockSize", "1 EA"},
          {"RoundUpToIntegerQuantity", "True"},
          {"LimitStates", limit_states(sequence)}};
}

/// A library: the table, what its components are, and the cautions.
class Library {
 public:
  Library(const StudyData& data, const RunMeasure& measure, const OutsideMeasure& outside)
      : data_(data),
        measure_(measure),
        outside_(outside),
        job_(plain_identifier(data.file().text_attribute("job_name"), "study")) {}

  void add(const CurveSequence& sequence, bool has_supported) {
    const std::string group =
        job_ + (sequence.configuration.empty()
                    ? ""
                    : "." + plain_identifier(sequence.configuration, "variant"));
    const std::string id = group + "." + sequence.name;
    require(!descriptions_.contains(id),
            fmt::format("{}: two components would be named {}; choose one with --configuration or "
                        "--limit",
                        data_.file().path(), id));
    require(sequence.curves.size() <= kLimitStates,
            fmt::format("{}: {} has {} limit states; a component of the library has at most {}: "
                        "--separate, or choose one with --limit",
                        data_.file().path(), id, sequence.curves.size(), kLimitStates));
    table_ += row(id, outside_, sequence);
    for (const ChosenCurve& curve : sequence.curves)
      for (const std::string& caution : cautions(curve.audit, {outside_.unit, outside_.unit_in_si}))
        notes_ += csv_line({csv_cell(id), csv_cell(curve.state.name + ": " + caution)});
    if (sequence.adjusted) notes_ += csv_line({csv_cell(id), csv_cell(std::string(kAdjusted))});
    descriptions_[id] = description(data_, sequence, measure_, outside_, has_supported);
    references_.merge(references(sequence));
    groups_[group] = sequence.configuration.empty() ? job_ : sequence.configuration;
  }

  void take(const TakeFile& take) const {
    const std::string title = data_.file().text_attribute("title");
    Json groups = Json::object();
    for (const auto& [group, configuration] : groups_) groups[group] = configuration;
    Json all{{"_GeneralInformation",
              {{"ShortName", job_},
               {"Description",
                fmt::format("Fragility of equipment on casters over {}, fitted to the runs of a "
                            "study: {}",
                            measure_.name, title.empty() ? job_ : title)},
               {"Version", fmt::format("gurney {}, job SHA-256 {}",
                                       data_.file().text_attribute("program_version"),
                                       data_.file().text_attribute("job_sha256"))},
               {"ComponentGroups", groups}}},
             {"References", references_}};
    all.update(descriptions_);
    take("fragility.csv", table_);
    take("fragility.json", all.dump(2) + "\n");
    take("fragility_cautions.csv", notes_);
  }

 private:
  const StudyData& data_;
  const RunMeasure& measure_;
  const OutsideMeasure& outside_;
  std::string job_;
  std::string table_ = header(), notes_ = csv_line({"ID", "Caution"});
  Json descriptions_ = Json::object();
  std::map<std::string, std::string> references_, groups_;
};

}  // namespace

std::vector<std::string> export_pelicun(const StudyData& data, const ExportChoice& choice,
                                        const TakeFile& take) {
  const RunMeasure measure = data.measure(choice.measure);
  const OutsideMeasure outside =
      outside_measure(data, measure.name, "DLML, whose names pelicun knows,", dlml_measure);
  const ChosenCurves chosen = chosen_curves(data, choice);
  Library library(data, chosen.measure, outside);
  for (const CurveSequence& each : sequences(chosen, !choice.separate)) {
    const CurveSequence supported = supported_part(each);
    const bool has_part = is_incomplete(each) && !supported.curves.empty();
    library.add(each, has_part);
    if (has_part) library.add(supported, false);
  }
  library.take(take);
  return chosen.left_out;
}

}  // namespace gurney::study
