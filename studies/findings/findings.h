#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// Facts of a run, a study, an item: plain data, built once. `studies/render` and
/// `studies/page` show it as text, JSON, Markdown and HTML, and know no subject.
namespace gurney::findings {

using Numbers = std::vector<double>;
using Counts = std::vector<std::int64_t>;
using Texts = std::vector<std::string>;
using ValueTypes = std::variant<std::monostate, bool, std::int64_t, double, std::string, Numbers,
                                Counts, std::vector<Numbers>, Texts, std::vector<Texts>>;

/// Nothing, yes or no, a count, a number in SI units, a text, or a list. A number that does not
/// exist is NaN: null in JSON, a dash in a table, and no line among facts.
struct Value : ValueTypes {
  Value();
  Value(const Value&);
  Value(Value&&) noexcept;
  Value& operator=(const Value&);
  Value& operator=(Value&&) noexcept;
  ~Value();

  template <std::integral T>
  Value(T of) {  // NOLINT: cells are written as lists, here and below
    if constexpr (std::same_as<T, bool>)
      emplace<bool>(of);
    else
      emplace<std::int64_t>(static_cast<std::int64_t>(of));
  }

  template <class T>
  requires(!std::integral<T> && std::constructible_from<ValueTypes, T>) Value(T of)
      : ValueTypes(std::move(of)) {}  // NOLINT

  template <class T>
  Value(const std::optional<T>& of) {  // NOLINT
    if (of) *this = Value(*of);
  }

  template <std::ranges::input_range T>  // a vector of Eigen
  requires(std::same_as<std::ranges::range_value_t<T>, double> && !std::same_as<T, Numbers>)
      Value(const T& of)
      : ValueTypes(Numbers(of.begin(), of.end())) {}  // NOLINT

  bool is_missing() const;  ///< nothing, NaN or infinite, or an empty text
};

/// Between the ends of an interval; one without an upper end is "1.2 or more", or "none".
inline constexpr const char* kTo = " to ";

/// How a number is written. Programs get it with all digits.
struct Format {
  /// Format of fmt. Empty: four significant ones, with an exponent only below 1e-4 and from 1e6 on.
  std::string digits = ".4g";
  std::string unit = {};       ///< that people read; empty: of none
  double in_si = 1;            ///< size of that unit
  double json_unit = 1;        ///< in which JSON has it, in SI
  std::string between = ", ";  ///< the numbers of a list
  std::string before = {};     ///< a mark of this number
  double least = 0;            ///< people read smaller ones as 0 [SI]
};

/// @param key    in JSON; empty: for people alone
/// @param label  for people; empty: for JSON alone
struct Fact {
  std::string key, label;
  Value value;
  Format format = {};
  std::string note = {};  ///< after the value
};

/// A key `a.b` is `b` of an object `a`, which is null where all members of it are missing.
struct Column {
  std::string key, label;
  Format format = {};
  std::string meaning = {};  ///< shown where a page is pointed at
};

/// The key of an example's table that stands for tables of any key.
inline constexpr const char* kAnyKey = "*";

inline constexpr std::size_t kAll = static_cast<std::size_t>(-1);

/// A value with a format of its own, or that of its column.
struct Cell {
  Value value;
  std::optional<Format> format = {};

  template <class T>
  requires std::constructible_from<Value, T> Cell(T of) : value(std::move(of)) {}  // NOLINT
  Cell(Value of, Format own) : value(std::move(of)), format(std::move(own)) {}

  const Format& format_in(const Column& column) const { return format ? *format : column.format; }
};

/// A key `name{}` makes JSON an object by the first column, `{}` keys of the object around, any other
/// an array of objects.
struct Table {
  std::string key, title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows = {};
  bool grouped = false;     ///< people read a table for each value of the first column, its title
  std::size_t most = kAll;  ///< rows that a terminal shows

  void add(std::vector<Cell> row) { rows.push_back(std::move(row)); }
};

/// The tables that people read: itself, or its groups without their column.
std::vector<Table> groups_of(const Table& table);

/// The value of a row in the column of a key; one of another kind is an error of the program.
const Value& value_in(const Table& table, std::size_t row, std::string_view key);
double number_in(const Table& table, std::size_t row, std::string_view key);  ///< NaN: missing
const std::string& text_in(const Table& table, std::size_t row, std::string_view key);

/// Texts of one or more lines below a title, which is left out with them.
struct List {
  std::string key, title;
  Texts lines;
  std::size_t most = kAll;  ///< lines that a terminal shows, but one text at least
  bool broken = false;      ///< sentences, which a terminal breaks at its width
};

/// Title of a list of what a reader has to know before any number is used.
inline constexpr const char* kCautions = "Cautions";

/// A sentence built from facts, for people.
struct Sentence {
  std::string text;
};

struct Part;

/// Parts in the order in which people read them. A key `name[]` makes JSON an array of such
/// sections; an empty one puts the parts into the object around.
struct Section {
  std::string key, title;
  std::vector<Part> parts;

  explicit Section(std::string its_key = {}, std::string its_title = {});
  Section(const Section&);
  Section(Section&&) noexcept;
  Section& operator=(const Section&);
  Section& operator=(Section&&) noexcept;
  ~Section();

  Section& fact(std::string key, std::string label, Value value, Format format = {},
                std::string note = {});
  Section& json(std::string key, Value value, Format format = {});  ///< not for people
  Section& text(std::string label, Value value, Format format = {},
                std::string note = {});  ///< not for programs
  Section& say(std::string sentence);    ///< an empty one is left out
  Section& list(std::string key, std::string title, Texts lines);
  Section& add(Table table);
  Section& add(List lines);
  Section& add(Section section);
};

struct Part : std::variant<Fact, Table, List, Sentence, Section> {
  using std::variant<Fact, Table, List, Sentence, Section>::variant;
};

/// Takes the labels of facts that are zero, so that programs alone have them.
/// @returns how many they were
std::size_t hide_zeros(Section& section);

/// The fact, table, list or section with a key; a section without a key has its parts in the one
/// around. None: null.
template <class Kind>
const Kind* find(const Section& section, std::string_view key) {
  for (const Part& part : section.parts) {
    if (const auto* found = std::get_if<Kind>(&part); found && found->key == key) return found;
    if (const auto* inner = std::get_if<Section>(&part); inner && inner->key.empty())
      if (const Kind* const found = find<Kind>(*inner, key)) return found;
  }
  return nullptr;
}
template <class Kind>
Kind& find(Section& section, std::string_view key) {
  return const_cast<Kind&>(*find<Kind>(std::as_const(section), key));
}

/// The text of a fact; empty without it.
std::string text_of(const Section& section, std::string_view key);

/// Text of a value for people, without its unit: "0.41", "yes", "a, b"; "-" for a missing one.
std::string written(const Value& value, const Format& format);

/// Text of a value with its unit: "0.41 m".
std::string with_unit(const Value& value, const Format& format);

/// "a, b and c"
std::string listed(const Texts& names);

/// Its sentences and lists as lines of text; a line of a list begins with two blanks.
Texts lines_of(const Section& section);

/// "load [N]"
std::string heading(const Column& column);

}  // namespace gurney::findings
