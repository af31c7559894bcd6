#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/config/node.h"

namespace gurney::config {

class Table;

/// A key of a file for messages that come when its Document is gone.
struct Spot {
  Place place;
  std::string file;
  std::string where;  ///< `file:line:column` of its value
  std::string name;   ///< with the path before it
};

/// One configuration file, read strictly.
///
///     Document document("trolley.toml");
///     const double mass = document.root().number("mass_kg", Range::positive());
///     document.finish();  // throws one Error that lists all, unread keys included
///
/// A getter that meets an error notes it and gives a harmless value, so that one pass finds all;
/// nothing read may be used before `finish`. A file whose name ends in .json is JSON, any other
/// TOML.
class Document {
 public:
  /// @throws Error if the file is missing, is a folder, cannot be read, or is not TOML (JSON).
  explicit Document(const std::string& path);

  /// From text already in memory; `path` is for messages and relative names.
  Document(const std::string& text, const std::string& path);

  /// From another document's tree, changed.
  Document(Node tree, const Document& origin);

  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  Table root();
  const Node& tree() const { return tree_; }
  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }

  /// Takes an element out of the root, which then knows nothing of it.
  std::optional<Node> take(const std::string& key);

  /// A key or a text of an earlier version gets its name of today, so that old files stay readable.
  /// Does nothing where the table has a key `now` as well: `old` is unknown then.
  /// @param table  path of the table, empty for the root
  /// @returns a note on it with its place; none if the file does not have it
  std::optional<std::string> rename_key(const std::string& table, const std::string& old,
                                        const std::string& now);
  std::optional<std::string> rename_text(const std::string& table, const std::string& key,
                                         const std::string& old, const std::string& now);

  std::string where(Place place) const;  ///< `path:line:column`; of JSON `path:/item/0/name`

  void note(Place place, const std::string& message);
  void note(const Spot& spot, const std::string& message);  ///< its name and then the message
  void note(const Error& error);  ///< errors of another file that this one names
  std::size_t errors() const { return problems_.size() + foreign_.size(); }
  bool clean() const { return errors() == 0; }

  /// @throws Error with every noted error and every key nobody asked for, sorted by line.
  void finish();

  /// Every key asked for so far: `item.headings_deg`, `excitation.force[].name`.
  std::vector<std::string> asked_keys() const;

 private:
  struct Problem {
    Place place;
    std::string message;
  };

  Node* find_table(const std::string& path);
  void note_unread(const Node& table, const std::string& path);

  std::string path_, text_;
  std::vector<std::string> pointers_;  ///< of JSON: see JsonTree
  Node tree_;
  std::vector<Problem> problems_;
  std::vector<std::string> foreign_;
};

}  // namespace gurney::config
