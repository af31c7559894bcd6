#pragma once

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

}  // namespace gurney::picture
