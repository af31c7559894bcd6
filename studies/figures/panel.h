#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gurney::figures {

/// How a line or an area is drawn. An empty colour draws nothing.
struct Pen {
  std::string stroke = "#000000";
  double width = 1;
  std::string dash = {};  ///< SVG stroke-dasharray, such as "4 3"
  std::string fill = {};
  double opacity = 1;
};

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  double size = 11;  ///< [px]
  Anchor anchor = Anchor::kStart;
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees, reads from below
  std::string color = "#222222";
};

/// A picture in Scalable Vector Graphics; x to the right, y down, in px.
class Svg {
 public:
  using Points = std::vector<std::pair<double, double>>;

  Svg(double width, double height);

  void line(double x1, double y1, double x2, double y2, const Pen& pen);
  void rectangle(double x, double y, double width, double height, const Pen& pen);
  void circle(double x, double y, double radius, const Pen& pen);
  void polyline(const Points& points, const Pen& pen, bool closed = false);
  void text(double x, double y, const std::string& text, const TextStyle& style = {});

  /// Later marks are drawn inside this rectangle only, until end_group().
  void begin_clip(double x, double y, double width, double height);

  /// Later marks belong together, until end_group(); a page reads the attributes.
  /// @param attributes  names, which must be plain, and values of any text
  void begin_group(const std::vector<std::pair<std::string, std::string>>& attributes);
  void end_group();

  /// Says what the picture shows; it is not drawn.
  void describe(const std::string& text);

  std::string str() const;

 private:
  std::string body_;
  double width_, height_;
  int clips_ = 0;
};

/// Smallest and largest value of an axis.
struct Range {
  double low = 0, high = 0;
  double span() const { return high - low; }
};

/// Round numbers (1, 2, 2.5 or 5 times a power of ten) inside `range`, about `wanted` of them.
std::vector<double> ticks(const Range& range, int wanted);

/// ticks(), at least two of them.
std::vector<double> axis_ticks(const Range& range, int wanted);

/// 1, 2 and 5 times the powers of ten inside a range of log10 values, as log10; of a range of more
/// than three decades their powers of ten only, of one with fewer than three such numbers every
/// digit.
std::vector<double> decade_ticks(const Range& log_range);

/// The smallest range of all numbers among `values`, and of `range`.
Range widened(Range range, const std::vector<double>& values);

/// Words in lines that are no wider than `width` [px]; of more than `most` lines the last one that
/// is kept ends with an ellipsis.
std::vector<std::string> lines_of(const std::string& text, double size, double width,
                                  std::size_t most = 1000);

/// Width of a text of this size in the widest of the figures' fonts, DejaVu Sans [px].
double text_width(const std::string& text, double size);

/// Factor from the widths of text_width to those of bold texts [-].
inline constexpr double kBold = 1.14;

/// The beginning of a text, with an ellipsis where the whole is wider.
std::string fitted(const std::string& text, double size, double width);

enum class Marker { kCircle, kSquare, kTriangle, kDiamond, kCross };

/// One curve: `y` over `x`, of equal length. Values that are not finite break the curve.
struct Curve {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> x, y;
  Pen pen;
  std::optional<Marker> key = {};  ///< of the marks that belong to it, for the legend
  double shift = 0;                ///< in x, which is no value: it keeps curves apart
  Range known = {};  ///< x rises, and outside of this range the curve is dotted; span 0: nowhere

  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

/// Single points.
struct Marks {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> x, y;
  Pen pen;  ///< without a fill: white inside
  Marker marker = Marker::kCircle;
  double radius = 3;                   ///< [px]
  std::string name = {};               ///< of what they are, on a page; empty: the label
  std::vector<std::size_t> runs = {};  ///< of which each is; empty: of none
  double shift = 0;                    ///< as of a curve
  bool only_x = false;                 ///< y is a place, no value

  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

/// Empty for the colours of palette(), dashes where they repeat.
std::string dash_of(std::size_t color);

/// A line in a colour of palette(), with dash_of() where none is given.
Pen pen(std::size_t color, double width = 1.3, const std::string& dash = "");

/// Values over x, in a unit.
template <class X, class Y>
Curve curve_of(const std::string& label, const X& x, const Y& y, const Pen& pen, double unit = 1) {
  Curve curve{label, {x.begin(), x.end()}, {y.begin(), y.end()}, pen};
  for (double& value : curve.y) value /= unit;
  return curve;
}

/// `get(row)` over `at(row)`.
template <class Rows, class At, class Get>
Curve curve_over(const std::string& label, const Rows& rows, const Pen& pen, At at, Get get) {
  Curve curve{label, {}, {}, pen};
  for (const auto& row : rows) curve.add(at(row), get(row));
  return curve;
}

/// Between two curves over the same `x`.
struct Area {
  std::vector<double> x, low, high;
  std::string color;
  double opacity = 0.15;

