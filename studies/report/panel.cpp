#include "studies/report/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gurney::report {
namespace {

constexpr double kTick = 4;
const Pen kAxis{.stroke = "#444444", .width = 0.8};
const Pen kGrid{.stroke = "#e6e6e6", .width = 0.7};

Range range_of(const std::vector<Curve>& curves, std::vector<double> Curve::*member) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Curve& curve : curves)
    for (const double value : curve.*member)
      if (std::isfinite(value)) {
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
      }
  return range.low <= range.high ? range : Range{0, 1};
}

/// Leaves some air, and gives a constant curve an axis of its own size.
Range padded(Range range) {
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (!(range.span() > 1e-9 * size)) {
    const double half = size > 0 ? 0.5 * size : 1;
    return {range.low - half, range.high + half};
  }
  return {range.low - 0.06 * range.span(), range.high + 0.06 * range.span()};
}

/// Widens one range until a unit is as long on both axes.
void equalise(const Frame& frame, Range& x, Range& y) {
  const double unit = std::max(x.span() / frame.width, y.span() / frame.height);
  const auto widen = [](Range& range, double span) {
    const double middle = (range.low + range.high) / 2;
    range = {middle - span / 2, middle + span / 2};
  };
  widen(x, unit * frame.width);
  widen(y, unit * frame.height);
}

std::string tick_label(double value, double step) {
  if (std::abs(value) < 1e-9 * step) return "0";
  const double size = std::max(std::abs(value), step);
  if (size >= 1e6 || size < 1e-4) return fmt::format("{:.3g}", value);
  int decimals = 0;
  for (double rest = step; decimals < 6 && std::abs(rest - std::round(rest)) > 1e-6; ++decimals)
    rest *= 10;
  std::string label = fmt::format("{:.{}f}", value, decimals);
  if (label.front() == '-') label = "\u2212" + label.substr(1);
  return label;
}

double step_of(const std::vector<double>& at) { return at.size() > 1 ? at[1] - at[0] : 1; }

std::vector<double> x_ticks_of(const Panel& panel, const Range& x, int wanted) {
  std::vector<double> at = panel.x_ticks;
  if (at.empty()) return panel.log_x ? decade_ticks(x) : ticks(x, wanted);
  if (panel.log_x)
    for (double& value : at) value = std::log10(value);
  return at;
}

void draw_axes(Svg& svg, const Frame& frame, const Panel& panel, const Scaling& scaling,
               const Range& x, const Range& y) {
  const double right = frame.x + frame.width, bottom = frame.y + frame.height;
  const auto x_ticks = x_ticks_of(panel, x, static_cast<int>(frame.width / 70));
  const auto y_ticks =
      panel.log_y ? decade_ticks(y) : ticks(y, std::max(3, static_cast<int>(frame.height / 26)));
  for (const double value : x_ticks) {
    const double at = scaling.x(value);
    svg.line(at, frame.y, at, bottom, kGrid);
    svg.line(at, bottom, at, bottom + kTick, kAxis);
    svg.text(at, bottom + 15,
             panel.log_x ? fmt::format("{:.3g}", std::pow(10, value))
                         : tick_label(value, step_of(x_ticks)),
             {.size = 10, .anchor = Anchor::kMiddle});
  }
  for (const double value : y_ticks) {
    const double at = scaling.y(value);
    svg.line(frame.x, at, right, at, kGrid);
    svg.line(frame.x - kTick, at, frame.x, at, kAxis);
    svg.text(frame.x - 7, at + 3.5,
             panel.log_y ? fmt::format("{:.3g}", std::pow(10, value))
                         : tick_label(value, step_of(y_ticks)),
             {.size = 10, .anchor = Anchor::kEnd});
  }
  if (panel.zero_line && y.low < 0 && y.high > 0)
    svg.line(frame.x, scaling.y(0), right, scaling.y(0), {.stroke = "#999999", .width = 0.8});
  svg.text(frame.x + frame.width / 2, bottom + 31, panel.x_label, {.anchor = Anchor::kMiddle});
  svg.text(frame.x - 46, frame.y + frame.height / 2, panel.y_label,
           {.anchor = Anchor::kMiddle, .upwards = true});
  svg.text(frame.x, frame.y - 9, panel.title, {.size = 12, .bold = true});
}

