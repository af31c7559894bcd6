#include <execinfo.h>
#include <unistd.h>

#include <cstring>

#include "studies/build_info/cpu_needs.h"
#include "studies/cli/command_line.h"

// This file is compiled for the baseline CPU and uses no inline function of the C++ library, so
// that it runs where the rest of the program cannot.
namespace {

#if defined(__x86_64__)
/// Says so and exits with 1 where a CPU lacks what the program was compiled to use; else the first
/// such instruction would kill it without a word. Runs before every other static initialiser.
__attribute__((constructor(101))) void check_cpu() {
  __builtin_cpu_init();
  const gurney::build_info::CpuNeeds& needs = gurney::build_info::kCpuNeeds;
  const char* missing = nullptr;
  if (needs.bmi && !__builtin_cpu_supports("bmi")) missing = "BMI";
  if (needs.bmi2 && !__builtin_cpu_supports("bmi2")) missing = "BMI2";
  if (needs.avx && !__builtin_cpu_supports("avx")) missing = "AVX";
  if (needs.avx2 && !__builtin_cpu_supports("avx2")) missing = "AVX2";
  if (needs.fma && !__builtin_cpu_supports("fma")) missing = "FMA";
  if (needs.avx512f && !__builtin_cpu_supports("avx512f")) missing = "AVX-512";
  if (!missing) return;
  const char* const parts[] = {
      "gurney: this program was built for the CPU class ", GURNEY_CPU_CLASS,
      ", but this CPU has no ", missing,
      ". Build it here, or anywhere with `cmake --preset release -DGURNEY_CPU=generic`.\n"};
  for (const char* part : parts)
    if (write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
  _exit(1);
}
#endif

}  // namespace

int main(int argc, char** argv) {
  // The C library loads the unwinder of the stack when a thread needs it first, and aborts where it has
  // no memory for that then. This loads it now.
  void* frame = nullptr;
  backtrace(&frame, 1);
  return gurney::cli::run_command_line(argc, argv);
}
