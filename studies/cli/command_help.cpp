#include "studies/cli/command_help.h"

#include <array>
#include <sstream>
#include <string>

namespace gurney::cli {
namespace {

struct CommandHelp {
  const char *command, *description, *examples;  ///< examples: one a line
};

constexpr std::array kCommands = {
    CommandHelp{"run", "Run a job: a single run or a study",
                "gurney run studies/jobs/icu_ventilator_shake.toml -o shake.h5\n"
                "gurney run studies/jobs/icu_ventilator_fragility.toml -o ventilator.h5 --resume"},
    CommandHelp{"merge", "Merge the shards of a study into its results file",
                "gurney merge ventilator.h5.shards\n"
                "gurney merge ventilator.h5.shards --job ventilator.toml -o all.h5"},
    CommandHelp{"status", "Report the progress of shards, also while they run",
                "gurney status ventilator.h5.shards"},
    CommandHelp{"submit", "Write a batch script that runs a study in shards on a cluster",
                "gurney submit ventilator.toml --slurm --shards 16 -j 4 --time 02:00:00\n"
                "gurney submit ventilator.toml --slurm --shards 16 --mode allocation"},
    CommandHelp{"check", "Validate a job and estimate its cost (dry run)",
                "gurney check studies/jobs/icu_ventilator_fragility.toml\n"
                "gurney check job.toml --json"},
    CommandHelp{"replay", "Re-run one case of a study with full output",
                "gurney replay ventilator.h5 12"},
    CommandHelp{"workbench", "Write the page that runs jobs in a browser, filled with yours",
                "gurney workbench -o workbench.html\n"
                "gurney workbench studies/jobs/icu_bay.toml -o bay.html"},
    CommandHelp{"show", "Summarize a results file", "gurney show ventilator.h5"},
    CommandHelp{"plot", "Plot what a results file holds",
                "gurney plot ventilator.h5 --list\n"
                "gurney plot ventilator.h5 fragility overturned --width 85mm -o overturned.pdf\n"
                "gurney plot run.h5 history displacement tilt -o run.png"},
    CommandHelp{
        "report", "Write a run, a study, a calibration or a verification as one HTML page",
        "gurney report ventilator.h5 -o ventilator.html\n"
        "gurney report ventilator.h5 --limit-state \"peak_displacement > 0.2 m\" -o far.html"},
    CommandHelp{"play", "Write a page that plays a run back in three dimensions",
                "gurney play shake.h5 -o shake.html\n"
                "gurney play ventilator.h5 --run 3 --run 7 -o both.html\n"
                "gurney play ventilator.h5 --run 3 --ghosts -o suite.html"},
    CommandHelp{"explain", "Explain what happened in a run, why, and what would have prevented it",
                "gurney explain shake.h5 -o why.svg\n"
                "gurney explain ventilator.h5 --run 3 --what-if"},
    CommandHelp{"fragility", "Fit fragility functions and confidence bands",
                "gurney fragility ventilator.h5 --figure ventilator.svg\n"
                "gurney fragility ventilator.h5 --limit overturned --measure \"Sa(1) RotD50\"\n"
                "gurney fragility ventilator.h5 --limit-state \"peak_displacement > 0.2 m\""},
    CommandHelp{"export", "Export results and items to the formats of other programs",
                "gurney export ventilator.h5 --to csv\n"
                "gurney export icu_ventilator --to mjcf\n"
                "gurney export ventilator.h5 --to pelicun -o pelicun"},
    CommandHelp{"compare", "Compare configurations pairwise",
                "gurney compare ventilator.h5 --configurations off,on\n"
                "gurney compare first.h5 second.h5"},
    CommandHelp{"pulling", "Evaluate the simulated pulling tests of a study",
                "gurney pulling pulling_tests.h5 -o figures"},
    CommandHelp{"measures", "Compare intensity measures: efficiency and sufficiency",
                "gurney measures ventilator.h5"},
    CommandHelp{"sensitivity", "Rank uncertain parameters by their influence on a demand",
                "gurney sensitivity ventilator.h5 --demand peak_displacement"},
    CommandHelp{"converge", "Time-step, solver and stiffness convergence of a job",
                "gurney converge studies/jobs/pulling_test.toml --figure converge.svg"},
    CommandHelp{"records", "Inspect, convert, generate and scale ground motions",
                "gurney records ls groundmotions/records"},
    CommandHelp{"records floor", "Compute floor motions from a ground motion and a building model",
                "gurney records floor groundmotions/records/synthetic_3c.csv \\\n"
                "  --building groundmotions/buildings/lead_rubber_hospital.toml --floor roof "
                "-o roof.csv"},
    CommandHelp{"records plot", "Plot histories and response spectra of records",
                "gurney records plot groundmotions/records/synthetic_3c.csv -o record.svg"},
    CommandHelp{"equipment", "List, inspect and validate equipment", "gurney equipment ls"},
    CommandHelp{"equipment ls", "List items, casters, floor coverings, rooms and tethers",
                "gurney equipment ls\ngurney equipment ls --json"},
    CommandHelp{"equipment show",
                "Mass, inertia, support, tilt, wheel loads and resistance of an item",
                "gurney equipment show icu_bed --brakes on --figure bed.svg"},
    CommandHelp{"equipment check",
                "Validate files of items, casters, floor coverings, rooms and tethers",
                "gurney equipment check my_cart.toml my_caster.toml"},
    CommandHelp{"calibrate", "Estimate caster parameters from measured pulls and impacts",
                "gurney calibrate studies/calibration/example -o calibrated"},
    CommandHelp{"records ls", "List the records of files and folders",
                "gurney records ls groundmotions/records\ngurney records ls PEER_download --json"},
    CommandHelp{"records info", "Print peaks, durations and intensity measures of records",
                "gurney records info groundmotions/records/synthetic_3c.csv"},
    CommandHelp{"records convert", "Write records as Gurney's CSV or as AT2, processed on the way",
                "gurney records convert groundmotions/records/synthetic_3c.csv -o filtered.csv \\\n"
                "  --step \"band_pass corners_hz=[0.1,25]\""},
    CommandHelp{"records make", "Generate a synthetic motion",
                "gurney records make --list\n"
                "gurney records make near_fault_pulse period_s=2 -o pulse.csv"},
    CommandHelp{"records model", "Spectrum of a published ground-motion model, with its scatter",
                "gurney records model --magnitude 7 --distance 20 --vs30 400\n"
                "gurney records model --magnitude 7 --distance 20 --vs30 400 --json"},
    CommandHelp{
        "records scale", "Factors that bring a suite of records to a target spectrum",
        "gurney records scale groundmotions/records --target \"asce7 sds_g=1 sd1_g=0.6\" \\\n"
        "  --periods 0.2:2 -o suite.csv"},
    CommandHelp{"new", "Write a commented file to begin with, which runs as it is",
                "gurney new job first\n"
                "gurney new item my_cart\n"
                "gurney new study fragility --from PEER_download --item my_cart.toml"},
    CommandHelp{"doctor", "Report whether the program works on this machine",
                "gurney doctor\ngurney doctor --json"},
    CommandHelp{"completion", "Print the script that completes commands in bash or zsh",
                "source <(gurney completion bash)"},
    CommandHelp{"help", "Print this help, or that of a command",
                "gurney help records scale\ngurney help --man"},
    CommandHelp{
        "verify", "Verify the engine against closed-form solutions",
        "gurney verify\ngurney verify --list\ngurney verify skid_to_roll --draw 7 --count 3"}};

CLI::App* at(CLI::App& app, const std::string& command) {
  CLI::App* found = &app;
  std::istringstream words(command);
  for (std::string word; words >> word;) found = found->get_subcommand(word);
  return found;
}

std::string indented(const char* lines) {
  std::string text = "Examples:";
  std::istringstream all(lines);
  for (std::string line; std::getline(all, line);) text += "\n  " + line;
  return text;
}

/// A command has its own footer, not that of the program.
void clear_footers(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands(nullptr)) {
    command->footer("");
    clear_footers(*command);
  }
}

}  // namespace

void describe_commands(CLI::App& app) {
  clear_footers(app);
  for (const CommandHelp& help : kCommands) {
    CLI::App* const command = at(app, help.command);
    command->description(help.description);
    command->footer(indented(help.examples));
  }
}

}  // namespace gurney::cli
