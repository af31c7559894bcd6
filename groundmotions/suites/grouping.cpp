#include "groundmotions/suites/grouping.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <numbers>
#include <vector>

#include "engine/base/append_all.h"
#include "engine/base/units.h"
#include "groundmotions/assembly/file_names.h"
#include "groundmotions/assembly/place.h"
#include "groundmotions/assembly/site.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {
namespace {

constexpr double kParallel = 1 * kRadiansPerDegree;
constexpr double kAlike = 0.5;  ///< share of two names that is the same; an assumption

using Group = std::vector<FoundComponent>;

/// Event and station without the name of the component; dates and times where there is no event.
std::string content_of(const Component& component) {
  std::string event;
  for (const char* name : {"event", "event time", "event date", "origin time (Japan)"})
    if (event.empty()) event = fact_of(component, name);
  std::string text =
      " " + plain_words(event) + " / " + plain_words(fact_of(component, "station")) + " ";
  const std::string name = " " + plain_words(component.name) + " ";
  if (const auto at = text.rfind(name); name != "  " && at != std::string::npos)
    text.replace(at, name.size(), " ");
  return plain_words(text).empty() ? "" : text;
}

bool parallel(double a, double b) {
  return std::abs(std::remainder(a - b, std::numbers::pi)) < kParallel;
}

bool starts_together(const FoundComponent& a, const FoundComponent& b) {
  return !a.start_time || !b.start_time ||
         std::abs(*a.start_time - *b.start_time) < std::min(a.duration, b.duration);
}

bool can_be_together(const FoundComponent& a, const FoundComponent& b) {
  if (a.site != b.site || !starts_together(a, b) || a.vertical != b.vertical)
    return a.site == b.site && starts_together(a, b);
  if (a.vertical) return false;
  if (a.azimuth && b.azimuth) return !parallel(*a.azimuth, *b.azimuth);
  return a.name.empty() || upper(a.name) != upper(b.name);
}

bool can_be_record(const Group& group) {
  if (std::ranges::count(group, false, &FoundComponent::vertical) > 2) return false;
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!can_be_together(group[i], group[j])) return false;
  return true;
}

Group joined(Group a, const Group& b) {
  append_all(a, b);
  return a;
}

std::string file_name(const FoundComponent& component) {
  return component.path.filename().string();
}

/// Share of the longer name that both begin and end with.
double likeness(const std::string& a, const std::string& b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  std::size_t front = 0, back = 0;
  while (front < shorter && a[front] == b[front]) ++front;
  while (front + back < shorter && a[a.size() - 1 - back] == b[b.size() - 1 - back]) ++back;
  return static_cast<double>(front + back) / static_cast<double>(std::max(a.size(), b.size()));
}

/// Joins the groups of one event, station and site: all of them if that can be a record, else those
/// of the likest names, one pair after the other.
void join_alike(std::vector<Group>& groups) {
  Group all;
  for (const Group& group : groups) all = joined(std::move(all), group);
  if (can_be_record(all)) {
    groups = {all};
    return;
  }
  for (;;) {
    double best = kAlike;
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (std::size_t j = i + 1; j < groups.size(); ++j) {
        const double like = likeness(file_name(groups[i][0]), file_name(groups[j][0]));
        if (like <= best || !can_be_record(joined(groups[i], groups[j]))) continue;
        best = like;
        first = i;
        second = j;
      }
    if (second == 0) return;
    groups[first] = joined(std::move(groups[first]), groups[second]);
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(second));
  }
}

/// Groups by a key; what has none stays alone.
template <class Item, class Key>
std::vector<std::vector<Item>> by_key(const std::vector<Item>& items, const Key& key_of) {
  std::map<std::string, std::size_t> places;
  std::vector<std::vector<Item>> groups;
  for (const Item& item : items) {
    const std::string key = key_of(item);
    const auto place = places.find(key);
    if (key.empty() || place == places.end()) {
      if (!key.empty()) places[key] = groups.size();
      groups.push_back({item});
    } else {
      groups[place->second].push_back(item);
    }
  }
  return groups;
}

std::string place_key(const FoundComponent& component, const std::string& key) {
  if (key.empty()) return {};
  return component.path.parent_path().string() + "|" + key + "|" + component.site;
}

std::string name_of(const Group& group) {
  const std::string& pattern = group[0].pattern;
  const bool by_name = std::ranges::all_of(
      group, [&](const auto& each) { return !each.pattern.empty() && each.pattern == pattern; });
  const std::string folder = group[0].path.parent_path().filename().string();
  if (group.size() > 1 && by_name && pattern.starts_with("*.") && !folder.empty()) return folder;
  if (group.size() > 1 && by_name) return name_of_pattern(pattern);
  std::vector<std::string> stems;
  for (const FoundComponent& each : group) stems.push_back(each.path.stem().string());
  return common_name(stems);
}

