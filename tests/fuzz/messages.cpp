#include "studies/cli/json_errors.h"
#include "tests/fuzz/feed.h"

/// Messages of the readers, which quote their inputs, on their way into JSON.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = gurney::fuzz::text_of(data, size);
  const nlohmann::ordered_json errors = gurney::cli::json_errors(text);
  if (errors.dump().empty() || (errors.empty() && !text.empty())) std::abort();
  return 0;
}
