#pragma once

#include <string>

namespace gurney::picture {

/// The figure without colours: each as grey as it looks. The colours of curves
/// (figures::palette()) become black, or one grey, and differ by dashes.
std::string in_grey(const std::string& svg);

}  // namespace gurney::picture
