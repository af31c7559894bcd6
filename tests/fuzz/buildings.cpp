#include "groundmotions/buildings/building.h"
#include "tests/fuzz/feed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gurney;
  static const fuzz::InputFile file("building.toml");
  fuzz::feed([&] { groundmotions::building_from_file(file.with(fuzz::text_of(data, size))); });
  return 0;
}