  void add(double at, double least, double most) {
    x.push_back(at);
    low.push_back(least);
    high.push_back(most);
  }
};

/// A horizontal bar of a panel of rows.
struct Bar {
  double middle = 0, half = 0.25;  ///< its place and half its height [rows from the top]
  Range x;
  Pen pen;
};

/// Span from one value of x to another, over the whole height, with its name at the top.
struct Span {
  Range x;
  std::string label, fill;
};

/// A dashed line at a value of x, over the whole height, with its name above the axes.
struct Guide {
  double at = 0;
  std::string label = {};
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
  double least_span = 0;             ///< of y from the curves; values that differ less are equal
  std::vector<double> x_ticks = {};  ///< empty: round numbers
  bool lanes = false;                ///< for draw_lanes(): each curve on axes of its own
  bool own_ranges = false;           ///< of lanes: each its own; else all the same
  bool x_labels = true;              ///< numbers at the ticks
  std::vector<Marks> marks = {};
  std::vector<Area> areas = {};  ///< below the curves
  /// Names beside the axes from above, in place of ticks and name of the vertical axis; y counts
  /// rows from the top.
  std::vector<std::string> rows = {};
  std::vector<Bar> bars = {};    ///< below the curves
  std::vector<Span> spans = {};  ///< below all
  std::vector<Guide> guides = {};
  bool overlaid = false;  ///< something else is drawn over the axes, which pages then do not zoom
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

  /// Mapping of the same axes for values in SI, where those of the axes are in a unit.
  Scaling of_si(double unit_in_si) const {
    return {frame_,
            {x_.low * unit_in_si, x_.high * unit_in_si},
            {y_.low * unit_in_si, y_.high * unit_in_si}};
  }

 private:
  Frame frame_;
  Range x_, y_;
};

/// How far title and legend begin left of axes with names of rows beside them [px].
/// @param left  of the axes
double overhang(const Panel& panel, double left);

/// Height of title and legend above axes of this width [px].
double head_height(const Panel& panel, double width);

/// The legend of a panel at the right end above its axes, and its title, at their left end or,
/// where that is too narrow for both, above the legend.
void draw_head(Svg& svg, const Frame& frame, const Panel& panel);

/// `x` and `y` in px.
void draw_marker(Svg& svg, double x, double y, const Marks& marks);

/// Draws the panel and returns the scaling of its axes, for what else belongs into it; with log_x
/// it takes log10 of x, with log_y of y.
Scaling draw(Svg& svg, const Frame& frame, const Panel& panel);

/// Draws the curves one below the other, each on axes of its own.
void draw_lanes(Svg& svg, const Frame& frame, const Panel& panel);

/// Colour-blind safe colours (Okabe & Ito 2008), repeated after the seventh.
std::string palette(std::size_t index);

/// Colours of ordered curves, from dark blue to yellow (viridis of matplotlib); their order is seen
/// in grey and by the colour-blind, too.
std::string ramp(std::size_t index, std::size_t count);

/// As many shapes, so that they can be distinguished in grey.
Marker marker(std::size_t index);

}  // namespace gurney::figures
