#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "engine/base/parallel.h"
#include "engine/baselines/stock_baseline.h"
#include "equipment/catalogue/data_folder.h"
#include "groundmotions/suites/suite.h"
#include "studies/build_info/build_info.h"
#include "studies/workbench/wasm/files.h"

// What the program has from OpenSSL, OpenMP, Bullet's dynamics and its own build.
namespace gurney {

/// A page writes no results file, and nothing else states checksums.
std::string sha256(std::string_view) { return {}; }

void parallel_for(std::size_t count, int, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

Response baselines::simulate_on_stock_bullet(const Scene&, const FloorMotion&,
                                             const SimulationSettings&, StockBullet) {
  throw Error("settings.solver: the baselines are in the program and not in this page");
}

equipment::DataFolder equipment::find_data_folder() {
  return {workbench::kRoot, DataFolder::Origin::kBesideProgram};
}

/// A page has no folders, and no patterns of files in them.
bool groundmotions::is_glob(const std::filesystem::path&) { return false; }
std::vector<std::filesystem::path> groundmotions::glob(const std::filesystem::path&) { return {}; }

build_info::BuildInfo build_info::build_info() {
  return {GURNEY_VERSION, "", "Clang " __clang_version__, "double", "wasm32"};
}

}  // namespace gurney
