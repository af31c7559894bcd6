#include "engine/config/json_reader.h"
#include "engine/config/toml_reader.h"
#include "tests/fuzz/feed.h"

/// TOML and JSON of any content.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gurney;
  const std::string text = fuzz::text_of(data, size);
  fuzz::feed([&] { config::describe(config::read_toml(text, "file.toml")); });
  fuzz::feed([&] { config::describe(config::read_json(text, "file.json").root); });
  return 0;
}
