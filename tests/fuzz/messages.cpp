#include <nlohmann/json.hpp>

#include "studies/cli/json_errors.h"
#include "studies/render/render.h"
#include "tests/fuzz/feed.h"

/// Messages of the readers, which quote their inputs, on their way into JSON.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = gurney::fuzz::text_of(data, size);
  gurney::findings::Section errors;
  gurney::cli::add_errors(errors, text);
  const auto read = nlohmann::json::parse(gurney::render::json(errors));
  if (read.contains("errors") == text.empty()) std::abort();
  return 0;
}
