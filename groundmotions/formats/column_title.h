#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// The title of a column in a table of plain numbers: `NS [cm/s2]`, `Vel (cm/s)`, `acc_g`, `v`.
struct ColumnTitle {
  std::string text;  ///< as in the file
  std::string name;  ///< without what is in brackets

  /// In brackets, or behind a `_` if it is one: known or not, but no direction; empty if none.
  std::string unit;
  std::string direction;  ///< in brackets: `Acc (DOWN) [g]`
  std::string quantity;   ///< "velocity" or "displacement"; empty: may be acceleration

  /// A `v` alone, which may be a velocity or the vertical.
  bool is_doubtful = false;
};

/// `v`, `d` and `u` beside an acceleration are velocity and displacement; `v` beside directions is
/// the vertical.
std::vector<ColumnTitle> parsed_titles(const std::vector<std::string>& titles);

/// Sets azimuth or direction as the title says them, also `NS acc` and `Acc (DOWN)`. Where the user
/// has `stated` a direction it stays, with a warning if the title says vertical for a horizontal or
/// the other way round; the sign is turned of a vertical that points down. To be called when the
/// samples are there.
void orient(const ColumnTitle& title, const std::optional<Direction>& stated, Component& component);

}  // namespace gurney::groundmotions
