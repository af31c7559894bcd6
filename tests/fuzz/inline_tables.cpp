#include <functional>

#include "engine/config/document.h"
#include "engine/config/table.h"
#include "groundmotions/processing/pipeline.h"
#include "groundmotions/scaling/target_spectrum.h"
#include "groundmotions/synthetic/kinds.h"
#include "studies/cli/inline_table.h"
#include "studies/job/scale_reader.h"
#include "tests/fuzz/feed.h"

namespace {

using namespace gurney;
using Read = std::function<void(config::Table& root)>;

void read_option(const std::string& key, const std::string& table, const Read& read) {
  fuzz::feed([&] {
    config::Document document(key + " = " + table + "\n", "--option");
    config::Table root = document.root();
    read(root);
    document.finish();
  });
}

void read_synthetic(const std::vector<std::string>& words) {
  fuzz::feed([&] {
    groundmotions::synthetic_request(words.at(0), {words.begin() + 1, words.end()});
  });
}

}  // namespace

/// Words of the command line: --step, --target, --scale-to, `records make`.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> words = cli::words_of(fuzz::text_of(data, size));
  if (words.empty()) return 0;
  fuzz::feed([&] {
    read_option("processing", "[" + cli::inline_table("step", words) + "]",
                [](config::Table& root) { groundmotions::read_processing_steps(root); });
    read_option("spectrum", cli::inline_table("target", words), [](config::Table& root) {
      if (auto table = root.table("spectrum")) groundmotions::read_target(*table);
    });
    read_option("scale_to", cli::inline_table("measure", words), [](config::Table& root) {
      if (auto table = root.table("scale_to")) study::read_scale_to(*table);
    });
  });
  read_synthetic(words);
  return 0;
}
