#include "studies/report/hospital_report.h"

#include <fmt/format.h>

#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using findings::Format;
using findings::Section;
using findings::Table;
using findings::Value;

const Format kShare{".3f"}, kNumber{".3g"}, kMoney{".4g"};

Value value_of(const std::optional<double>& number) { return number ? Value(*number) : Value(); }

Table services_of(const study::HospitalAnswer& answer, bool rooms) {
  Table table{rooms ? "rooms" : "services",
              rooms ? "Chance that a room works" : "Chance that a service works",
              {{"name", rooms ? "room" : "service"},
               {"pgv", "PGV [m/s]", {"g"}},
               {"works", "works", kShare},
               {"interval", "95 %", interval_format(kShare)},
               {"independent", rooms ? "" : "if independent", kShare,
                "given the intensity, pieces fail independently of each other"},
               {"dependent", rooms ? "" : "if together", kShare,
                "given the intensity, the motion alone decides"}}};
  const auto count = answer.levels.empty() ? 0
                     : rooms               ? answer.levels.front().rooms.size()
                                           : answer.levels.front().services.size();
  for (std::size_t i = 0; i < count; ++i)
    for (const study::LevelAnswer& level : answer.levels) {
      const study::ServiceAnswer& of = rooms ? level.rooms[i] : level.services[i];
      table.add({of.name, level.pgv, of.works.value, ends(of.works.interval),
                 value_of(of.independent), value_of(of.dependent)});
    }
  return table;
}

Table levels_of(const study::HospitalAnswer& answer) {
  Table table{"levels",
              "Beds out of use and loss",
              {{"pgv", "PGV [m/s]", {"g"}},
               {"beds_out", answer.beds > 0 ? "beds out" : "", kNumber},
               {"beds_out_interval", answer.beds > 0 ? "95 %" : "", interval_format(kNumber)},
               {"beds_out_p95", answer.beds > 0 ? "in 1 of 20 more than" : "", {"g"}},
               {"loss", "loss", kMoney},
               {"loss_interval", "95 %", interval_format(kMoney)},
               {"loss_p95", "in 1 of 20 more than", kMoney}}};
  for (const study::LevelAnswer& level : answer.levels)
    table.add({level.pgv, level.beds_out.value, ends(level.beds_out.interval), level.beds_out_p95,
               level.loss.value, ends(level.loss.interval), level.loss_p95});
  return table;
}

Table ranking_of(const study::HospitalAnswer& answer) {
  Table table{"ranking",
              fmt::format("What to secure first, by {} at a PGV of {:g} m/s", answer.ranked_by,
                          answer.ranked_at),
              {{"place", ""},
               {"action", "action"},
               {"group", "pieces of"},
               {"pieces", "pieces"},
               {"cost", "cost", kMoney},
               {"gain", "gain", kNumber},
               {"gain_interval", "95 %", interval_format(kNumber)},
               {"gain_per_cost", "per 1000", kNumber, "gain for 1000 of the currency"},
               {"left", "left", kNumber, "of what is ranked by, after this and those before"},
               {"beds", ""},
               {"loss", "loss avoided", kMoney},
               {"taken", "do it"}}};
  for (std::size_t i = 0; i < answer.ranking.size(); ++i) {
    const study::RankedAction& action = answer.ranking[i];
    table.add({i + 1, action.name, action.group, action.pieces, action.cost, action.gain.value,
               ends(action.gain.interval),
               action.cost > 0 ? Value(1000 * action.gain.value / action.cost) : Value(),
               action.left, action.beds, action.loss,
               action.taken ? (action.gain.interval.low > 0 ? "yes" : "not settled") : "no gain"});
  }
  return table;
}

void add_annual(const study::AnnualAnswer& annual, bool has_beds, Section& all) {
  Table table{"annual",
              "A year",
              {{"what", "on average"},
               {"per_year", "a year", kNumber},
               {"interval", "95 %", interval_format(kNumber)}}};
  for (const auto& [name, rate] : annual.lost)
    table.add({name + " lost", rate.value, ends(rate.interval)});
  if (has_beds)
    table.add({"beds out of use", annual.beds_out.value, ends(annual.beds_out.interval)});
  table.add({"loss", annual.loss.value, ends(annual.loss.interval)});
  all.add(std::move(table));
}

}  // namespace

findings::Section hospital_findings(const study::Hospital& hospital,
                                    const study::HospitalAnswer& answer) {
  Section all("", hospital.title);
  int rooms = 0;
  for (const study::Room& room : hospital.rooms) rooms += room.count;
  all.json("title", hospital.title);
  all.fact("pieces", "pieces", answer.pieces);
  all.fact("room_count", "rooms", rooms);  // "rooms" is their table
  if (answer.beds > 0) all.fact("beds", "beds", answer.beds);
  all.fact("samples", "samples", answer.samples);
  if (answer.records > 0)
    all.fact("records", "records", answer.records);
  else
    all.fact("correlation", "correlation", hospital.correlation, {"g"});
  all.fact("currency", "loss in", answer.money);
  if (!hospital.services.empty()) {
    all.add(services_of(answer, false));
    if (answer.records == 0)
      all.say(
          "Independent and together are no bounds: what needs all of several groups, each with "
          "spares, may work less often between them.");
  }
  all.add(services_of(answer, true)).add(levels_of(answer));
  if (answer.annual) add_annual(*answer.annual, answer.beds > 0, all);
  if (!answer.ranking.empty()) {
    all.json("ranked_at", answer.ranked_at).json("ranked_by", answer.ranked_by);
    all.fact("before", answer.ranked_by + ", nothing done", answer.before, kNumber);
    all.add(ranking_of(answer));
  }
  all.list("cautions", findings::kCautions, answer.cautions);
  all.say(answer.records > 0
              ? "All pieces of a sample have the motion of one record; given it, each has one of "
                "the runs of its setting."
              : "All pieces of a sample have one motion; given its intensity, capacities share the "
                "stated correlation.");
  all.say(
      "Intervals hold the records of the runs and the samples, not prices, repairs and what a "
      "tether holds.");
  return all;
}

}  // namespace gurney::report
