#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/base/units.h"
#include "studies/page/study_page.h"

namespace gurney::page {
namespace {

using Kind = study::IntensityPlan::Kind;

constexpr const char* kBaker =
    "Baker, J. W. (2015). Efficient analytical fragility function fitting using dynamic structural "
    "analysis. Earthquake Spectra 31(1), 579-599.";
constexpr const char* kLiang =
    "Liang, K.-Y. & Zeger, S. L. (1986). Longitudinal data analysis using generalized linear "
    "models. Biometrika 73(1), 13-22.";
constexpr const char* kIda =
    "Vamvatsikos, D. & Cornell, C. A. (2002). Incremental dynamic analysis. Earthquake Engineering "
    "& Structural Dynamics 31(3), 491-514.";
constexpr const char* kCluster =
    "Varin, C., Reid, N. & Firth, D. (2011). An overview of composite likelihood methods. "
    "Statistica Sinica 21(1), 5-42.";
constexpr const char* kPlischke =
    "Plischke, E., Borgonovo, E. & Smith, C. L. (2013). Global sensitivity measures from given "
    "data. European Journal of Operational Research 226(3), 536-550.";
constexpr const char* kSaltelli =
    "Saltelli, A. et al. (2010). Variance based sensitivity analysis of model output. Computer "
    "Physics Communications 181(2), 259-270.";

/// Sentences for the methods of a paper, and the publications that they name.
struct Methods {
  std::vector<std::string> sentences, sources;
};
std::string program_of(const StudyPage& page) {
  const study::FileOverview& file = page.overview.file;
  std::string what = "Equipment";
  if (page.scene) {
    std::set<std::string> names;
    for (const PlacedItem& item : page.scene->scene.items) names.insert(item.model.name);
    what = fmt::format("{}", fmt::join(names, ", "));
  }
  std::string text = fmt::format(
      "The response of {} to floor motion was simulated with Gurney {} (commit {}, CPU class {})",
      what, file.program_version, file.git_commit, file.cpu_class);
  if (!page.scene) return text + ".";
  const SimulationSettings& settings = page.scene->settings;
  text += settings.tolerance > 0
              ? fmt::format(
                    ", with time steps of {:g} ms at most, chosen for a relative error of "
                    "{:g}",
                    1000 * settings.time_step, settings.tolerance)
              : fmt::format(", with a time step of {:g} ms", 1000 * settings.time_step);
  return text + fmt::format("; an item counts as overturned at a tilt of {:.3g} degrees.",
                            settings.overturn_tilt / kRadiansPerDegree);
}

std::string motions_of(const StudyPage& page, Methods& methods) {
  const study::StudyOverview& overview = page.overview;
  const std::size_t records = overview.file.motions.size();
  if (records == 0) return "The floor was at rest.";
  const study::IntensityPlan& plan = page.data.study().intensity;
  std::string text = counted(records, "ground motion record");
  if (plan.kind == Kind::kIda) {
    methods.sources.push_back(kIda);
    text += fmt::format(
        " {} scaled step by step in an incremental dynamic analysis over {} ("
        "Vamvatsikos & Cornell 2002) until the limit state {} was exceeded",
        records == 1 ? "was" : "were", overview.measure,
        page.data.study().limit_states[plan.until].words);
  } else if (plan.kind == Kind::kStripes) {
    if (overview.suite_by_level) text += ", a suite for each level,";
    text += fmt::format(" {} scaled to {} of {} ({}{}){}", records == 1 ? "was" : "were",
                        counted(overview.levels.size(), "level"), overview.measure,
                        overview.levels.front(),
                        overview.levels.size() > 1 ? " to " + overview.levels.back() : "",
                        plan.more_stages > 0 ? ", the later ones planned from the outcomes of the "
                                               "earlier"
                                             : "");
  } else {
    text += fmt::format(" {} applied with {} ({})", records == 1 ? "was" : "were",
                        overview.levels.size() == 1 ? "the factor" : "factors",
                        fmt::join(overview.levels, ", "));
  }
  if (overview.factors_on_records.any())
    text += ", scale factors " + overview.factors_on_records.text();
  if (overview.angles.size() > 1)
    text += fmt::format(", each at {} angles to the floor", overview.angles.size());
  return text + ".";
}

std::string factors_of(const study::StudyOverview& overview) {
  if (overview.configurations.size() < 2) return {};
  std::vector<std::string> factors;
  for (const auto& each : overview.factors)
    factors.push_back(fmt::format("{} ({})", each.name, fmt::join(each.levels, ", ")));
  return fmt::format("{} combine the levels of {}.",
                     counted(overview.configurations.size(), "configuration"),
                     fmt::join(factors, "; "));
}

std::string draws_of(const StudyPage& page) {
  const study::Study& study = page.data.study();
  if (study.draws == 0)
    return "Every parameter had its stated value; parameter uncertainty is not included.";
  const char* how = "";
  switch (study.sampling) {
    case Sampling::kMonteCarlo:
      how = "Monte Carlo sampling";
      break;
    case Sampling::kLatinHypercube:
      how = "Latin hypercube sampling";
      break;
    case Sampling::kSobol:
      how = "a shifted Sobol sequence";
      break;
    case Sampling::kSaltelli:
      how = "a Saltelli design";
      break;
  }
  return fmt::format(
      "Each record was combined with {} of the uncertain parameters from their distributions, by "
      "{} "
      "(seed {}).",
      counted(static_cast<std::size_t>(study.draws), "draw"), how, page.overview.file.seed);
}

std::string states_of(const study::StudyOverview& overview) {
  std::vector<std::string> states;
  for (const study::LimitState& state : overview.states)
    states.push_back(state.name == state.words ? state.words
                                               : fmt::format("{} ({})", state.name, state.words));
  return fmt::format("Limit states were {}.", fmt::join(states, "; "));
}

void add_fits(const StudyPage& page, Methods& methods) {
  const auto any = [&](auto has) { return std::ranges::any_of(page.fragilities, has); };
  if (any([](const auto& each) { return each.capacities && each.curve(); })) {
    methods.sentences.push_back(
        "Lognormal fragility curves were fitted to the capacities that the incremental dynamic "
        "analysis brackets for each record and limit state, as interval-censored data; records "
        "that never exceed are right-censored, and cases of one record share its weight (a "
        "composite likelihood; Varin et al. 2011).");
    methods.sources.push_back(kCluster);
  }
  if (any([](const auto& each) { return !each.capacities && each.curve(); })) {
    methods.sentences.push_back(
        "Lognormal fragility curves were fitted to the outcomes of the runs by maximum likelihood "
        "(Baker 2015); their 95 % intervals take into account that runs share records, by a "
        "cluster-robust covariance (Liang & Zeger 1986) and a bootstrap-t over records.");
    methods.sources.insert(methods.sources.end(), {kBaker, kLiang});
  }
  if (any([](const auto& each) { return each.rate.has_value(); }))
    methods.sentences.push_back(
        "Mean annual rates are the integral of the fragility over the site's hazard curve.");
  for (const report::SensitivityReport& each : page.sensitivities)
    if (each.why_not.empty()) {
      methods.sentences.push_back(
          fmt::format("Variance-based sensitivity indices were estimated from {} ({}).",
                      each.found.designed ? "the design" : "the runs as they are",
                      each.found.designed ? "Saltelli et al. 2010" : "Plischke et al. 2013"));
      methods.sources.push_back(each.found.designed ? kSaltelli : kPlischke);
      return;
    }
}

std::string step_of(const study::StudyOverview& overview) {
  if (!overview.step_check) return "The time step was not checked within the study.";
  const study::StepCheck& check = *overview.step_check;
  for (const study::StepChange& each : check.changes)
    if (study::name_of(each) == "peak_displacement" && each.compared > 0)
      return fmt::format(
          "In {} that {} repeated with half the time step the peak displacement "
          "changed by {:.2g} % in the median and {:.2g} % at most.",
          counted(check.runs, "run"), check.runs == 1 ? "was" : "were", 100 * each.median,
          100 * each.largest);
  return fmt::format("{} {} repeated with half the time step.", counted(check.runs, "run"),
                     check.runs == 1 ? "was" : "were");
}

Methods methods_of(const StudyPage& page) {
  const study::StudyOverview& overview = page.overview;
  Methods methods;
  methods.sentences = {program_of(page), motions_of(page, methods)};
  if (const std::string factors = factors_of(overview); !factors.empty())
    methods.sentences.push_back(factors);
  methods.sentences.push_back(draws_of(page));
  methods.sentences.push_back(overview.failed == 0
                                  ? fmt::format("None of {} failed.", counted(overview.runs, "run"))
                                  : fmt::format("Of {} {} failed and {} excluded.",
                                                counted(overview.runs, "run"), overview.failed,
                                                overview.failed == 1 ? "was" : "were"));
  methods.sentences.push_back(states_of(overview));
  add_fits(page, methods);
  methods.sentences.push_back(step_of(overview));
  return methods;
}

}  // namespace

Section study_methods(const StudyPage& page) {
  const Methods methods = methods_of(page);
  Html content = paragraph(
                     "A paragraph for the methods section of a paper, from the facts of "
                     "this file:") +
                 element("div", paragraph(fmt::format("{}", fmt::join(methods.sentences, " "))),
                         {{"class", "methods"}});
  if (!methods.sources.empty()) content += element("h3", "References") + list(methods.sources);
  return {"methods", "Methods", content};
}

}  // namespace gurney::page
