#include "equipment/catalogue/item_file.h"

#include <algorithm>
#include <optional>

#include "engine/config/nearest_name.h"
#include "engine/config/overlay.h"
#include "engine/config/table.h"

namespace gurney::equipment {
namespace {

using config::Document;
using config::Node;

/// Mistakes of several readings of one file, each line once.
class Mistakes {
 public:
  void add(const std::string& text, const std::string& remark) {
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = text.substr(begin, end - begin);
      if (std::find(plain_.begin(), plain_.end(), line) == plain_.end()) {
        plain_.push_back(line);
        text_ += (text_.empty() ? "" : "\n") + line + remark;
      }
      begin = end + 1;
    }
  }

  void finish() const { require(text_.empty(), text_); }

 private:
  std::vector<std::string> plain_;
  std::string text_;
};

ItemDescription read(Document& document, const std::string& remark, Mistakes& mistakes) {
  document.root().choice("schema", {"gurney-item/1"});
  ItemDescription item = read_item(document.root());
  try {
    document.finish();
  } catch (const Error& error) {
    mistakes.add(error.what(), remark);
  }
  return item;
}

/// The item with these variants over it, in their order.
ItemDescription read_changed(const Node& tree, const Document& origin,
                             const std::vector<const Node*>& variants, Mistakes& mistakes) {
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
    mistakes.add(error.what(), "");
  }
  Document document(std::move(changed), origin);
  return read(document, remark, mistakes);
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

ItemDescription load_item_description(const std::string& file, const ItemSelection& selection) {
  Document document(file);
  document.set_draw(selection.draw);
  const std::vector<Node> variants = take_variants(document);
  const std::string unknown = unknown_variant(selection.variants, names_of(variants));
  require(unknown.empty(), file + ": " + unknown);

  const Node tree = document.tree();
  Mistakes mistakes;
  ItemDescription item = read(document, "", mistakes);
  for (const Node& variant : variants) read_changed(tree, document, {&variant}, mistakes);
  std::vector<const Node*> selected;
  for (const std::string& name : selection.variants)
    for (const Node& variant : variants)
      if (variant.key == name) selected.push_back(&variant);
  if (!selected.empty()) item = read_changed(tree, document, selected, mistakes);
  mistakes.finish();
  item.variants = names_of(variants);
  return item;
}

}  // namespace gurney::equipment
