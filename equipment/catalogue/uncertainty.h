#pragma once

#include <optional>
#include <string>

#include "engine/base/random/distribution.h"
#include "engine/base/random/draw.h"
#include "engine/config/table.h"

namespace gurney::equipment {

/// The possible values of a number, as the `distribution` of its quantity says
/// (docs/formats/equipment_file.md).
struct Uncertainty {
  Distribution distribution;  ///< in the unit of the key
  CorrelationGroup group;
  std::string reason;  ///< assumption behind it; empty: it has a source
};

/// Reads the table `key` of `parent`. Errors are noted; the result is empty then.
/// @param range  what the number may be: the distribution must stay within
std::optional<Uncertainty> read_uncertainty(config::Table& parent, const std::string& key,
                                            const config::Range& range);

/// Unit of a number by the end of its key: `kg` for `chassis.mass_kg`, `1` for a pure number.
std::string unit_of_key(const std::string& key);

}  // namespace gurney::equipment
