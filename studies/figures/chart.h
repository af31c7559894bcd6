#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/figures/panel.h"
#include "studies/units/unit_system.h"

namespace gurney::figures {

/// Paper of a figure, which is laid out for its width. Texts are 10 to 12 px.
struct PlotPage {
  double width = 700;  ///< [px]
  /// A panel shows at most so many marks, and so many curves without a name, evenly
  /// chosen; 0: all. The note says so.
  std::size_t most_marks = 0;
  study::UnitSystem units = {};  ///< of what does not bring its own
  bool apart = false;            ///< a picture for each panel, described by the note
};

/// A panel as high as `aspect` times its width says, within bounds; with lanes and rows as they
/// need.
struct PlotPanel {
  Panel panel;
  double aspect = 0.62;
  double height = 0;                                                     ///< [px]; 0: by `aspect`
  std::function<void(Svg&, const Frame&, const Scaling&)> overlay = {};  ///< drawn over the axes
  std::size_t across = 1, down = 1;                                      ///< cells of the chart
  double beside = 0;  ///< room at its right, for what the overlay writes there [px]
};

/// A figure: title, panels in a grid, row by row, and lines of text below. Margins, rows and
/// columns are the same in every figure.
struct Chart {
  std::string title;
  std::string note = {};  ///< in small letters below the title: what the figure shows
  std::vector<PlotPanel> panels = {};
  std::size_t columns = 1;
  std::vector<std::string> footnotes = {};

  std::string svg(const PlotPage& page = {}) const;

 private:
  std::string picture(const PlotPage& page) const;
};

/// Panels of one height.
std::vector<PlotPanel> of_height(std::vector<Panel> panels, double height);

}  // namespace gurney::figures
