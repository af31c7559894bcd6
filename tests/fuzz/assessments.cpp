#include "groundmotions/hazard/disaggregation.h"
#include "groundmotions/hazard/hazard_curve_file.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/plan/assessment_files.h"
#include "tests/fuzz/feed.h"

/// Limit states, performance levels and hazards of finished studies, as files and as lines; hazards and
/// disaggregations of other programs.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gurney;
  static const fuzz::InputFile file("assessment.toml"), answer("answer.json"), table("table.csv");
  static const study::Places kPlaces{{"bed", "pole"}, {"doorway"}, {"cord"}, {{"bed", "screen"}}};
  const std::string text = fuzz::text_of(data, size);
  const std::string& path = file.with(text);
  fuzz::feed([&] { study::read_limit_states_file(path, {}); });
  fuzz::feed([&] { study::read_hazard_file(path); });
  fuzz::feed([&] { groundmotions::read_usgs_hazard(answer.with(text), ""); });
  fuzz::feed([&] { groundmotions::read_openquake_hazard(table.with(text), {}); });
  fuzz::feed([&] { groundmotions::read_disaggregation(answer.with(text), {}); });
  fuzz::feed([&] { groundmotions::read_disaggregation(table.with(text), {}); });
  fuzz::feed([&] { study::read_limit_state_expression(text, kPlaces); });
  return 0;
}
