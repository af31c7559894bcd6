#include "studies/doctor/machine.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

#include "studies/build_info/build_info.h"
#include "studies/build_info/cpu_needs.h"

namespace gurney::doctor {
namespace {

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

}  // namespace

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

}  // namespace gurney::doctor
