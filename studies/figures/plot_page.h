#pragma once

#include <string>
#include <vector>

#include "studies/figures/panel.h"

namespace gurney::figures {

/// A page of panels, one below the other, that is laid out for its width. Texts are 10 to 12 px.
struct PlotPage {
  double width = 700;  ///< [px]
};

/// A panel as high as `aspect` times its width says, within bounds; with lanes as they need.
struct PlotPanel {
  Panel panel;
  double aspect = 0.62;
};

/// @param note  in small letters below the title: what the figure shows
std::string plot_figure(const PlotPage& page, const std::string& title, const std::string& note,
                        const std::vector<PlotPanel>& panels);

}  // namespace gurney::figures
