#include "studies/doctor/determinism.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "embedded/determinism_toml.h"
#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "studies/run/run_batch.h"
#include "studies/run/task_result.h"

namespace gurney::doctor {
namespace {

namespace fs = std::filesystem;

/// A folder in that for temporary files, gone at the end.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "gurney_doctor_XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr, name + ": cannot be made");
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// SHA-256 of the results of all runs.
std::string digest(const study::Batch& batch, const fs::path& folder, int threads) {
  study::PartFolder parts(folder, "", batch.plan.tasks(), study::PartFolder::Start::kNew);
  const study::CrashLog crashes(folder / "crashes");
  study::run_batch(
      batch, parts, crashes, {}, threads, [] { return true; }, [](const study::BatchProgress&) {});
  std::string all;
  for (std::size_t task = 0; task < batch.plan.tasks(); ++task) {
    study::TaskResult result = study::task_from_bytes(parts.read(task));
    result.cost = {};
    all += study::to_bytes(result);
  }
  return sha256(all);
}

}  // namespace

Finding same_bits(const std::string& with_one, const std::string& with_several, int threads,
                  std::size_t runs) {
  if (with_one != with_several)
    return problem(
        "determinism",
        fmt::format("{} runs with 1 and with {} threads give different results", runs, threads),
        "do not trust results of this machine: test its memory, and report it with the "
        "output of this command");
  return ok("determinism", fmt::format("{} runs with 1 and with {} threads give the same bits, {}",
                                       runs, threads, with_one.substr(0, 12)));
}

Finding determinism() {
  const int threads = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
  try {
    const Scratch scratch;
    const study::StudyJob job(std::string(embedded::determinism_toml),
                              (scratch.path() / "determinism.toml").string());
    const study::StudyMotions motions(job);
    const study::Plan plan(job, motions);
    const study::Batch batch{job, motions, plan};
    motions.read_all(threads);
    return same_bits(digest(batch, scratch.path() / "one", 1),
                     digest(batch, scratch.path() / "several", threads), threads, plan.runs());
  } catch (const std::exception& error) {
    return problem("determinism", error.what(), "see the lines above");
  }
}

}  // namespace gurney::doctor
