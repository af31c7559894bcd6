#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <functional>

#include "engine/config/document.h"
#include "engine/run/simulate.h"
#include "equipment/catalogue/check_file.h"
#include "groundmotions/buildings/building.h"
#include "groundmotions/buildings/floor_record.h"
#include "groundmotions/formats/format.h"
#include "groundmotions/synthetic/kinds.h"
#include "studies/analysis/overview.h"
#include "studies/calibration/trials/trial_file.h"
#include "studies/exports/export.h"
#include "studies/plan/study_job.h"
#include "studies/prepare/run_job.h"
#include "studies/results/results_file.h"
#include "studies/run/part_folder.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_study.h"
#include "tests/support/temp_folder.h"
#include "tests/system/mutation/mutator.h"

/// Damaged files of every kind give an Error or a result: no signal, no exception of the library,
/// nothing that takes more than kLongest. GURNEY_MUTATIONS: how many of each kind.
namespace gurney::study {
namespace {

namespace fs = std::filesystem;

constexpr double kLongest = 10;  // [s]

int mutations() {
  const char* const wanted = std::getenv("GURNEY_MUTATIONS");
  return wanted == nullptr ? 40 : std::atoi(wanted);
}

const fs::path kSource = GURNEY_SOURCE_DIR;

constexpr const char* kJob = R"(schema = "gurney-job/1"
title = "two items, a kerb, a cord and a pull"
[[item]]
equipment = "medication_cart"
name = "a"
headings_deg = [0, 30, -40, 90]
position_m = [0.1, -0.1]
yaw_deg = 12
[[item]]
name = "b"
position_m = [-1.2, 0]
equipment = "infusion_pole"
[[item.force]]
point_m = [0, 0, 0.5]
direction = [1, 0, 0]
force_n = [0, 30, 0]
time_s = [0, 0.1, 0.2]
[item.initial]
velocity_m_per_s = [0.1, 0, 0]
[[room.kerb]]
from_m = [-3, -2]
to_m = [-3, 2]
width_m = 0.1
height_m = 0.01
[[room.box]]
name = "wall"
center_m = [2, 0, 1]
size_m = [0.1, 4, 2]
material = "plasterboard"
[[tether]]
item = "a"
kind = "power_cord"
point_m = [0, 0, 0.5]
anchor_m = [-0.5, 0.7, 0.5]
slack_length_m = 1.2
[floor]
covering = "rubber"
slope = 0.01
[excitation.record]
synthetic = { kind = "ricker" }
scale = 0.3
angle_deg = 20
[settings]
duration_s = 0.04
time_step_s = 0.004
[output]
history_step_s = 0.02
)";

std::vector<std::string> files_in(const fs::path& folder, const std::string& ending) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ending) files.push_back(contents_of(entry.path().string()));
  std::ranges::sort(files);
  return files;
}

class Mutation : public testing::Test {
 protected:
  ~Mutation() override { ::alarm(0); }

  /// Reads each seed whole, then damaged.
  void survive(const std::string& name, const std::vector<std::string>& seeds, bool binary,
               const std::function<void(const std::string&)>& read) {
    for (const std::string& seed : seeds)
      EXPECT_EQ(attempt(name, seed, read), "") << seed.substr(0, 300);
    int refused = 0;
    for (int i = 0; i < mutations(); ++i) {
      Mutator mutator(static_cast<unsigned>(i));
      const std::string& seed = seeds[static_cast<std::size_t>(i) % seeds.size()];
      refused += !attempt(name, binary ? mutator.binary(seed) : mutator.text(seed), read).empty();
    }
    RecordProperty("refused", refused);
    if (mutations() > 100) printf("%d of %d refused\n", refused, mutations());
  }

  std::string path(const std::string& name) const { return folder_.file(name); }

 private:
  std::string attempt(const std::string& name, const std::string& bytes,
                      const std::function<void(const std::string&)>& read) {
    std::ofstream(path(name), std::ios::binary) << bytes;
    ::alarm(6 * static_cast<unsigned>(kLongest));  // of a machine that does other things too
    const std::clock_t start = std::clock();
    std::string error;
    try {
      read(path(name));
    } catch (const Error& refusal) {
      error = refusal.what();
    } catch (const std::exception& other) {
      ADD_FAILURE() << "not for a user: " << other.what() << "\n" << kept(name, bytes);
    }
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kLongest)
        << kept(name, bytes);
    return error;
  }

  /// Where the file that failed is left.
  static std::string kept(const std::string& name, const std::string& bytes) {
    const fs::path to = fs::temp_directory_path() / ("mutated_" + name);
    std::ofstream(to, std::ios::binary) << bytes;
    return to.string();
  }

  TempFolder folder_;
};