SuiteRecord record_of(const Group& group, const std::string& name) {
  SuiteRecord record{.name = name, .files = {}, .options = group[0].options, .facts = {}};
  for (const FoundComponent& each : group)
    record.files.push_back({.path = each.path, .channel = each.channel});
  return record;
}

/// Blanks in a row become one.
std::string place_of(const Component& component) {
  std::string place = fact_of(component, "location");
  if (place.empty()) place = fact_of(component, "sensor");
  return fmt::format("{}", fmt::join(words_of(place, " \t"), " "));
}

std::string with_place(const std::string& name, const FoundComponent& component) {
  const std::string& place = component.place.empty() ? component.site : component.place;
  return place.empty() ? name : name + " " + place;
}

bool says_where(const FoundComponent& channel) {
  return channel.vertical || channel.azimuth || !channel.site.empty();
}

/// A channel alone at its place, beside channels at other places of the folder.
bool is_alone_at_place(const Group& group, const std::vector<Group>& groups) {
  return group.size() == 1 && !group[0].place.empty() &&
         std::ranges::any_of(groups, [&](const Group& other) {
           return !other[0].place.empty() && other[0].place != group[0].place &&
                  other[0].content == group[0].content &&
                  other[0].path.parent_path() == group[0].path.parent_path();
         });
}

/// Two sensors at one station have files of like names; the place distinguishes them.
void name_apart(std::vector<Group>& groups, std::vector<SuiteRecord>& records) {
  std::map<std::string, int> count;
  for (const SuiteRecord& record : records) ++count[record.name];
  for (std::size_t i = 0; i < records.size(); ++i)
    if (count[records[i].name] > 1 || is_alone_at_place(groups[i], groups))
      records[i].name = with_place(records[i].name, groups[i][0]);
}

void take_directions_from_names(std::vector<FoundComponent>& components,
                                std::vector<std::string>& doubts) {
  std::vector<NamedFile> files;
  std::vector<FoundComponent*> unknown;
  for (FoundComponent& each : components)
    if (each.lacks_direction) {
      files.push_back({each.path, each.site, each.time_step, each.samples});
      unknown.push_back(&each);
    }
  NameMatches matches = match_names(files);
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    if (!matches.marks[i]) continue;
    const NameMark& mark = *matches.marks[i];
    unknown[i]->name = mark.text;
    unknown[i]->pattern = mark.pattern;
    unknown[i]->azimuth = mark.azimuth;
    unknown[i]->vertical = mark.place == Direction::kVertical;
  }
  std::ranges::move(matches.doubts, std::back_inserter(doubts));
}

std::string channel_name(const FoundComponent& channel) {
  return fmt::format("{} channel {}{}", channel.path.stem().string(), channel.channel.value_or(1),
                     channel.name.empty() ? "" : " (" + channel.name + ")");
}

namespace fs = std::filesystem;

constexpr std::string_view kSeparators = "-_. ";
constexpr std::array<std::string_view, 8> kVerticals = {"UP",  "DWN", "DOWN", "VER",
                                                        "VRT", "UD",  "V",    "Z"};

bool all_digits(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c); });
}

/// Whether two characters side by side are of one word or one number.
bool touches(unsigned char a, unsigned char b) {
  return (std::isdigit(a) && std::isdigit(b)) || (std::isalpha(a) && std::isalpha(b));
}

/// Three digits, UP and its like are known at the end of a name whatever is before them.
bool is_known_at_end(std::string_view part) {
  return (part.size() == 3 && all_digits(part)) ||
         (part.size() > 1 && std::ranges::find(kVerticals, part) != kVerticals.end());
}

/// Where `part` stands last in `text` with no character of its own kind beside it: no letter beside
/// a letter, no digit beside a digit.
std::size_t find_apart(std::string_view text, std::string_view part) {
  const auto at_byte = [](std::string_view s, std::size_t i) {
    return static_cast<unsigned char>(s[i]);
  };
  for (auto at = text.rfind(part); at != text.npos;
       at = at > 0 ? text.rfind(part, at - 1) : text.npos) {
    const std::size_t end = at + part.size();
    const bool at_end = end == text.size();
    const bool before = at > 0 && touches(at_byte(text, at - 1), at_byte(part, 0));
    const bool after = !at_end && touches(at_byte(text, end), at_byte(part, part.size() - 1));
    const bool may_touch = at > 0 && at_end && is_known_at_end(part);
    if ((!before || may_touch) && !after) return at;
  }
  return text.npos;
}

