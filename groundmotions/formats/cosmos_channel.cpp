#include "groundmotions/formats/cosmos_channel.h"

#include <fmt/format.h>

#include <cmath>

#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr double kMaxNumbers = 1e8;

/// The format behind "Format=" of a line in capitals.
std::optional<FortranFormat> format_in(std::string_view text) {
  const auto at = text.rfind("FORMAT");
  if (at == kNone) return {};
  const auto open = text.find('(', at);
  if (open == kNone) return {};
  return fortran_format(text.substr(open, text.find(')', open) - open + 1));
}

/// The code in "units=cm/sec2(04)", "units=g.     (02)" or "units= counts(50)".
std::optional<int> unit_code_in(std::string_view text) {
  const auto units = text.find("UNIT");
  const auto open = units == kNone ? kNone : text.find('(', units);
  if (open == kNone) return {};
  const auto code = number(text.substr(open + 1, text.find(')', open) - open - 1));
  return code && *code >= 0 && *code < 1000 ? std::optional(static_cast<int>(*code)) : std::nullopt;
}

class CosmosFileReader {
 public:
  CosmosFileReader(const SourceFile& file, FileErrors& errors)
      : file_(file), errors_(errors), fields_(file, errors) {}

  std::vector<CosmosChannel> read() {
    std::vector<CosmosChannel> channels;
    for (skip_ends(); !at_end() && !errors_.any(); skip_ends()) {
      channels.emplace_back();
      read_channel(channels.back());
    }
    return channels;
  }

 private:
  bool at_end() const { return line_ >= file_.lines().size(); }
  std::string text() const { return at_end() ? "" : upper(file_.lines()[line_].substr(0, 200)); }

  void skip_ends() {
    while (!at_end()) {
      const std::string line = text();
      const bool is_end = line.starts_with("END-OF-DATA") || line.starts_with("/&") ||
                          line.find("END OF DATA") != kNone;
      if (!is_end && !trimmed(line).empty()) return;
      ++line_;
    }
  }

  void error(const std::string& what) {
    const std::string found = at_end() ? "the end of the file" : "'" + text().substr(0, 60) + "'";
    errors_.add(std::min(line_ + 1, file_.lines().size()), 1, what + ", got " + found);
  }

  void read_channel(CosmosChannel& channel) {
    channel.first_line = line_;
    const std::string first = text();
    const auto lines = number_after(first, " WITH");
    if (!starts_cosmos_channel(first) || !lines || !(*lines >= 1 && *lines <= 100))
      return error("a channel must begin with a line '(Format vNN.NN with NN text lines)'");
    for (double i = 0; i < *lines && !at_end(); ++i, ++line_) channel.text.push_back(text());
    read_unknowns(channel);
    read_numbers("INTEGER", channel.integers);
    read_numbers("REAL", channel.reals);
    read_comments(channel);
    if (!errors_.any()) read_all_series(channel);
  }

  /// The last line of text ends with "-999, -999.0", the values for what is not known.
  static void read_unknowns(CosmosChannel& channel) {
    if (channel.text.empty()) return;
    const std::string& line = channel.text.back();
    auto rest = trimmed(std::string_view(line).substr(line.rfind(':') + 1));
    const auto integer = take_number(rest);
    if (!integer) return;
    rest = trimmed(rest.starts_with(',') ? rest.substr(1) : rest);
    channel.unknown_integer = *integer;
    channel.unknown_real = take_number(rest).value_or(channel.unknown_real);
  }

  std::optional<std::size_t> count_of(std::string_view line) {
    line = trimmed(line);
    const auto count = take_number(line);
    if (!count || !(*count >= 0 && *count <= kMaxNumbers && *count == std::floor(*count)))
      return {};
    return static_cast<std::size_t>(*count);
  }

  void read_numbers(const std::string& kind, std::vector<double>& numbers) {
    if (errors_.any()) return;
    const std::string line = text();
    const auto count = count_of(line);
    const auto format = format_in(line);
    if (!count || !format || line.find(kind) == kNone)
      return error(fmt::format("expected 'NNN {}-header values follow on NN lines, Format=(...)'",
                               kind == "REAL" ? "Real" : "Integer"));
    ++line_;
    numbers = fields_.read(line_, *count, *format, EmptyField::kZero, "numbers of the header");
  }

  void read_comments(CosmosChannel& channel) {
    const std::string line = text();
    if (errors_.any() || line.find("COMMENT") == kNone) return;
    const auto count = count_of(line);
    if (!count) return error("expected 'NN Comment line(s) follow'");
    const std::size_t end = std::min(line_ + 1 + *count, file_.lines().size());
    for (++line_; line_ < end; ++line_) {
      const std::string comment = text();
      const auto at = comment.find("<SCNL>");
      if (at == kNone) continue;
      const auto parts = words_of(std::string_view(comment).substr(at + 6), ". \t");
      if (parts.size() > 1) channel.code = parts[1];
    }
  }

  bool is_announcement(const std::string& line) {
    return count_of(line) && (line.find("UNIT") != kNone || line.find("PTS") != kNone) &&
           format_in(line);
  }

  void read_all_series(CosmosChannel& channel) {
    if (!is_announcement(text()))
      return error("expected 'NNNN acceleration pts, approx NN secs, units=...(NN),Format=(...)'");
    while (!errors_.any() && is_announcement(text())) {
      CosmosSeries series{.line = line_, .text = text(), .unit_code = {}, .values = {}};
      series.unit_code = unit_code_in(series.text);
      ++line_;
      series.values = fields_.read(line_, *count_of(series.text), *format_in(series.text),
                                   EmptyField::kError, "samples");
      if (!errors_.any())
        check_enough(static_cast<double>(series.values.size()), series.line + 1, errors_);
      channel.series.push_back(std::move(series));
    }
  }

  const SourceFile& file_;
  FileErrors& errors_;
  FieldReader fields_;
  std::size_t line_ = 0;
};

std::optional<double> known(const std::vector<double>& values, std::size_t number, double unknown) {
  if (number > values.size()) return {};
  const double value = values[number - 1];
  return std::isnan(value) || value == unknown ? std::nullopt : std::optional(value);
}

}  // namespace

std::optional<double> CosmosChannel::integer(std::size_t number) const {
  return known(integers, number, unknown_integer);
}

std::optional<double> CosmosChannel::real(std::size_t number) const {
  return known(reals, number, unknown_real);
}

bool starts_cosmos_channel(std::string_view line) {
  const std::string text = upper(line.substr(0, 200));
  return text.find("(FORMAT V") != kNone && text.find("TEXT LINES)") != kNone;
}

std::vector<CosmosChannel> cosmos_channels(const SourceFile& file, FileErrors& errors) {
  return CosmosFileReader(file, errors).read();
}

}  // namespace gurney::groundmotions
