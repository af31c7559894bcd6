#include "groundmotions/assembly/file_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "engine/base/units.h"
#include "groundmotions/formats/header_text.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {
namespace {

constexpr double kRight = std::numbers::pi / 2;
constexpr double kTolerance = kRadiansPerDegree;  ///< of a right angle
constexpr double kLengthsDiffer = 0.01;
constexpr std::string_view kSeparators = "-_. ()[]+,";

enum Style : unsigned {
  kCompass = 1,
  kAxes = 2,
  kNumbered = 4,
  kFault = 8,
  kLongitudinal = 16,
  kRadial = 32,
  kSeed = 64,
  kDegrees = 128,
  kPair = 256,
  kAny = ~0U
};

struct Word {
  std::string_view text;
  Direction place;
  unsigned styles;
  std::optional<double> degrees = {};
};

constexpr auto kH1 = Direction::kH1, kH2 = Direction::kH2, kUp = Direction::kVertical;

constexpr std::array kWords = {Word{"E", kH1, kCompass, 90},
                               Word{"EW", kH1, kCompass, 90},
                               Word{"EO", kH1, kCompass, 90},
                               Word{"EAST", kH1, kCompass, 90},
                               Word{"ESTE", kH1, kCompass, 90},
                               Word{"N", kH2, kCompass, 0},
                               Word{"NS", kH2, kCompass, 0},
                               Word{"NORTH", kH2, kCompass, 0},
                               Word{"NORTE", kH2, kCompass, 0},
                               Word{"X", kH1, kAxes},
                               Word{"Y", kH2, kAxes},
                               Word{"H1", kH1, kNumbered},
                               Word{"H2", kH2, kNumbered},
                               Word{"HOR1", kH1, kNumbered},
                               Word{"HOR2", kH2, kNumbered},
                               Word{"COMP1", kH1, kNumbered},
                               Word{"COMP2", kH2, kNumbered},
                               Word{"FN", kH1, kFault},
                               Word{"FP", kH2, kFault},
                               Word{"SN", kH1, kFault},
                               Word{"SP", kH2, kFault},
                               Word{"L", kH1, kLongitudinal},
                               Word{"LN", kH1, kLongitudinal},
                               Word{"LON", kH1, kLongitudinal},
                               Word{"LONG", kH1, kLongitudinal},
                               Word{"T", kH2, kLongitudinal | kRadial},
                               Word{"TR", kH2, kLongitudinal},
                               Word{"TRA", kH2, kLongitudinal},
                               Word{"TRAN", kH2, kLongitudinal},
                               Word{"TRANS", kH2, kLongitudinal},
                               Word{"R", kH1, kRadial},
                               Word{"Z", kUp, kAny},
                               Word{"V", kUp, kAny},
                               Word{"U", kUp, kAny},
                               Word{"UP", kUp, kAny},
                               Word{"UD", kUp, kAny},
                               Word{"VER", kUp, kAny},
                               Word{"VRT", kUp, kAny},
                               Word{"VERT", kUp, kAny},
                               Word{"VERTICAL", kUp, kAny},
                               Word{"DN", kUp, kAny},
                               Word{"DWN", kUp, kAny},
                               Word{"DOWN", kUp, kAny}};

bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

void set_degrees(double degrees, NameMark& mark) {
  mark.azimuth = std::fmod(degrees, 360) * kRadiansPerDegree;
}

/// Band and instrument of an accelerometer and its orientation: HNE, HN1, BNZ.
std::optional<NameMark> seed_mark(std::string_view text) {
  constexpr std::string_view kBands = "FGDCESHB", kInstruments = "NGLH", kOrientations = "12ENZ";
  if (text.size() != 3 || kBands.find(text[0]) == kBands.npos ||
      kInstruments.find(text[1]) == kInstruments.npos)
    return {};
  const auto at = kOrientations.find(text[2]);
  if (at == kOrientations.npos) return {};
  NameMark mark{.text = std::string(text), .place = kUp, .styles = kAny};
  if (text[2] == 'Z') return mark;
  mark.place = text[2] == '1' || text[2] == 'E' ? kH1 : kH2;
  mark.styles = at < 2 ? kSeed : kCompass;
  if (at >= 2) set_degrees(text[2] == 'E' ? 90 : 0, mark);
  return mark;
}

/// @param text  in capitals
std::optional<NameMark> mark_of(std::string_view text) {
  if (auto mark = seed_mark(text)) return mark;
  const auto word = std::ranges::find(kWords, text, &Word::text);
  if (word == kWords.end()) return {};
  NameMark mark{.text = std::string(text), .place = word->place, .styles = word->styles};
  if (word->degrees) set_degrees(*word->degrees, mark);
  mark.points_down = text.starts_with('D');
  return mark;
}

/// E-W, N-S and U-D as one word.
std::string without_hyphens(std::string stem) {
  for (std::size_t at = 0; at + 3 <= stem.size(); ++at) {
    const std::string part = upper(stem.substr(at, 3));
    const bool is_apart =
        (at == 0 || !letter(stem[at - 1])) && (at + 3 == stem.size() || !letter(stem[at + 3]));
    if (is_apart && (part == "E-W" || part == "N-S" || part == "U-D")) stem.erase(at + 1, 1);
  }
  return stem;
}

/// A part of a name between separators.
struct Token {
  std::size_t begin = 0, end = 0;
};

std::vector<Token> tokens_of(std::string_view stem) {
  std::vector<Token> tokens;
  for (std::size_t begin = stem.find_first_not_of(kSeparators); begin != stem.npos;) {
    const auto end = std::min(stem.find_first_of(kSeparators, begin), stem.size());
    tokens.push_back({begin, end});
    begin = stem.find_first_not_of(kSeparators, end);
  }
  return tokens;
}

/// Words behind a component that say nothing of it.
bool is_filler(std::string_view text) {
  constexpr std::array<std::string_view, 5> kFillers = {"ACC", "ACCEL", "ACCELERATION", "G", "COR"};
  return std::ranges::find(kFillers, text) != kFillers.end();
}

class MarkFinder {
 public:
  explicit MarkFinder(const std::filesystem::path& file)
      : extension_(file.extension().string()),
        stem_(without_hyphens(file.stem().string())),
        capitals_(upper(stem_)) {}

