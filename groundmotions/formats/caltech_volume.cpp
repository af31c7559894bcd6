#include "groundmotions/formats/caltech_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/unit_text.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kMaxTextLines = 40;  ///< 13 in volume 1, 25 in volume 2
constexpr double kMaxSamples = 1e7;

/// Formats of samples in the order they are tried; the first that fits the first line is taken,
/// or else (that line has an error) the first of its length.
constexpr std::array kSampleFormats = {"8F10.3", "8F9.6", "10F8.3", "10F7.3"};
constexpr std::array kPairFormats = {"10F7.3", "1X,10F7.3", "8F7.3", "1X,8F7.3", "8F10.3"};

class VolumeReader {
 public:
  VolumeReader(const SourceFile& file, FileErrors& errors)
      : file_(file), errors_(errors), fields_(file, errors) {}

  std::vector<CaltechChannel> read() {
    std::vector<CaltechChannel> channels;
    for (skip_blanks(); line_ < file_.lines().size() && !errors_.any(); skip_blanks())
      channels.push_back(read_channel());
    return channels;
  }

 private:
  std::string_view line(std::size_t index) const { return file_.lines()[index]; }
  bool at_end() const { return line_ >= file_.lines().size(); }
  void skip_blanks() {
    while (!at_end() && trimmed(line(line_)).empty()) ++line_;
  }

  CaltechChannel read_channel() {
    CaltechChannel channel{
        .first_line = line_, .text = {}, .integers = {}, .reals = {}, .series = {}, .trailing = {}};
    if (read_header(channel)) read_all_series(channel);
    return channel;
  }

  /// The text ends where the first line of whole integers begins: its number of lines varies.
  bool read_header(CaltechChannel& channel) {
    const FortranFormat wide = *fortran_format("16I5"), narrow = *fortran_format("20I4");
    const std::size_t end = std::min(file_.lines().size(), line_ + kMaxTextLines);
    while (line_ < end && !fields_.fits(line_, 16, wide) && !fields_.fits(line_, 20, narrow))
      channel.text.push_back(upper(line(line_++)));
    if (line_ == end) {
      errors_.add(channel.first_line + 1, 1,
                  fmt::format("no integer header (16I5) within {} lines of this channel's header",
                              kMaxTextLines));
      return false;
    }
    const auto& format = fields_.fits(line_, 16, wide) ? wide : narrow;
    channel.integers =
        fields_.read(line_, 100, format, EmptyField::kZero, "integers of the header");
    const bool corrected =
        !channel.text.empty() && trimmed(channel.text[0]).starts_with("CORRECTED");
    channel.reals = fields_.read(line_, corrected ? 100 : 50, *fortran_format("8F10.3"),
                                 EmptyField::kZero, "real numbers of the header");
    return !errors_.any();
  }

  void read_all_series(CaltechChannel& channel) {
    skip_blanks();
    do channel.series.push_back(read_series(channel));
    while (!errors_.any() && next_is_series());
    if (!at_end() && is_end_mark(line(line_))) ++line_;
    skip_blanks();
    if (errors_.any() || at_end() || upper(line(line_)).find("ACCELEROGRAM") != kNone) return;
    const std::size_t behind = line_;
    const auto text = trimmed(line(line_++));
    skip_blanks();
    if (at_end() && std::isalpha(static_cast<unsigned char>(text[0]))) {
      channel.trailing = text;
      return;
    }
    line_ = behind;
    errors_.add(line_ + 1, 1,
                fmt::format("the samples of this channel end here, but neither the next channel "
                            "nor the end of the file follows: '{}'",
                            trimmed(line(line_)).substr(0, 60)));
  }

  bool next_is_series() {
    skip_blanks();
    return !at_end() && is_announcement(upper(line(line_)));
  }

  static bool is_end_mark(std::string_view text) {
    return text.starts_with("/&") || upper(text).find("END OF DATA") != kNone;
  }

  static bool is_announcement(const std::string& text) {
    std::string_view rest = trimmed(text);
    return take_number(rest) && rest.find("POINTS") != kNone;
  }

