#pragma once

#include "equipment/catalogue/load_item.h"

namespace gurney::equipment {

/// The item with its parts and contents where they come to rest on a level floor, its chassis as it was. A box
/// that turns becomes the hull of its corners. One that does not come to rest stays at q = 0, with a warning.
LoadedItem at_rest(LoadedItem item);

}  // namespace gurney::equipment
