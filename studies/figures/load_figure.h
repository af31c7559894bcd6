#pragma once

#include <string>
#include <vector>

#include "studies/figures/plot_page.h"

namespace gurney::figures {

/// Resistance that is proportional to the load, with the pulls that it was found from.
struct LoadLine {
  std::string label;
  double ratio = 0;                      ///< f_r / N
  Range interval = {}, prediction = {};  ///< 95 %, of the ratio; not finite: none
  std::vector<double> load, resistance;  ///< of the pulls [N]
};

std::string load_figure(const PlotPage& page, const std::vector<LoadLine>& lines);

/// Values of single trials over the constant that was fitted to them.
struct ResidualRow {
  std::string label;
  struct Trial {
    double ratio = 1, error = 0;  ///< value and standard error, over the constant
    bool validation = false;
  };
  std::vector<Trial> trials;
  Range interval = {}, prediction = {};  ///< 95 %, over the constant; not finite: none
};

std::string residual_figure(const PlotPage& page, const std::vector<ResidualRow>& rows);

}  // namespace gurney::figures