  CaltechSeries read_series(const CaltechChannel& channel) {
    CaltechSeries series;
    series.line = line_;
    if (at_end()) {
      errors_.add(file_.lines().size(), 1, "the file ends behind the header: no samples");
      return series;
    }
    const std::string text = upper(line(line_));
    if (is_announcement(text))
      read_announced(text, series);
    else
      read_pairs(channel, series);
    return series;
  }

  std::size_t checked_count(double count, std::size_t index) {
    if (count >= 2 && count <= kMaxSamples && count == std::floor(count))
      return static_cast<std::size_t>(count);
    errors_.add(index + 1, 1,
                fmt::format("the number of samples must be a whole number above 1, got {}", count));
    return 0;
  }

  void read_announced(const std::string& text, CaltechSeries& series) {
    std::string_view rest = trimmed(text);
    const std::size_t count = checked_count(*take_number(rest), line_);
    if (rest.find("ACC") == kNone)
      series.quantity = rest.find("VEL") != kNone ? CaltechSeries::Quantity::kVelocity
                                                  : CaltechSeries::Quantity::kDisplacement;
    series.time_step = step_in(rest);
    series.unit = unit_in(rest);
    ++line_;
    if (count == 0 || at_end()) {
      if (at_end()) errors_.add(file_.lines().size(), 1, "the file ends behind this line");
      return;
    }
    const auto format = announced_format(rest);
    series.values = fields_.read(line_, count, format ? *format : fitting(kSampleFormats, count),
                                 EmptyField::kError, "samples");
  }

  static std::optional<FortranFormat> announced_format(std::string_view text) {
    const auto open = text.rfind('(');
    if (open == kNone) return {};
    return fortran_format(text.substr(open, text.find(')', open) - open + 1));
  }

  /// "EQUALLY SPACED AT .005 SEC" or "AT 200 PTS/SEC".
  static std::optional<double> step_in(std::string_view text) {
    const auto at = text.find(" AT ");
    if (at == kNone) return {};
    std::string_view rest = trimmed(text.substr(at + 4));
    const auto value = take_number(rest);
    const auto unit = trimmed(rest).substr(0, trimmed(rest).find(' '));
    return value && unit.find("/S") != kNone ? 1 / *value : value;
  }

  template <std::size_t N>
  FortranFormat fitting(const std::array<const char*, N>& candidates, std::size_t count) const {
    for (const char* candidate : candidates) {
      const FortranFormat format = *fortran_format(candidate);
      if (fields_.fits(line_, std::min(count, format.per_line), format)) return format;
    }
    const auto text = line(line_).substr(0, line(line_).find_last_not_of(' ') + 1);
    for (const char* candidate : candidates) {
      const FortranFormat format = *fortran_format(candidate);
      if (text.size() == format.skip + format.per_line * format.width) return format;
    }
    return *fortran_format(candidates[0]);
  }

  /// The text states the number of pairs; integer 28 does too, but has room for five digits only.
  void read_pairs(const CaltechChannel& channel, CaltechSeries& series) {
    const auto at = channel.find("NO. OF POINTS");
    auto count = at ? number_after(channel.text[*at], "NO. OF POINTS") : std::nullopt;
    if (!count) count = channel.integers[27];
    const std::size_t pairs = checked_count(*count, channel.first_line + at.value_or(0));
    if (pairs == 0) return;
    const auto numbers = fields_.read(line_, 2 * pairs, fitting(kPairFormats, 2 * pairs),
                                      EmptyField::kError, "numbers (a time and a value each)");
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
      series.times.push_back(numbers[i]);
      series.values.push_back(numbers[i + 1]);
    }
  }

  const SourceFile& file_;
  FileErrors& errors_;
  FieldReader fields_;
  std::size_t line_ = 0;
};

}  // namespace

std::optional<std::size_t> CaltechChannel::find(std::string_view key, std::size_t begin) const {
  for (std::size_t i = begin; i < text.size(); ++i)
    if (text[i].find(key) != std::string::npos) return i;
  return {};
}

std::vector<CaltechChannel> caltech_channels(const SourceFile& file, FileErrors& errors) {
  return VolumeReader(file, errors).read();
}

}  // namespace gurney::groundmotions
