#include "studies/picture/picture.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "engine/base/error.h"
#include "studies/picture/grey.h"
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

}  // namespace gurney::picture
