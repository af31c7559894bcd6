#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/base/error.h"
#include "engine/base/shell_word.h"
#include "studies/analysis/demand_runs.h"
#include "studies/analysis/demands.h"
#include "studies/figures/demand_figures.h"
#include "studies/figures/labels.h"
#include "studies/figures/loss_figure.h"
#include "studies/figures/plan_figures.h"
#include "studies/figures/study_figures.h"
#include "studies/page/html.h"
#include "studies/page/study_page.h"
#include "studies/report/fragility_report.h"
#include "studies/report/loss_report.h"
#include "studies/report/overview_report.h"
#include "studies/report/study_report.h"

namespace gurney::page {
namespace {

std::string percent(std::size_t count, std::size_t of) {
  return of == 0 ? "\u2013" : fmt::format("{:.3g} %", 100.0 * double(count) / double(of));
}

Html tile(const std::string& value, const std::string& name) {
  return element("li", element("b", value) + element("span", name));
}

Html table_of(const StudyPage& page) {
  const auto& all = page.fragilities;
  findings::Table table = report::fragility_table(
      all, study::report_unit(page.data, all.front().measure),
      std::ranges::any_of(all, [](const auto& each) { return each.rate.has_value(); }));
  table.title = fmt::format("Lognormal fragility curves over {}", all.front().measure.name);
  return html(table);
}

Html notes_of(const StudyPage& page) {
  if (page.fragilities.empty()) return {};
  const std::vector<std::string> all = report::notes_on_curves(
      page.fragilities, study::report_unit(page.data, page.fragilities.front().measure));
  if (all.empty()) return {};
  return element("h3", "Notes on the curves") +
         (all.size() > 3 ? folded(counted(all.size(), "note"), list(all)) : list(all));
}

Html performance_of(const StudyPage& page) {
  Html all;
  for (const findings::Table& of : report::worst_level_tables(
           page.data, page.fragilities, study::performance_tables(page.data, page.fragilities)))
    all += html(of);
  return all.empty() ? all : element("h3", "Performance levels") + all;
}

constexpr std::size_t kMaxDemands = 3, kMaxHistories = 2000;

figures::PlotPage paper_of(const StudyPage& page) {
  return {.width = kNarrow, .most_marks = kMaxMarks, .units = page.overview.units, .apart = true};
}

/// The peak displacement, and the demands of items that limit states ask for.
std::vector<std::string> demands_of_interest(const study::StudyData& data) {
  std::vector<std::string> names{"peak_displacement"};
  for (const study::LimitState& state : data.limit_states()) {
    const std::string& column = state.quantity.column;
    const bool size = state.is_simple() && state.quantity.of == study::Quantity::Of::kItem &&
                      !column.starts_with("time_of_");
    if (size && std::ranges::find(names, column) == names.end() && names.size() < kMaxDemands)
      names.push_back(column);
  }
  return names;
}

std::vector<std::size_t> drawn_configurations(const study::StudyData& data) {
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < data.configurations().size() && drawn.size() < kMaxConfigurations;
       ++i)
    if (!data.runs_of(i).empty()) drawn.push_back(i);
  return drawn;
}

/// None where no run has it.
std::vector<study::DemandRuns> runs_of(const study::StudyData& data, const std::string& demand) {
  try {
    auto all = study::demand_runs(data, drawn_configurations(data), demand, data.measure(""));
    if (all.size() > kMaxItems) all.resize(kMaxItems);
    return all;
  } catch (const Error&) {
    return {};
  }
}

struct Kind {
  const char *name, *caption, *description;
  std::string (*draw)(const figures::PlotPage&, const std::string&,
                      const std::vector<study::DemandRuns>&);
};

constexpr Kind kDistributions{"cdf", "distribution at each level",
                              "Empirical distribution functions, one for each intensity level.",
                              figures::distribution_figure},
    kIda{"ida", "IDA curves",
         "Intensity over demand, a curve for each analysis case, with 16, 50 and 84 % fractiles.",
         figures::ida_figure},
    kStripes{"stripes", "stripes", "Demands at each intensity with median and fractiles.",
             figures::stripes_figure},
    kCloud{"cloud", "cloud with regression", "Demand over intensity on logarithmic axes.",
           figures::cloud_figure};

std::vector<Kind> kinds_for(const study::StudyData& data) {
  const study::IntensityPlan& plan = data.study().intensity;
  if (plan.kind == study::IntensityPlan::Kind::kIda) return {kIda, kCloud};
  if (plan.levels.size() + static_cast<std::size_t>(plan.more_stages) > 1)
    return {kStripes, kDistributions};
  return {kDistributions, kCloud};
}

/// What the figures leave out, and how to see it.
Html left_out(const StudyPage& page, std::size_t items) {
  const std::size_t configurations = page.data.configurations().size();
  std::vector<std::string> parts;
  if (configurations > kMaxConfigurations)
    parts.push_back(
        fmt::format("the first {} of {} configurations", kMaxConfigurations, configurations));
  if (items > kMaxItems) parts.push_back(fmt::format("the first {} of {} items", kMaxItems, items));
  if (parts.empty()) return {};
  return paragraph(
      fmt::format("These figures draw {}. Others: gurney plot {} cdf "
                  "--configuration NAME -o cdf.svg.",
                  fmt::join(parts, " and "), shell_word(page.path)));
}

/// Names the limit states that the figure leaves out.
Html without_panel(const StudyPage& page, const std::set<std::string>& with_curve) {
  std::vector<std::string> names;
  for (const study::FragilityResult& each : page.fragilities)
    if (!with_curve.contains(each.state) && std::ranges::find(names, each.state) == names.end())
      names.push_back(each.state);
  if (names.empty()) return {};
  return paragraph(
      fmt::format("Without a panel, as no configuration has a curve, for the reasons above: {}.",
                  fmt::join(names, "; ")));
}

/// Curves of the limit states that have one.
Html figure_of_curves(const StudyPage& page) {
  std::vector<study::FragilityResult> drawn;
  std::vector<std::string> configurations;
  std::set<std::string> with_curve;
  for (const study::FragilityResult& each : page.fragilities)
    if (each.curve()) with_curve.insert(each.state);
  for (const study::FragilityResult& each : page.fragilities) {
    if (!with_curve.contains(each.state)) continue;
    if (std::ranges::find(configurations, each.configuration) == configurations.end())
      configurations.push_back(each.configuration);
    if (configurations.size() <= kMaxConfigurations) drawn.push_back(each);
  }
  if (drawn.empty()) return {};
  const figures::PlotPage paper{.width = kNarrow, .most_marks = kMaxMarks, .apart = true};
  Html figure = side_by_side(html(
      Drawing{"fragility", figures::fragility_figure(page.data, drawn, paper),
              "Fragility curves with 95 % confidence bands, where there are enough records.",
              "Probability of exceedance over intensity; the table has medians and dispersions."}));
  figure += without_panel(page, with_curve);
  if (configurations.size() > kMaxConfigurations)
    figure += paragraph(fmt::format(
        "The figure draws the first {} of {} configurations. Others: gurney fragility {} "
        "--configuration NAME --figure fragility.svg.",
        kMaxConfigurations, configurations.size(), shell_word(page.path)));
  return figure;
}

}  // namespace

