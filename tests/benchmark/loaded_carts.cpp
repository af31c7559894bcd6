#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "engine/config/document.h"
#include "studies/job/job.h"
#include "tests/benchmark/sections.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

constexpr int kRepeats = 3, kColumns = 5;         // repeats of one cart
constexpr double kApartX = 0.95, kApartY = 0.75;  // a cart is 0.77 by 0.56 m [m]
constexpr double kDuration = 20;                  // [s]

/// Shipped items: medication carts of three drawers that open, with a laptop, a pill box, a water jug and two
/// infusion pumps that stand loose on each.
Scene loaded_carts(int count, bool brakes) {
  std::string text = "schema = \"gurney-job/1\"\n";
  for (int k = 0; k < count; ++k) {
    text += fmt::format(
        "[[item]]\nname = \"cart {}\"\nequipment = \"medication_cart\"\n"
        "variant = \"drawers and computer\"\nlocked_parts = [\"lowest drawer\"]\nbrakes = {}\n"
        "position_m = [{}, {}]\n",
        k + 1, brakes, kApartX * (k % kColumns), kApartY * (k / kColumns));
    for (const auto& [name, x, y] : {std::tuple{"left", -0.28, 0.15}, {"right", 0.285, 0.06}})
      text += fmt::format(
          "[[item]]\nname = \"{} pump {}\"\nequipment = \"infusion_pump\"\non = \"cart {}\"\n"
          "position_m = [{}, {}]\n",
          name, k + 1, k + 1, x, y);
  }
  text +=
      "[excitation.record]\nsynthetic = { kind = \"ricker\", period_s = 1 "
      "}\n[settings]\nduration_s = 20\n";
  config::Document document(text, "loaded_carts.toml");
  return study::read_job(document).scene;
}

/// Quality and least CPU time of a few runs [s].
std::pair<Quality, double> timed(const Scene& scene, const FloorMotion& floor, bool ride) {
  const SimulationSettings settings{
      .duration = kDuration, .history_step = 0, .merge_held_bodies = ride};
  std::pair<Quality, double> result{{}, 1e300};
  for (int i = 0; i < (scene.items.size() > 10 ? 1 : kRepeats); ++i) {
    const double start = cpu_time();
    result.first = simulate(scene, floor, settings).quality;
    result.second = std::min(result.second, cpu_time() - start);
  }
  return result;
}

void print_row(int carts, bool brakes, double peak) {
  const Scene scene = loaded_carts(carts, brakes);
  const FloorMotion floor = shaking(1, peak);
  const auto [work, time] = timed(scene, floor, true);
  const double free_time = timed(scene, floor, false).second;
  fmt::print("| {} | {} | {} | {:.1f} g | {} | {:.1f} | {:.0f} us | {:.2g} | {:.2g} |\n", carts,
             scene.items.size(), brakes ? "on" : "off", peak, work.steps,
             double(work.newton_iterations) / work.steps, 1e6 * time / work.steps, kDuration / time,
             kDuration / free_time);
}

}  // namespace

void print_loaded_carts() {
  fmt::print(
      "\nCarts with three drawers and five loose bodies each, {:g} s at 4 ms; one cart: least of "
      "{}\n"
      "| carts | bodies | brakes | PGA | steps | iterations a step | CPU time a step | x real time "
      "| all bodies free |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      kDuration, kRepeats);
  for (const int carts : {1, 10})
    for (const bool brakes : {false, true})
      for (const double peak : {0.2, 0.4}) print_row(carts, brakes, peak);
}

}  // namespace gurney::benchmark
