#include "equipment/catalogue/item_contact.h"

#include "equipment/catalogue/contact_constants.h"

namespace gurney::equipment {

ItemContact read_item_contact(config::Table table) {
  ItemContact contact;
  contact.material = table.text("material");
  if (contact.material.empty()) table.note("material", " = \"\": must be the name of a material");
  contact.constants = read_contact_constants(Quantities(table, contact.assumptions));
  return contact;
}

}  // namespace gurney::equipment
