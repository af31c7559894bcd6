"""How the time, files, inodes and memory of a study grow with its cases: docs/cluster.md."""

from dataclasses import dataclass

PART_BYTES = 8 * 2**20  # a part is written when so much waits (studies/run/run_batch.cpp),
LEAST_INTERVAL = 1.0    # or after so many seconds,
PART_OF_TIME = 0.02     # or this part of the time since the shard began, whichever is longer
FILES_OF_SHARD = 5      # its folder, `study`, `lock`, `crashes`, its log
# Bytes of memory for a case: where it is in the parts (PartFolder::Place, in a vector that doubles),
# and, of a shard, its place in the order of cases (missing_tasks), of a merge, which shard has it.
RUN_MEMORY_OF_CASE = 2 * 32 + 8 + 32
MERGE_MEMORY_OF_CASE = 2 * 32 + 8
# What waits for the next part is held as results, and as the bytes of the part.
WAITING_COPIES = 2


@dataclass
class Inputs:
    """What was measured; seconds are of CPU time."""

    run_start: float      # of a shard, before its first case
    run_case: float       # of a case
    run_memory: float     # [bytes], without cases
    part_case: float      # bytes of a case in its part
    merge_start: float
    merge_case: float
    merge_memory: float
    result_case: float    # bytes of a case in the results


def parts_of(seconds, part_bytes):
    """Part files of a shard that runs for so long and keeps so many bytes."""
    rate = part_bytes / max(seconds, 1e-9)
    time, parts = 0.0, 0
    while time < seconds:
        # After an interval of PART_OF_TIME of the time at its end.
        interval = max(LEAST_INTERVAL, time * PART_OF_TIME / (1 - PART_OF_TIME))
        if rate > 0:
            interval = min(interval, PART_BYTES / rate)
        # A part waits for the end of a case at least; there are no empty ones.
        time += interval
        parts += 1
    return parts


def predict(inputs, cases, cores, case_seconds=None):
    """Of a study on so many cores, each with a shard of its own.

    :param case_seconds: of another study than the measured one
    """
    run_case = case_seconds or inputs.run_case
    of_shard = -(-cases // cores)
    run = inputs.run_start + of_shard * run_case
    merge = inputs.merge_start + cases * inputs.merge_case
    parts = cores * min(of_shard, parts_of(of_shard * run_case, of_shard * inputs.part_case))
    return {
        "run [s]": run,
        "merge [s]": merge,
        "inodes": parts + cores * FILES_OF_SHARD + 2,
        "parts [bytes]": cases * inputs.part_case,
        "results [bytes]": cases * inputs.result_case,
        # at most: less waits where parts are written before they are full
        "run memory [bytes]": inputs.run_memory + of_shard * RUN_MEMORY_OF_CASE
                              + WAITING_COPIES * min(PART_BYTES, of_shard * inputs.part_case),
        "merge memory [bytes]": inputs.merge_memory + cases * MERGE_MEMORY_OF_CASE,
    }


def through(small, large):
    """Start and slope of the line through two measurements (cases, value); no slope is negative."""
    slope = max(0.0, (large[1] - small[1]) / (large[0] - small[0]))
    return max(0.0, small[1] - slope * small[0]), slope
