#pragma once

#include <optional>
#include <string_view>
#include <vector>

/// Statements on the samples in a line of free text, letter case apart.
namespace gurney::groundmotions {

/// "acceleration", "velocity" or "displacement" if the line speaks of one: "VELOCITY HISTORY",
/// "displacement in cm", "ACC (G)". Acceleration goes first where a line names several; peaks,
/// wave velocities and the like are not what the samples are.
std::optional<std::string_view> quantity_in(std::string_view line);

/// A line of a header (from 0) that says that the samples are "velocity" or "displacement".
struct OtherQuantity {
  std::size_t line = 0;
  std::string_view quantity;
};

/// Nothing if they may be accelerations. A line that starts with a quantity decides, then any that
/// speaks of acceleration, then the first.
std::optional<OtherQuantity> other_quantity_in(const std::vector<std::string_view>& lines);

/// The unit a line gives to the samples, as it is written there: "Units: cm/s2", "IN UNITS OF G",
/// "acceleration in cm/s", "[gal]". After the word `unit` any text, known or not; elsewhere known
/// units of acceleration or velocity only, a bare "g" where it can be nothing else ("Acceleration,
/// g"). Nothing for units of time and of peaks.
std::optional<std::string_view> unit_text_in(std::string_view line);

/// The time step a line states [s]: "dt = 0.02", "DT=20 MSEC", "Time step (ms): 5", "sampling
/// rate 200 Hz", "200 samples/sec", "equal spacing of 0.02 sec". Without a unit seconds and Hz.
std::optional<double> time_step_in(std::string_view line);

/// How many samples a line states: "NPTS= 400", "No. of points: 400".
std::optional<double> count_in(std::string_view line);

/// The direction that a line states for its component, in capitals and as orient() takes it:
/// "Component: N-S", "VERTICAL COMPONENT", "Acceleration (UP)". Empty if it states none.
std::string component_in(std::string_view line);

/// A factor other than 1 that a line states for the numbers: "scale factor: 2.5".
std::optional<double> factor_in(std::string_view line);

/// Seconds in the unit that a line gives to its times: "Time (ms)", "time in min". Known units
/// only.
std::optional<double> time_unit_in(std::string_view line);

/// The time that `text` starts with [s]: a number, then perhaps a unit of time.
std::optional<double> leading_time(std::string_view text);

}  // namespace gurney::groundmotions
