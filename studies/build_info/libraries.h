#pragma once

#include <string>

namespace gurney::build_info {

/// Names and versions of the libraries this program was built with: "Boost 1.74.0, Bullet 3.24, ..."
std::string libraries();

}  // namespace gurney::build_info
