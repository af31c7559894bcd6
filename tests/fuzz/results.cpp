#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#include <signal.h>
#include <sys/resource.h>

#include "studies/analysis/overview.h"
#include "studies/results/study_reader.h"
#include "tests/fuzz/feed.h"

/// The sanitizers need more address space than a reader may take.
extern "C" int setrlimit(__rlimit_resource_t, const rlimit*) noexcept { return 0; }

namespace {

using namespace gurney;

/// A crash of libhdf5 in the child that reads a file first (hdf5_probe.cpp) is what the child is
/// for, and no finding.
void be_probe() {
  __sanitizer_set_death_callback(nullptr);
  for (const int each : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) signal(each, SIG_DFL);
}

void read_all(const study::StudyReader& file) {
  for (const char* table : {"runs", "items", "wheels", "points", "impacts", "drawn", "motions"}) {
    if (!file.has(table)) continue;
    for (const std::string& column : file.columns_of(table)) {
      const std::string path = std::string(table) + "/" + column;
      fuzz::feed([&] { file.numbers(path); });
      fuzz::feed([&] { file.strings(path); });
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  return pthread_atfork(nullptr, nullptr, be_probe);
}

/// Results of studies and of single runs.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("results.h5");
  const std::string& path = file.with(fuzz::text_of(data, size));
  fuzz::feed([&] {
    if (!study::is_study_file(path)) {
      study::run_overview(path);
      return;
    }
    read_all(study::StudyReader(path));
    study::study_overview(path);
  });
  return 0;
}
