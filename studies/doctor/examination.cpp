#include "studies/doctor/examination.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>
#include <utility>

#include "embedded/determinism_toml.h"
#include "engine/base/error.h"
#include "engine/base/hash/sha256.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/data_folder.h"
#include "studies/build_info/build_info.h"
#include "studies/build_info/cpu_needs.h"
#include "studies/picture/picture.h"
#include "studies/results/hdf5_version.h"
#include "studies/run/run_batch.h"
#include "studies/run/task_result.h"

namespace gurney::doctor {
namespace {

/// Reads every file of a kind. @return how many there are
std::size_t read_all(equipment::DataKind kind, std::string& errors) {
  const std::vector<std::string> names = equipment::catalogue_names(kind);
  for (const std::string& name : names) try {
      equipment::check_data_file(equipment::find_data(kind, name, ""));
    } catch (const Error& error) {
      errors += (errors.empty() ? "" : "\n") + std::string(error.what());
    }
  return names.size();
}

namespace fs = std::filesystem;

constexpr double kGigabyte = 1e9;
constexpr std::uint64_t kLittle = 1'000'000'000;  // [bytes] below it a study may not fit

/// The text after `key` in a file of lines `key : value`; empty: none.
std::string value_in(const char* file, const std::string& key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(key)) {
      const std::size_t from = line.find_first_not_of(" \t", line.find(':') + 1);
      return from == std::string::npos ? "" : line.substr(from);
    }
  return {};
}

std::string cpu_name() {
  const std::string name = value_in("/proc/cpuinfo", "model name");
  return name.empty() ? "CPU" : name;
}

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

const char* name_of(Finding::State state) {
  switch (state) {
    case Finding::State::kOk:
      return "ok";
    case Finding::State::kWarning:
      return "warning";
    case Finding::State::kProblem:
      break;
  }
  return "problem";
}

Finding ok(std::string name, std::string text) {
  return {Finding::State::kOk, std::move(name), std::move(text), {}};
}

Finding warning(std::string name, std::string text, std::string advice) {
  return {Finding::State::kWarning, std::move(name), std::move(text), std::move(advice)};
}

Finding problem(std::string name, std::string text, std::string advice) {
  return {Finding::State::kProblem, std::move(name), std::move(text), std::move(advice)};
}

std::vector<Finding> examination() {
  return {program(), libraries(), cpu(),     arithmetic(), data(),
          threads(), memory(),    disk("."), figures(),    determinism()};
}

Finding program() {
  const build_info::BuildInfo build = build_info::build_info();
  return ok("program", fmt::format("gurney {}, commit {}, {}", build.program_version,
                                   build.git_commit, build.compiler));
}

Finding libraries() {
  const std::string built = study::hdf5_version_built(), loaded = study::hdf5_version_loaded();
  if (built != loaded)
    return warning("libraries",
                   fmt::format("{}; HDF5 {} is loaded", build_info::libraries(), loaded),
                   "build the program again with the libraries of this machine");
  return ok("libraries", build_info::libraries());
}

Finding data() {
  using equipment::DataKind;
  const equipment::DataFolder folder = equipment::find_data_folder();
  const char* const advice =
      "GURNEY_DATA must name a folder that holds equipment/ as the shipped one does, or not be set";
  std::string errors;
  try {
    const std::size_t items = read_all(DataKind::kItem, errors),
                      casters = read_all(DataKind::kCaster, errors),
                      floors = read_all(DataKind::kFloor, errors),
                      rooms = read_all(DataKind::kRoom, errors);
    if (!errors.empty()) return problem("data", errors, "correct these files, or install again");
    return ok("data",
              fmt::format("{} items, {} casters, {} floor coverings, {} rooms in {} ({})", items,
                          casters, floors, rooms, folder.path, name_of(folder.origin)));
  } catch (const Error& error) {
    return problem("data", error.what(), advice);
  }
}

Finding figures() {
  try {
    picture::png(R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>)", {0.1, 0.1});
    return ok("figures", "SVG, PDF and PNG");
  } catch (const Error& error) {
    return warning("figures", fmt::format("SVG only: {}", error.what()),
                   "for PDF and PNG: apt-get install librsvg2-2");
  }
}

Finding cpu() {
  const std::string built = build_info::build_info().cpu_class;
#if defined(__x86_64__)
  const bool has_avx2 = __builtin_cpu_supports("avx2"), has_fma = __builtin_cpu_supports("fma"),
             has_bmi2 = __builtin_cpu_supports("bmi2"),
             has_avx512 = __builtin_cpu_supports("avx512f");
  const std::string text =
      fmt::format("{}: AVX2 {}, FMA {}, BMI2 {}, AVX-512 {}; the program is built for {}",
                  cpu_name(), has_avx2 ? "yes" : "no", has_fma ? "yes" : "no",
                  has_bmi2 ? "yes" : "no", has_avx512 ? "yes" : "no", built);
  if (has_avx2 && has_fma && has_bmi2 && !build_info::kCpuNeeds.avx2)
    return warning("cpu", text,
                   "the program does not use what this CPU has: build it here with "
                   "`cmake --preset release`; results then differ in the last digits");
  return ok("cpu", text);
#else
  return ok("cpu", fmt::format("{}; the program is built for {}", cpu_name(), built));
#endif
}

Finding threads(unsigned hardware, std::optional<double> quota) {
  if (hardware == 0)
    return warning("threads", "number not known", "state it: gurney run STUDY -j NUMBER");
  const std::string text = fmt::format("{}", hardware);
  if (quota && *quota < hardware)
    return warning(
        "threads", fmt::format("{}, of which the system grants {:g}", text, *quota),
        fmt::format("use as many: gurney run STUDY -j {}", std::max(1, static_cast<int>(*quota))));
  return ok("threads", text);
}

Finding threads() {
  std::ifstream file("/sys/fs/cgroup/cpu.max");
  double granted = 0, period = 0;
  const bool limited = static_cast<bool>(file >> granted >> period) && period > 0;
  return threads(std::thread::hardware_concurrency(),
                 limited ? std::optional(granted / period) : std::nullopt);
}

Finding memory(std::optional<std::uint64_t> available) {
  if (!available) return ok("memory", "not known");
  const std::string text =
      fmt::format("{:.1f} GB available", static_cast<double>(*available) / kGigabyte);
  if (*available < kLittle)
    return warning("memory", text, "gurney check STUDY says how much a study needs");
  return ok("memory", text);
}

Finding memory() {
  std::optional<std::uint64_t> available;
  std::uint64_t kilobytes = 0;
  if (std::istringstream(value_in("/proc/meminfo", "MemAvailable")) >> kilobytes)
    available = kilobytes * 1024;
  std::ifstream most("/sys/fs/cgroup/memory.max"), used("/sys/fs/cgroup/memory.current");
  std::uint64_t limit = 0, current = 0;
  if (most >> limit && used >> current) {
    const std::uint64_t left = limit - std::min(limit, current);
    available = std::min(available.value_or(left), left);
  }
  return memory(available);
}

Finding disk(const fs::path& folder) {
  std::error_code unknown;
  const std::string name = fs::weakly_canonical(folder, unknown).string();
  const fs::space_info space = fs::space(folder, unknown);
  if (unknown)
    return problem("disk", name + ": " + unknown.message(), "go to a folder that exists");
  const std::string text =
      fmt::format("{:.1f} GB free in {}", static_cast<double>(space.available) / kGigabyte, name);
  if (::access(folder.c_str(), W_OK) != 0)
    return warning("disk", text + ", which cannot be written",
                   "go to a folder of yours, or name the results: gurney run JOB -o FILE.h5");
  if (space.available < kLittle)
    return warning("disk", text, "gurney check STUDY says how much a study needs");
  return ok("disk", text);
}

Finding arithmetic() {
  volatile double small = std::numeric_limits<double>::min();
  small = small / 2;
  if (std::fegetround() != FE_TONEAREST || small == 0)
    return problem("arithmetic", "not that of IEEE 754: rounding or small numbers were changed",
                   "start the program without what changes them, such as a library in LD_PRELOAD");
  return ok("arithmetic", fmt::format("double precision (IEEE 754), Bullet {}",
                                      build_info::build_info().bullet_precision));
}

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
