#include <fmt/core.h>

#include <algorithm>
#include <string>

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

void print_row(int carts, bool brakes, double peak) {
  const Scene scene = loaded_carts(carts, brakes);
  const FloorMotion floor = shaking(1, peak);
  double least = 1e300;
  Response response;
  for (int i = 0; i < (carts > 1 ? 1 : kRepeats); ++i) {
    const double start = cpu_time();
    response = simulate(scene, floor, {.duration = kDuration, .history_step = 0});
    least = std::min(least, cpu_time() - start);
  }
  const auto& work = response.quality;
  fmt::print("| {} | {} | {} | {:.1f} g | {} | {:.1f} | {:.0f} us | {:.2g} |\n", carts,
             scene.items.size(), brakes ? "on" : "off", peak, work.steps,
             double(work.newton_iterations) / work.steps, 1e6 * least / work.steps,
             kDuration / least);
}

}  // namespace

void print_loaded_carts() {
  fmt::print(
      "\nCarts with three drawers and five loose bodies each, {:g} s at 4 ms; one cart: least of "
      "{}\n"
      "| carts | bodies | brakes | PGA | steps | iterations a step | CPU time a step | x real time "
      "|\n| --- | --- | --- | --- | --- | --- | --- | --- |\n",
      kDuration, kRepeats);
  for (const int carts : {1, 10})
    for (const bool brakes : {false, true})
      for (const double peak : {0.2, 0.4}) print_row(carts, brakes, peak);
}

}  // namespace gurney::benchmark
