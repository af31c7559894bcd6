#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/benchmark/sections.h"
#include "tests/benchmark/workload.h"

namespace gurney::benchmark {
namespace {

constexpr double kReferenceStep = 0.000125;
constexpr double kStep = 0.004;

double quantile(std::vector<double> values, double p) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto last = values.size() - 1;
  return values[static_cast<std::size_t>(std::lround(p * static_cast<double>(last)))];
}

double relative(double value, double reference) { return std::abs(value / reference - 1); }

/// Largest absolute acceleration of the marked points.
double peak_acceleration(const Response& response) {
  double peak = 0;
  for (const auto& point : response.items[0].demands.points)
    peak = std::max(peak, point.peak_absolute_acceleration);
  return peak;
}

struct Pair {
  Response coarse, fine;
  double seconds = 0;
};

}  // namespace

void print_pulling_accuracy() {
  fmt::print("Pulling test: 40 N for 3 s, then coasting; error against closed form\n");
  fmt::print("{:>10} {:>10} {:>9} {:>14} {:>14}\n", "k_n N/m", "k_t N/m", "dt ms", "at release",
             "at rest");
  struct Setting {
    double normal, tangential, step;
  };
  for (const Setting& s : {Setting{3e6, 1e9, 4e-3},
                           {3e6, 1e9, 5e-4},
                           {3e8, 1e9, 4e-3},
                           {3e8, 1e9, 5e-4},
                           {3e5, 1e5, 4e-3},
                           {3e5, 1e5, 5e-4}}) {
    Scene scene = trolley({0, 0, 0, 0});
    make_rigid(scene, s.normal, s.tangential);
    scene.items[0].loads = {pull()};
    const Response response =
        simulate(scene, FloorMotion(), {.time_step = s.step, .history_step = 0.5});
    const PullReference reference = pull_reference(scene);
    double at_release = 0;
    for (const Sample& sample : response.items[0].history)
      if (std::abs(sample.time - 3) < 1e-9) at_release = sample.displacement.x();
    fmt::print("{:>10.0e} {:>10.0e} {:>9.3g} {:>13.4f}% {:>13.4f}%\n", s.normal, s.tangential,
               1e3 * s.step, 100 * (at_release / reference.at_release - 1),
               100 * (response.items[0].demands.residual_displacement / reference.at_rest - 1));
  }
  fmt::print(
      "The soft tread (last rows) winds up 0.05 mm before the full resistance acts: that is the\n"
      "model, not an error (docs/theory/tread.md).\n\n");
}

void print_ensemble_accuracy(int records, int headings) {
  fmt::print(
      "Three-component motions of 20 s on the four-caster trolley, {} records x {} sets of caster\n"
      "angles; dt 4 ms against 0.125 ms; one core\n",
      records, headings);
  fmt::print("{:>5} {:>16} {:>16} {:>16} {:>12} {:>13} {:>9} {:>10}\n", "PGA g", "displacement",
             "acceleration", "wheel force", "lift-off", "end mm", "x real", "us a step");
  for (const double pga : {0.4, 0.8, 1.2}) {
    const int count = records * headings;
    std::vector<Pair> pairs(static_cast<std::size_t>(count));
    const auto scene_of = [&](int i) {
      const double turn = 37.0 * (i % headings);
      return trolley({10 + turn, 100 + 3 * turn, 200 + 7 * turn, 300 + 11 * turn});
    };
    const auto floor_of = [&](int i) {
      return shaking(static_cast<unsigned>(1 + i / headings), pga);
    };
    SimulationSettings settings{.time_step = kStep, .duration = 20, .history_step = 0};
    double seconds = 0;
    long steps = 0;
    for (int i = 0; i < count; ++i) {
      auto [response, wall] = timed(scene_of(i), floor_of(i), {settings}, 1);
      seconds += wall;
      steps += response.quality.steps;
      pairs[static_cast<std::size_t>(i)].coarse = std::move(response);
    }
    settings.time_step = kReferenceStep;
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i)
      pairs[static_cast<std::size_t>(i)].fine = simulate(scene_of(i), floor_of(i), settings);

    std::array<std::vector<double>, 3> errors;
    std::vector<double> end_distance;
    double coarse_lift = 0, fine_lift = 0;
    for (const Pair& pair : pairs) {
      const Demands &a = pair.coarse.items[0].demands, &b = pair.fine.items[0].demands;
      errors[0].push_back(relative(a.peak_displacement, b.peak_displacement));
      errors[1].push_back(relative(peak_acceleration(pair.coarse), peak_acceleration(pair.fine)));
      errors[2].push_back(relative(a.peak_normal_force, b.peak_normal_force));
      end_distance.push_back(std::hypot(a.residual_displacement_x - b.residual_displacement_x,
                                        a.residual_displacement_y - b.residual_displacement_y));
      coarse_lift += a.lifted_time;
      fine_lift += b.lifted_time;
    }
    const auto cell = [&](int k) {
      const auto& e = errors[static_cast<std::size_t>(k)];
      return fmt::format("{:.2f}% / {:.2f}%", 100 * quantile(e, 0.5), 100 * quantile(e, 0.9));
    };
    const std::string ends = fmt::format("{:.1f} / {:.1f}", 1e3 * quantile(end_distance, 0.5),
                                         1e3 * quantile(end_distance, 0.9));
    const std::string lift =
        fine_lift > 0 ? fmt::format("{:.2f}%", 100 * (coarse_lift / fine_lift - 1)) : "none";
    fmt::print("{:>5} {:>16} {:>16} {:>16} {:>12} {:>13} {:>9.0f} {:>10.2f}\n", pga, cell(0),
               cell(1), cell(2), lift, ends, 20.0 * count / seconds,
               1e6 * seconds / static_cast<double>(steps));
    std::fflush(stdout);
  }
  fmt::print(
      "Cells: median / 90 % quantile of the relative error of the peak; lift-off: error of the "
      "time\n"
      "with at least one wheel off the floor, summed over the ensemble; end: distance of the "
      "final\n"
      "places (they scatter by nature: a trolley that nearly stops with its casters crosswise may "
      "go\n"
      "either way).\n\n");
}

}  // namespace gurney::benchmark
