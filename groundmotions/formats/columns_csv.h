#pragma once

#include <string>
#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// A record in this format, accelerations in m/s2, with its azimuths and starts
/// (columns_csv_facts.h).
/// @param comments  lines without `#` and line ends
/// @param digits    after the point
std::string columns_csv_text(const Record& record, const std::vector<std::string>& comments,
                             int digits = 5);

}  // namespace gurney::groundmotions
