#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/response/response.h"
#include "studies/explanation/overturning.h"
#include "studies/units/unit_system.h"

/// Why a run ended as it did: facts in time order, margins, energies (docs/look.md).
namespace gurney::explanation {

/// The worst that happened to an item, the mildest first.
enum class Finding { kStill, kMoved, kRocked, kHit, kToppled, kOverturned };
const char* name_of(Finding finding);
/// Whether it came to lie, on the floor or on what it stood on.
inline bool lies(Finding finding) { return finding >= Finding::kToppled; }

enum class EventKind {
  kMoved,             ///< left its place: the onset of the first millimetre
  kGripExceeded,      ///< a braked wheel skids
  kBrakeTurned,       ///< a braked wheel turns against its brake
  kLiftOff,           ///< the first caster leaves the floor; value: all are back [s], NaN: never
  kLanded,            ///< all casters are back
  kTipped,            ///< an item without casters tilts; value [rad]
  kImpact,            ///< value: approach speed [m/s]
  kTaut,              ///< value: largest tension of the run [N]
  kUnplugged,         ///< or broken
  kReleased,          ///< the latch of a part lets go
  kFell,              ///< from what it stood on
  kToppled,           ///< on what it stood on; value: direction from the floor's x axis [rad]
  kZone,              ///< an item enters a zone
  kPeakDisplacement,  ///< value [m]
  kPeakTilt,          ///< value [rad]
  kOverturned,        ///< value: direction from the floor's x axis [rad]
  kEnd
};
const char* name_of(EventKind kind);

/// Casters off the floor between the first lift-off and the time when all are back.
struct Uplift {
  std::size_t casters = 0;  ///< that left the floor in that time
  std::size_t most = 0;     ///< at once
  double together = 0;      ///< with all of these off the floor [s]
  double longest = 0;       ///< of a single caster without a landing [s]
  std::string longest_of;   ///< that caster
  bool overturned = false;  ///< the item did: what is not back was off until then
};

struct Event {
  double time = 0;  ///< [s]
  EventKind kind = EventKind::kEnd;
  std::string item;                   ///< empty: of the room or of all
  std::string part;                   ///< casters, what was hit, the zone, the tether
  double value = 0;                   ///< see EventKind
  bool sampled = false;               ///< found in the histories, whose step is its resolution
  std::optional<Uplift> uplift = {};  ///< of kLiftOff
};

/// Tilt against the angle at which the item stands on its edge:
///   tan(critical) = reach of the supports from the centre of mass in the direction of the tilt
///                   / height of the centre of mass,
/// with the forks where they are at that time. Where it overturned, until then.
struct TiltMargin {
  double tilt = 0, critical = 0;  ///< where tilt / critical is largest [rad]
  double time = 0;                ///< [s]
  double direction = 0;           ///< item axes, from the front anticlockwise [rad]
  double time_passed = -1;        ///< when tilt > critical first; < 0: never [s]

  double ratio() const { return critical > 0 ? tilt / critical : 0; }
};

/// Force that keeps the item where it is on the floor against what its casters can hold:
///   demand = m |a|, a the horizontal acceleration of the floor,
///   grip   = sum over casters of min(mu_s N, T / R) with a brake of torque T, of
///            min(mu_s N, (Cr N + T_axle) / R) without; N as simulated;
///   without casters mu m (g + a_z).
struct GripMargin {
  double demand = 0, grip = 0;  ///< where grip - demand is smallest [N]
  double time = 0;              ///< [s]
  double time_exceeded = -1;    ///< when demand > grip first; < 0: never [s]
  double peak_demand = 0;       ///< [N]
  bool braked = false;          ///< some caster is
  bool rolls = false;           ///< some caster is not
};

struct ItemFacts {
  std::string name;
  bool has_casters = false;
  bool on_floor = true;  ///< on its own casters or feet: only then it has a grip
  bool is_part = false;  ///< which a joint holds: it has no edge to tip over
  bool stands_on_parts =
      false;             ///< some of its casters are theirs: neither edge nor grip are known
  double mass = 0;       ///< with what it carries [kg]
  bool carries = false;  ///< mass is more than its own
  double height_of_center_of_mass = 0;  ///< [m]
  Finding finding = Finding::kStill;
  double peak_displacement = 0, time_of_peak_displacement = 0;  ///< [m], [s]
  double residual_displacement = 0;                             ///< [m]
  double peak_velocity = 0;                                     ///< [m/s]
  double peak_travel = 0,
         peak_swing = 0;  ///< of a part on its joint [m], [rad]; 0: it does not move so
  double stop_speed = 0;  ///< with which a part met a stop of its joint; 0: it did not [m/s]
  TiltMargin tilt;
  GripMargin grip;
  std::string first_lifted, first_skidded;  ///< casters; empty: none
  double time_of_lift = -1, time_of_skid = -1;
  std::size_t uplifts = 0;  ///< times with a caster off the floor, before it overturned
};

/// Energy of the explained item up to a moment; potential and elastic against the start [J].
struct Stage {
  std::string name;
  double time = 0;  ///< [s]
  double kinetic = 0, potential = 0, elastic = 0;
  double floor_work = 0, other_work = 0;  ///< put in
  double friction = 0, rolling = 0, impacts = 0, other_loss = 0;
};

/// Histories of the explained item, for the figure.
struct Tracks {
  std::vector<double> time;            ///< [s]
  std::vector<double> floor;           ///< acceleration in the direction of the pulse [m/s2]
  std::vector<double> displacement;    ///< horizontal resultant [m]
  std::vector<double> tilt, critical;  ///< [rad]; critical NaN while it hardly tilts
  std::vector<double> demand, grip;    ///< NaN once it has overturned [N]
  std::vector<EnergyAccount> energy;
};

/// Everything that text, JSON and figure state.
struct Explanation {
  std::string title, record, outcome, cause;  ///< record empty: the floor is at rest
  bool failed = false;                        ///< the run did: nothing else is there but the cause
  double end_time = 0;
  double resolution = 0;  ///< step of the histories [s]
  std::vector<ItemFacts> items;
  std::size_t subject = 0;    ///< the item that is explained
  std::optional<Impact> hit;  ///< the hardest of the subject, before it overturned; none: no hit
  double worst_time = 0;      ///< of the finding [s]
  Vector2 direction = Vector2::Zero();  ///< of the motion that led to it, floor axes; zero: none
  double swing_start = 0;               ///< of that motion [s]
  std::vector<Event> events;            ///< by time
  std::optional<HalfCycle> pulse;       ///< the floor's, against `direction`
  std::vector<Stage> stages;
  Tracks tracks;
  std::optional<Predictability> predictability;  ///< of the subject
  study::UnitSystem units = {};                  ///< of text and figure

  const ItemFacts& item() const { return items.at(subject); }
};

}  // namespace gurney::explanation
