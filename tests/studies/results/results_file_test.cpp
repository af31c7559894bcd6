#include "studies/results/results_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <map>
#include <regex>
#include <thread>

#include "engine/base/hash/sha256.h"
#include "studies/results/hdf5_file.h"
#include "tests/studies/fabricated_run.h"
#include "tests/support/temp_folder.h"

namespace gurney {
namespace {

class ResultsFile : public testing::Test {
 protected:
  std::string save(const RunFacts& facts, const Response& response) {
    const std::string path = folder_.file("results.h5");
    std::ofstream(path, std::ios::binary) << results_image(facts, response);
    return path;
  }

  TempFolder folder_;
};

TEST_F(ResultsFile, HoldsTheRun) {
  const Response response = fabricated_response();
  const Hdf5Reader file(save(fabricated_facts(), response));
  EXPECT_EQ(file.text_attribute("filetype"), "gurney-results");
  EXPECT_EQ(file.text_attribute("job_text"), "title = \"A trolley\"\n");
  EXPECT_EQ(file.strings("/runs/outcome"), std::vector<std::string>{"rested"});
  EXPECT_EQ(file.numbers("/runs/residual_yaw"),
            std::vector<double>{response.items[0].demands.residual_yaw});
  EXPECT_EQ(file.numbers("/runs/wheel_liftoffs"), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(file.numbers("/runs/record_pgv"), (std::vector<double>{0.31, 0.22, 0.11}));
  EXPECT_EQ(file.numbers("/verification/subdivided_steps"), std::vector<double>{4});
  EXPECT_EQ(file.strings("/assumptions/key"),
            std::vector<std::string>{"tread.rolling_resistance_m"});
  EXPECT_EQ(file.text_attribute("draw_seed"), "1");
  EXPECT_EQ(file.text_attribute("draw"), "3");
  EXPECT_EQ(file.numbers("/drawn/value"), (std::vector<double>{1.0625, 0.001}));
  EXPECT_EQ(file.strings("/drawn/unit"), (std::vector<std::string>{"mm", "1"}));
}

TEST_F(ResultsFile, HoldsTheHistories) {
  const Response response = fabricated_response();
  const Hdf5Reader file(save(fabricated_facts(), response));
  constexpr std::size_t kSample = 345, kWheel = 2, kWheels = 4;
  const Sample& sample = response.items[0].history[kSample];
  EXPECT_EQ(file.numbers("/histories/count").at(0), response.items[0].history.size());
  EXPECT_EQ(file.numbers("/histories/time").at(kSample), sample.time);
  EXPECT_EQ(file.numbers("/histories/velocity").at(3 * kSample + 1), sample.velocity.y());
  EXPECT_EQ(file.numbers("/histories/normal_force").at(kWheels * kSample + kWheel),
            sample.wheels[kWheel].normal_force);
  EXPECT_EQ(file.numbers("/histories/mode").at(kWheels * kSample + kWheel),
            static_cast<double>(sample.wheels[kWheel].mode));
  EXPECT_EQ(file.numbers("/histories/point_displacement").at(3 * kSample + 2),
            sample.points[0].displacement.z());
  EXPECT_EQ(file.numbers("/histories/loss_tread").at(kSample), sample.energy.tread_loss);
}

TEST_F(ResultsFile, GivesTheSameBytesForTheSameRun) {
  const std::string first = results_image(fabricated_facts(), fabricated_response());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's times count seconds
  EXPECT_EQ(first, results_image(fabricated_facts(), fabricated_response()));
  RunFacts other = fabricated_facts();
  other.job_text += "#";
  EXPECT_NE(first, results_image(other, fabricated_response()));
}

TEST_F(ResultsFile, ManagesWithoutHistoryRecordOrPoints) {
  RunFacts facts = fabricated_facts(true);
  facts.scene.items[0].model.marked_points.clear();
  facts.assumptions.clear();
  Response response = fabricated_response(true);
  response.items[0].history.clear();
  response.items[0].demands.points.clear();
  const Hdf5Reader file(save(facts, response));
  EXPECT_TRUE(file.numbers("/histories/displacement").empty());
  EXPECT_EQ(file.strings("/runs/record"), std::vector<std::string>{""});
}

TEST_F(ResultsFile, HoldsARunThatDiverged) {
  Response response;
  response.cause = "the solve did not converge";
  response.items[0].demands.wheels.resize(4);
  response.items[0].demands.points.resize(1);
  const Hdf5Reader file(save(fabricated_facts(), response));
  EXPECT_EQ(file.strings("/runs/outcome"), std::vector<std::string>{"diverged"});
  EXPECT_EQ(file.strings("/runs/cause"), std::vector<std::string>{"the solve did not converge"});
}

/// The rows `| name | ... |` of a page whose first cell is a name in backquotes.
std::map<std::string, std::vector<std::string>> table_rows(const std::string& path) {
  std::ifstream page(path);
  std::map<std::string, std::vector<std::string>> rows;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    std::vector<std::string> cells;
    std::string cell;
    for (const char c : line.substr(1)) {
      if (c == '|' && !(cell.size() > 0 && cell.back() == '\\')) {
        cells.push_back(std::regex_replace(cell, std::regex("^ +| +$|`"), ""));
        cell.clear();
      } else {
        if (c == '|')
          cell.back() = c;
        else
          cell += c;
      }
    }
    rows[cells.at(0)] = {cells.begin() + 1, cells.end()};
  }
  return rows;
}

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : " x ") + name;
  return result;
}

TEST_F(ResultsFile, IsWhatItsPageSays) {
  RunFacts facts = fabricated_facts();
  facts.seed = 7;
  const Hdf5Reader file(save(facts, fabricated_response()));
  auto rows = table_rows(GURNEY_SOURCE_DIR "/docs/formats/results_file.md");
  std::string should;
  for (const Hdf5Dataset& dataset : file.datasets()) {
    const std::vector<std::string> cells{dataset.type, joined(dataset.scales), dataset.units,
                                         dataset.long_name};
    EXPECT_EQ(rows[dataset.path], cells) << dataset.path;
    if (rows[dataset.path] != cells)
      should += "| `" + dataset.path + "` | " + cells[0] + " | " + cells[1] + " | " + cells[2] +
                " | " + std::regex_replace(cells[3], std::regex("\\|"), "\\|") + " |\n";
    rows.erase(dataset.path);
  }
  for (const std::string& name : file.attributes()) {
    EXPECT_EQ(rows.count(name), 1u) << "attribute " << name << " is not on the page";
    rows.erase(name);
  }
  for (const auto& [name, cells] : rows) ADD_FAILURE() << "the file has no " << name;
  EXPECT_EQ(should, "") << "lines for the page:\n" << should;
}

TEST(Sha256, MatchesThePublishedExample) {
  // FIPS 180-4 example: one block, "abc".
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace gurney