  std::vector<NameMark> find() {
    if (auto mark = extension_.empty() ? std::nullopt : mark_of(upper(extension_).substr(1))) {
      mark->pattern = stem_ + ".*";
      mark->is_word = mark->is_last = true;
      marks_.push_back(std::move(*mark));
    }
    const auto tokens = tokens_of(capitals_);
    std::size_t last = tokens.size();
    while (last > 1 && is_filler(text_of(tokens[last - 1]))) --last;
    for (std::size_t i = 0; i < tokens.size(); ++i) find_in(tokens[i], i + 1 == last);
    if (!tokens.empty()) find_degrees(tokens.back());
    return std::move(marks_);
  }

 private:
  std::string_view text_of(const Token& token) const {
    return std::string_view(capitals_).substr(token.begin, token.end - token.begin);
  }

  /// The separators before a mark go with it; at the front those behind it.
  void add(NameMark mark, std::size_t begin, std::size_t end) {
    const auto separates = [&](std::size_t at) {
      return at < stem_.size() &&
             std::string_view("-_. ").find(stem_[at]) != std::string_view::npos;
    };
    if (begin == 0)
      while (separates(end)) ++end;
    while (begin > 0 && separates(begin - 1)) --begin;
    mark.pattern = stem_.substr(0, begin) + "*" + stem_.substr(end) + extension_;
    marks_.push_back(std::move(mark));
  }

  /// A mark is a whole token or its end: GM1X, STAEW.
  void find_in(const Token& token, bool is_last) {
    const std::string_view text = text_of(token);
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
      auto mark = mark_of(text.substr(begin));
      const bool is_one = begin + 1 == text.size();
      if (begin > 0 && mark && mark->styles == kSeed) mark.reset();  // RSN1
      if (!mark && is_one && is_pair(text)) mark = pair_mark(text.back());
      if (!mark && is_one && (letter(text.back()) || is_pair(text)))
        mark = NameMark{.text = std::string(1, text.back())};
      if (!mark) continue;
      mark->is_word = begin == 0;
      mark->is_last = is_last;
      add(std::move(*mark), token.begin + begin, token.end);
    }
  }