std::vector<std::string> spellings_of(const Component& component) {
  std::vector<std::string> spellings = {component.name};
  if (component.direction == Direction::kVertical) append_all(spellings, kVerticals);
  if (!component.azimuth) return spellings;
  const double degrees = std::round(*component.azimuth / kRadiansPerDegree);
  spellings.push_back(fmt::format("{:03.0f}", degrees));
  if (degrees == 0) spellings.emplace_back("360");
  return spellings;
}

}  // namespace

FoundComponent found_component(const std::filesystem::path& path, const Component& component,
                               std::optional<int> channel, const ReadOptions& options) {
  return {.path = path,
          .channel = channel,
          .name = component.name,
          .pattern = channel ? "" : name_pattern(path.filename().string(), component),
          .content = content_of(component),
          .site = site_of(component),
          .place = place_of(component),
          .vertical = component.direction == Direction::kVertical ||
                      (!component.azimuth && sounds_vertical(component.name)),
          .lacks_direction = !channel && lacks_direction(component),
          .azimuth = component.azimuth,
          .start_time = component.start_time,
          .duration = component.duration(),
          .time_step = component.time_step,
          .samples = component.acceleration.size(),
          .options = options};
}

std::vector<SuiteRecord> records_of_file(const std::vector<FoundComponent>& channels) {
  const std::string stem = channels[0].path.stem().string();
  if (can_be_record(channels) || !std::ranges::all_of(channels, says_where)) {
    SuiteRecord record{.name = stem, .files = {}, .options = channels[0].options, .facts = {}};
    record.files.push_back({.path = channels[0].path});
    return {record};
  }
  std::vector<SuiteRecord> records;
  for (const Group& site :
       by_key(channels, [](const FoundComponent& channel) { return channel.site + " "; })) {
    if (can_be_record(site) && !site[0].site.empty()) {
      records.push_back(record_of(site, with_place(stem, site[0])));
      continue;
    }
    for (const FoundComponent& channel : site)
      records.push_back(record_of({channel}, channel_name(channel)));
  }
  return records;
}

std::vector<SuiteRecord> records_of_components(std::vector<FoundComponent> components,
                                               std::vector<std::string>& doubts) {
  take_directions_from_names(components, doubts);
  const std::vector<Group> by_name = by_key(
      components, [](const FoundComponent& each) { return place_key(each, upper(each.pattern)); });
  const auto by_content = by_key(by_name, [](const Group& group) {
    const bool is_one = std::ranges::all_of(
        group, [&](const auto& each) { return each.content == group[0].content; });
    return is_one ? place_key(group[0], group[0].content) : std::string();
  });
  std::vector<Group> groups;
  for (std::vector<Group> alike : by_content) {
    if (alike.size() > 1) join_alike(alike);
    append_all(groups, alike);
  }
  std::vector<SuiteRecord> records;
  for (const Group& group : groups) records.push_back(record_of(group, name_of(group)));
  name_apart(groups, records);
  return records;
}

std::string name_without_component(const std::string& file_name, const std::string& component) {
  std::string plain = upper(component);
  std::erase_if(plain, [](char c) { return c == '-'; });  // "E-W" is "EW" in file names
  if (plain.empty()) return {};
  const std::string extension = fs::path(file_name).extension().string();
  if (upper(extension) == "." + plain)
    return file_name.substr(0, file_name.size() - extension.size()) + "*";
  const std::string stem = file_name.substr(0, file_name.size() - extension.size());
  const std::string padded =
      all_digits(plain) && plain.size() < 3 ? std::string(3 - plain.size(), '0') + plain : plain;
  for (const std::string& text : {padded, plain})
    if (const auto at = find_apart(upper(stem), text); at != std::string::npos) {
      std::size_t begin = at;
      while (begin > 0 && kSeparators.find(stem[begin - 1]) != std::string_view::npos) --begin;
      if (begin == 0) begin = at;
      return stem.substr(0, begin) + "*" + stem.substr(at + text.size()) + extension;
    }
  return {};
}

std::string name_pattern(const std::string& file_name, const Component& component) {
  for (const std::string& spelling : spellings_of(component))
    if (std::string pattern = name_without_component(file_name, spelling); !pattern.empty())
      return pattern;
  return {};
}

std::string name_of_pattern(std::string pattern) {
  const auto star = pattern.find('*');
  if (star != std::string::npos) pattern.erase(star, 1);
  std::string name = fs::path(pattern).stem().string();
  while (!name.empty() && kSeparators.find(name.back()) != std::string_view::npos) name.pop_back();
  return name.empty() ? pattern : name;
}

}  // namespace gurney::groundmotions
