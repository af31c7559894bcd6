#include "studies/figures/panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/printable.h"

namespace gurney::figures {
namespace {

std::string style_of(const Pen& pen) {
  std::string style = fmt::format(R"(fill="{}" )", pen.fill.empty() ? "none" : pen.fill);
  if (pen.stroke.empty()) {
    style += R"(stroke="none")";
  } else {
    style += fmt::format(R"(stroke="{}" stroke-width="{:g}" stroke-linejoin="round")", pen.stroke,
                         pen.width);
  }
  if (!pen.dash.empty()) style += fmt::format(R"( stroke-dasharray="{}")", pen.dash);
  if (pen.opacity < 1) style += fmt::format(R"( opacity="{:g}")", pen.opacity);
  return style;
}

/// Names may be of any length, figures are not.
std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 300;  // characters
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool begins = (static_cast<unsigned char>(text[at]) & 0xc0) != 0x80;
    if (begins && ++count > kLongest) return text.substr(0, at) + "\u2026";
  }
  return text;
}

constexpr double kTick = 4;
constexpr std::size_t kColors = 7;  // of the palette
const Pen kAxis{.stroke = "#444444", .width = 0.8};
const Pen kGrid{.stroke = "#e6e6e6", .width = 0.7};

/// Range of all that is drawn along an axis.
Range range_of(const Panel& panel, bool along_x) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto widen = [&](const std::vector<double>& values) { range = widened(range, values); };
  for (const Curve& curve : panel.curves) widen(along_x ? curve.x : curve.y);
  for (const Marks& marks : panel.marks) widen(along_x ? marks.x : marks.y);
  for (const Area& area : panel.areas) {
    widen(along_x ? area.x : area.low);
    if (!along_x) widen(area.high);
  }
  for (const Bar& bar : panel.bars)
    if (along_x) widen({bar.x.low, bar.x.high});
  return range.low <= range.high ? range : Range{0, 1};
}

/// Leaves some air, and gives a constant curve an axis of its own size.
Range padded(Range range, double least_span = 0) {
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (!(range.span() > std::max(1e-9 * size, least_span))) {
    const double half = std::max(0.5 * size, 0.5 * least_span);
    return {range.low - (half > 0 ? half : 1), range.high + (half > 0 ? half : 1)};
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
  if (at.empty()) return panel.log_x ? decade_ticks(x) : axis_ticks(x, wanted);
  if (panel.log_x)
    for (double& value : at) value = std::log10(value);
  return at;
}

/// All of one axis in one form.
std::vector<std::string> log_labels(const std::vector<double>& at) {
  const bool plain =
      std::ranges::all_of(at, [](double value) { return value > -4.01 && value < 6; });
  std::vector<std::string> labels;
  for (const double value : at)
    labels.push_back(plain ? fmt::format("{:.6g}", std::pow(10, value))
                           : fmt::format("{:.0e}", std::pow(10, value)));
  return labels;
}

std::vector<std::string> tick_labels(const std::vector<double>& at, bool log) {
  if (log) return log_labels(at);
  std::vector<std::string> labels;
  for (const double value : at) labels.push_back(tick_label(value, step_of(at)));
  return labels;
}

/// The places among ticks whose labels do not touch: of decades powers of ten before all others.
/// @param air  between labels [px]
std::vector<bool> labelled(const std::vector<double>& at, const std::vector<double>& px,
                           const std::vector<double>& sizes, double air = 5) {
  std::vector<bool> shown(at.size(), false);
  const auto free = [&](std::size_t i) {
    for (std::size_t k = 0; k < at.size(); ++k)
      if (shown[k] && std::abs(px[i] - px[k]) < (sizes[i] + sizes[k]) / 2 + air) return false;
    return true;
  };
  for (const bool powers : {true, false})
    for (std::size_t i = 0; i < at.size(); ++i)
      if ((std::abs(at[i] - std::round(at[i])) < 1e-9) == powers && !shown[i]) shown[i] = free(i);
  return shown;
}

std::string axis_name(const std::string& label, bool log) {
  return log && !label.empty() ? label + ", log scale" : label;
}

/// Every digit of each decade, without labels.
void draw_minor_ticks(Svg& svg, const Frame& frame, const Scaling& scaling, const Range& range,
                      bool along_x) {
  for (double decade = std::floor(range.low); decade <= range.high; ++decade)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = decade + std::log10(digit);
      if (value < range.low || value > range.high) continue;
      const double at = along_x ? scaling.x(value) : scaling.y(value);
      const double bottom = frame.y + frame.height;
      if (along_x)
        svg.line(at, bottom, at, bottom + kTick / 2, kAxis);
      else
        svg.line(frame.x - kTick / 2, at, frame.x, at, kAxis);
    }
}

