#include "studies/report/loss_report.h"

#include <fmt/format.h>

#include "studies/report/formats.h"

namespace gurney::report {
namespace {

using findings::Format;
using findings::Section;
using findings::Table;
using findings::Value;

const Format kLossMoney{".0f"}, kMeanMoney{".4g"}, kLossDays{".3g"}, kLossPercent{".3g", "%", 0.01};

Value interval_of(const study::LossEstimate& estimate) {
  return estimate.interval ? ends(*estimate.interval) : Value();
}

Table levels_of(const study::StudyLoss& loss) {
  Table table{"levels",
              "Loss by level",
              {{"level", loss.measure.name},
               {"runs", "runs"},
               {"mean_cost", "mean loss", kLossMoney},
               {"mean_cost_interval", "95 %", interval_format(kLossMoney)},
               {"mean_cost_range", "at ranges' ends", interval_format(kLossMoney),
                "mean loss with every price and ratio at the low or high end of its range"},
               {"median_cost", "median", kLossMoney},
               {"p90_cost", "90 %", kLossMoney},
               {"largest_cost", "largest", kLossMoney},
               {"p_loss", "P(loss)", kLossPercent},
               {"p_loss_interval", "95 %", interval_format(kLossPercent)},
               {"p_out_of_use", "P(out of use)", kLossPercent, "of one item or more"},
               {"p_out_of_use_interval", "95 %", interval_format(kLossPercent)},
               {"p_serious_injury", "P(injury)", kLossPercent,
                "a state that may injure seriously is reached: nobody needs to stand there"},
               {"p_serious_injury_interval", "95 %", interval_format(kLossPercent)},
               {"mean_days", "days", kLossDays, "until used again or checked, sum over the items"},
               {"mean_days_interval", "", interval_format(kLossDays)}}};
  for (const study::LossAtLevel& at : loss.levels)
    table.add({at.level, at.runs, at.cost.value, interval_of(at.cost),
               findings::Numbers{at.low, at.high}, at.median, at.p90, at.largest, at.any.estimate,
               ends(at.any.interval), at.out_of_use.estimate, ends(at.out_of_use.interval),
               at.serious.estimate, ends(at.serious.interval), at.days.value,
               interval_of(at.days)});
  return table;
}

/// @param in_json  unit of the medians in JSON
Table steps_of(const study::StudyLoss& loss, const study::ReportUnit& unit,
               const study::ReportUnit& in_json) {
  Table table{"steps",
              "Where it comes from",
              {{"item", "item"},
               {"states", "reached"},
               {"cost", "adds", kLossMoney, "to what milder states cost"},
               {"exceeded", "runs"},
               {"theta", "median", format_of(unit, in_json.in_si)},
               {"beta", "beta", {".3g"}},
               {"status", ""},
               {"rate_per_year", "a year", {".3g"}}}};
  for (const study::FittedStep& step : loss.steps) {
    const auto& curve = step.curve.curve();
    table.add({step.item, step.states, step.cost, step.happened,
               curve ? Value(curve->theta) : Value(), curve ? Value(curve->beta) : Value(),
               text(step.curve.status()), step.rate ? Value(*step.rate) : Value()});
  }
  return table;
}

/// @param per  "" or " a year"
Table exceedance_of(const study::ExpectedLoss& of, const std::string& per) {
  const bool annual = !per.empty();
  const Format chance{".3g"};
  Table table{
      "exceedance",
      annual ? "How often the loss is above a value" : "How likely the loss is above a value",
      {{"cost", "loss above", kLossMoney},
       {annual ? "rate_per_year" : "probability", annual ? "times a year" : "P", chance},
       {annual ? "rate_per_year_interval" : "probability_interval", "95 %",
        interval_format(chance)},
       {"fitted", "curve", {}, "no: the shares of the runs count"}}};
  for (const study::LossExceedance& at : of.exceedance)
    table.add({at.cost, at.chance.value, interval_of(at.chance), at.fitted});
  return table;
}

/// @param per  "" or " a year"
void add_expected(const study::ExpectedLoss& of, const std::string& per, Section& section) {
  const auto add = [&](const char* key, const std::string& label,
                       const study::LossEstimate& estimate, const Format& format) {
    section.fact(key, label, estimate.value, format,
                 estimate.interval
                     ? "95 %: " + written(interval_of(estimate), interval_format(format))
                     : "");
    section.json(std::string(key) + "_interval", interval_of(estimate));
  };
  add("cost", "expected loss" + per, of.cost, kMeanMoney);
  add("days", "days out of use" + per, of.days, kLossDays);
  add("out_of_use", per.empty() ? "P(an item out of use)" : "times out of use" + per, of.out_of_use,
      {".3g"});
  add("serious_injury", per.empty() ? "P(serious injury possible)" : "times injury possible" + per,
      of.serious, {".3g"});
  if (!of.exceedance.empty()) section.add(exceedance_of(of, per));
}

Section loss_of(const study::StudyData& data, const study::StudyLoss& loss) {
  const study::ReportUnit unit = report_unit(data, loss.measure),
                          in_json = data.units().or_else("si").of(loss.measure.units);
  Section of("losses[]", loss.configuration);
  of.json("configuration", loss.configuration).json("runs", loss.runs);
  of.json("units", in_json.name).json("records", loss.records).json("failed", loss.failed);
  findings::Texts items;
  Table priced{"items", "", json_columns({"name", "equipment", "price"})};
  for (const study::PricedItem& item : loss.items) {
    const double price = study::mean_of(item.price);
    items.push_back(fmt::format("{} ({:.4g})", item.name, price));
    priced.add({item.name, item.equipment, price});
  }
  of.text("items and prices", findings::listed(items)).add(std::move(priced));
  if (!loss.levels.empty()) of.add(levels_of(loss));
  if (!loss.steps.empty()) of.add(steps_of(loss, unit, in_json));
  for (const study::ExpectedLoss& at : loss.at) {
    Section here("at[]", fmt::format("At {} {:g} {}", loss.measure.name, at.im / unit.in_si,
                                     unit.name == "1" ? "" : unit.name));
    here.json("im", at.im / in_json.in_si);
    add_expected(at, "", here);
    of.add(std::move(here));
  }
  if (loss.annual) {
    Section year("annual", "A year, with the hazard");
    add_expected(*loss.annual, " a year", year);
    of.add(std::move(year));
  }
  of.list("cautions", findings::kCautions, loss.cautions);
  return of;
}

}  // namespace

findings::Section loss_findings(const study::StudyData& data,
                                const study::Consequences& consequences,
                                const std::vector<study::StudyLoss>& losses) {
  Section all("", fmt::format("Losses in {}", consequences.money()));
  all.json("currency", consequences.currency()).json("year", consequences.year());
  all.json("consequences", consequences.path());
  all.json("measure", losses.empty() ? "" : losses.front().measure.name);
  for (const study::StudyLoss& loss : losses) all.add(loss_of(data, loss));
  all.say(
      "Of all states that an item reaches in a run the worst counts, and the items' losses "
      "are summed. Days hold those of checks and repairs after which an item still counts as in "
      "use: only states that take its service are out of use. Intervals are of the records, not of "
      "prices and repairs.");
  return all;
}

}  // namespace gurney::report