Section study_summary(const StudyPage& page) {
  const study::StudyOverview& overview = page.overview;
  Html tiles = tile(std::to_string(overview.runs), "runs") +
               tile(std::to_string(overview.overturned), "overturned") +
               tile(std::to_string(overview.failed), "failed") +
               tile(std::to_string(overview.configurations.size()), "configurations") +
               tile(std::to_string(overview.file.motions.size()), "records");
  for (std::size_t i = 0; i < overview.states.size(); ++i) {
    std::size_t exceeded = 0, runs = 0;
    for (const study::LevelCounts& each : overview.counts) {
      exceeded += each.exceeded[i];
      runs += each.counted();
    }
    tiles += tile(percent(exceeded, runs), "of runs: " + overview.states[i].name);
  }
  findings::Section answers;
  answers.add(report::answers_of(overview, page.data, page.fragilities));
  answers.add(report::compared_answers(overview, page.data));
  return {"summary", "At a glance",
          html(answers) + figure_of_curves(page) +
              caution_box(report::cautions_of(overview, page.data, page.fragilities)) +
              element("ul", tiles, {{"class", "key"}}) + html(report::energy_findings(overview))};
}

Section study_design(const StudyPage& page) {
  const study::StudyOverview& overview = page.overview;
  const std::string what =
      overview.configurations.size() > 1 ? "configuration " + overview.configurations.front() : "";
  return {"design", "What was run",
          html(report::design_findings(overview)) +
              (page.scene ? scene_drawings(*page.scene, what, overview.units)
                          : paragraph(page.no_scene))};
}

Section study_outcomes(const StudyPage& page) {
  return {"outcomes", "Outcomes", html(report::share_findings(page.overview))};
}

Section study_zones(const StudyPage& page) {
  return {"zones", "Zones", html(report::zone_findings(page.data))};
}

