#include "studies/figures/svg.h"

#include <fmt/format.h>

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

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : shortened(printable(text))) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
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
      escaped(text));
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
    body_ += fmt::format(" {}=\"{}\"", name, escaped(value));
  body_ += ">\n";
}

void Svg::end_group() { body_ += "</g>\n"; }

void Svg::describe(const std::string& text) {
  body_ = "<desc>" + escaped(text) + "</desc>\n" + body_;
}

std::string Svg::str() const {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
             "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"Helvetica, Arial, Liberation Sans, "
             "DejaVu Sans, sans-serif\">\n",
             width_, height_) +
         body_ + "</svg>\n";
}

}  // namespace gurney::figures