  /// The numbers of FEMA P-695, 120111: set 12, earthquake 01, station 1, component 1.
  static bool is_pair(std::string_view text) {
    return text.size() == 6 && std::ranges::all_of(text, digit) && text.starts_with("12") &&
           text[4] >= '1' && text[4] <= '4';
  }
  static std::optional<NameMark> pair_mark(char digit) {
    if (digit != '1' && digit != '2') return {};
    return NameMark{
        .text = std::string(1, digit), .place = digit == '1' ? kH1 : kH2, .styles = kPair};
  }

  /// Three digits at the end: NIS090, C05085, but not run001090.
  void find_degrees(const Token& token) {
    constexpr std::size_t kDigits = 3, kMaxDigits = 5;
    const std::string_view text = text_of(token);
    std::size_t digits = 0;
    while (digits < text.size() && digit(text[text.size() - 1 - digits])) ++digits;
    if (digits < kDigits || digits > kMaxDigits || token.end != stem_.size()) return;
    const auto degrees = number(text.substr(text.size() - kDigits));
    if (!degrees || *degrees > 360) return;
    NameMark mark{.text = std::string(text.substr(text.size() - kDigits)),
                  .place = kH1,
                  .styles = kDegrees,
                  .is_word = true,
                  .is_last = true};
    set_degrees(*degrees, mark);
    add(std::move(mark), token.end - kDigits, token.end);
  }

  std::string extension_, stem_, capitals_;
  std::vector<NameMark> marks_;
};

struct Candidate {
  std::size_t file = 0;
  NameMark mark;
};
using Candidates = std::vector<Candidate>;

bool horizontal(const Candidate& each) { return each.mark.place && each.mark.place != kUp; }

bool are_a_pair(const NameMark& a, const NameMark& b) {
  if ((a.styles & b.styles) == 0) return false;
  if (!a.azimuth || !b.azimuth) return a.place != b.place;
  const double angle = std::remainder(*a.azimuth - *b.azimuth, std::numbers::pi);
  return std::abs(std::abs(angle) - kRight) < kTolerance;
}

/// Why files named alike are not one motion; empty: they are.
std::string doubt_of(const Candidates& group, const std::vector<NamedFile>& files) {
  std::vector<NameMark> horizontals;
  for (const Candidate& each : group)
    if (horizontal(each)) horizontals.push_back(each.mark);
  if (std::ssize(group) - std::ssize(horizontals) > 1 || horizontals.size() > 2)
    return "more than one file for a direction";
  if (horizontals.size() == 2 && !are_a_pair(horizontals[0], horizontals[1]))
    return "their names are not two horizontal directions";
  const auto at = [&](const Candidate& each) { return files[each.file]; };
  const auto [step_low, step_high] =
      std::ranges::minmax(group, {}, [&](const Candidate& each) { return at(each).time_step; });
  if (at(step_high).time_step > at(step_low).time_step * (1 + 1e-6))
    return fmt::format("time steps of {:g} and {:g} s", at(step_low).time_step,
                       at(step_high).time_step);
  const auto [short_one, long_one] =
      std::ranges::minmax(group, {}, [&](const Candidate& each) { return at(each).samples; });
  const auto fewest = at(short_one).samples, most = at(long_one).samples;
  if (static_cast<double>(most - fewest) > kLengthsDiffer * static_cast<double>(most))
    return fmt::format("{} and {} samples", fewest, most);
  return {};
}

/// Azimuths by chance: run001 and run002 number files.
bool only_degrees(const Candidates& group) {
  return std::ranges::all_of(group, [](const Candidate& each) {
    return !horizontal(each) || each.mark.styles == kDegrees;
  });
}

bool any_of_one_letter(const Candidates& group) {
  return std::ranges::any_of(
      group, [](const Candidate& each) { return horizontal(each) && each.mark.text.size() == 1; });
}