Section study_failures(const StudyPage& page) {
  const findings::Table table = report::failure_findings(page.overview);
  return {"failures", "Failed runs",
          table.rows.empty() ? paragraph("No run failed.") : html(table)};
}

Section study_time_step(const StudyPage& page) {
  if (page.overview.step_check)
    return {"time-step", "Time-step check",
            folded(fmt::format("{} with half the step: changes of their demands",
                               counted(page.overview.step_check->runs, "run")),
                   html(report::step_check_findings(*page.overview.step_check)))};
  return {"time-step", "Time-step check",
          paragraph("The study asked for none (study.step_check): how far the time step changes "
                    "these results is not known from this file.")};
}

Section study_fragility(const StudyPage& page) {
  if (page.fragilities.empty()) return {"fragility", "Fragility", {}};
  return {"fragility", "Fragility",
          paragraph("P(limit state | im) = \u03a6(ln(im / \u03b8) / \u03b2)") + table_of(page) +
              notes_of(page) + performance_of(page)};
}

Section study_loss(const StudyPage& page) {
  if (page.losses.empty()) return {"loss", "Loss", {}};
  const findings::Section facts = report::loss_findings(page.data, *page.consequences, page.losses);
  const auto figure = [&] {
    return html(
        Drawing{"loss",
                figures::loss_figure(*page.consequences, page.losses,
                                     study::report_unit(page.data, page.losses.front().measure)),
                "Expected loss at each level, and with a hazard how often a year the loss is above "
                "a value.",
                "Loss by level, with intervals; the tables have the numbers."});
  };
  const bool drawn = std::ranges::any_of(
      page.losses, [](const study::StudyLoss& loss) { return !loss.levels.empty(); });
  return {"loss", facts.title, (drawn ? figure() : Html{}) + html(facts)};
}

Section study_sensitivity(const StudyPage& page) {
  Html content;
  for (std::size_t i = 0; i < page.sensitivities.size(); ++i) {
    const report::SensitivityReport& each = page.sensitivities[i];
    const study::StudySensitivity& found = each.found;
    if (page.sensitivities.size() > 1 && !each.configuration.empty())
      content += element("h3", each.configuration);
    if (!each.why_not.empty()) {
      content += paragraph("No sensitivity: " + each.why_not);
      continue;
    }
    const std::vector<std::string> remarks = report::sensitivity_remarks(found);
    const Html figure =
        html(Drawing{fmt::format("sensitivity-{}", i + 1), figures::sensitivity_figure(each),
                     "Sensitivity: indices with 95 % intervals, and tornado.",
                     "First-order indices of the inputs, and means of the demand where an input is "
                     "low or high; the table has the numbers."});
    const bool stands_out = std::ranges::any_of(found.inputs, &study::SensitiveInput::stands_out);
    content += paragraph(report::sensitivity_title(each)) + paragraph(remarks.front()) +
               (stands_out ? figure : Html{}) +
               folded("Numbers and remarks", (stands_out ? Html{} : figure) +
                                                 html(report::sensitive_inputs(each)) +
                                                 list({remarks.begin() + 1, remarks.end()}));
  }
  return {"sensitivity", "Sensitivity", content};
}

Section study_demands(const StudyPage& page) {
  const study::StudyData& data = page.data;
  Html figures;
  std::size_t items = 0;
  for (const std::string& demand : demands_of_interest(data)) {
    const std::vector<study::DemandRuns> all = runs_of(data, demand);
    if (all.empty()) continue;
    items = std::max(
        items, study::demands_named(data, drawn_configurations(data).front(), {demand}).size());
    Html of_demand;
    for (const Kind& kind : kinds_for(data)) {
      std::string name = fmt::format("{}-{}", kind.name, demand);
      std::ranges::replace(name, '_', '-');
      of_demand +=
          html(Drawing{name, kind.draw(paper_of(page), "", all),
                       figures::label_of(demand) + ": " + kind.caption + ".", kind.description});
    }
    const std::string title = figures::label_of(demand);
    figures += figures.empty() ? element("h3", title) + side_by_side(of_demand)
                               : folded(title, side_by_side(of_demand));
  }
  const study::StoredHistories histories(page.path);
  const std::size_t kept = histories.names().empty() ? 0 : histories.runs().size();
  if (kept > 0 && kept <= kMaxHistories)
    figures += element("h3", "Paths") +
               html(Drawing{"paths",
                            figures::trajectory_figure(
                                {.most_marks = kMaxMarks, .units = page.overview.units}, page.path),
                            "Paths of the items seen from above, each from its start.",
                            fmt::format("Paths of {}.", counted(kept, "run"))});
  return {"demands", "Demands", left_out(page, items) + figures};
}

}  // namespace gurney::page
