#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace gurney::cli {

/// Each adds one command to the program, or to `gurney records`. Where the command is chosen,
/// `action` is set to what it does, which returns the exit code and throws Error for bad input.
using AddCommand = void(CLI::App& app, std::function<int()>& action);

AddCommand add_calibrate;    ///< caster constants from pull and impact tests
AddCommand add_check;        ///< reads a job with all it names and prints what would run
AddCommand add_compare;      ///< configurations, pairwise
AddCommand add_completion;   ///< scripts for bash and zsh
AddCommand add_converge;     ///< of a job with the time step and the solver
AddCommand add_doctor;       ///< whether the program works on this machine
AddCommand add_equipment;    ///< ls, show, check
AddCommand add_explain;      ///< why a run ended as it did
AddCommand add_export;       ///< results for other programs
AddCommand add_fragility;    ///< curves and bands of a study
AddCommand add_measures;     ///< efficiency and sufficiency of intensity measures
AddCommand add_merge;        ///< the shards of a study into its results
AddCommand add_play;         ///< a page that plays a run back
AddCommand add_new;          ///< files to begin with
AddCommand add_plot;         ///< figures of a results file
AddCommand add_pulling;      ///< simulated pulling tests and their figures
AddCommand add_records;      ///< and its commands
AddCommand add_report;       ///< a results file as one HTML page
AddCommand add_sensitivity;  ///< of a demand to the uncertain parameters
AddCommand add_show;         ///< what a results file holds
AddCommand add_status;       ///< of shards while they run
AddCommand add_submit;       ///< writes a script for a scheduler
AddCommand add_verify;       ///< the engine against closed-form solutions
AddCommand add_workbench;    ///< the page that runs jobs in a browser

AddCommand add_records_convert;  ///< to Gurney's CSV or to AT2, processed on the way
AddCommand add_records_floor;    ///< floor motions of a building
AddCommand add_records_info;     ///< peaks, durations and measures
AddCommand add_records_make;     ///< synthetic motions
AddCommand add_records_model;    ///< a published ground-motion model
AddCommand add_records_plot;     ///< histories and spectra
AddCommand add_records_scale;    ///< factors to a measure or a target spectrum

}  // namespace gurney::cli
