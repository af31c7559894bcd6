#include "studies/verification/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/config/nearest_name.h"

namespace gurney::verification {
namespace {

bool is_named(const CaseRun& each, const std::string& name) {
  const Statement& statement = each.family->statement;
  return name == statement.group || name == statement.name || name == each.name();
}

bool may_hold(const Family& family, const std::string& name) {
  const Statement& statement = family.statement;
  return name == statement.group || name == statement.name ||
         name.starts_with(statement.name + "/");
}

std::vector<std::string> known_names(const std::vector<CaseRun>& all) {
  std::vector<std::string> known;
  for (const CaseRun& each : all)
    for (const std::string& name :
         {each.family->statement.group, each.family->statement.name, each.name()})
      if (std::ranges::find(known, name) == known.end()) known.push_back(name);
  return known;
}

Findings findings_of(const CaseRun& chosen, Solver solver) {
  try {
    Runner runner(solver);
    chosen.family->run(chosen.set.values, runner);
    return std::move(runner.findings);
  } catch (const std::exception& error) {
    return {{{"runs that could not be made", "", 1, 0, 0, error.what()}}, {}};
  }
}

}  // namespace

std::vector<CaseRun> choose(const std::vector<Family>& families, const Selection& selection) {
  std::vector<CaseRun> all;
  for (const Family& family : families) {
    if (!selection.names.empty() && std::ranges::none_of(selection.names, [&](const auto& name) {
          return may_hold(family, name);
        }))
      continue;  // some take long to draw
    if (!selection.seed) {
      for (const Case& each : family.cases) all.push_back({&family, each, {}, {}, 0});
    } else if (family.drawn) {
      for (int i = 0; i < selection.draws; ++i)
        all.push_back(
            {&family, draw_case(family, *selection.seed + static_cast<unsigned>(i)), {}, {}, 0});
    }
  }
  for (const std::string& name : selection.names) {
    if (std::ranges::any_of(all, [&](const CaseRun& each) { return is_named(each, name); }))
      continue;
    Selection everything = selection;
    everything.names.clear();
    throw Error(
        fmt::format("no case, family or group is named '{}'{}; gurney verify --list lists them",
                    name, config::near_name(name, known_names(choose(families, everything)))));
  }
  if (!selection.names.empty())
    std::erase_if(all, [&](const CaseRun& each) {
      return std::ranges::none_of(selection.names,
                                  [&](const std::string& name) { return is_named(each, name); });
    });
  return all;
}

void run(CaseRun& chosen, bool stock) {
  const auto start = std::chrono::steady_clock::now();
  chosen.findings = findings_of(chosen, Solver::kImplicit);
  chosen.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!stock || !chosen.family->on_stock) return;
  chosen.stock = {{"bullet", findings_of(chosen, Solver::kBullet)},
                  {"bullet-dantzig", findings_of(chosen, Solver::kBulletDantzig)}};
}

void run_all(std::vector<CaseRun>& chosen, bool stock, int threads,
             const std::function<void(const CaseRun&)>& done) {
  std::vector<char> ready(chosen.size(), 0);
  std::size_t reported = 0;
  std::mutex reporting;
  parallel_for(chosen.size(), threads, [&](std::size_t i) {
    run(chosen[i], stock);
    const std::lock_guard lock(reporting);
    ready[i] = 1;
    for (; reported < chosen.size() && ready[reported]; ++reported) done(chosen[reported]);
  });
}

}  // namespace gurney::verification