void draw_x_axis(Svg& svg, const Frame& frame, const Panel& panel, const Scaling& scaling,
                 const Range& range) {
  constexpr double kSize = 10;
  const double bottom = frame.y + frame.height;
  const auto at = x_ticks_of(panel, range, std::max(2, static_cast<int>(frame.width / 70)));
  const std::vector<std::string> labels = tick_labels(at, panel.log_x);
  std::vector<double> px, sizes;
  for (std::size_t i = 0; i < at.size(); ++i) {
    px.push_back(scaling.x(at[i]));
    sizes.push_back(text_width(labels[i], kSize) + 6);  // numbers side by side need air
  }
  const std::vector<bool> shown = labelled(at, px, sizes);
  svg.begin_group({{"class", "ticks-x"}});
  for (std::size_t i = 0; i < at.size(); ++i) {
    svg.line(px[i], frame.y, px[i], bottom, kGrid);
    svg.line(px[i], bottom, px[i], bottom + kTick, kAxis);
    if (shown[i] && panel.x_labels)
      svg.text(px[i], bottom + 15, labels[i], {.size = kSize, .anchor = Anchor::kMiddle});
  }
  if (panel.log_x) draw_minor_ticks(svg, frame, scaling, range, true);
  svg.end_group();
  svg.text(frame.x + frame.width / 2, bottom + 31, axis_name(panel.x_label, panel.log_x),
           {.anchor = Anchor::kMiddle});
}

/// Name of the vertical axis, in two lines where it is longer than the axis.
/// @param left  of the axis [px]
void draw_y_name(Svg& svg, const Frame& frame, const std::string& name, double left) {
  constexpr double kSize = 11, kLine = 11, kMost = 54;  // leftmost, with letters to the left of it
  const double space = std::max(frame.height + 40, 80.0);
  const std::vector<std::string> lines = lines_of(name, kSize, space, 2);
  double x = frame.x - left;
  if (lines.size() == 2) x = frame.x - std::min(left + kLine - 4, kMost);
  for (const std::string& line : lines) {
    svg.text(x, frame.y + frame.height / 2, line,
             {.size = kSize, .anchor = Anchor::kMiddle, .upwards = true});
    x += kLine;
  }
}

void draw_y_axis(Svg& svg, const Frame& frame, const Panel& panel, const Scaling& scaling,
                 const Range& range) {
  constexpr double kSize = 10;
  const double apart = panel.equal_scales ? 70 : 32;  // equal scales: ticks as on the other axis
  const int wanted = std::max(2, static_cast<int>(frame.height / apart));
  const std::vector<double> at = panel.log_y ? decade_ticks(range) : axis_ticks(range, wanted);
  const std::vector<std::string> labels = tick_labels(at, panel.log_y);
  std::vector<double> px;
  double widest = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    px.push_back(scaling.y(at[i]));
    widest = std::max(widest, text_width(labels[i], kSize));
  }
  const std::vector<bool> shown =
      labelled(at, px, std::vector<double>(at.size(), kSize), panel.log_y ? 5 : 1.5);
  svg.begin_group({{"class", "ticks-y"}});
  for (std::size_t i = 0; i < at.size(); ++i) {
    svg.line(frame.x, px[i], frame.x + frame.width, px[i], kGrid);
    svg.line(frame.x - kTick, px[i], frame.x, px[i], kAxis);
    if (shown[i])
      svg.text(frame.x - 7, px[i] + 3.5, labels[i], {.size = kSize, .anchor = Anchor::kEnd});
  }
  if (panel.log_y) draw_minor_ticks(svg, frame, scaling, range, false);
  if (panel.zero_line && range.low < 0 && range.high > 0)
    svg.line(frame.x, scaling.y(0), frame.x + frame.width, scaling.y(0),
             {.stroke = "#999999", .width = 0.8});
  svg.end_group();
  draw_y_name(svg, frame, axis_name(panel.y_label, panel.log_y),
              std::clamp(widest + 14, 34.0, 52.0));
}

