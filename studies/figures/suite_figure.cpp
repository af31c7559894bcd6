#include "studies/figures/suite_figure.h"

#include <fmt/format.h>

#include "engine/base/units.h"
#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

Curve curve(const std::string& label, const Eigen::VectorXd& periods,
            const Eigen::VectorXd& acceleration, const Pen& pen) {
  Curve result{label, {periods.begin(), periods.end()}, {}, pen};
  for (const double value : acceleration) result.y.push_back(value / kStandardGravity);
  return result;
}

}  // namespace

std::string suite_figure(const groundmotions::TargetSpectrum& target,
                         const Eigen::VectorXd& periods, const Eigen::MatrixXd& spectra,
                         const groundmotions::SuiteScaling& scaling) {
  Svg svg(900, 470);
  svg.text(70, 34,
           fmt::format("{} record{} scaled to {}, {:g} % damping", spectra.rows(),
                       spectra.rows() == 1 ? "" : "s", target.name, 100 * target.damping),
           {.size = 16, .bold = true});
  Panel panel{
      .title = fmt::format("Mean at least {:.0f} % of the target; misfit of the mean {:.3f}",
                           100 * scaling.smallest_ratio, scaling.suite_misfit),
      .x_label = "Period (s)",
      .y_label = "Sa (g)",
      .curves = {},
      .log_x = true,
      .legend_columns = 3};
  for (Eigen::Index i = 0; i < spectra.rows(); ++i)
    panel.curves.push_back(curve(i == 0 ? "records" : "", periods,
                                 scaling.factors[i] * spectra.row(i).transpose(),
                                 {.stroke = "#999999", .width = 0.8}));
  panel.curves.push_back(curve("mean", periods, scaling.mean, {.stroke = palette(0), .width = 2}));
  Eigen::VectorXd wanted(periods.size());
  for (Eigen::Index i = 0; i < periods.size(); ++i) wanted[i] = target.at(periods[i]);
  panel.curves.push_back(
      curve("target", periods, wanted, {.stroke = palette(1), .width = 2, .dash = "6 3"}));
  draw(svg, {70, 90, 790, 320}, panel);
  return svg.str();
}

}  // namespace gurney::figures
