#include "equipment/catalogue/catalogue.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/config/document.h"
#include "engine/config/table.h"
#include "equipment/catalogue/load_item.h"
#include "tests/support/catalogue_list.h"
#include "tests/support/error_text.h"
#include "tests/support/key_table.h"
#include "tests/support/temp_folder.h"

namespace gurney::equipment {
namespace {

using config::Node;

/// Every shipped file of every kind.
std::vector<std::string> shipped_files() {
  std::vector<std::string> files;
  for (const DataKind kind :
       {DataKind::kItem, DataKind::kCaster, DataKind::kFloor, DataKind::kRoom, DataKind::kTether})
    for (const std::string& name : catalogue_names(kind))
      files.push_back(find_data(kind, name, ""));
  for (const char* file : {"contacts", "levelness"})
    files.push_back(data_folder() + "/equipment/" + file + ".toml");
  return files;
}

bool has_text(const Node& table, const char* key) {
  const Node* node = table.find(key);
  return node != nullptr && node->kind == Node::Kind::kText && !node->text.empty();
}

/// Places of numbers that stand outside a quantity with a source or an assumption. How many of a
/// payload an item carries is a choice, as a brake that is on, and no measurement.
void find_bare_numbers(const Node& node, const config::Document& document, std::string& found) {
  if (has_text(node, "source") || has_text(node, "assumption") || node.key == "count" ||
      node.key == "axis")
    return;
  if (node.is_number()) found += document.where(node.place) + "\n";
  for (const Node& element : node.elements) find_bare_numbers(element, document, found);
}

TEST(Catalogue, EveryNumberHasASourceOrAnAssumption) {
  ASSERT_GE(shipped_files().size(), 7u);
  std::string bare;
  for (const std::string& file : shipped_files()) {
    const config::Document document(file);
    find_bare_numbers(document.tree(), document, bare);
  }
  EXPECT_EQ(bare, "");
  // The search itself finds what it should.
  const config::Document document("a = 1\nb = { value = 1, source = 's' }\nc = [[2]]", "x");
  std::string found;
  find_bare_numbers(document.tree(), document, found);
  EXPECT_EQ(found, "x:1:5\nx:3:7\n");
}

TEST(Catalogue, EveryFileLoads) {
  for (const std::string& name : catalogue_names(DataKind::kItem)) {
    const LoadedItem item = load_item(find_data(DataKind::kItem, name, ""));
    EXPECT_EQ(item.warnings, std::vector<std::string>{}) << name;
    EXPECT_FALSE(item.assumptions.empty()) << name;
  }
  for (const std::string& name : catalogue_names(DataKind::kCaster))
    EXPECT_EQ(load_caster_type(find_data(DataKind::kCaster, name, "")).stated().name, name);
  for (const std::string& name : catalogue_names(DataKind::kFloor))
    EXPECT_GT(load_floor_covering(find_data(DataKind::kFloor, name, ""))
                  .stated()
                  .rolling_resistance_factor,
              0);
}

TEST(Catalogue, NamesTheNearestOrTheList) {
  EXPECT_EQ(error_text([] { find_data(DataKind::kCaster, "R10", "job.toml"); }),
            "unknown caster; did you mean 'R100'?");
  EXPECT_EQ(
      error_text([] { find_data(DataKind::kItem, "spaceship", "job.toml"); }),
      "unknown item of equipment (the catalogue has " + catalogue_list(DataKind::kItem) + ")");
  EXPECT_EQ(catalogue_list(DataKind::kCaster).substr(0, 16), "P100, R100, R125");
}

TEST(Catalogue, FindsFilesBesideTheOneThatNamesThem) {
  const TempFolder folder;
  const std::string cart = folder.write("items/cart.toml", "");
  EXPECT_EQ(find_data(DataKind::kItem, "items/cart.toml", folder.path() + "/job.toml"), cart);
  EXPECT_EQ(find_data(DataKind::kItem, "cart.toml", folder.path() + "/items/other.toml"), cart);
  EXPECT_EQ(error_text([&] { find_data(DataKind::kItem, "cart.toml", folder.path() + "/j.toml"); }),
            "no such file: " + folder.path() + "/cart.toml");
}

TEST(Catalogue, FollowsTheEnvironment) {
  const TempFolder folder;
  const std::string mine = folder.write("equipment/casters/mine.toml", "");
  setenv("GURNEY_DATA", folder.path().c_str(), 1);
  EXPECT_EQ(find_data(DataKind::kCaster, "mine", ""), mine);
  const std::string missing = error_text([] { catalogue_names(DataKind::kItem); });
  unsetenv("GURNEY_DATA");
  EXPECT_EQ(missing, folder.path() +
                         "/equipment/items: the catalogue is not there; the environment variable "
                         "GURNEY_DATA names the folder that holds equipment/");
}

/// What `read` asks for, and what the page documents, must be the same.
template <typename Read>
void compare_with_page(const std::string& section, const std::string& text, Read read) {
  config::Document document(text, "a.toml");
  read(document.root());
  std::set<std::string> asked = without_provenance(document.asked_keys());
  asked.insert("schema");
  std::erase_if(asked,
                [](const std::string& key) { return key.rfind("caster[].inline.", 0) == 0; });
  EXPECT_EQ(asked, documented_keys(GURNEY_SOURCE_DIR "/docs/formats/equipment_file.md", section));
}

TEST(EquipmentPage, HasEveryKeyTheReadersKnowAndNoOther) {
  compare_with_page(
      "Item file",
      "[chassis]\n[contact]\n[[shape]]\n[[shape]]\nkind = \"cylinder\"\n[[shape]]\nkind = "
      "\"hull\"\n[[shape]]\nkind = \"mesh\"\n[[caster]]\n[[payload]]\n[[marked_point]]\n",
      [](config::Table table) { read_item(table); });
  compare_with_page("Caster file", "[tread]\n[axle]\n[swivel]\n",
                    [](config::Table table) { read_caster_type(table); });
  compare_with_page("Floor file", "", [](config::Table table) { read_floor(table); });
}

}  // namespace
}  // namespace gurney::equipment
