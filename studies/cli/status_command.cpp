#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/printable.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/study_output.h"
#include "studies/report/study_report.h"
#include "studies/run/shard_status.h"

namespace gurney::cli {
namespace {

using study::RecordTime;
using study::ShardStatus;

struct StatusOptions {
  std::string folder;
  bool json = false;
};

std::string state_of(const ShardStatus& shard) {
  if (!shard.started) return "not started";
  if (shard.other_study) return "of another study: not counted, and refused by merge";
  if (shard.done == shard.tasks) return "finished";
  return shard.process.empty() ? "stopped" : "running: " + shard.process;
}

/// Time that a running shard still takes [s]; 0: unknown, or nothing runs.
double to_go(const ShardStatus& shard) {
  if (shard.process.empty()) return 0;
  return shard.seconds_per_task *
         static_cast<double>(shard.tasks - std::min(shard.done, shard.tasks));
}

findings::Table table_of(const std::vector<ShardStatus>& shards) {
  findings::Table table{"shards",
                        "",
                        {{"shard", "shard"},
                         {"", "cases"},
                         {"analysis_cases", ""},
                         {"finished", ""},
                         {"runs", "runs"},
                         {"overturned", "overturned"},
                         {"", "failed"},
                         {"failed", ""},
                         {"untrusted", ""},
                         {"runs_per_second", "runs/s", {".1f"}},
                         {"", "to go"},
                         {"seconds_to_go", ""},
                         {"state", "state"}}};
  for (const ShardStatus& s : shards) {
    const double time = to_go(s);
    table.add({fmt::format("{}/{}", s.shard.number, s.shard.count),
               fmt::format("{} of {}", s.done, s.tasks), s.tasks, s.done, s.counts.runs,
               s.counts.overturned, report::failed_runs(s.counts.failed, s.counts.untrusted),
               s.counts.failed, s.counts.untrusted, s.runs_per_second,
               time > 0 ? duration_text(time) : std::string("-"), time, state_of(s)});
  }
  return table;
}

struct Total {
  std::size_t tasks = 0, done = 0, runs = 0, failed = 0, finished = 0, running = 0, damaged = 0,
              foreign = 0;
  double rate = 0, to_go = 0;  ///< of those that run; the longest
};

Total total_of(const std::vector<ShardStatus>& shards) {
  Total all;
  for (const ShardStatus& s : shards) {
    all.tasks += s.tasks;
    all.done += s.done;
    all.runs += s.counts.runs;
    all.failed += s.counts.failed;
    all.damaged += s.damaged;
    all.foreign += s.foreign;
    all.finished += s.done == s.tasks;
    if (s.process.empty()) continue;
    ++all.running;
    all.rate += s.runs_per_second;
    all.to_go = std::max(all.to_go, to_go(s));
  }
  return all;
}

/// Records of all shards, those with the slowest runs first.
std::vector<std::pair<std::string, RecordTime>> slowest_records(
    const std::vector<ShardStatus>& shards) {
  constexpr std::size_t kMost = 5;
  std::map<std::string, RecordTime> all;
  for (const ShardStatus& shard : shards)
    for (const auto& [name, time] : shard.records) {
      all[name].runs += time.runs;
      all[name].seconds += time.seconds;
    }
  std::vector<std::pair<std::string, RecordTime>> sorted(all.begin(), all.end());
  std::ranges::stable_sort(sorted, std::greater<>(),
                           [](const auto& each) { return each.second.mean(); });
  if (sorted.size() > kMost) sorted.resize(kMost);
  return sorted;
}

findings::Table table_of(const std::vector<std::pair<std::string, RecordTime>>& records) {
  findings::Table table{"slowest_records",
                        "",
                        {{"record", "slowest records"},
                         {"runs", "runs"},
                         {"cpu_seconds_per_run", "CPU time of a run", {".3g", "s"}}}};
  for (const auto& [name, time] : records)
    table.add({name.empty() ? "floor at rest" : printable(name), time.runs, time.mean()});
  return table;
}

int status_command(const StatusOptions& options) {
  const std::vector<ShardStatus> shards = study::shard_status(options.folder);
  const Total all = total_of(shards);
  findings::Section known;
  known.add(table_of(shards));
  known.json("analysis_cases", all.tasks).json("finished", all.done).json("runs", all.runs);
  known.json("failed", all.failed).json("damaged_parts", all.damaged);
  known.json("foreign_analysis_cases", all.foreign).json("runs_per_second", all.rate);
  known.json("seconds_to_go", all.to_go);
  known.say(
      fmt::format("{} of {} analysis cases, {} runs, {} failed; {} of {} shards finished, {} "
                  "running{}{}",
                  all.done, all.tasks, all.runs, all.failed, all.finished, shards.size(),
                  all.running, all.rate > 0 ? fmt::format(", {:.1f} runs/s", all.rate) : "",
                  all.to_go > 0 ? fmt::format(", {} to go", duration_text(all.to_go)) : ""));
  if (all.damaged > 0)
    known.say(fmt::format("{} damaged parts, whose runs will be repeated", all.damaged));
  if (all.foreign > 0)
    known.say(fmt::format(
        "{} analysis cases stand in the folder of another shard and are not counted", all.foreign));
  const auto records = slowest_records(shards);
  if (records.size() > 1 || options.json) known.add(table_of(records));
  print_findings(known, options.json);
  return 0;
}

}  // namespace

void add_status(Commands& commands) {
  commands.add<StatusOptions>(
      {"status", "Report the progress of shards, also while they run",
       "gurney status ventilator.h5.shards"},
      status_command, [](Options& add, StatusOptions& options) {
        add.required("FOLDER", options.folder,
                     "The folder of the shards, FILE.h5.shards, or of one study, FILE.h5.parts");
        add("--json", options.json, "Print it as JSON");
      });
}

}  // namespace gurney::cli
