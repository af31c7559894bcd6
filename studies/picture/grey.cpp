#include "studies/picture/grey.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gurney::picture {
namespace {

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