/// Names beside the axes, and lines between the rows.
void draw_rows(Svg& svg, const Frame& frame, const Panel& panel) {
  constexpr double kSize = 10, kLine = 11;
  const double high = frame.height / static_cast<double>(panel.rows.size());
  for (std::size_t i = 0; i < panel.rows.size(); ++i) {
    const double top = frame.y + static_cast<double>(i) * high;
    if (i > 0)
      svg.line(frame.x, top, frame.x + frame.width, top, {.stroke = "#cccccc", .width = 0.6});
    const auto fit = static_cast<std::size_t>(std::max(1.0, std::floor(high / kLine)));
    const std::vector<std::string> lines = lines_of(panel.rows[i], kSize, frame.x - 12, fit);
    double y = top + high / 2 + 3.5 - kLine * 0.5 * (static_cast<double>(lines.size()) - 1);
    for (const std::string& line : lines) {
      svg.text(frame.x - 7, y, line, {.size = kSize, .anchor = Anchor::kEnd});
      y += kLine;
    }
  }
}

void draw_bars(Svg& svg, const Panel& panel, const Scaling& scaling) {
  for (const Bar& bar : panel.bars) {
    const double from = scaling.x(std::min(bar.x.low, bar.x.high));
    const double to = scaling.x(std::max(bar.x.low, bar.x.high));
    const double top = scaling.y(bar.middle - bar.half);
    const double bottom = scaling.y(bar.middle + bar.half);
    if (!std::isfinite(to - from)) continue;
    if (to > from && bottom > top)
      svg.rectangle(from, top, to - from, bottom - top, bar.pen);
    else
      svg.line(from, top, to, bottom, bar.pen);  // a rectangle without an area is not drawn
  }
}

void draw_spans(Svg& svg, const Frame& frame, const Panel& panel, const Scaling& scaling) {
  for (const Span& span : panel.spans)
    if (const double from = scaling.x(span.x.low), to = scaling.x(span.x.high); to - from >= 1)
      svg.rectangle(from, frame.y, to - from, frame.height,
                    {.stroke = "", .fill = span.fill, .opacity = 0.55});
}

/// Names that would touch move to the right.
void draw_guides(Svg& svg, const Frame& frame, const Panel& panel, const Scaling& scaling) {
  double last = -1e9;
  for (const Guide& guide : panel.guides) {
    const double x = scaling.x(guide.at);
    svg.line(x, frame.y, x, frame.y + frame.height,
             {.stroke = "#888888", .width = 0.8, .dash = "4 3"});
    if (guide.label.empty()) continue;
    last = std::max(x, last + 13);
    svg.text(last, frame.y - 4, guide.label, {.size = 10, .anchor = Anchor::kMiddle, .bold = true});
  }
  for (const Span& span : panel.spans)
    if (const double from = scaling.x(span.x.low), to = scaling.x(span.x.high);
        to - from > text_width(span.label, 11) + 4)
      svg.text((from + to) / 2, frame.y + 13, span.label,
               {.size = 11, .anchor = Anchor::kMiddle, .bold = true, .color = "#666666"});
}

