#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/base/diagnostics.h"
#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/hospital/hospital.h"

namespace gurney::study {
namespace {

using Node = FaultTree::Node;
using Nodes = std::vector<Node>;

/// Puts rooms and services into the tree, those first that others need.
class TreeBuilder {
 public:
  TreeBuilder(const Hospital& hospital, const std::vector<std::string>& states,
              const std::vector<std::vector<Reached>>& lost, HospitalTree& into)
      : hospital_(hospital), states_(states), lost_(lost), into_(into) {
    for (std::size_t room = 0; room < hospital.rooms.size(); ++room) {
      first_.emplace_back();
      for (int copy = 0; copy < hospital.rooms[room].count; ++copy) {
        first_.back().emplace_back();
        for (std::size_t item = 0; item < hospital.rooms[room].items.size(); ++item) {
          first_.back().back().push_back(into.pieces.size());
          for (int i = 0; i < hospital.rooms[room].items[item].count; ++i)
            into.pieces.push_back({room, item});
        }
      }
    }
  }

  void build() {
    for (std::size_t i = 0; i < hospital_.rooms.size(); ++i) into_.rooms.push_back(room(i));
    for (std::size_t i = 0; i < hospital_.services.size(); ++i)
      into_.services.push_back(service(i));
    errors_.raise();
  }

 private:
  /// Where a name is looked up: inside a copy of a room, or in the hospital.
  struct Scope {
    const config::Spot* spot;
    std::optional<std::size_t> room;
    std::size_t copy = 0;
  };

  Node anything() { return into_.tree.piece(0, 0); }  // stands for what is in error

  Nodes fail(const Scope& scope, const Requirement& at, const std::string& message) {
    errors_.add_new(fmt::format("{}: {}: at character {}: {}", scope.spot->where, scope.spot->name,
                                at.column, message));
    return {anything()};
  }

  Nodes pieces_of(std::size_t room, std::size_t copy, std::size_t item, Reached lost) {
    Nodes nodes;
    for (int i = 0; i < hospital_.rooms[room].items[item].count; ++i)
      nodes.push_back(
          into_.tree.piece(first_[room][copy][item] + static_cast<std::size_t>(i), lost));
    return nodes;
  }

