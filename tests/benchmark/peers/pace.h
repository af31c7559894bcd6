#pragma once

namespace gurney::benchmark {

/// CPU time of one fixed run, now: the least of five [s]. Neighbours on a shared machine change its
/// speed by a third within minutes; what is measured between two of these is corrected by them.
double pace();

}  // namespace gurney::benchmark