void take_nothing(const std::string&, std::string_view) {}

void run(const std::string& path) {
  const PreparedRun run = prepare_run(path);
  if (run.facts.settings.duration > 0.1 || run.facts.settings.time_step < 1e-4) return;
  results_image(run.facts, simulate(run.facts.scene, run.facts.floor, run.facts.settings));
}

std::string as_json(const std::string& toml) {
  const config::Document document(toml, "job.toml");
  const std::function<std::string(const config::Node&)> text = [&](const config::Node& node) {
    const bool table = node.kind == config::Node::Kind::kTable;
    if (!table && node.kind != config::Node::Kind::kArray) return describe(node);
    std::string all;
    for (const config::Node& each : node.elements)
      all += (all.empty() ? "" : ", ") + (table ? "\"" + each.key + "\": " : "") + text(each);
    return table ? "{" + all + "}" : "[" + all + "]";
  };
  return text(document.tree());
}

TEST_F(Mutation, Jobs) { survive("job.toml", {kJob}, false, run); }

TEST_F(Mutation, JsonJobs) { survive("job.json", {as_json(kJob)}, false, run); }

TEST_F(Mutation, Studies) {
  std::vector<std::string> seeds = files_in(kSource / "studies" / "jobs", ".toml");
  for (std::string& seed : seeds)
    for (auto at = seed.find("\"../../"); at != seed.npos; at = seed.find("\"../../", at))
      seed.replace(at + 1, 5, kSource.string());
  survive("job.toml", seeds, false, [](const std::string& file) {
    if (has_study(file))
      StudyJob{file};
    else
      read_job(file);
  });
}

TEST_F(Mutation, DataFiles) {
  std::vector<std::string> seeds;
  for (const char* folder : {"items", "casters", "floors", "rooms", "tethers"})
    for (const std::string& each : files_in(kSource / "equipment" / folder, ".toml"))
      seeds.push_back(each);
  survive("data.toml", seeds, false,
          [](const std::string& file) { equipment::check_data_file(file); });
}

TEST_F(Mutation, Buildings) {
  const groundmotions::Record ground =
      groundmotions::make_record(groundmotions::synthetic_request("ricker", {}));
  survive("building.toml", files_in(kSource / "groundmotions" / "buildings", ".toml"), false,
          [&](const std::string& file) {
            groundmotions::building_response(ground, groundmotions::building_from_file(file), 1);
          });
}

TEST_F(Mutation, Trials) {
  survive("trial.csv", files_in(kSource / "studies" / "calibration" / "example", ".csv"), false,
          [](const std::string& file) { calibration::read_trial_file(file); });
}

TEST_F(Mutation, RunResults) {
  survive("run.h5", {results_image(synthetic_facts(), synthetic_response())}, true,
          [](const std::string& file) {
            run_overview(file);
            export_tables(file, take_nothing);
            export_xdmf(file, "run", take_nothing);
          });
}

/// Without its seal, so that more than the seal is tested.
TEST_F(Mutation, StudyResults) {
  SyntheticStudy::write(path("seed.h5"));
  const std::string whole = contents_of(path("seed.h5"));
  survive("study.h5", {whole, whole.substr(0, whole.rfind("\ngurney sha256"))}, true,
          [](const std::string& file) {
            study_overview(file);
            export_tables(file, take_nothing);
          });
}

TEST_F(Mutation, Parts) {
  {
    PartFolder parts(path("seed"), "identity\n", 8, PartFolder::Start::kNew);
    parts.add({{3, "three"}, {0, ""}, {7, std::string(300, 'x')}});
  }
  survive("00000001.part", {contents_of(path("seed") + "/00000001.part")}, true,
          [&](const std::string& file) {
            fs::remove_all(path("parts"));
            fs::create_directory(path("parts"));
            std::ofstream(path("parts") + "/study") << "identity\n";
            fs::copy_file(file, path("parts") + "/00000001.part");
            const PartFolder parts(path("parts"), "identity\n", 8, PartFolder::Start::kResume);
            for (const std::size_t unit : {0, 3, 7})
              if (parts.has(unit)) parts.read(unit);
          });
}

}  // namespace
}  // namespace gurney::study
