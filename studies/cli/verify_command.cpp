#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "engine/base/parallel.h"
#include "studies/cli/commands.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/verification_figures.h"
#include "studies/render/render.h"
#include "studies/report/verification_report.h"
#include "studies/results/output_files.h"
#include "studies/verification/family.h"
#include "studies/verification/verify.h"

namespace gurney::cli {
namespace {

using verification::CaseRun;

constexpr int kFailed = 3;

struct VerifyOptions {
  verification::Selection selection;
  bool json = false, markdown = false, overwrite = false, list = false;
  std::string figures;
  NamedFigures style;
  int threads = 0;
};

std::string figure_path(const VerifyOptions& options, const CaseRun& run) {
  std::string name = run.name();
  name[name.find('/')] = '_';
  return fmt::format("{}/{}{}", options.figures, name, options.style.suffix());
}

void write_figures(const VerifyOptions& options, const std::vector<CaseRun>& runs) {
  study::OutputFiles files(options.overwrite);
  for (const CaseRun& run : runs)
    if (const std::string figure = figures::verification_figure(run); !figure.empty())
      files.stage(figure_path(options, run), options.style.bytes(figure));
  files.commit();
}

/// A line for each group with its families; each family's cases are FAMILY/CASE.
int list_names(const std::vector<verification::Family>& families) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const verification::Family& family : families) {
    const auto group = std::ranges::find(groups, family.statement.group,
                                         [](const auto& each) { return each.first; });
    const std::string name = fmt::format("{} ({})", family.statement.name, family.cases.size());
    if (group == groups.end())
      groups.push_back({family.statement.group, {name}});
    else
      group->second.push_back(name);
  }
  fmt::print("group: families (number of cases)\n");
  for (const auto& [group, names] : groups)
    fmt::print("{}:\n  {}\n", group, fmt::join(names, "\n  "));
  return 0;
}

int verify(const VerifyOptions& options) {
  options.style.check();
  const std::vector<verification::Family> families = verification::all_families();
  if (options.list) return list_names(families);
  std::vector<CaseRun> runs = choose(families, options.selection);
  if (!options.figures.empty()) {
    std::filesystem::create_directories(options.figures);
    const study::OutputFiles files(options.overwrite);
    for (const CaseRun& each : runs) files.check(figure_path(options, each));
  }
  const int threads = threads_or_all(options.threads);
  const bool in_full = !options.selection.names.empty() && !options.selection.seed;
  const bool text = !options.json && !options.markdown;
  run_all(runs, !options.selection.seed, threads, [&](const CaseRun& each) {
    fmt::print(text ? stdout : stderr, "{}", report::verification_text(each, in_full && text));
    std::fflush(text ? stdout : stderr);
  });
  if (!options.figures.empty()) write_figures(options, runs);
  if (options.json) fmt::print("{}", render::json(report::verification_facts(runs)));
  if (options.markdown) fmt::print("{}", report::verification_markdown(runs));
  if (text) fmt::print("{}", report::verification_summary(runs));
  return std::ranges::all_of(runs, [](const CaseRun& each) { return each.findings.passed(); })
             ? 0
             : kFailed;
}

}  // namespace

void add_verify(Commands& commands) {
  commands.add<VerifyOptions>(
      {"verify", "Verify the engine against closed-form solutions",
       "gurney verify\ngurney verify --list\ngurney verify skid_to_roll --draw 7 --count 3"},
      verify, [](Options& add, VerifyOptions& options) {
        add("NAME", options.selection.names,
            "Groups, families or cases to report in full (default: all)");
        add("--list", options.list, "Print the names of groups and families");
        add("--json", options.json, "Print JSON, with every check");
        add("--markdown", options.markdown, "Print docs/verification_tables.md");
        add("--figures FOLDER", options.figures,
            "Draw computed and reference of each case into this folder");
        add_figure_format(add, options.style);
        add("--overwrite", options.overwrite, "Replace figures that exist");
        CLI::Option* const draw =
            add("--draw", options.selection.seed,
                "Run parameters drawn in the ranges of each closed form with this seed");
        add("--count", options.selection.draws,
            "Number of consecutive seeds, starting with that of --draw (default: 1)")
            ->needs(draw)
            ->check(CLI::Range(1, 1000000));
        add.threads(options.threads, "Threads (default: all hardware threads)");
      });
}

}  // namespace gurney::cli
