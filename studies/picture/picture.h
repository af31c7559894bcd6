#pragma once

#include <optional>
#include <string>

namespace gurney::picture {

/// Size of a page [in].
struct Size {
  double width = 0, height = 0;
};

/// The bytes of an SVG as PDF, or as PNG with 300 pixels to the inch. The only functions that know
/// librsvg and cairo.
/// @throws Error for what they refuse
std::string pdf(const std::string& svg, const Size& size);
std::string png(const std::string& svg, const Size& size);

/// File format of a figure.
enum class Format { kSvg, kPdf, kPng };

/// The format that a file's suffix names.
/// @throws Error for another suffix, with those allowed
Format format_of(const std::string& path);

/// A length such as "85mm", in mm; units mm, cm, in, pt and px (1/96 in).
/// @throws Error for another text, and unless it is 20 mm to 1 m
double length_in_mm(const std::string& text);

/// How a figure is written.
struct Style {
  std::optional<double> width_mm = {};  ///< none: 1/96 in for each px of the figure
  bool grey = false;                    ///< without colours; their curves differ by dashes
};

/// The bytes of a figure, given as the SVG that studies/report makes, whose size is in px. The same
/// figure gives the same bytes. PNG has 300 pixels to the inch.
/// @throws Error for a figure that is too large
std::string written(const std::string& svg, Format format, const Style& style = {});

/// The figure without colours: each as grey as it looks. The colours of curves
/// (figures::palette()) become black, or one grey, and differ by dashes.
std::string in_grey(const std::string& svg);

}  // namespace gurney::picture