void draw_axes(Svg& svg, const Frame& frame, const Panel& panel, const Scaling& scaling,
               const Range& x, const Range& y) {
  draw_x_axis(svg, frame, panel, scaling, x);
  if (panel.rows.empty())
    draw_y_axis(svg, frame, panel, scaling, y);
  else
    draw_rows(svg, frame, panel);
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

/// The values of an axis of decades.
void take_log10(std::vector<double>& values) {
  for (double& value : values) value = std::log10(value);
}

Panel in_decades(Panel panel) {
  for (Guide& guide : panel.guides)
    if (panel.log_x) guide.at = std::log10(guide.at);
  for (Curve& curve : panel.curves) {
    if (panel.log_x) take_log10(curve.x);
    if (panel.log_x && curve.known.span() > 0)
      curve.known = {std::log10(curve.known.low), std::log10(curve.known.high)};
    if (panel.log_y) take_log10(curve.y);
  }
  for (Marks& marks : panel.marks) {
    if (panel.log_x) take_log10(marks.x);
    if (panel.log_y) take_log10(marks.y);
  }
  for (Area& area : panel.areas) {
    if (panel.log_x) take_log10(area.x);
    if (panel.log_y) take_log10(area.low);
    if (panel.log_y) take_log10(area.high);
  }
  return panel;
}

void draw_area(Svg& svg, const Area& area, const Scaling& scaling) {
  Svg::Points outline;
  for (std::size_t i = 0; i < area.x.size(); ++i)
    outline.emplace_back(scaling.x(area.x[i]), scaling.y(area.low[i]));
  for (std::size_t i = area.x.size(); i-- > 0;)
    outline.emplace_back(scaling.x(area.x[i]), scaling.y(area.high[i]));
  svg.polyline(outline, {.stroke = "", .fill = area.color, .opacity = area.opacity}, true);
}

/// The part of a curve, whose x rises, between two values of x.
Curve part_of(const Curve& curve, const Range& x) {
  Curve part{"", {}, {}, curve.pen};
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    for (const double end : {x.low, x.high})
      if (i > 0 && curve.x[i - 1] < end && end < curve.x[i])
        part.add(end, std::lerp(curve.y[i - 1], curve.y[i],
                                (end - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1])));
    if (curve.x[i] >= x.low && curve.x[i] <= x.high) part.add(curve.x[i], curve.y[i]);
  }
  return part;
}

void draw_curve(Svg& svg, const Curve& curve, const Scaling& scaling) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<Curve> parts{curve};
  if (curve.known.span() > 0) {
    parts = {part_of(curve, {-kFar, curve.known.low}), part_of(curve, curve.known),
             part_of(curve, {curve.known.high, kFar})};
    parts.front().pen.dash = parts.back().pen.dash = "1.5 3";
  }
  for (const Curve& part : parts)
    for (const Svg::Points& piece : pieces(part, scaling)) svg.polyline(piece, part.pen);
}

void draw_curves(Svg& svg, const Panel& panel, const Scaling& scaling) {
  for (const Curve& curve : panel.curves) {
    if (!curve.label.empty())
      svg.begin_group(
          {{"data-name", curve.label}, {"data-shift", fmt::format("{:g}", curve.shift)}});
    draw_curve(svg, curve, scaling);
    if (!curve.label.empty()) svg.end_group();
  }
}

void draw_marks(Svg& svg, const Panel& panel, const Scaling& scaling) {
  for (const Marks& marks : panel.marks) {
    std::string runs;
    const auto is_drawn = [&](std::size_t i) {
      return std::isfinite(marks.x[i]) && std::isfinite(marks.y[i]);
    };
    for (std::size_t i = 0; i < marks.runs.size(); ++i)
      if (is_drawn(i)) runs += fmt::format("{}{}", runs.empty() ? "" : " ", marks.runs[i]);
    svg.begin_group({{"class", "marks"},
                     {"data-name", marks.label.empty() ? marks.name : marks.label},
                     {"data-runs", runs},
                     {"data-shift", fmt::format("{:g}", marks.shift)},
                     {"data-only-x", fmt::format("{:d}", marks.only_x)}});
    for (std::size_t i = 0; i < marks.x.size(); ++i)
      if (is_drawn(i)) draw_marker(svg, scaling.x(marks.x[i]), scaling.y(marks.y[i]), marks);
    svg.end_group();
  }
}

/// What a page needs to state values and to zoom: the frame [px] and the ranges of the axes, as
/// log10 where they are of decades.
std::vector<std::pair<std::string, std::string>> axes_data(const Frame& frame, const Panel& panel,
                                                           const Range& x, const Range& y) {
  const bool fixed = panel.overlaid || panel.equal_scales || !panel.rows.empty() ||
                     !panel.spans.empty() || !panel.guides.empty();
  return {{"class", "axes"},
          {"data-frame",
           fmt::format("{:.2f} {:.2f} {:.2f} {:.2f}", frame.x, frame.y, frame.width, frame.height)},
          {"data-x", fmt::format("{:.9g} {:.9g}", x.low, x.high)},
          {"data-y", fmt::format("{:.9g} {:.9g}", y.low, y.high)},
          {"data-log", fmt::format("{:d} {:d}", panel.log_x, panel.log_y)},
          {"data-x-name", panel.x_label},
          {"data-y-name", panel.y_label},
          {"data-fixed", fmt::format("{:d}", fixed)}};
}

}  // namespace

