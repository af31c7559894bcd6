#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "groundmotions/acceleration_unit.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/mistakes.h"

/// What a file says of itself, checked against the user's options and against its samples. Lines
/// are counted from 1.
namespace gurney {

/// The unit that a file states on `line`; a mistake if it is no unit of acceleration or differs
/// from options.unit.
AccelerationUnit checked_unit(std::string_view stated, std::size_t line, const ReadOptions& options,
                              Mistakes& mistakes);

/// The unit of a file that states none: options.unit; a mistake if that is empty.
AccelerationUnit unit_of_user(const ReadOptions& options, Mistakes& mistakes);

/// The time step that a file states as `key` on `line` [s]; a mistake unless it is in (0, 1] and
/// agrees with options.time_step to 1e-6.
double checked_time_step(double stated, std::string_view key, std::size_t line,
                         const ReadOptions& options, Mistakes& mistakes);

/// A mistake unless the file holds as many samples as it states as `key` on `line`, 2 at least.
void check_count(double stated, std::string_view key, std::size_t line, std::size_t held,
                 Mistakes& mistakes);

/// Compares the peak that a file states with that of its samples: a warning if they differ by more
/// than half of the last digit of `stated` and 0.1 % (an assumption: samples have four digits), a
/// mistake if by more than a factor of 1.5.
/// @param unit  of `stated`
void check_peak(std::string_view stated, const AccelerationUnit& unit, std::size_t line,
                Component& component, Mistakes& mistakes);

/// A mistake for options.si_per_count, which is for files of raw counts only.
void refuse_si_per_count(const ReadOptions& options, Mistakes& mistakes);

/// A mistake for options.columns, which is for tables of plain numbers only.
void refuse_columns(const ReadOptions& options, Mistakes& mistakes);

/// "velocity" or "displacement" if that is what the unit measures, else nothing.
std::optional<std::string_view> other_quantity(std::string_view unit);

/// `values` times `factor`.
Eigen::VectorXd scaled(const std::vector<double>& values, double factor);

}  // namespace gurney
