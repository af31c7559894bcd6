#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/groundmotions/formats/checked_read.h"
#include "tests/groundmotions/formats/format_samples.h"

/// Damaged files of every format give an Error that names the file, or finite samples in a short
/// time; what was cut is never read as a shorter record without a word.
namespace gurney::groundmotions {
namespace {

/// Reads a sample after each of `changes`, which return the changed bytes.
class Robustness : public testing::TestWithParam<std::size_t> {
 protected:
  const std::string& bytes() const { return sample_.bytes; }
  Components read(const std::string& changed) const {
    return checked_read(changed, sample_.options);
  }

  /// For bytes of which some were taken away.
  void expect_no_silent_loss(const std::string& changed, const std::string& what) const {
    const Components found = read(changed);
    if (found.empty() || !sample_.states_count) return;
    EXPECT_TRUE(samples_in(found) >= samples_in(whole_) || warnings_in(found) > warnings_in(whole_))
        << what << ": " << samples_in(found) << " samples of " << samples_in(whole_) << ", read as "
        << found[0].format;
  }

  /// What was cut in its last number is not another number without a word.
  void expect_no_silent_change(const std::string& changed, const std::string& what) const {
    const Components found = read(changed);
    if (!sample_.states_count || found.size() != whole_.size() ||
        samples_in(found) != samples_in(whole_) || warnings_in(found) > warnings_in(whole_))
      return;
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_EQ(found[i].acceleration, whole_[i].acceleration) << what << ": " << found[i].name;
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> result;
    for (std::size_t begin = 0; begin < bytes().size();) {
      const auto end = std::min(bytes().find('\n', begin), bytes().size() - 1) + 1;
      result.push_back(bytes().substr(begin, end - begin));
      begin = end;
    }
    return result;
  }

  static std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
  }

  const FormatSample sample_ = format_samples()[GetParam()];
  const Components whole_ = checked_read(sample_.bytes, sample_.options);
};

TEST_P(Robustness, TheSampleIsReadAsItsFormat) {
  ASSERT_FALSE(whole_.empty());
  for (const Component& component : whole_) EXPECT_EQ(component.format, sample_.format);
}

TEST_P(Robustness, OtherFormatsDoNotClaimTheSample) {
  const SourceFile file("f", bytes());
  for (const Format& format : formats()) {
    if (format.name == sample_.format) break;
    EXPECT_FALSE(format.is_binary != file.is_text() && format.recognises(file)) << format.name;
  }
}

TEST_P(Robustness, ATruncatedFileIsNotReadAsAShorterOne) {
  for (std::size_t length = 1; length < bytes().size(); ++length) {
    const std::string cut = bytes().substr(0, length), what = "cut at " + std::to_string(length);
    expect_no_silent_loss(cut, what);
    expect_no_silent_change(cut, what);
  }
}

TEST_P(Robustness, BlankLinesAroundTheFileDoNotMatter) {
  if (!SourceFile("f", bytes()).is_text()) return;
  for (const std::string blanks : {"\n", " \r\n\t\r\n"})
    for (const std::string& changed : {blanks + bytes(), bytes() + blanks}) {
      const Components found = read(changed);
      ASSERT_EQ(found.size(), whole_.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].format, whole_[i].format);
        EXPECT_EQ(found[i].name, whole_[i].name);
        EXPECT_EQ(found[i].azimuth, whole_[i].azimuth);
        EXPECT_EQ(found[i].acceleration, whole_[i].acceleration);
      }
    }
}

TEST_P(Robustness, ALineIsNotLostSilently) {
  const auto all = lines();
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto less = all;
    less.erase(less.begin() + static_cast<long>(i));
    expect_no_silent_loss(joined(less), "without line " + std::to_string(i + 1));
  }
}

