#include "studies/figures/spectra_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/base/error.h"
#include "studies/figures/labels.h"
#include "studies/statistics/quantiles.h"

namespace gurney::figures {
namespace {

using Suite = study::SuiteSpectra;

struct View {
  const char* name;
  std::string (*title)(const Suite&);
  Eigen::VectorXd (*spectrum)(const Suite::Record&);
};

std::string factors_of(const Suite& suite) {
  const auto [low, high] = std::ranges::minmax(suite.records, {}, &Suite::Record::factor);
  return low.factor == high.factor
             ? fmt::format("factor {:.3g}", low.factor)
             : fmt::format("factors {:.3g} to {:.3g}", low.factor, high.factor);
}

std::string title_of_scaled(const Suite& suite) {
  return fmt::format("Scaled to {}, {}", suite.level, factors_of(suite));
}

const View kViews[] = {
    {"records", [](const Suite&) -> std::string { return "Records as read and processed"; },
     [](const Suite::Record& record) { return record.ground; }},
    {"scaled", title_of_scaled,
     [](const Suite::Record& record) -> Eigen::VectorXd { return record.factor * record.ground; }},
    {"floor", [](const Suite& suite) { return "Floor, records scaled to " + suite.level; },
     [](const Suite::Record& record) { return record.floor; }}};

bool has(const Suite& suite, const View& view) {
  return view.spectrum(suite.records.front()).size() > 0;
}

bool changes(const Suite& suite) {
  return std::ranges::any_of(suite.records, [](const auto& each) { return each.factor != 1; });
}

std::vector<View> views_of(const std::vector<Suite>& suites, const std::vector<std::string>& what) {
  std::vector<View> views;
  for (const std::string& each : what)
    require(std::ranges::find(kViews, each, &View::name) != std::end(kViews),
            fmt::format("no spectra of '{}'; there are records, scaled, floor", each));
  for (const View& view : kViews) {
    const std::string name = view.name;
    const bool wanted = std::ranges::find(what, name) != what.end();
    const bool there = std::ranges::any_of(suites, [&](const Suite& each) {
      return has(each, view) && (wanted || name != "scaled" || changes(each));
    });
    require(there || !wanted, "no spectra of the floor: the study has no building");
    if (there && (wanted || what.empty())) views.push_back(view);
  }
  return views;
}

/// Fractiles at each period, as one curve with a gap: it is drawn whole or not at all.
Curve fractiles(const std::vector<Eigen::VectorXd>& spectra, const Eigen::VectorXd& periods,
                const std::vector<double>& fractions, const std::string& label, const Pen& pen,
                double unit) {
  constexpr double kNoPoint = std::numeric_limits<double>::quiet_NaN();
  Curve curve{label, {}, {}, pen};
  for (const double fraction : fractions) {
    if (!curve.x.empty()) {
      curve.x.push_back(kNoPoint);
      curve.y.push_back(kNoPoint);
    }
    for (Eigen::Index i = 0; i < periods.size(); ++i) {
      std::vector<double> values;
      for (const Eigen::VectorXd& each : spectra) values.push_back(each[i] / unit);
      curve.x.push_back(periods[i]);
      curve.y.push_back(statistics::quantile_of(values, fraction));
    }
  }
  return curve;
}

PlotPanel panel_of(const Suite& suite, const View& view, bool named,
                   const study::ReportUnit& unit) {
  std::string which = suite.configurations.front();
  if (suite.configurations.size() > 1)
    which += fmt::format(" and {} more", suite.configurations.size() - 1);
  Panel panel{.title = view.title(suite) + (named && !which.empty() ? ", " + which : ""),
              .x_label = "Period (s)",
              .y_label = with_unit(std::string("Sa ") + name_of(suite.combination), unit),
              .zero_line = false,
              .log_x = true,
              .legend_columns = 3,
              .log_y = true};
  std::vector<Eigen::VectorXd> spectra;
  for (const Suite::Record& record : suite.records) {
    spectra.push_back(view.spectrum(record));
    Curve curve{spectra.size() == 1 && suite.records.size() > 1 ? "records" : "",
                {suite.periods.begin(), suite.periods.end()},
                {},
                {.stroke = "#999999", .width = 0.7}};
    if (suite.records.size() == 1) {
      curve.label = record.name;
      curve.pen = {.stroke = palette(0), .width = 1.8};
    }
    for (const double value : spectra.back()) curve.y.push_back(value / unit.in_si);
    panel.curves.push_back(std::move(curve));
  }
  if (suite.records.size() < 2) return {.panel = panel, .aspect = 0.6};
  panel.curves.push_back(fractiles(spectra, suite.periods, {0.5}, "median",
                                   {.stroke = palette(0), .width = 2}, unit.in_si));
  panel.curves.push_back(fractiles(spectra, suite.periods, {0.16, 0.84}, "16 and 84 % fractiles",
                                   {.stroke = palette(1), .width = 1.5, .dash = "6 3"},
                                   unit.in_si));
  return {.panel = panel, .aspect = 0.6};
}

}  // namespace

std::string spectra_figure(const PlotPage& page, const std::string& title,
                           const std::vector<Suite>& suites, const std::vector<std::string>& what) {
  std::vector<PlotPanel> panels;
  std::size_t records = 0;
  const std::vector<View> views = views_of(suites, what);
  for (const Suite& suite : suites) {
    records += suite.records.size();
    for (const View& view : views)
      if (has(suite, view))
        panels.push_back(panel_of(suite, view, suites.size() > 1, page.units.of("m/s2")));
  }
  return Chart{title,
               fmt::format("pseudo-acceleration, 5 % damping; {} record{}", records,
                           records == 1 ? "" : "s"),
               panels}
      .svg(page);
}

std::string floor_spectra_figure(const PlotPage& page, const std::string& title,
                                 const study::FloorSpectra& spectra) {
  const study::ReportUnit unit = page.units.of("m/s2");
  Panel panel{.title = "Floor",
              .x_label = "Period (s)",
              .y_label = with_unit("Sa", unit),
              .zero_line = false,
              .log_x = true,
              .legend_columns = 3,
              .log_y = true};
  const char* const dashes[] = {"", "6 3", "2 2"};
  for (const auto& [axis, values] : spectra.of_axis) {
    const std::size_t index = panel.curves.size();
    Curve curve{axis,
                {spectra.periods.begin(), spectra.periods.end()},
                {},
                {.stroke = palette(index), .width = 1.6, .dash = dashes[index % 3]}};
    for (const double value : values) curve.y.push_back(value / unit.in_si);
    panel.curves.push_back(std::move(curve));
  }
  return Chart{
      title, "pseudo-acceleration, 5 % damping; floor axes", {{.panel = panel, .aspect = 0.55}}}
      .svg(page);
}

}  // namespace gurney::figures
