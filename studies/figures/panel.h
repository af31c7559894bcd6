#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/figures/svg.h"

namespace gurney::figures {

/// Smallest and largest value of an axis.
struct Range {
  double low = 0, high = 0;
  double span() const { return high - low; }
};

/// Round numbers (1, 2, 2.5 or 5 times a power of ten) inside `range`, about `wanted` of them.
std::vector<double> ticks(const Range& range, int wanted);

/// 1, 2 and 5 times the powers of ten inside a range of log10 values, as log10; of a range of more
/// than three decades their powers of ten only, of one with fewer than three such numbers every
/// digit.
std::vector<double> decade_ticks(const Range& log_range);

/// About how wide a text of this size is [px].
double text_width(const std::string& text, double size);

/// The beginning of a text, with an ellipsis where the whole is wider.
std::string fitted(const std::string& text, double size, double width);

enum class Marker { kCircle, kSquare, kTriangle, kDiamond, kCross };

/// One curve: `y` over `x`, of equal length. Values that are not finite break the curve.
struct Curve {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> x, y;
  Pen pen;
  std::optional<Marker> key = {};  ///< of the marks that belong to it, for the legend
};

/// Single points.
struct Marks {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> x, y;
  Pen pen;  ///< without a fill: white inside
  Marker marker = Marker::kCircle;
  double radius = 3;  ///< [px]
};

/// Between two curves over the same `x`.
struct Area {
  std::vector<double> x, low, high;
  std::string color;
  double opacity = 0.15;
};

/// Axes with curves.
struct Panel {
  std::string title;
  std::string x_label, y_label;  ///< with their units
  std::vector<Curve> curves = {};
  bool zero_line = true;
  bool log_x = false;                ///< decades along x; values must be > 0
  bool equal_scales = false;         ///< a plan: one metre is as long on both axes
  int legend_columns = 0;            ///< 0: no legend
  Range x_range = {}, y_range = {};  ///< span 0: from the curves; log10 on an axis of decades
  bool log_y = false;                ///< as log_x
  std::vector<double> x_ticks = {};  ///< empty: round numbers
  bool lanes = false;                ///< for draw_lanes(): each curve on axes of its own
  bool own_ranges = false;           ///< of lanes: each its own; else all the same
  bool x_labels = true;              ///< numbers at the ticks
  bool y_axis = true;                ///< ticks and name of the vertical axis
  std::vector<Marks> marks = {};
  std::vector<Area> areas = {};  ///< below the curves
};

/// Where in the picture a panel stands: the rectangle of its axes, without labels [px].
struct Frame {
  double x, y, width, height;
};

/// Maps values to px inside a frame.
class Scaling {
 public:
  Scaling(const Frame& frame, const Range& x, const Range& y) : frame_(frame), x_(x), y_(y) {}
  double x(double value) const { return frame_.x + (value - x_.low) / x_.span() * frame_.width; }
  double y(double value) const { return frame_.y + (y_.high - value) / y_.span() * frame_.height; }

  /// Of the same axes for values in SI, where those of the axes are in a unit.
  Scaling of_si(double unit_in_si) const {
    return {frame_,
            {x_.low * unit_in_si, x_.high * unit_in_si},
            {y_.low * unit_in_si, y_.high * unit_in_si}};
  }

 private:
  Frame frame_;
  Range x_, y_;
};

/// Height of title and legend above axes of this width [px].
double head_height(const Panel& panel, double width);

/// Draws the panel and returns the scaling of its axes, for what else belongs into it; with log_x
/// it takes log10 of x, with log_y of y.
Scaling draw(Svg& svg, const Frame& frame, const Panel& panel);

/// Draws the curves one below the other, each on axes of its own.
void draw_lanes(Svg& svg, const Frame& frame, const Panel& panel);

/// Colour-blind safe colours (Okabe & Ito 2008), repeated after the seventh.
std::string palette(std::size_t index);

/// As many shapes, so that they can be distinguished in grey.
Marker marker(std::size_t index);

}  // namespace gurney::figures
