#pragma once

#include <cstddef>
#include <string>

namespace gurney::report {

/// "3 failed", or "3 failed (2 untrusted)" when some of them are.
std::string failed_runs(std::size_t failed, std::size_t untrusted);

}  // namespace gurney::report
