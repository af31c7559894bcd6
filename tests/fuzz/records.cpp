#include <array>

#include "groundmotions/assembly/plausibility.h"
#include "groundmotions/assembly/read_record.h"
#include "tests/fuzz/feed.h"

/// A record file of any format, with and without what the file might not say.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gurney;
  static const fuzz::InputFile file("record.txt");
  static const std::array<groundmotions::ReadOptions, 3> kOptions{
      groundmotions::ReadOptions{}, groundmotions::ReadOptions{.unit = "g"},
      groundmotions::ReadOptions{.unit = "cm/s2", .time_step = 0.01}};
  fuzz::feed([&] {
    implausible(groundmotions::read_record({{file.with(fuzz::text_of(data, size))}},
                                           kOptions[size % kOptions.size()]));
  });
  return 0;
}