TEST_P(Robustness, LinesMayRepeatSwapAndGrow) {
  const auto all = lines();
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto more = all;
    more.insert(more.begin() + static_cast<long>(i), all[i]);
    read(joined(more));
    auto swapped = all;
    std::swap(swapped[i], swapped[(i + 1) % all.size()]);
    read(joined(swapped));
  }
  for (const char c : {' ', '9', '-', ','})
    for (const std::size_t i : {std::size_t{0}, all.size() - 1}) {
      auto longer = all;
      longer[i].insert(longer[i].size() / 2, 300'000, c);
      read(joined(longer));
    }
}

TEST_P(Robustness, ChangedBytesAreAnErrorOrARecord) {
  const std::string pieces[] = {"-",     ".",   "E",     "e999", "nan", "inf",  ",",  "\n",
                                "\r",    " ",   "\t",    "9",    "0x",  "#",    ":",  "****",
                                "NPTS=", "DT=", "UNITS", "\xff", "(8f", "\x1a", "/&", "99999999",
                                "-999",  "=",   ")",     "0",    "/",   "|",    "*",  ";"};
  std::mt19937 draw(5);
  for (int round = 0; round < 2000; ++round) {
    std::string changed = bytes();
    for (auto changes = draw() % 3 + 1; changes > 0; --changes) {
      const std::size_t at = draw() % changed.size();
      if (draw() % 2 == 0)
        changed.replace(at, draw() % 4, pieces[draw() % std::size(pieces)]);
      else
        changed[at] = static_cast<char>(draw() % 256);
    }
    read(changed);
  }
}

TEST_P(Robustness, AbsurdNumbersAreAnErrorOrARecord) {
  constexpr const char* kDigits = "+-.0123456789";
  std::size_t number = 0;
  for (std::size_t begin = bytes().find_first_of(kDigits); begin != std::string::npos; ++number) {
    const std::size_t end = std::min(bytes().find_first_not_of(kDigits, begin), bytes().size());
    for (const std::string value : {"1000000000", "0", "-1", "1e30", "nan", "", "1e-300"}) {
      std::string changed = bytes();
      // The same width, so that fixed columns stay where they are, and as it is.
      std::string wide = value;
      wide.insert(0, end - begin - std::min(end - begin, value.size()), ' ');
      read(std::string(changed).replace(begin, end - begin, wide));
      if (number % 8 == 0) read(changed.replace(begin, end - begin, value));
    }
    begin = bytes().find_first_of(kDigits, end);
  }
}

std::string sample_name(const testing::TestParamInfo<std::size_t>& info) {
  std::string name = format_samples()[info.param].format + std::to_string(info.param);
  std::erase_if(name, [](unsigned char c) { return !std::isalnum(c); });
  return name;
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, Robustness,
                         testing::Range<std::size_t>(0, format_samples().size()), sample_name);

TEST(RobustnessSamples, AreThereForEveryFormat) {
  std::set<std::string> covered;
  for (const FormatSample& sample : format_samples()) covered.insert(sample.format);
  for (const Format& format : formats())
    EXPECT_TRUE(covered.contains(format.name))
        << format.name << " needs a line in tests/groundmotions/formats/format_samples.h";
}

TEST(RobustnessSamples, BinaryAndStrangeFilesAreErrors) {
  std::mt19937 draw(5);
  std::string noise;
  for (int i = 0; i < 4096; ++i) noise += static_cast<char>(draw() % 256);
  for (const std::string& bytes :
       {noise, std::string(1000, '\0'), std::string(100'000, ' '), std::string(100'000, '\n'),
        std::string("\xef\xbb\xbf"), std::string(1'000'000, '-'), std::string(1'000'000, '1'),
        std::string("{\"x\": [1, 2]}"), std::string("*"), std::string("\x1a")})
    EXPECT_TRUE(checked_read(bytes, {.unit = "g", .time_step = 0.02}).empty())
        << bytes.substr(0, 20);
}

}  // namespace
}  // namespace gurney::groundmotions