Svg::Svg(double width, double height) : width_(width), height_(height) {
  rectangle(0, 0, width, height, {.stroke = "", .fill = "#ffffff"});
}

void Svg::line(double x1, double y1, double x2, double y2, const Pen& pen) {
  body_ += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x1,
                       y1, x2, y2, style_of(pen));
}

void Svg::rectangle(double x, double y, double width, double height, const Pen& pen) {
  body_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n",
                       x, y, width, height, style_of(pen));
}

void Svg::circle(double x, double y, double radius, const Pen& pen) {
  body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", x, y, radius,
                       style_of(pen));
}

void Svg::polyline(const Points& points, const Pen& pen, bool closed) {
  if (points.empty()) return;
  body_ += closed ? "<polygon points=\"" : "<polyline points=\"";
  for (const auto& [x, y] : points) body_ += fmt::format("{:.2f},{:.2f} ", x, y);
  body_ += "\" " + style_of(pen) + "/>\n";
}

void Svg::text(double x, double y, const std::string& text, const TextStyle& style) {
  const char* const anchors[] = {"start", "middle", "end"};
  body_ += fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}"
      "</text>\n",
      x, y, style.size, anchors[static_cast<int>(style.anchor)], style.color,
      style.bold ? " font-weight=\"bold\"" : "",
      style.upwards ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", x, y) : "",
      xml_text(shortened(text)));
}

void Svg::begin_clip(double x, double y, double width, double height) {
  ++clips_;
  body_ += fmt::format(
      "<clipPath id=\"clip{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" "
      "height=\"{4:.2f}\"/></clipPath>\n<g clip-path=\"url(#clip{0})\">\n",
      clips_, x, y, width, height);
}

void Svg::begin_group(const std::vector<std::pair<std::string, std::string>>& attributes) {
  body_ += "<g";
  for (const auto& [name, value] : attributes)
    body_ += fmt::format(" {}=\"{}\"", name, xml_text(value));
  body_ += ">\n";
}

void Svg::end_group() { body_ += "</g>\n"; }

void Svg::describe(const std::string& text) {
  body_ = "<desc>" + xml_text(text) + "</desc>\n" + body_;
}

std::string Svg::str() const {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
             "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"Helvetica, Arial, Liberation Sans, "
             "DejaVu Sans, sans-serif\">\n",
             width_, height_) +
         body_ + "</svg>\n";
}

Range widened(Range range, const std::vector<double>& values) {
  for (const double value : values)
    if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
  return range;
}

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

std::vector<double> axis_ticks(const Range& range, int wanted) {
  std::vector<double> at = ticks(range, wanted);
  for (int more = 1; at.size() < 2 && more < 8; ++more) at = ticks(range, wanted + more);
  return at;
}

std::vector<double> decade_ticks(const Range& log_range) {
  const auto of_digits = [&](std::initializer_list<double> digits) {
    std::vector<double> result;
    for (double decade = std::floor(log_range.low); decade <= log_range.high; ++decade)
      for (const double digit : digits)
        if (const double at = decade + std::log10(digit);
            at >= log_range.low - 1e-9 && at <= log_range.high + 1e-9)
          result.push_back(at);
    return result;
  };
  if (log_range.span() > 3) return of_digits({1.0});
  const std::vector<double> result = of_digits({1.0, 2.0, 5.0});
  return result.size() >= 3 ? result : of_digits({1, 2, 3, 4, 5, 6, 7, 8, 9});
}

