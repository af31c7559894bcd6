#pragma once

#include <string>

#include "studies/doctor/examination.h"

namespace gurney::doctor {

/// A small study, with one thread and with several: the same bits are to come out. The text has a
/// digest, which is equal on all machines with this build.
Finding determinism();

/// The verdict on the digests of two runs.
Finding same_bits(const std::string& with_one, const std::string& with_several, int threads,
                  std::size_t runs);

}  // namespace gurney::doctor
