#include <cstdio>
#include <cstdlib>

#include "engine/run/run.h"
#include "equipment/catalogue/catalogue.h"
#include "equipment/catalogue/load_item.h"
#include "groundmotions/assembly/read_record.h"
#include "groundmotions/record/record_motion.h"

int main(int, char** files) {
  using namespace gurney;
  setenv("GURNEY_DATA", GURNEY_DATA_FOLDER, 0);  // the catalogue; a value that is set stays
  const auto item =
      equipment::load_item(find_data(equipment::DataKind::kItem, "icu_ventilator", ""));
  Scene scene = scene_of(item.model);
  scene.pairs = item.pairs;
  const auto record = groundmotions::read_record({{files[1]}});
  for (const double scale : {0.5, 1.0}) {
    const Response response = run(scene, groundmotions::floor_motion(record, scale), {});
    std::printf("%g %.17g\n", scale, response.items[0].demands.peak_displacement);
  }
}
