#pragma once

#include <span>
#include <vector>

#include "studies/explanation/facts.h"
#include "studies/results/run_facts.h"

namespace gurney::explanation {

/// Displacement that counts as motion [m].
inline constexpr double kVisible = Predictability::kLeastDisplacement;

/// "front left" by the mount against the middle of all mounts (x to the front, y to the left).
std::string place_of(const EquipmentModel& item, std::size_t caster);

/// The caster's name; with its place where the name does not state it.
std::string caster_words(const EquipmentModel& item, std::size_t caster);

/// A time from the first caster that leaves the floor until all are back, at samples of the
/// histories. Casters may land and leave again in it: each has times of its own.
struct Lift {
  double from = 0, until = 0;  ///< [s]; until the end of the histories where not all are back
  bool landed = false;
  std::vector<std::size_t> casters;  ///< in the order in which they left
  std::size_t most = 0;              ///< casters at once
  double together = 0;               ///< time with all of `casters` off the floor [s]
  double longest = 0;                ///< time of a single caster without a landing [s]
  std::size_t longest_caster = 0;
};
std::vector<Lift> lifts_of(const EquipmentModel& item, std::span<const Sample> history);

/// Lifts that the events state: the first, the last of an item that overturned, and the longest of
/// the others, so that there are three of them where there are as many.
inline constexpr std::size_t kStatedLifts = 3;
std::vector<Lift> stated_lifts(std::vector<Lift> lifts, bool overturned);

/// Onset of the first visible displacement: the last sample before it in which the origin was
/// slower than 1 mm/s. < 0: none [s].
double onset_of_motion(const std::vector<Sample>& history);

/// First sample in which a braked caster skids, and which; time < 0: none.
struct Skid {
  double time = -1;
  std::size_t caster = 0;
};
Skid first_skid(const EquipmentModel& item, const std::vector<Sample>& history);

/// Events by time. Times of impacts, tethers, zones, overturning and peaks are those of the
/// response; the others are found in the histories.
std::vector<Event> events_of(const study::RunFacts& facts, const Response& response);

}  // namespace gurney::explanation
