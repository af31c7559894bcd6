#include "equipment/catalogue/check_file.h"
#include "tests/fuzz/feed.h"

/// Items, casters, floor coverings, rooms and tethers.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gurney;
  static const fuzz::InputFile file("data.toml");
  fuzz::feed([&] { equipment::check_data_file(file.with(fuzz::text_of(data, size))); });
  return 0;
}
