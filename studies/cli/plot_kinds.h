#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/figures/chart.h"

namespace gurney::cli {

/// What `gurney plot` is asked for.
struct PlotRequest {
  std::string file, kind;
  std::vector<std::string> what;  ///< histories, demands, limit states; empty: the usual ones
  std::vector<std::string> configurations;
  std::string measure, method;
  std::optional<std::size_t> run;
  std::optional<std::size_t> level;  ///< its index
  std::string job;                   ///< path of the study's job; empty: that in its log
};

/// @throws Error unless the kind is one of those there are
void check_kind(const PlotRequest& request);

/// The figure as SVG. @throws Error for what the file does not hold, with what it holds
std::string plotted(const PlotRequest& request, const figures::PlotPage& page);

/// What can be plotted from a file: a paragraph for each kind.
std::string plot_list(const std::string& file);

}  // namespace gurney::cli