class NameMatcher {
 public:
  explicit NameMatcher(const std::vector<NamedFile>& files) : files_(files) {
    result_.marks.resize(files.size());
    for (std::size_t i = 0; i < files.size(); ++i)
      for (NameMark& mark : name_marks(files[i].path)) {
        const std::string key =
            files[i].path.parent_path().string() + "/" + upper(mark.pattern) + "|" + files[i].site;
        Candidates& group = groups_[key];
        if (group.empty() || group.back().file != i) group.push_back({i, std::move(mark)});
      }
  }

  NameMatches match() {
    std::vector<std::pair<double, const std::string*>> order;
    for (auto& [key, group] : groups_) {
      take_numbering(key, group);
      if (group.size() > 1 && std::ranges::any_of(group, horizontal))
        order.emplace_back(-worth(group), &key);
    }
    std::ranges::stable_sort(order, {}, [](const auto& each) { return each.first; });
    for (const auto& [value, key] : order) take(*key);
    for (std::size_t i = 0; i < files_.size(); ++i)
      if (!result_.marks[i]) result_.marks[i] = vertical_mark(files_[i].path);
    return std::move(result_);
  }

 private:
  /// Removes what is no component; keeps in mind whether letters number the files.
  void take_numbering(const std::string& key, Candidates& group) {
    const auto other = [](const Candidate& each) { return !each.mark.place; };
    if (std::ranges::any_of(group, other)) numbered_[key] = true;
    std::erase_if(group, other);
  }

  /// More files first, then whole words, then those at the end of the name.
  static double worth(const Candidates& group) {
    double worth = 4 * static_cast<double>(group.size());
    for (const Candidate& each : group)
      worth += (2.0 * each.mark.is_word + each.mark.is_last) / static_cast<double>(group.size());
    return worth;
  }

  void take(const std::string& key) {
    const Candidates& group = groups_.at(key);
    if (std::ranges::any_of(
            group, [&](const Candidate& each) { return result_.marks[each.file].has_value(); }))
      return;
    std::string doubt = doubt_of(group, files_);
    if (doubt.empty() && numbered_[key] && any_of_one_letter(group))
      doubt = "letters may number the files";
    if (doubt.empty())
      for (const Candidate& each : group) result_.marks[each.file] = each.mark;
    else if (!only_degrees(group) &&
             std::ranges::all_of(group, [](const Candidate& each) { return each.mark.is_word; }))
      result_.doubts.push_back(doubt_text(group, doubt));
  }

  std::string doubt_text(const Candidates& group, const std::string& doubt) const {
    constexpr std::size_t kShown = 4;
    std::string names;
    for (std::size_t i = 0; i < std::min(kShown, group.size()); ++i)
      names += (i ? ", " : "") + files_[group[i].file].path.string();
    if (group.size() > kShown) names += fmt::format(" and {} more", group.size() - kShown);
    return fmt::format(
        "{}: named as components of one motion, but not joined: {}; if they belong together, "
        "write a list with the columns name, h1, h2, vertical (docs/formats/record_sets.md)",
        names, doubt);
  }

  const std::vector<NamedFile>& files_;
  std::map<std::string, Candidates> groups_;
  std::map<std::string, bool> numbered_;
  NameMatches result_;
};

std::filesystem::path file_name(const Component& component) {
  return std::filesystem::path(component.file).filename();
}

void take(const NameMark& mark, Component& component) {
  component.name = mark.text;
  component.azimuth = mark.azimuth;
  if (!mark.azimuth) component.direction = mark.place;
  component.warnings.push_back(
      fmt::format("its direction ({}) was taken from the file's name", mark.text));
  if (mark.points_down) turn_up(mark.text, component);
}

/// The user's word counts; the name is a reason to look again.
void warn_of_stated_vertical(UnplacedComponent& each) {
  if (!each.stated || *each.stated == Direction::kVertical) return;
  if (const auto mark = vertical_mark(file_name(each.component)))
    each.component.warnings.push_back(
        fmt::format("{}: the file's name says '{}', a vertical; it is used as {}",
                    each.component.file, mark->text, name_of(*each.stated)));
}

