#include "studies/picture/picture.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "engine/base/error.h"
#include "studies/picture/rendering.h"

namespace gurney::picture {
namespace {

constexpr double kMmPerInch = 25.4, kPxPerInch = 96, kPointsPerInch = 72;
constexpr double kNarrowestMm = 20, kWidestMm = 1000;

/// The number of an attribute of the first tag: width="700".
double attribute_of(const std::string& svg, const std::string& name) {
  const std::string key = " " + name + "=\"";
  const auto at = svg.find(key);
  require(at != std::string::npos && at < svg.find('>'), "a figure without " + name);
  return std::stod(svg.substr(at + key.size()));
}

void replace_attribute(std::string& svg, const std::string& name, const std::string& value) {
  const auto at = svg.find(" " + name + "=\"") + name.size() + 3;
  svg.replace(at, svg.find('"', at) - at, value);
}

struct CurveColor {
  const char *color, *grey, *dash;
};

// The palette of studies/figures/panel.cpp.
constexpr std::array kCurveColors = {
    CurveColor{"#0072B2", "#000000", ""},        CurveColor{"#D55E00", "#000000", "6 3"},
    CurveColor{"#009E73", "#808080", ""},        CurveColor{"#CC79A7", "#808080", "6 3"},
    CurveColor{"#E69F00", "#000000", "1.5 2.5"}, CurveColor{"#56B4E9", "#000000", "7 2 1.5 2"},
    CurveColor{"#000000", "#808080", "1.5 2.5"}};

/// As bright as the colour: relative luminance, and sRGB's transfer function (IEC 61966-2-1).
std::string grey_of(const std::string& color) {
  const auto linear = [&](std::size_t at) {
    const double value = std::stoi(color.substr(at, 2), nullptr, 16) / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(1) + 0.7152 * linear(3) + 0.0722 * linear(5);
  const double grey = y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1 / 2.4) - 0.055;
  const int level = static_cast<int>(std::lround(255 * grey));
  return fmt::format("#{0:02x}{0:02x}{0:02x}", level);
}

const CurveColor* curve_color(const std::string& color) {
  for (const CurveColor& each : kCurveColors)
    if (color == each.color) return &each;
  return nullptr;
}

bool is_curve(const std::string& tag) {
  return tag.starts_with("<polyline") || tag.starts_with("<line");
}

/// One tag; texts never get here, so nothing that a user named is changed.
std::string grey_tag(std::string tag) {
  for (const std::string key : {"stroke=\"#", "fill=\"#"}) {
    const auto found = tag.find(" " + key);
    if (found == std::string::npos) continue;
    const auto at = found + key.size();
    const std::string color = tag.substr(at, 7);
    const CurveColor* const curve = curve_color(color);
    tag.replace(at, 7, curve ? curve->grey : grey_of(color));
    const bool dashed = tag.find("stroke-dasharray") != std::string::npos;
    if (curve && is_curve(tag) && key[0] == 's' && *curve->dash != '\0' && !dashed)
      tag.insert(at + 8, fmt::format(" stroke-dasharray=\"{}\"", curve->dash));
  }
  return tag;
}

}  // namespace

Format format_of(const std::string& path) {
  const std::string suffix = std::filesystem::path(path).extension().string();
  if (suffix == ".svg") return Format::kSvg;
  if (suffix == ".pdf") return Format::kPdf;
  if (suffix == ".png") return Format::kPng;
  throw Error(path + ": the name of a figure must end in .svg, .pdf or .png");
}

double length_in_mm(const std::string& text) {
  constexpr std::array<std::pair<const char*, double>, 5> kUnits{
      {{"mm", 1},
       {"cm", 10},
       {"in", kMmPerInch},
       {"pt", kMmPerInch / kPointsPerInch},
       {"px", kMmPerInch / kPxPerInch}}};
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string unit(end, text.data() + text.size());
  for (const auto& [name, mm] : kUnits) {
    if (error != std::errc() || unit != name) continue;
    const double length = number * mm;
    require(length >= kNarrowestMm && length <= kWidestMm,
            fmt::format("width {}: must be {} mm to {} mm", text, kNarrowestMm, kWidestMm));
    return length;
  }
  throw Error(
      fmt::format("width '{}': must be a number with its unit, mm, cm, in, pt or px: 85mm", text));
}

std::string written(const std::string& svg, Format format, const Style& style) {
  const double width_px = attribute_of(svg, "width"), height_px = attribute_of(svg, "height");
  const double width_in = style.width_mm ? *style.width_mm / kMmPerInch : width_px / kPxPerInch;
  const double height_in = width_in * height_px / width_px;
  std::string styled = style.grey ? in_grey(svg) : svg;
  if (format == Format::kSvg) {
    if (style.width_mm) {
      replace_attribute(styled, "width", fmt::format("{:g}mm", width_in * kMmPerInch));
      replace_attribute(styled, "height", fmt::format("{:g}mm", height_in * kMmPerInch));
    }
    return styled;
  }
  const Size size{width_in, height_in};
  return format == Format::kPdf ? pdf(styled, size) : png(styled, size);
}

std::string in_grey(const std::string& svg) {
  std::string result;
  for (std::size_t at = 0; at < svg.size();) {
    const bool tag = svg[at] == '<';
    const auto next = svg.find(tag ? '>' : '<', at);
    const auto end = next == std::string::npos ? svg.size() : next + (tag ? 1 : 0);
    const std::string part = svg.substr(at, end - at);
    result += tag ? grey_tag(part) : part;
    at = end;
  }
  return result;
}

}  // namespace gurney::picture
