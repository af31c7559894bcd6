#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "groundmotions/formats/plain_rows.h"
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

/// The titles of a table as the last lines of its text give them: in one row, `Time[s] Accel[g]`,
/// or with a row of units below or above them, `Time,Acc` and `[s],[g]` or `s,g`.
struct TableTitles {
  std::vector<ColumnTitle> titles;  ///< one for each column, or none
  std::vector<std::size_t> lines;   ///< of the header (from 0) that they are made of
  std::size_t line = 1;             ///< in the file, from 1, of the last of them
  bool are_components = false;      ///< a line says so: `components: E N Z`

  bool any() const { return !titles.empty(); }
};

/// @param count  columns of the table
/// Sentences and statements of as many words (`Units: g`, `cm/s2; dt=0.01`) are no titles. Without
/// titles a line such as `components: E N Z` names the columns but a first one of times.
TableTitles table_titles(const PlainRows& rows, std::size_t count);

}  // namespace gurney::groundmotions
