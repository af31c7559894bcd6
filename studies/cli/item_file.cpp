#include "studies/cli/item_file.h"

#include "engine/base/error.h"
#include "equipment/catalogue/catalogue.h"

namespace gurney::cli {

std::string item_file(const std::string& name) {
  try {
    return equipment::find_data(equipment::DataKind::kItem, name, "");
  } catch (const Error& error) {
    throw Error(name + ": " + error.what());
  }
}

}  // namespace gurney::cli