Scaling draw(Svg& svg, const Frame& frame, const Panel& given) {
  const Panel panel = in_decades(given);
  Range x = panel.x_range, y = panel.y_range;
  if (!(x.span() > 0))
    x = panel.marks.empty() && panel.bars.empty() ? range_of(panel, true)
                                                  : padded(range_of(panel, true));
  if (!panel.rows.empty())
    y = {static_cast<double>(panel.rows.size()), 0};
  else if (!(y.span() > 0))
    y = padded(range_of(panel, false), panel.least_span);
  if (!(x.span() > 0)) x = padded(x);
  if (panel.equal_scales) equalise(frame, x, y);
  const Scaling scaling(frame, x, y);
  svg.begin_group(axes_data(frame, panel, x, y));
  draw_spans(svg, frame, panel, scaling);
  draw_axes(svg, frame, panel, scaling, x, y);
  svg.begin_clip(frame.x, frame.y, frame.width, frame.height);
  svg.begin_group({{"class", "view"}});
  for (const Area& area : panel.areas) draw_area(svg, area, scaling);
  draw_bars(svg, panel, scaling);
  draw_curves(svg, panel, scaling);
  svg.end_group();
  svg.end_group();
  svg.rectangle(frame.x, frame.y, frame.width, frame.height, kAxis);
  draw_marks(svg, panel, scaling);
  svg.end_group();
  draw_guides(svg, frame, panel, scaling);
  draw_head(svg, frame, panel);
  return scaling;
}

void draw_lanes(Svg& svg, const Frame& frame, const Panel& panel) {
  constexpr double kSpace = 5;
  const auto count = static_cast<double>(panel.curves.size());
  const double height = (frame.height - kSpace * (count - 1)) / count;
  const Range y =
      panel.y_range.span() > 0 ? panel.y_range : padded(range_of(panel, false), panel.least_span);
  Panel lane = panel;
  lane.y_range = y;
  lane.legend_columns = 0;
  lane.y_label.clear();
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const double top = frame.y + static_cast<double>(i) * (height + kSpace);
    const bool last = i + 1 == panel.curves.size();
    lane.title = i == 0 ? panel.title : "";
    lane.x_label = last ? panel.x_label : "";
    lane.x_labels = last;
    lane.curves = {panel.curves[i]};
    if (panel.own_ranges) lane.y_range = padded(range_of(lane, false), panel.least_span);
    draw(svg, {frame.x, top, frame.width, height}, lane);
    const std::string name = fitted(panel.curves[i].label, 10, frame.width - 10);
    const double right = frame.x + frame.width - 5, wide = text_width(name, 10);
    const auto& values = panel.curves[i].y;  // the name is where the curve does not end
    const Range& range = lane.y_range;
    const bool high = !values.empty() && values.back() > (range.low + range.high) / 2;
    const double line = high ? top + height - 4 : top + 11;
    svg.rectangle(right - wide - 2, line - 10, wide + 5, 13,
                  {.stroke = "", .fill = "#ffffff", .opacity = 0.8});
    svg.text(right, line, name,
             {.size = 10, .anchor = Anchor::kEnd, .color = panel.curves[i].pen.stroke});
  }
  draw_y_name(svg, frame, panel.y_label, 52);
}

std::string dash_of(std::size_t color) {
  static const char* const dashes[] = {"", "6 3", "2 2", "8 2 2 2"};
  return dashes[color / kColors % std::size(dashes)];
}

Pen pen(std::size_t color, double width, const std::string& dash) {
  return {.stroke = palette(color), .width = width, .dash = dash.empty() ? dash_of(color) : dash};
}

std::string ramp(std::size_t index, std::size_t count) {
  // Viridis at eighths of its length, without its last: that yellow is hardly seen on paper.
  constexpr std::array<std::array<double, 3>, 8> kRamp = {{{68, 1, 84},
                                                           {71, 44, 122},
                                                           {59, 81, 139},
                                                           {44, 113, 142},
                                                           {33, 144, 141},
                                                           {39, 173, 129},
                                                           {92, 200, 99},
                                                           {170, 220, 50}}};
  const double place =
      count < 2 ? 0 : 7.0 * static_cast<double>(index) / static_cast<double>(count - 1);
  const auto below = std::min<std::size_t>(6, static_cast<std::size_t>(place));
  const double part = place - static_cast<double>(below);
  std::array<int, 3> rgb{};
  for (std::size_t i = 0; i < 3; ++i)
    rgb[i] = static_cast<int>(
        std::lround(kRamp[below][i] + part * (kRamp[below + 1][i] - kRamp[below][i])));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

std::string palette(std::size_t index) {
  static const char* const colors[kColors] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                              "#E69F00", "#56B4E9", "#000000"};
  return colors[index % kColors];
}

}  // namespace gurney::figures
