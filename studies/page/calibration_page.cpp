#include <fmt/format.h>

#include "studies/figures/pulling_figures.h"
#include "studies/page/drawing.h"
#include "studies/page/findings_html.h"
#include "studies/page/json_findings.h"

namespace gurney::page {
namespace {

using namespace findings;

figures::Range range_of(const Table& table, std::size_t row, const char* key, double over) {
  const auto& ends = std::get<Numbers>(value_in(table, row, key));
  return {ends[0] / over, ends[1] / over};
}

Html load_drawing(const Table& constants, const Table& pulls) {
  std::vector<figures::LoadLine> lines;
  for (std::size_t i = 0; i < constants.rows.size(); ++i) {
    if (text_in(constants, i, "name") != "rolling_resistance") continue;
    const std::string &caster = text_in(constants, i, "caster"),
                      &floor = text_in(constants, i, "floor");
    const double value = number_in(constants, i, "value");
    figures::LoadLine line{fmt::format("{} on {}: Cr/R {:.4g}", caster, floor, value),
                           value,
                           range_of(constants, i, "interval_95", 1),
                           range_of(constants, i, "prediction_95", 1),
                           {},
                           {}};
    for (std::size_t k = 0; k < pulls.rows.size(); ++k) {
      if (text_in(pulls, k, "caster") != caster || text_in(pulls, k, "floor") != floor) continue;
      line.load.push_back(number_in(pulls, k, "normal_force_n"));
      line.resistance.push_back(number_in(pulls, k, "resistance_n"));
    }
    lines.push_back(line);
  }
  if (pulls.rows.empty() || lines.empty()) return {};
  return html(Drawing{"loads", figures::load_figure({.width = 480}, lines),
                      "Rolling resistance of the pulls, and the fitted lines f_r = (Cr/R) N.",
                      "Marks are pulls for calibration; lines start at the origin. The numbers are "
                      "in the table of pulls below."});
}

Html residual_drawing(const Table& constants, const Table& values) {
  std::vector<figures::ResidualRow> rows;
  for (std::size_t i = 0; i < constants.rows.size(); ++i) {
    const std::string& about = text_in(constants, i, "constant");
    const double value = number_in(constants, i, "value");
    rows.push_back({about,
                    {},
                    range_of(constants, i, "interval_95", value),
                    range_of(constants, i, "prediction_95", value)});
    for (std::size_t k = 0; k < values.rows.size(); ++k)
      if (text_in(values, k, "constant") == about &&
          value_in(values, k, "lower_bound") == value_in(constants, i, "lower_bound"))
        rows.back().trials.push_back({number_in(values, k, "value") / value,
                                      number_in(values, k, "standard_error") / value,
                                      text_in(values, k, "use") == "validation"});
  }
  return html(Drawing{"residuals", figures::residual_figure({.width = 480}, rows),
                      "Values of the single trials against the constants.",
                      "One row for each constant. The numbers are in the table of residuals."});
}

Table keys_table() {
  return {"",
          "What a caster file takes from the constants",
          {{"", "constant"}, {"", "key"}, {"", "value there"}},
          {{"Cr/R", "tread.rolling_resistance_mm",
            "times the radius of the wheel; the scatter is its lognormal distribution"},
           {"mu_s, mu_k", "tread.static_friction, tread.kinetic_friction",
            "as they are; without a distribution, as mu_s must not be below mu_k in any draw"},
           {"swivel torque over N", "tread.patch_width_mm",
            "4 (torque over N less T/N) / mu_s, with the swivel friction T of the base"},
           {"Cr/R at start, e", "none", "e belongs into [contact] of the item"}}};
}

Html texts_of(const Table& files) {
  Html all;
  for (std::size_t i = 0; i < files.rows.size(); ++i)
    all += folded(text_in(files, i, "file"),
                  element("pre", text_in(files, i, "text"), {{"tabindex", "0"}}));
  return all.empty() ? all : paragraph("All other keys are those of the base.") + all;
}

constexpr const char* kMethods =
    "The logarithm of a trial's value is the sum of the constant's logarithm, a scatter between "
    "trials and the error of the measurement. The estimate is by least squares weighted with both "
    "variances, the scatter by Paule & Mandel (1982, J. Res. Natl. Bur. Stand. 87, 377-385), the "
    "interval by Student's t with the covariance of Knapp & Hartung (2003, Statistics in Medicine "
    "22, 2693-2710). Rolling resistance of a pull is that of Xu, Ma & Kurata (2022, 5th SPONSE "
    "workshop): from the force and the accelerations while pulled and while coasting.";

}  // namespace

Document calibration_document(const findings::Section& of) {
  const Table& constants = *find<Table>(of, "constants");
  Document document{of.title,
                    fmt::format("{} from {}", counted(constants.rows.size(), "constant"),
                                counted(std::stoul(text_of(of, "trials")), "trial")),
                    sections_of(of, {"summary", "trials", "fit", "diagnostics", "validation",
                                     "casters", "provenance"}),
                    {}};
  Html& fit = document.sections.at(2).content;
  fit = element("div",
                load_drawing(constants, *find<Table>(of, "pulls")) +
                    residual_drawing(constants, *find<Table>(of, "values")),
                {{"class", "figures"}}) +
        fit;
  Html& casters = document.sections.at(5).content;
  casters = html(keys_table()) + casters + texts_of(*find<Table>(of, "caster_files"));
  document.sections.insert(document.sections.end() - 1,
                           {"methods", "Methods", element("p", kMethods, {{"class", "methods"}})});
  return document;
}

}  // namespace gurney::page
