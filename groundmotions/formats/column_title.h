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
  std::string quantity;   ///< "velocity", "voltage", "time"...; empty: may be acceleration
  std::string factor;     ///< "x 10" of `Acc (g) x 10`; empty if there is none

  /// A `v`, `d` or `u` alone, which may be a velocity, a displacement or the vertical.
  bool is_doubtful = false;

  /// `Acc`, `NS [g]`: surely an acceleration, not only because nothing else is stated.
  bool is_acceleration() const;
};

/// `v`, `d` and `u` beside an acceleration are velocity and displacement; `v` beside directions is
/// the vertical.
std::vector<ColumnTitle> parsed_titles(const std::vector<std::string>& titles);

/// Whether a text is a unit of something, brackets around it apart: "[g]", "cm/s", "sec", "kN".
bool is_unit_of_something(std::string_view text);

/// `Time`, `t (s)`, `[sec]`; `#`, `No.`, `Sample`, or no title at all.
bool names_time(const ColumnTitle& title);
bool names_index(const ColumnTitle& title);

/// `Period`, `Tn (s)`, `f (Hz)`: the first column of a spectrum; `Sa(g)`, `PSA`, `FAS`: another.
/// @param beside_time  the first column is surely a time: `SE` may be south-east then
bool names_period(const ColumnTitle& title);
bool names_ordinate(const ColumnTitle& title, bool beside_time);

/// Sets azimuth or direction as the title says them, also `NS acc` and `Acc (DOWN)`. Where the user
/// has `stated` a direction it stays, with a warning if the title says vertical for a horizontal or
/// the other way round; the sign is turned of a vertical that points down. To be called when the
/// samples are there.
void orient(const ColumnTitle& title, const std::optional<Direction>& stated, Component& component);

}  // namespace gurney::groundmotions
