#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "studies/results/results_file.h"
#include "studies/run/task_result.h"
#include "tests/groundmotions/formats/format_samples.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temp_folder.h"

/// Writes the inputs that fuzzing starts from: a folder for each reader, of files of this project.
/// usage: write_seeds FOLDER
namespace gurney {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = GURNEY_SOURCE_DIR;

class Seeds {
 public:
  explicit Seeds(fs::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& reader, const std::string& bytes) {
    fs::create_directories(folder_ / reader);
    std::ofstream(folder_ / reader / fmt::format("{:03}", ++count_), std::ios::binary) << bytes;
  }

  /// The beginnings of files: short inputs are read often.
  void add_files(const std::string& reader, const fs::path& folder, const std::string& ending) {
    for (const auto& entry : fs::directory_iterator(kSource / folder))
      if (entry.path().extension() == ending) add(reader, begin_of(entry.path().string()));
  }

 private:
  static std::string begin_of(const std::string& path) {
    constexpr std::size_t kLongest = 2500;
    const std::string whole = contents_of(path);
    return whole.substr(0, whole.size() <= kLongest ? whole.npos : whole.rfind('\n', kLongest) + 1);
  }

  fs::path folder_;
  int count_ = 0;
};

void write_texts(Seeds& seeds) {
  for (const auto& sample : groundmotions::format_samples()) seeds.add("records", sample.bytes);
  for (const char* folder : {"items", "casters", "floors", "rooms", "tethers"})
    seeds.add_files("equipment", fs::path("equipment") / folder, ".toml");
  seeds.add_files("buildings", "groundmotions/buildings", ".toml");
  seeds.add_files("jobs", "studies/jobs", ".toml");
  constexpr const char* kJson =
      R"({"schema": "gurney-job/1", "item": {"equipment": "xu_trolley", "yaw_deg": 30},
 "excitation": {"record": {"synthetic": {"kind": "ricker"}}}, "study": {"draws": 2}})";
  seeds.add("jobs", kJson);
  seeds.add("config", kJson);
  seeds.add_files("trials", "studies/calibration/example", ".csv");
  seeds.add_files("config", "studies/jobs", ".toml");
  seeds.add("suites", "name, h1, h2, unit, time_step_s, scale\na, a.txt, b.txt, m/s2, 0.01, 1.5\n");
  seeds.add("suites", "name, file, channels\nfirst, a.smc; b.smc, 1 2\n");
  seeds.add("suites",
            "-- Summary of Metadata of Selected Records --\n Result ID, Record Sequence Number, "
            "Earthquake Name, Horizontal-1 Acc. Filename, Horizontal-2 Acc. Filename, Vertical "
            "Acc. Filename\n1, 1063, Northridge-01, RSN1063_A.AT2, RSN1063_B.AT2, -----\n");
}

void write_lines(Seeds& seeds) {
  for (const char* line :
       {"high_pass corner_hz=0.1 order=4", "taper start_s=1 end_s=1", "rotate azimuth_deg=30",
        "resample time_step_s=0.01", "baseline order=2", "asce7 sds_g=1.0 sd1_g=0.6 tl_s=8",
        "eurocode8 type=1 ground=C ag_g=0.3", "nzs1170 site_class=C hazard_factor=0.4",
        "ac156 sds_g=1 height_ratio=0.5 vertical=true", "Sa(1.0) component=RotD50 value=0.4 unit=g",
        "ricker period_s=0.5", "clough_penzien seed=3 duration_s=20", "table file=a.csv"})
    seeds.add("inline_tables", line);
  for (const char* line :
       {"job.toml:12:3: item.mass_kg = -1: must be above 0\nlist.csv:7: no file",
        "job.json:/item/mass_kg: item.mass_kg: must be a number", "out/a.h5: no such file",
        "--time x: must be a time", "a:99999999999:1: b"})
    seeds.add("messages", line);
  for (const char* line :
       {"moved = peak_displacement > 0.2 m", "overturned", "doorway: least_free_width < 90 cm",
        "bed/screen: peak_absolute_acceleration > 1 g", "at least 2 items: peak_tilt > 5 deg"})
    seeds.add("assessments", line);
  seeds.add("assessments",
            "schema = \"gurney-limit-states/1\"\nperformance = [\"moved\"]\n[[limit_state]]\n"
            "name = \"moved\"\ndemand = \"peak_displacement\"\nabove = 0.1\nunit = \"m\"\n");
  seeds.add("assessments",
            "schema = \"gurney-hazard/1\"\nmeasure = \"PGA\"\ncomponent = \"geomean\"\nunit = "
            "\"g\"\nim = [0.1, 0.3, 1]\nrate_per_year = [0.01, 0.001, 0.0001]\n");
}

void write_study(const std::string& path) {
  study::SyntheticRuns made;
  made.job = study::synthetic_job("", study::kBrakes);
  made.configurations = {"false", "true"};
  made.records = {"a", "b"};
  for (std::size_t i = 0; i < 8; ++i)
    made.runs.push_back({.configuration = i / 4, .record = i / 2 % 2, .level = 1.0 + i % 2});
  made.write(path);
}

void write_results(Seeds& seeds, const fs::path& folder) {
  const std::string study = (folder / "study.h5").string();
  write_study(study);
  const std::string whole = contents_of(study);
  fs::remove(study);
  // The seal goes, so that more than the seal is tested.
  seeds.add("results", whole.substr(0, whole.rfind("\ngurney sha256")));
  Response response = synthetic_response();
  for (ItemResponse& item : response.items) item.history.resize(3);
  seeds.add("results", study::results_image(synthetic_facts(), response));
  study::TaskResult task{
      .task = 3, .drawn = {1, 2}, .runs = {{.response = response}}, .cost = {"a", 0.5, 1, 2}};
  seeds.add("parts", study::to_bytes(task));
  seeds.add("parts", "job = 1\nanalysis_cases = 8\n\nschema = \"gurney-job/1\"\ntitle = \"a\"\n");
}

}  // namespace
}  // namespace gurney

int main(int count, char** words) {
  if (count != 2) return 2;
  std::filesystem::create_directories(words[1]);
  gurney::Seeds seeds(words[1]);
  gurney::write_texts(seeds);
  gurney::write_lines(seeds);
  gurney::write_results(seeds, words[1]);
}
