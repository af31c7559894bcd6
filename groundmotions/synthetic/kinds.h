#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/config/range.h"
#include "engine/config/table.h"
#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// One number that a kind of synthetic motion takes.
struct SyntheticParameter {
  std::string key;  ///< with its unit: "period_s"
  std::string meaning;
  double fallback = 0;  ///< value where the user gives none
  config::Range range;
};

/// Values of all parameters of a kind by key. "seed" is whole.
using SyntheticValues = std::map<std::string, double>;

/// A kind of synthetic motion, for the job file and the command line.
struct SyntheticKind {
  std::string name;  ///< "ricker"
  std::string description;
  std::string source;  ///< publication
  std::vector<SyntheticParameter> parameters;
  std::function<Record(const SyntheticValues&)> make;
};

/// All kinds, in the order of the documentation.
const std::vector<SyntheticKind>& synthetic_kinds();

/// A motion that was asked for.
struct SyntheticRequest {
  const SyntheticKind* kind = nullptr;  ///< in synthetic_kinds()
  SyntheticValues values;
};

/// Reads `kind` and the parameters of that kind from a table of a job file. Errors are noted in
/// its document; unknown keys are found by Document::finish().
/// @returns nothing for an unknown kind.
std::optional<SyntheticRequest> read_synthetic_request(config::Table& table);

/// The same from the words of a command line.
/// @param settings  "key=value"
/// @throws Error with one line for each error: `records make KIND:N:column: ...`, N the number of
/// the setting.
SyntheticRequest synthetic_request(const std::string& kind,
                                   const std::vector<std::string>& settings);

/// Makes the motion. Its name and the header of every component say that it is synthetic and tell
/// the kind, the source and every parameter.
/// @throws Error `synthetic KIND: ...` for parameters that do not go together.
Record make_record(const SyntheticRequest& request);

}  // namespace gurney::groundmotions
