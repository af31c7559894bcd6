#include <fmt/core.h>

#include <cmath>
#include <fstream>

#include "engine/base/units.h"
#include "engine/scene/perturbed.h"
#include "tests/benchmark/peers/curves.h"
#include "tests/benchmark/workload.h"
#include "tests/peers/moreau.h"

namespace gurney::benchmark {
namespace {

using peers::CrossCheck;
using peers::Path;

struct Method {
  std::string engine, setup;
  double step;  ///< [s]
  std::function<Path(const CrossCheck&)> run;
};

CrossCheck with_scene(CrossCheck check, const std::function<void(Scene&)>& change) {
  change(check.scene);
  return check;
}

std::vector<Method> methods(bool quick) {
  const double step = quick ? 0.001 : 0.00025, slow = quick ? 0.0005 : 0.0001,
               slowest = quick ? 0.00005 : 0.00001;
  const auto all = engines({step}, {});
  const Engine &real = all[0], &rigid = all[2];
  const auto changed = [&](const char* setup, const Engine& engine,
                           const std::function<void(Scene&)>& change) {
    return Method{"Gurney", setup, step, [=](const CrossCheck& check) {
                    return engine.run(with_scene(check, change), step);
                  }};
  };
  const auto rigid_treads = [](Scene& scene) { make_rigid(scene, kRigid, kRigidTangential); };
  const auto rigid_friction = [](Scene& scene) {
    make_rigid(scene, kRigid, 100 * kRigidTangential);
  };
  const auto more_friction = [](Scene& scene) {
    for (Caster& caster : scene.items[0].model.casters)
      caster.tread.static_friction = caster.tread.kinetic_friction *= 1.01;
  };
  std::vector<Method> result = {
      {"Moreau", "rigid friction", slow,
       [=](const CrossCheck& check) {
         return peers::moreau_path(with_scene(check, rigid_treads), slow);
       }},
      changed("friction of 1e9 N/m", real, rigid_friction),
      changed("mass + 1e-9", rigid, [](Scene& scene) { scene = perturbed(scene, 1); }),
      changed("friction + 1 %", rigid, more_friction),
      {"explicit", "real treads", slowest,
       [=](const CrossCheck& check) { return peers::explicit_path(check, slowest); }}};
  for (const Engine& engine : all)
    if (!engine.chooses_steps)
      result.push_back({engine.name, engine.setup, step,
                        [=](const CrossCheck& check) { return engine.run(check, step); }});
  return result;
}

/// A row for each method: peak displacement and yaw of each run.
void print_case(const std::string& name, const std::vector<CrossCheck>& runs,
                const std::vector<unsigned>& seeds, bool quick, std::ofstream& out) {
  fmt::print("\n{}: peak displacement [mm] and yaw [deg] of each motion\n", name);
  for (const Method& method : methods(quick)) {
    fmt::print("{:>8} {:>26} {:>8}", method.engine, method.setup,
               fmt::format("{:g} ms", 1e3 * method.step));
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const Path path = method.run(runs[r]);
      const Peaks peaks = peaks_of(path, runs[r], 0);
      double yaw = 0;
      for (const peers::Snapshot& at : path) yaw = std::max(yaw, std::abs(at.place.z()));
      const double mm = 1e3 * peaks[0], degrees = yaw / kRadiansPerDegree,
                   tilt = peaks[1] / kRadiansPerDegree;
      fmt::print(" {:>9.2f} {:>6.2f}", mm, degrees);
      out << fmt::format("{},{},{},\"{}\",{:g},{:.6g},{:.4g},{:.4g}\n", name, seeds[r],
                         method.engine, method.setup, 1e3 * method.step, mm, degrees, tilt);
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
}

}  // namespace

void print_sliding(bool quick, const std::string& file) {
  const Job cart = half_locked_job(quick ? 1 : 3);
  std::vector<CrossCheck> ahead;
  for (const CrossCheck& run : cart.runs) ahead.push_back(along_x(run));
  std::ofstream out(file);
  out << "case,motion,engine,setup,time_step_ms,peak_displacement_mm,peak_yaw_deg,peak_tilt_deg\n";
  print_case(cart.name + " along x", ahead, cart.seeds, quick, out);
  print_case(cart.name, cart.runs, cart.seeds, quick, out);
}

}  // namespace gurney::benchmark
