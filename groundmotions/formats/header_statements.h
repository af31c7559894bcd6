#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "groundmotions/acceleration_unit.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/formats/mistakes.h"

namespace gurney {

std::string upper(std::string_view text);

/// The number behind `key` in `line`, blanks, '=' and ':' between them apart.
std::optional<double> number_after(std::string_view line, std::string_view key);

/// The unit of acceleration that a header line names somewhere, letter case apart: "UNITS: G)",
/// "SEC AND G/10.", "in cm/sec2.". A tenth of g is "g/10".
std::optional<AccelerationUnit> unit_in(std::string_view line);

/// The unit a file states, or else that of the options; a mistake if there is none or both differ.
/// @param line  that states it, from 1
AccelerationUnit agreed_unit(const std::optional<AccelerationUnit>& stated, std::size_t line,
                             const ReadOptions& options, Mistakes& mistakes);

/// The time step a file states, or else that of the options; a mistake if there is none, both
/// differ, or it is not in (0, 1] s.
double agreed_time_step(const std::optional<double>& stated, std::size_t line,
                        const ReadOptions& options, Mistakes& mistakes);

/// The peak a header states: its size and by how much it may be rounded [m/s2]; its line, from 1.
struct StatedPeak {
  double size = 0;
  double rounding = 0;
  std::size_t line = 1;
};

/// A warning if the samples, as they are or without their mean, have another peak; a mistake if
/// theirs is not within a factor of 1.5.
/// @param samples  as the file has them [m/s2]
void check_peak(const StatedPeak& peak, const Eigen::VectorXd& samples, Component& component,
                Mistakes& mistakes);

/// A warning if a record of this many samples has not the length its header states; a mistake if
/// it is not within a factor of 1.5.
/// @param length  [s]; not above 0: not stated
void check_length(double length, std::size_t line, Component& component, Mistakes& mistakes);

/// Azimuth or vertical of a component as a label says it: "90 DEG", "N08W", "UP", "VERT", "DOWN"
/// (turned to up, with a warning). Labels such as "L" or "Roof" say neither.
/// @returns whether the label says it.
bool orient_by_label(std::string_view label, Component& component);

/// Turns a component that points down, with a warning. @param why  the header's word: "DOWN"
void turn_up(std::string_view why, Component& component);

/// Seconds since 1970 of a date (UTC); nothing if there is no such date or time.
std::optional<double> utc_seconds(int year, int month, int day, double hour, double minute,
                                  double second);

}  // namespace gurney
