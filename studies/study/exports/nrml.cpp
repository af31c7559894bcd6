#include "studies/study/exports/nrml.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/base/error.h"
#include "studies/study/exports/outside_measure.h"

namespace gurney::study {
namespace {

/// OpenQuake looks at a continuous curve between minIML and maxIML only: all but this much of it
/// must lie there.
constexpr double kTail = 1e-4;

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

std::string function_of(const ChosenCurve& each, const OutsideMeasure& measure,
                        const std::string& id, const std::string& state) {
  const statistics::LognormalCurve curve{each.curve.theta / measure.unit_in_si, each.curve.beta};
  const double low = std::min(each.audit.lowest / measure.unit_in_si, curve.quantile(kTail));
  const double high = std::max(each.audit.highest / measure.unit_in_si, curve.quantile(1 - kTail));
  return fmt::format(
      "    <fragilityFunction id=\"{}\" format=\"continuous\" shape=\"logncdf\">\n"
      "      <imls imt=\"{}\" noDamageLimit=\"0\" minIML=\"{}\" maxIML=\"{}\"/>\n"
      "      <params ls=\"{}\" mean=\"{}\" stddev=\"{}\"/>\n"
      "    </fragilityFunction>\n",
      id, measure.name, low, high, state, curve.mean(), curve.standard_deviation());
}

}  // namespace

std::vector<std::string> export_nrml(const StudyData& data, const ExportChoice& choice,
                                     const TakeFile& take) {
  const RunMeasure measure = data.measure(choice.measure);
  const OutsideMeasure outside =
      outside_measure(data, measure.name, "NRML, which knows ground motions only,", nrml_measure);
  const ChosenCurves chosen = chosen_curves(data, choice);
  const std::string job = plain_identifier(data.file().text_attribute("job_name"), "study");
  std::map<std::string, std::map<std::string, std::string>> functions;  // of states, by their ids
  std::map<std::string, std::string> words, about;                      // of states
  for (const ChosenCurve& each : chosen.curves) {
    const std::string state = plain_identifier(each.state.name, "limit");
    const std::string id =
        each.configuration.empty() ? job : plain_identifier(each.configuration, "variant");
    const bool fresh = functions[state].emplace(id, function_of(each, outside, id, state)).second;
    require(fresh, fmt::format("{}: two functions would be named {} in {}.xml; choose one with "
                               "--configuration or --limit",
                               data.file().path(), id, state));
    words[state] = each.state.words;
    about[state] += fmt::format(" {}: fitted to {}.{}", id, basis_text(each),
                                caution_text(each, {outside.unit, outside.unit_in_si}));
  }
  for (const auto& [state, all] : functions) {
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<nrml xmlns=\"http://openquake.org/xmlns/nrml/0.5\">\n"
        "  <fragilityModel id=\"{}_{}\" assetCategory=\"contents\" lossCategory=\"contents\">\n"
        "    <description>{}</description>\n    <limitStates>{}</limitStates>\n",
        job, state,
        xml_text(fmt::format("{}: {}. Intensity measure: {} [{}]. mean and stddev are those of "
                             "the intensity, not median and beta.{} gurney {}, job SHA-256 {}",
                             data.file().text_attribute("title"), words[state], measure.name,
                             outside.unit, about[state],
                             data.file().text_attribute("program_version"),
                             data.file().text_attribute("job_sha256"))),
        state);
    for (const auto& [id, function] : all) text += function;
    take(state + ".xml", text + "  </fragilityModel>\n</nrml>\n");
  }
  return chosen.left_out;
}

}  // namespace gurney::study
