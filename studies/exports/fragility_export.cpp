#include "studies/exports/fragility_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/printable.h"
#include "engine/base/units.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/measures/measure.h"
#include "studies/exports/export.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/loss/study_loss.h"

namespace gurney::study {
namespace {

std::vector<std::size_t> chosen_states(const StudyData& data, const ExportChoice& choice) {
  if (!choice.limit.empty()) return {index_of(data.limit_states(), choice.limit)};
  std::vector<std::size_t> all(data.limit_states().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

constexpr double kCentimetersPerMeter = 100;

/// A measure of the study without its combination: "Sa(1) RotD50" is Sa(1).
groundmotions::Measure kind_of(const std::string& measure) {
  if (measure == "pfa") return {.kind = groundmotions::MeasureKind::kPfa};
  if (measure == "pfv") return {.kind = groundmotions::MeasureKind::kPfv};
  return groundmotions::parse_measure(measure.substr(0, measure.rfind(' ')));
}

std::string period_text(double period) {
  const std::string text = fmt::format("{}", period);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

bool has_usual_damping(const groundmotions::Measure& measure) {
  return std::abs(measure.damping - 0.05) < 1e-9;
}

using Curves = std::vector<statistics::LognormalCurve>;

/// Probabilities are compared between these quantiles of all curves, in as many steps.
constexpr double kTail = 1e-4, kAllowed = 1e-3;
constexpr int kSteps = 1000;

bool crosses(const Curves& curves) {
  double low = INFINITY, high = 0;
  for (const auto& curve : curves) {
    low = std::min(low, curve.quantile(kTail));
    high = std::max(high, curve.quantile(1 - kTail));
  }
  for (int i = 0; i <= kSteps; ++i) {
    const double im = low * std::pow(high / low, double(i) / kSteps);
    for (std::size_t k = 1; k < curves.size(); ++k)
      if (curves[k].probability(im) >= curves[k - 1].probability(im) + kAllowed) return true;
  }
  return false;
}

/// Whether the limit of `b` is one of the same requirement as that of `a`, and stricter.
bool is_stricter(const LimitState& b, const LimitState& a) {
  if (!a.is_simple() || a.kind != b.kind || a.quantity != b.quantity || a.at_least != b.at_least)
    return false;
  return a.kind == LimitState::Kind::kAbove ? b.limit > a.limit : b.limit < a.limit;
}

void add(std::vector<CurveSequence>& all, const ChosenCurve& curve) {
  for (CurveSequence& each : all) {
    if (each.configuration != curve.configuration) continue;
    const auto place = std::ranges::find_if(each.curves, [&](const ChosenCurve& other) {
      return is_stricter(other.state, curve.state);
    });
    const bool after =
        place != each.curves.begin() && is_stricter(curve.state, std::prev(place)->state);
    const bool first = place == each.curves.begin();  // one that is stricter comes next
    if (!after && !first) continue;
    each.curves.insert(place, curve);
    return;
  }
  all.push_back({curve.configuration, "", {curve}, false});
}

void complete(CurveSequence& sequence) {
  Curves curves;
  std::vector<std::string> names;
  for (const ChosenCurve& each : sequence.curves) {
    curves.push_back(each.curve);
    names.push_back(plain_identifier(each.state.name, "limit"));
  }
  sequence.name = fmt::format("{}", fmt::join(names, "_"));
  sequence.fitted = sequence.curves;
  sequence.adjusted = in_order(curves);
  for (std::size_t i = 0; i < curves.size(); ++i) sequence.curves[i].curve = curves[i];
}

/// OpenQuake looks at a continuous curve between minIML and maxIML only: all but this much of it
/// must lie there.
constexpr double kOutside = 1e-4;
/// Points of a discrete function. A curve of beta 0.4 is then met within 0.0002 by straight lines.
constexpr int kIntensities = 100;

std::string state_name(const ChosenCurve& curve) {
  return plain_identifier(curve.state.name, "limit");
}

/// Intensities between which a function is looked at, in the unit of the file.
struct Span {
  double low = INFINITY, high = 0;
};

std::vector<statistics::LognormalCurve> curves_of(const CurveSequence& sequence, double unit) {
  std::vector<statistics::LognormalCurve> curves;
  for (const ChosenCurve& each : sequence.curves)
    curves.push_back({each.curve.theta / unit, each.curve.beta});
  return curves;
}

Span span_of(const CurveSequence& sequence, double unit) {
  Span span;
  for (const ChosenCurve& each : sequence.curves) {
    const statistics::LognormalCurve curve{each.curve.theta / unit, each.curve.beta};
    span.low = std::min({span.low, each.audit.lowest / unit, curve.quantile(kOutside)});
    span.high = std::max({span.high, each.audit.highest / unit, curve.quantile(1 - kOutside)});
  }
  return span;
}

/// noDamageLimit is left out: OpenQuake warns of 0, and without it the curve itself counts.
std::string continuous(const CurveSequence& sequence, const OutsideMeasure& measure,
                       const std::string& id) {
  const Span span = span_of(sequence, measure.unit_in_si);
  std::string text = fmt::format(
      "    <fragilityFunction id=\"{}\" format=\"continuous\" shape=\"logncdf\">\n"
      "      <imls imt=\"{}\" minIML=\"{}\" maxIML=\"{}\"/>\n",
      id, measure.name, span.low, span.high);
  const auto curves = curves_of(sequence, measure.unit_in_si);
  for (std::size_t i = 0; i < curves.size(); ++i)
    text += fmt::format("      <params ls=\"{}\" mean=\"{}\" stddev=\"{}\"/>\n",
                        state_name(sequence.curves[i]), curves[i].mean(),
                        curves[i].standard_deviation());
  return text + "    </fragilityFunction>\n";
}

/// OpenQuake interpolates linearly, from 0 at noDamageLimit to the first probability and between
/// them; without the limit what is below the first intensity has no probability at all.
std::string discrete(const CurveSequence& sequence, const OutsideMeasure& measure,
                     const std::string& id) {
  const Span span = span_of(sequence, measure.unit_in_si);
  std::vector<double> intensities;
  for (int i = 1; i <= kIntensities; ++i)
    intensities.push_back(span.low * std::pow(span.high / span.low, double(i) / kIntensities));
  std::string text = fmt::format(
      "    <fragilityFunction id=\"{}\" format=\"discrete\">\n"
      "      <imls imt=\"{}\" noDamageLimit=\"{}\">{}</imls>\n",
      id, measure.name, span.low, fmt::join(intensities, " "));
  std::vector<double> before(intensities.size(), 1.0);
  const auto curves = curves_of(sequence, measure.unit_in_si);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (std::size_t i = 0; i < intensities.size(); ++i)
      before[i] = std::min(before[i], curves[k].probability(intensities[i]));
    text += fmt::format("      <poes ls=\"{}\">{}</poes>\n", state_name(sequence.curves[k]),
                        fmt::join(before, " "));
  }
  return text + "    </fragilityFunction>\n";
}

/// All functions of the same states: one file.
struct Model {
  std::string states, words, about;
  std::map<std::string, std::string> functions;  // by their ids
};

void add(const CurveSequence& sequence, const OutsideMeasure& measure, const std::string& id,
         Model& model) {
  model.states.clear();
  model.words.clear();
  for (const ChosenCurve& each : sequence.curves) {
    const char* const next = model.states.empty() ? "" : " ";
    model.states += next + state_name(each);
    model.words += (*next ? "; " : "") + each.state.words;
    model.about += fmt::format(
        " {}{}: fitted to {}.{}", id, sequence.curves.size() > 1 ? ", " + state_name(each) : "",
        basis_text(each), caution_text(each, {measure.unit, measure.unit_in_si}));
  }
  if (sequence.adjusted) model.about += fmt::format(" Caution: {}.", kAdjusted);
}

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

/// The item that the states of a component are of, with its price.
/// @throws Error where it is any of several
PricedItem item_of(const StudyData& data, const CurveSequence& sequence,
                   const Consequences& consequences) {
  const auto configuration =
      static_cast<std::size_t>(std::ranges::find(data.configurations(), sequence.configuration) -
                               data.configurations().begin());
  std::vector<std::string> unpriced;
  std::vector<PricedItem> items = priced_items(data, configuration, consequences, unpriced);
  const LimitState& state = sequence.curves.front().state;
  const std::string& named = state.quantity.item;
  if (!named.empty())
    std::erase_if(items, [&](const PricedItem& item) { return item.name != named; });
  require(items.size() == 1 && (!named.empty() || unpriced.empty()),
          fmt::format("{}: limit state '{}' must be of one item with a price in {}, such as "
                      "--limit-state 'ITEM: {}'",
                      data.file().path(), state.name, consequences.path(), state.words));
  return items.front();
}

/// Limit states as those of any item.
std::vector<LimitState> of_any_item(std::vector<LimitState> states) {
  for (LimitState& state : states) state.quantity.item.clear();
  return states;
}

/// Consequence of the same requirement, whatever its name.
/// @throws Error where there is none
const Consequence& consequence_of(const StudyData& data, const ChosenCurve& curve,
                                  const PricedItem& item, const Consequences& consequences) {
  const std::vector<LimitState> known = of_any_item(consequences.limit_states()),
                                states = of_any_item(data.limit_states());
  const std::size_t state = index_of(states, curve.state.name);
  for (std::size_t i = 0; i < known.size(); ++i)
    if (const Consequence* const of = consequences.of(item.equipment, i);
        of != nullptr && same_state(states, state, known, i))
      return *of;
  std::vector<std::string> names;
  for (const LimitState& each : known) {
    names.push_back(each.name);
    require(each.name != curve.state.name,
            fmt::format("{}: '{}' is {} there, but {} in {}: no consequence is stated for the "
                        "latter; give it a consequence of its own",
                        consequences.path(), each.name, each.words, curve.state.words,
                        data.file().path()));
  }
  throw Error(fmt::format("{}: no consequence of '{}' ({}) for {}{}", consequences.path(),
                          curve.state.name, curve.state.words, item.equipment,
                          config::suggestion(curve.state.name, names)));
}

std::string consequence_header() {
  std::vector<std::string> names{"ID", "Incomplete", "Quantity-Unit", "DV-Unit"};
  for (std::size_t i = 1; i <= kLimitStates; ++i)
    for (const char* each : {"Family", "Theta_0", "Theta_1", "LongLeadTime"})
      names.push_back(fmt::format("DS{}-{}", i, each));
  return csv_line(names);
}

/// Rows of consequence_repair.csv in the form of DLML: expected cost and time of each damage state.
/// Damage states exclude each other in pelicun, but a run that reaches one has reached those before
/// it, and costs what the worst of them does (item_loss()).
/// @param notes  gets where one before it costs more
std::string consequence_rows(const StudyData& data, const std::string& id,
                             const CurveSequence& sequence, const Consequences& consequences,
                             std::string& notes) {
  const PricedItem item = item_of(data, sequence, consequences);
  std::vector<std::string> cost{csv_cell(id + "-Cost"), "0", "1 EA", consequences.currency()},
      time{csv_cell(id + "-Time"), "0", "1 EA", "day"};
  double cost_before = 0, days_before = 0;
  for (const ChosenCurve& curve : sequence.curves) {
    const Consequence& of = consequence_of(data, curve, item, consequences);
    const auto at_least = [&](double& before, double value, const char* what) {
      if (value < before)
        notes +=
            csv_line({csv_cell(id),
                      csv_cell(fmt::format("{}: its {} is that of a milder state, {:g}, which is "
                                           "more than its own, {:g}",
                                           curve.state.name, what, before, value))});
      before = std::max(before, value);
    };
    at_least(cost_before, mean_of(item.price) * mean_of(of.cost_ratio), "cost");
    at_least(days_before, mean_of(of.days), "time");
    const auto add = [](std::vector<std::string>& cells, double value) {
      for (const std::string& cell :
           {std::string(), csv_cell(value), std::string(), std::string("0")})
        cells.push_back(cell);
    };
    add(cost, cost_before);
    add(time, days_before);
  }
  for (std::vector<std::string>* const cells : {&cost, &time}) cells->resize(4 + 4 * kLimitStates);
  return csv_line(cost) + csv_line(time);
}

/// A library: the table, what its components are, and the cautions.
class Library {
 public:
  Library(const StudyData& data, const RunMeasure& measure, const OutsideMeasure& outside,
          const Consequences* consequences)
      : data_(data),
        measure_(measure),
        outside_(outside),
        consequences_(consequences),
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
    if (consequences_ != nullptr)
      repair_ += consequence_rows(data_, id, sequence, *consequences_, notes_);
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
    take("fragility.json", all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    take("fragility_cautions.csv", notes_);
    if (consequences_ != nullptr) take("consequence_repair.csv", repair_);
  }

 private:
  const StudyData& data_;
  const RunMeasure& measure_;
  const OutsideMeasure& outside_;
  const Consequences* consequences_;
  std::string job_;
  std::string table_ = header(), notes_ = csv_line({"ID", "Caution"}),
              repair_ = consequence_header();
  Json descriptions_ = Json::object();
  std::map<std::string, std::string> references_, groups_;
};

}  // namespace

std::string basis_text(const ChosenCurve& curve) {
  const CurveAudit& of = curve.audit;
  if (of.of_demands)
    return fmt::format("the demands of {} runs with {} records (cloud)", of.outcomes,
                       curve.records);
  return of.of_capacities ? fmt::format("capacities of {} {}, of which {} exceed", of.outcomes,
                                        of.counted, of.exceeded)
                          : fmt::format("{} runs with {} records, of which {} exceed", of.outcomes,
                                        curve.records, of.exceeded);
}

std::string caution_text(const ChosenCurve& curve, const ReportUnit& unit) {
  std::string text;
  for (const std::string& each : cautions(curve.audit, unit)) text += " Caution: " + each + ".";
  return text;
}

ChosenCurves chosen_curves(const StudyData& data, const ExportChoice& choice) {
  ChosenCurves chosen{data.measure(choice.measure), {}, {}};
  const std::vector<std::size_t> states = chosen_states(data, choice);
  for (const std::size_t configuration : wanted_configurations(data, choice.configurations))
    for (const std::size_t state : states) {
      const FittedCurve fitted =
          fitted_curve(data, state, configuration, chosen.measure, choice.method);
      const std::optional<statistics::LognormalCurve> curve = fitted.curve();
      const LimitState& limit = data.limit_states()[state];
      if (!curve) {
        chosen.left_out.push_back(
            fmt::format("{}{}'{}': {}", data.configurations()[configuration],
                        data.configurations()[configuration].empty() ? "" : ", ", limit.name,
                        no_curve_text(fitted, report_unit(data, chosen.measure))));
        continue;
      }
      chosen.curves.push_back({data.configurations()[configuration], limit, *curve,
                               fitted.fit.groups, data.failed(configuration), fitted.audit});
    }
  require(!chosen.curves.empty(),
          fmt::format("{}: no fragility curve over {} can be fitted; nothing was written\n  {}",
                      data.file().path(), chosen.measure.name, fmt::join(chosen.left_out, "\n  ")));
  return chosen;
}

std::optional<OutsideMeasure> dlml_measure(const std::string& measure) {
  const groundmotions::Measure of = kind_of(measure);
  switch (of.kind) {
    case groundmotions::MeasureKind::kPga:
      return OutsideMeasure{"Peak Ground Acceleration", "g", kStandardGravity};
    case groundmotions::MeasureKind::kPgv:
      return OutsideMeasure{"Peak Ground Velocity", "mps", 1};
    case groundmotions::MeasureKind::kPfa:
      return OutsideMeasure{"Peak Floor Acceleration", "g", kStandardGravity};
    case groundmotions::MeasureKind::kPfv:
      return OutsideMeasure{"Peak Floor Velocity", "mps", 1};
    case groundmotions::MeasureKind::kSa:
      if (!has_usual_damping(of)) return {};
      return OutsideMeasure{"Spectral Acceleration|" + period_text(of.period), "g",
                            kStandardGravity};
    default:
      return {};
  }
}

std::optional<OutsideMeasure> nrml_measure(const std::string& measure) {
  const groundmotions::Measure of = kind_of(measure);
  switch (of.kind) {
    case groundmotions::MeasureKind::kPga:
      return OutsideMeasure{"PGA", "g", kStandardGravity};
    case groundmotions::MeasureKind::kPgv:
      return OutsideMeasure{"PGV", "cm/s", 1 / kCentimetersPerMeter};
    case groundmotions::MeasureKind::kSa:
      if (!has_usual_damping(of) || !(of.period > 0)) return {};
      return OutsideMeasure{"SA(" + period_text(of.period) + ")", "g", kStandardGravity};
    case groundmotions::MeasureKind::kPgd:
      return OutsideMeasure{"PGD", "cm", 1 / kCentimetersPerMeter};
    case groundmotions::MeasureKind::kArias:
      return OutsideMeasure{"IA", "m/s", 1};
    case groundmotions::MeasureKind::kCav:
      return OutsideMeasure{"CAV", "g s", kStandardGravity};
    case groundmotions::MeasureKind::kD575:
      return OutsideMeasure{"RSD575", "s", 1};
    case groundmotions::MeasureKind::kD595:
      return OutsideMeasure{"RSD595", "s", 1};
    case groundmotions::MeasureKind::kFiv3:
      return OutsideMeasure{"FIV3(" + period_text(of.period) + ")", "cm/s",
                            1 / kCentimetersPerMeter};
    default:
      return {};
  }
}

OutsideMeasure outside_measure(const StudyData& data, const std::string& measure,
                               const std::string& format, NameMeasure name) {
  if (const auto found = name(measure)) return *found;
  std::vector<std::string> named;
  for (const std::string& each : data.measures())
    if (name(each)) named.push_back("'" + each + "'");
  throw Error(fmt::format(
      "{}: {} has no name for the intensity measure '{}'; {}", data.file().path(), format, measure,
      named.empty() ? "nor for any other of this study"
                    : fmt::format("take one of these with --measure: {}", fmt::join(named, ", "))));
}

bool in_order(Curves& curves) {
  if (!crosses(curves)) return false;
  double mean = 0;
  for (const auto& curve : curves) mean += curve.beta / static_cast<double>(curves.size());
  double milder = 0;
  for (auto& curve : curves) {
    curve = {std::max(milder, curve.theta * std::exp(1.28 * (mean - curve.beta))), mean};
    milder = curve.theta;
  }
  return true;
}

bool is_incomplete(const CurveSequence& sequence) {
  return !std::ranges::all_of(sequence.curves, &ChosenCurve::is_supported);
}

CurveSequence supported_part(const CurveSequence& sequence) {
  CurveSequence part{sequence.configuration, "", {}, false};
  std::ranges::copy_if(sequence.fitted, std::back_inserter(part.curves),
                       &ChosenCurve::is_supported);
  if (!part.curves.empty()) complete(part);
  return part;
}

std::vector<CurveSequence> sequences(const ChosenCurves& chosen, bool combine) {
  std::vector<CurveSequence> all;
  for (const ChosenCurve& each : chosen.curves)
    if (combine)
      add(all, each);
    else
      all.push_back({each.configuration, "", {each}, false});
  for (CurveSequence& each : all) complete(each);
  return all;
}

std::vector<std::string> export_nrml(const StudyData& data, const ExportChoice& choice,
                                     const TakeFile& take) {
  const RunMeasure measure = data.measure(choice.measure);
  const OutsideMeasure outside =
      outside_measure(data, measure.name, "NRML, which knows ground motions only,", nrml_measure);
  const ChosenCurves chosen = chosen_curves(data, choice);
  const std::string job = plain_identifier(data.file().text_attribute("job_name"), "study");
  std::map<std::string, Model> models;  // by the names of their files
  for (const CurveSequence& each : sequences(chosen, !choice.separate)) {
    const std::string id =
        each.configuration.empty() ? job : plain_identifier(each.configuration, "variant");
    const std::string text =
        choice.discrete ? discrete(each, outside, id) : continuous(each, outside, id);
    Model& model = models[each.name];
    require(model.functions.emplace(id, text).second,
            fmt::format("{}: two functions would be named {} in {}.xml; choose one with "
                        "--configuration or --limit",
                        data.file().path(), id, each.name));
    add(each, outside, id, model);
  }
  for (const auto& [name, model] : models) {
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<nrml xmlns=\"http://openquake.org/xmlns/nrml/0.5\">\n"
        "  <fragilityModel id=\"{}_{}\" assetCategory=\"contents\" lossCategory=\"contents\">\n"
        "    <description>{}</description>\n    <limitStates>{}</limitStates>\n",
        job, name,
        xml_text(fmt::format("{}: {}. Intensity measure: {} [{}].{}{} gurney {}, job SHA-256 {}",
                             data.file().text_attribute("title"), model.words, measure.name,
                             outside.unit,
                             choice.discrete ? ""
                                             : " mean and stddev are those of the intensity, not "
                                               "median and beta.",
                             model.about, data.file().text_attribute("program_version"),
                             data.file().text_attribute("job_sha256"))),
        model.states);
    for (const auto& [id, function] : model.functions) text += function;
    take(name + ".xml", text + "  </fragilityModel>\n</nrml>\n");
  }
  return chosen.left_out;
}

std::vector<std::string> export_pelicun(const StudyData& data, const ExportChoice& choice,
                                        const TakeFile& take) {
  const RunMeasure measure = data.measure(choice.measure);
  const OutsideMeasure outside =
      outside_measure(data, measure.name, "DLML, whose names pelicun knows,", dlml_measure);
  const ChosenCurves chosen = chosen_curves(data, choice);
  Library library(data, chosen.measure, outside, choice.consequences);
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