constexpr std::size_t kFewestLetters = 3;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::size_t common_size(const std::vector<std::string>& stems) {
  std::size_t size = stems[0].size();
  for (const std::string& stem : stems)
    size = std::min(size, static_cast<std::size_t>(std::ranges::mismatch(stems[0], stem).in1 -
                                                   stems[0].begin()));
  return size;
}

/// Whether all stems that go on with a digit have three digits of an azimuth from `at` on.
bool azimuths_follow(const std::vector<std::string>& stems, std::size_t at) {
  std::size_t azimuths = 0;
  for (const std::string& stem : stems) {
    std::size_t end = at;
    while (end < stem.size() && is_digit(stem[end])) ++end;
    if (end == at) continue;
    if (end != at + 3 || number(stem.substr(at, 3)).value_or(999) > 360) return false;
    ++azimuths;
  }
  return azimuths > 1;
}

/// The first digits of azimuths are no part of the name: 000 and 090 begin alike.
std::size_t before_azimuths(const std::vector<std::string>& stems, std::size_t size) {
  for (std::size_t back = 0; back < 3 && back <= size; ++back) {
    if (azimuths_follow(stems, size - back)) return size - back;
    if (back < size && !is_digit(stems[0][size - back - 1])) break;
  }
  return size;
}

bool is_blank_part(char c) { return std::string_view("-_. ").find(c) != std::string_view::npos; }

}  // namespace

std::vector<NameMark> name_marks(const std::filesystem::path& file) {
  return MarkFinder(file).find();
}

std::optional<NameMark> vertical_mark(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 3> kUnmistakable = {"UD", "VERT", "VERTICAL"};
  auto marks = name_marks(file);
  // "vertical_park_NS" ends with its component.
  const bool ends_level = std::ranges::any_of(marks, [](const NameMark& mark) {
    return mark.is_word && mark.is_last && mark.azimuth && mark.text.size() > 1;
  });
  for (NameMark& mark : marks) {
    if (mark.place != kUp || mark.text == "U" || (ends_level && !mark.is_last)) continue;
    const auto at = mark.pattern.find('*');
    const bool is_first = at == 0 && mark.text != "V";
    const bool after_digit = at > 0 && digit(mark.pattern[at - 1]) && mark.text.size() > 1;
    const bool is_sure = std::ranges::find(kUnmistakable, mark.text) != kUnmistakable.end();
    if (mark.is_word ? mark.is_last || is_first || is_sure : mark.is_last && after_digit)
      return std::move(mark);
  }
  return {};
}

NameMatches match_names(const std::vector<NamedFile>& files) { return NameMatcher(files).match(); }

bool lacks_direction(const Component& component) {
  return !component.azimuth && !component.direction &&
         (component.name.empty() || component.name.starts_with("column ") ||
          upper(component.name) == "A" || quantity_in(component.name) == "acceleration");
}

void orient_by_file_names(std::vector<UnplacedComponent>& components) {
  std::vector<NamedFile> files;
  std::vector<UnplacedComponent*> unknown;
  for (UnplacedComponent& each : components) {
    const auto of_one_file = std::ranges::count_if(
        components, [&](const auto& other) { return other.component.file == each.component.file; });
    if (of_one_file > 1 || !lacks_direction(each.component)) continue;
    warn_of_stated_vertical(each);
    if (each.stated) continue;
    files.push_back({.path = file_name(each.component)});
    unknown.push_back(&each);
  }
  const NameMatches matches = match_names(files);
  for (std::size_t i = 0; i < unknown.size(); ++i)
    if (matches.marks[i]) take(*matches.marks[i], unknown[i]->component);
}

std::string common_name(const std::vector<std::string>& stems) {
  if (std::ranges::all_of(stems, [&](const auto& stem) { return stem == stems[0]; }))
    return stems[0];
  std::size_t size = before_azimuths(stems, common_size(stems));
  while (size > 0 && is_blank_part(stems[0][size - 1])) --size;
  return size < kFewestLetters ? fmt::format("{}", fmt::join(stems, " + "))
                               : stems[0].substr(0, size);
}

}  // namespace gurney::groundmotions