/// Pieces of the curve between values that are not finite; points closer than a third of a px to
/// the one before are left out.
std::vector<Svg::Points> pieces(const Curve& curve, const Scaling& scaling) {
  std::vector<Svg::Points> result(1);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i])) {
      if (!result.back().empty()) result.emplace_back();
      continue;
    }
    const std::pair<double, double> point{scaling.x(curve.x[i]), scaling.y(curve.y[i])};
    Svg::Points& piece = result.back();
    const bool last = i + 1 == curve.x.size();
    if (piece.empty() || last ||
        std::hypot(point.first - piece.back().first, point.second - piece.back().second) > 1.0 / 3)
      piece.push_back(point);
  }
  return result;
}

/// Above the axes, at their right end, `legend_columns` curves in a row.
void draw_legend(Svg& svg, const Frame& frame, const Panel& panel) {
  constexpr double kKey = 18, kGap = 5, kCharacter = 5.6, kSpace = 12, kRow = 13;
  std::vector<const Curve*> shown;
  for (const Curve& curve : panel.curves)
    if (!curve.label.empty()) shown.push_back(&curve);
  if (shown.empty() || panel.legend_columns == 0) return;
  const auto columns = std::min(static_cast<std::size_t>(panel.legend_columns), shown.size());
  const auto rows = (shown.size() + columns - 1) / columns;
  double x = frame.x + frame.width;
  for (std::size_t column = columns; column-- > 0;) {
    std::size_t longest = 0;
    for (std::size_t i = column; i < shown.size(); i += columns)
      longest = std::max(longest, shown[i]->label.size());
    x -= kKey + kGap + kCharacter * static_cast<double>(longest);
    for (std::size_t i = column; i < shown.size(); i += columns) {
      const auto below = rows - 1 - i / columns;
      const double y = frame.y - 13 - kRow * static_cast<double>(below);
      svg.line(x, y, x + kKey, y, shown[i]->pen);
      svg.text(x + kKey + kGap, y + 3.5, shown[i]->label, {.size = 10});
    }
    x -= kSpace;
  }
}

}  // namespace

std::vector<double> ticks(const Range& range, int wanted) {
  const double rough = range.span() / std::max(1, wanted);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double nice : {5.0, 2.5, 2.0, 1.0})
    if (nice * power >= rough * 0.999) step = nice * power;
  std::vector<double> result;
  for (double i = std::ceil(range.low / step - 1e-9); i * step <= range.high + 1e-9 * step; ++i)
    result.push_back(i * step);
  return result;
}

std::vector<double> decade_ticks(const Range& log_range) {
  std::vector<double> result;
  for (double decade = std::floor(log_range.low); decade <= log_range.high; ++decade)
    for (const double digit : {1.0, 2.0, 5.0})
      if (const double at = decade + std::log10(digit);
          at >= log_range.low - 1e-9 && at <= log_range.high + 1e-9)
        result.push_back(at);
  return result;
}

Scaling draw(Svg& svg, const Frame& frame, const Panel& given) {
  Panel panel = given;
  if (panel.log_x)
    for (Curve& curve : panel.curves)
      for (double& value : curve.x) value = std::log10(value);
  if (panel.log_y)
    for (Curve& curve : panel.curves)
      for (double& value : curve.y) value = std::log10(value);
  Range x = panel.x_range, y = panel.y_range;
  if (!(x.span() > 0)) x = range_of(panel.curves, &Curve::x);
  if (!(y.span() > 0)) y = padded(range_of(panel.curves, &Curve::y));
  if (!(x.span() > 0)) x = padded(x);
  if (panel.equal_scales) equalise(frame, x, y);
  const Scaling scaling(frame, x, y);
  draw_axes(svg, frame, panel, scaling, x, y);
  svg.begin_clip(frame.x, frame.y, frame.width, frame.height);
  for (const Curve& curve : panel.curves)
    for (const Svg::Points& piece : pieces(curve, scaling)) svg.polyline(piece, curve.pen);
  svg.end_clip();
  svg.rectangle(frame.x, frame.y, frame.width, frame.height, kAxis);
  draw_legend(svg, frame, panel);
  return scaling;
}

std::string palette(std::size_t index) {
  static const char* const colors[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                       "#E69F00", "#56B4E9", "#000000"};
  return colors[index % std::size(colors)];
}

}  // namespace gurney::report
