#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/figures/panel.h"
#include "studies/units/unit_system.h"

namespace gurney::figures {

/// A page of panels, one below the other, that is laid out for its width. Texts are 10 to 12 px.
struct PlotPage {
  double width = 700;  ///< [px]
  /// Of a panel at most so many marks, and so many curves without a name, are drawn, evenly
  /// chosen; 0: all. The note says so.
  std::size_t most_marks = 0;
  study::UnitSystem units = {};  ///< of what does not bring its own
};

/// A panel as high as `aspect` times its width says, within bounds; with lanes as they need.
struct PlotPanel {
  Panel panel;
  double aspect = 0.62;
  double height = 0;                                                     ///< [px]; 0: by `aspect`
  std::function<void(Svg&, const Frame&, const Scaling&)> overlay = {};  ///< drawn over the axes
};

/// @param note  in small letters below the title: what the figure shows
std::string plot_figure(const PlotPage& page, const std::string& title, std::string note,
                        std::vector<PlotPanel> panels);

}  // namespace gurney::figures