  static std::optional<std::size_t> index_of(const auto& list, const std::string& name) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i].name == name) return i;
    return {};
  }

  /// Pieces of `bay/pole` in all copies of the room, or of `pole` in the copy of the scope.
  std::optional<Nodes> items(const Scope& scope, const std::string& name,
                             std::optional<Reached> lost) {
    std::optional<std::size_t> room = scope.room;
    std::string item = name;
    if (const std::size_t slash = name.find('/'); slash != std::string::npos) {
      room = index_of(hospital_.rooms, name.substr(0, slash));
      item = name.substr(slash + 1);
    }
    const auto found = room ? index_of(hospital_.rooms[*room].items, item) : std::nullopt;
    if (!found) return {};
    const bool here = scope.room == room && name == item;
    Nodes nodes;
    for (std::size_t copy = 0; copy < first_[*room].size(); ++copy)
      if (!here || copy == scope.copy)
        for (const Node node : pieces_of(*room, copy, *found, lost.value_or(lost_[*room][*found])))
          nodes.push_back(node);
    return nodes;
  }

  std::vector<std::string> known(const Scope& scope) const {
    std::vector<std::string> names;
    if (scope.room)
      for (const HospitalItem& item : hospital_.rooms[*scope.room].items)
        names.push_back(item.name);
    for (const Room& room : hospital_.rooms) {
      names.push_back(room.name);
      for (const HospitalItem& item : room.items)
        if (!scope.room) names.push_back(room.name + "/" + item.name);
    }
    for (const HospitalService& each : hospital_.services) names.push_back(each.name);
    return names;
  }

  Nodes named(const Scope& scope, const Requirement& of) {
    if (auto pieces = items(scope, of.name, {})) return *pieces;
    if (const auto found = index_of(hospital_.rooms, of.name))
      return without_circle(scope, of, *found);
    if (const auto found = index_of(hospital_.services, of.name))
      return without_circle(scope, of, hospital_.rooms.size() + *found);
    return fail(scope, of,
                fmt::format("'{}': no such item, room or service{}", of.name,
                            config::suggestion(of.name, known(scope))));
  }

  std::string name_of(std::size_t unit) const {
    return unit < hospital_.rooms.size() ? hospital_.rooms[unit].name
                                         : hospital_.services[unit - hospital_.rooms.size()].name;
  }

  /// Nodes of a room or service; one that is being built already needs itself, which is an error.
  Nodes without_circle(const Scope& scope, const Requirement& of, std::size_t unit) {
    const auto begun = std::ranges::find(open_, unit);
    if (begun == open_.end())
      return unit < hospital_.rooms.size() ? room(unit)
                                           : Nodes{service(unit - hospital_.rooms.size())};
    std::string path;
    for (auto each = begun; each != open_.end(); ++each) path += name_of(*each) + " -> ";
    return fail(scope, of, fmt::format("a circle: {}{}", path, name_of(unit)));
  }

  Nodes nodes(const Scope& scope, const Requirement& of) {
    using Kind = Requirement::Kind;
    if (of.kind == Kind::kName) return named(scope, of);
    if (of.kind == Kind::kNotReached) {
      const auto state = std::ranges::find(states_, of.state);
      if (state == states_.end())
        return fail(scope, of,
                    fmt::format("'{}': no such limit state{}", of.state,
                                config::suggestion(of.state, states_)));
      const Reached lost = Reached{1} << (state - states_.begin());
      if (auto pieces = items(scope, of.name, lost)) return *pieces;
      return fail(
          scope, of,
          fmt::format("'{}': no such item{}", of.name, config::suggestion(of.name, known(scope))));
    }
    Nodes parts;
    for (const Requirement& part : of.parts)
      for (const Node node : nodes(scope, part)) parts.push_back(node);
    const int all = static_cast<int>(parts.size());
    const int least = of.kind == Kind::kAll ? all : of.kind == Kind::kAny ? 1 : of.at_least;
    if (least > all)
      return fail(scope, of,
                  fmt::format("at_least({}, ...) of {} parts: must be 1 to {}", least, all, all));
    return {into_.tree.gate(least, std::move(parts))};
  }

  Node one(const Scope& scope, const Requirement& of) {
    Nodes all = nodes(scope, of);
    if (all.size() == 1) return all.front();
    const int parts = static_cast<int>(all.size());
    return into_.tree.gate(parts, std::move(all));
  }

  /// Each copy; without `works` a room needs all its pieces.
  Nodes room(std::size_t index) {
    if (const auto known = rooms_.find(index); known != rooms_.end()) return known->second;
    const Room& of = hospital_.rooms[index];
    open_.push_back(index);
    Nodes copies;
    for (std::size_t copy = 0; copy < static_cast<std::size_t>(of.count); ++copy) {
      const Scope scope{&of.spot, index, copy};
      Requirement all{.kind = Requirement::Kind::kAll, .name = {}, .state = {}, .parts = {}};
      for (const HospitalItem& item : of.items)
        all.parts.push_back({.name = item.name, .state = {}, .parts = {}});
      copies.push_back(one(scope, of.works.value_or(all)));
    }
    open_.pop_back();
    return rooms_[index] = copies;
  }

  Node service(std::size_t index) {
    if (const auto known = services_.find(index); known != services_.end()) return known->second;
    const HospitalService& of = hospital_.services[index];
    open_.push_back(hospital_.rooms.size() + index);
    const Node node = one({&of.spot, {}, 0}, of.works);
    open_.pop_back();
    return services_[index] = node;
  }

  const Hospital& hospital_;
  const std::vector<std::string>& states_;
  const std::vector<std::vector<Reached>>& lost_;
  HospitalTree& into_;
  std::vector<std::vector<std::vector<std::size_t>>> first_;  ///< piece of room, copy, item
  std::map<std::size_t, Nodes> rooms_;
  std::map<std::size_t, Node> services_;
  std::vector<std::size_t> open_;
  Diagnostics errors_;
};

}  // namespace

HospitalTree::HospitalTree(const Hospital& hospital, const std::vector<std::string>& states,
                           const std::vector<std::vector<Reached>>& lost) {
  TreeBuilder(hospital, states, lost, *this).build();
}

int Hospital::beds() const {
  int sum = 0;
  for (const Room& room : rooms) sum += room.count * room.beds;
  return sum;
}

}  // namespace gurney::study
