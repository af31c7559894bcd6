#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/report/narrative.h"

namespace gurney::report {
namespace {

/// What one run shows of an item.
std::string trust(const Predictability& p) {
  const std::string change = "a change of mass by one part in a billion";
  if (p.time_of_peaks == 0) return "Predictable: the item stays where it is";
  switch (p.verdict) {
    case Predictability::Verdict::kPredictable:
      return fmt::format(
          "Predictable: {} grows {:.2g}-fold until the peaks of displacement and tilt at "
          "{:.2f} s{}",
          change, p.amplification_at_peaks, p.time_of_peaks,
          p.horizon > p.time_of_peaks
              ? fmt::format("; from {:.2f} s on the motion is sensitive", p.horizon)
              : "");
    case Predictability::Verdict::kSensitive:
      return fmt::format(
          "SENSITIVE: {} grows {:.2g}-fold until the peaks of displacement and tilt at {:.2f} s; "
          "from "
          "{:.2f} s on an error of 0.1 % may change the motion by its own size",
          change, p.amplification_at_peaks, p.time_of_peaks, p.horizon);
    case Predictability::Verdict::kChaotic:
      break;
  }
  return fmt::format(
      "CHAOTIC: {} leads to another motion before the peaks at {:.2f} s. They are those of one run "
      "among many; study.replicas gives their distribution",
      change, p.time_of_peaks);
}

/// By how much half the time step changes a peak, of the items whose motion has a number.
struct StepChange {
  double largest = 0;  ///< of the peak
  std::string of;

  /// Peaks below `least` count as rest.
  void add(double peak, double at_half_step, double least, const std::string& name) {
    if (!(std::max(peak, at_half_step) >= least)) return;
    const double change = at_half_step / peak - 1;
    if (!of.empty() && std::abs(change) <= std::abs(largest)) return;
    largest = change;
    of = name;
  }

  std::string text(const char* quantity, bool one_of_several) const {
    if (of.empty()) return "";
    return one_of_several
               ? fmt::format("{}s by at most {:.2g} % ({})", quantity, 100 * std::abs(largest), of)
               : fmt::format("the {} by {:+.2g} %", quantity, 100 * largest);
  }
};

/// For settings.peak_error.
std::string halvings(const Quality& quality) {
  if (quality.step_halvings == 0) return "";
  return fmt::format(
      "Time step: halved {} times{}; the last two changed {}.\n", quality.step_halvings,
      quality.step_halvings == Quality::kLargestHalvings ? ", no shorter is tried" : "",
      std::isfinite(quality.peak_change)
          ? fmt::format("no judged demand by more than {:.2g} %", 100 * quality.peak_change)
          : "an outcome");
}

std::string time_step(const Response& response, const std::vector<std::string>& names) {
  StepChange displacement, tilt;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const auto& found = response.items[i].predictability;
    if (!found || found->verdict == Predictability::Verdict::kChaotic) continue;
    const Demands& d = response.items[i].demands;
    if (!found->half_step) continue;
    displacement.add(d.peak_displacement, found->half_step->peak_displacement,
                     Predictability::kLeastDisplacement, names[i]);
    tilt.add(d.peak_tilt, found->half_step->peak_tilt, Predictability::kLeastTilt, names[i]);
  }
  const bool several = names.size() > 1;
  const std::string moved = displacement.text("peak displacement", several),
                    tilted = tilt.text("peak tilt", several);
  const std::string halved = halvings(response.quality);
  if (moved.empty() && tilted.empty()) return halved;
  return halved + fmt::format("Time step: half of it changes {}{}{}.\n", moved,
                              moved.empty() || tilted.empty() ? "" : ", ", tilted);
}

/// Of several items a line for each that is not predictable.
std::string of_several(const Response& response, const std::vector<std::string>& names) {
  std::string text, predictable;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const auto& found = response.items[i].predictability;
    if (!found) continue;
    if (found->verdict == Predictability::Verdict::kPredictable)
      predictable += (predictable.empty() ? "" : ", ") + names[i];
    else
      text += fmt::format("  {}: {}\n", names[i], trust(*found));
  }
  if (!predictable.empty())
    text +=
        fmt::format("  predictable until their peaks of displacement and tilt: {}\n", predictable);
  return text.empty() ? "" : "Predictability\n" + text;
}

}  // namespace

std::string narrative_of_trust(const Response& response, const std::vector<std::string>& names) {
  const auto& first = response.items[0].predictability;
  const std::string text = names.size() > 1 ? of_several(response, names)
                           : first          ? trust(*first) + ".\n"
                                            : "";
  return text + time_step(response, names);
}

}  // namespace gurney::report
