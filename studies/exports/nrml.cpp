#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/error.h"
#include "studies/exports/chosen_curves.h"
#include "studies/exports/export.h"

namespace gurney::study {
namespace {

/// OpenQuake looks at a continuous curve between minIML and maxIML only: all but this much of it
/// must lie there.
constexpr double kTail = 1e-4;
/// Points of a discrete function. A curve of beta 0.4 is then met within 0.0002 by straight lines.
constexpr int kIntensities = 100;

std::string state_name(const ChosenCurve& curve) {
  return plain_identifier(curve.state.name, "limit");
}

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\t')
      escaped += c;
  }
  return escaped;
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
    span.low = std::min({span.low, each.audit.lowest / unit, curve.quantile(kTail)});
    span.high = std::max({span.high, each.audit.highest / unit, curve.quantile(1 - kTail)});
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

}  // namespace

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

}  // namespace gurney::study
