#pragma once

#include <string>
#include <vector>

namespace gurney::benchmark {

/// Pulling tests against closed form, and three-component ensembles at 4 ms against 0.125 ms.
void print_pulling_accuracy();
void print_ensemble_accuracy(int records, int headings);

/// The same scene on our solver and on stock Bullet: error and speed at equal accuracy.
void print_peers();

/// Time of response spectra and of all intensity measures of a record.
void print_spectra();

/// Verdicts of runs beside the error of their time step, for free and braked items.
void print_predictability(int records);

/// The same for items that hit each other and walls.
void print_rooms(int motions);

/// Accuracy and CPU time of fixed steps and of steps chosen by a tolerance.
void print_step_control(int records);

/// Accuracy and CPU time of runs that halve their own step.
void print_refine(int motions);

/// Demands that are said to be settled, and those that are within what is said.
void print_settled(int motions);

/// Whether the interval of P(overturned) from a few replicas of chaotic runs contains that of many.
void print_replicas(int motions);

/// Coverage of the intervals of fragility curves and rates from few and many records.
void print_intervals(int repeats);

/// CPU time over the number of casters, of items and the length of the record, and of batches on two
/// threads.
void print_cost();

/// CPU time of carts with parts and contents.
void print_loaded_carts();

/// CPU time of whole studies by what takes it: motions, buildings, draws, engine, the rest.
void print_studies(const std::vector<std::string>& jobs, int cases);

}  // namespace gurney::benchmark
