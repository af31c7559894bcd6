#include "studies/calibration/trials/trial_file.h"
#include "tests/fuzz/feed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gurney;
  static const fuzz::InputFile file("trial.csv");
  fuzz::feed([&] { calibration::read_trial_file(file.with(fuzz::text_of(data, size))); });
  return 0;
}
