#include "studies/plan/study_job.h"
#include "tests/fuzz/feed.h"

/// Jobs of single runs and of studies, in TOML, or in JSON where the text begins as such.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gurney;
  static const fuzz::InputFile toml("job.toml"), json("job.json");
  const std::string text = fuzz::text_of(data, size);
  const std::string& path = (text.starts_with('{') ? json : toml).with(text);
  fuzz::feed([&] {
    if (study::has_study(path))
      study::StudyJob{path};
    else
      study::read_job(path);
  });
  return 0;
}
