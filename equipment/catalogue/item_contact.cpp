#include "equipment/catalogue/item_contact.h"

#include "equipment/catalogue/contact_constants.h"

namespace gurney::equipment {

Uncertain<ItemContact> read_item_contact(config::Table table) {
  ItemContact fixed;
  fixed.material = table.text("material");
  if (fixed.material.empty()) table.note("material", " = \"\": must be the name of a material");
  Uncertain<ItemContact> contact(fixed);
  contact.set(&ItemContact::constants, read_contact_constants(Quantities(table)));
  return contact;
}

}  // namespace gurney::equipment
