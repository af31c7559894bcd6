#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "engine/base/error.h"
#include "studies/run/run_batch.h"
#include "studies/run/study_identity.h"
#include "tests/studies/small_study.h"

/// A small study with several threads, for ThreadSanitizer: `./dev check tsan`.
/// usage: threads FOLDER
namespace gurney::study {
namespace {

constexpr const char* kStudy = R"(angles_deg = [0, 90]
draws = 4
step_check = 0.5
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.3]
[[study.factor]]
name = "brakes"
key = "item.brakes"
values = [false, true]
[item.yaw_deg]
value = 0
distribution = { kind = "uniform", low = 0, high = 360, assumption = "any" }
)";

std::size_t run(const std::filesystem::path& folder, int threads) {
  const SmallStudy study(small_job(kStudy));
  study.motions.read_all(threads);
  PartFolder parts(folder, identity_of(study.batch), study.plan.tasks(), PartFolder::Start::kNew);
  const CrashLog crashes(folder / "crashes");
  const BatchProgress progress = run_batch(
      study.batch, parts, crashes, {}, threads, [] { return true; }, [](const BatchProgress&) {});
  parts.remove();
  return progress.runs;
}

}  // namespace
}  // namespace gurney::study

int main(int count, char** words) {
  if (count != 2) return 2;
  try {
    std::printf("%zu runs with 4 threads\n", gurney::study::run(words[1], 4));
  } catch (const gurney::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
