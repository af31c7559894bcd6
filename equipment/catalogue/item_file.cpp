#include "equipment/catalogue/item_file.h"

#include <algorithm>
#include <optional>

#include "engine/base/diagnostics.h"
#include "engine/config/nearest_name.h"
#include "engine/config/overlay.h"
#include "engine/config/table.h"

namespace gurney::equipment {
namespace {

using config::Document;
using config::Node;

Uncertain<ItemDescription> read(Document& document, const std::string& remark,
                                Diagnostics& errors) {
  document.root().choice("schema", {"gurney-item/1"});
  Uncertain<ItemDescription> item = read_item(document.root());
  try {
    document.finish();
  } catch (const Error& error) {
    errors.add_new(error.what(), remark);
  }
  return item;
}

/// The item with these variants over it, in their order.
Uncertain<ItemDescription> read_changed(const Node& tree, const Document& origin,
                                        const std::vector<const Node*>& variants,
                                        Diagnostics& errors) {
  Node changed = tree;
  Document notes(Node(), origin);
  std::string names;
  for (const Node* variant : variants) {
    config::overlay(changed, *variant, "variant." + variant->key, notes);
    names += (names.empty() ? "'" : ", '") + variant->key + "'";
  }
  const std::string remark = " (variant " + names + ")";
  try {
    notes.finish();
  } catch (const Error& error) {
    errors.add_new(error.what());
  }
  Document document(std::move(changed), origin);
  return read(document, remark, errors);
}

/// Takes the tables [variant.NAME] from a document and leaves those that are tables.
std::vector<Node> take_variants(Document& document) {
  const std::optional<Node> taken = document.take("variant");
  if (!taken) return {};
  if (taken->kind != Node::Kind::kTable) {
    document.note(taken->place,
                  "variant = " + describe(*taken) + ": must be tables [variant.NAME]");
    return {};
  }
  std::vector<Node> variants;
  for (const Node& each : taken->elements)
    if (each.kind == Node::Kind::kTable)
      variants.push_back(each);
    else
      document.note(each.place, "variant." + each.key + " = " + describe(each) +
                                    ": must be a table [variant." + each.key + "]");
  return variants;
}

std::vector<std::string> names_of(const std::vector<Node>& variants) {
  std::vector<std::string> names;
  for (const Node& variant : variants) names.push_back(variant.key);
  return names;
}

}  // namespace

std::vector<std::string> variant_names(const std::string& item_file) {
  Document document(item_file);
  return names_of(take_variants(document));
}

std::string unknown_variant(const std::vector<std::string>& wanted,
                            const std::vector<std::string>& known) {
  for (const std::string& name : wanted)
    if (std::find(known.begin(), known.end(), name) == known.end())
      return "the item has no variant '" + name + "'" + config::suggestion(name, known);
  return "";
}

Uncertain<ItemDescription> load_item_description(const std::string& file,
                                                 const std::vector<std::string>& variants) {
  Document document(file);
  const std::vector<Node> known = take_variants(document);
  const std::string unknown = unknown_variant(variants, names_of(known));
  require(unknown.empty(), file + ": " + unknown);

  const Node tree = document.tree();
  Diagnostics errors;  // of several readings of one file, each line once
  Uncertain<ItemDescription> item = read(document, "", errors);
  for (const Node& variant : known) read_changed(tree, document, {&variant}, errors);
  std::vector<const Node*> selected;
  for (const std::string& name : variants)
    for (const Node& variant : known)
      if (variant.key == name) selected.push_back(&variant);
  if (!selected.empty()) item = read_changed(tree, document, selected, errors);
  errors.raise();
  item.add(
      [names = names_of(known)](ItemDescription& of_draw, Sampler&) { of_draw.variants = names; });
  return item;
}

}  // namespace gurney::equipment
