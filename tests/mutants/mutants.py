"""Makes random small faults in a copy of the sources, one at a time, and lists those that the tests of
their room do not see. Started by ./dev mutate.

usage: mutants.py TREE [N [SEED]]     TREE is a copy that it may change, configured in TREE/build/release
       mutants.py --list TREE [N [SEED]]   prints the faults without building

A fault changes one operator, sign, comparison, constant or function of one line. N (20) counts those
that compile; SEED (1) chooses them. Tests run without GURNEY_RECORDS: what catches a fault is in the
repository.
"""

import os
import random
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

# Sources that faults are made in, and the programs that test them: the first that fails catches.
PROGRAMS = {
    "engine/config": ["config_test"],
    "engine/response": ["response_test", "run_test"],
    "engine/run": ["run_test", "verification_test"],
    "engine/bullet": ["run_test", "verification_test"],
    "engine/baselines": ["verification_test"],
    "engine": ["engine_test", "run_test", "verification_test"],
    "groundmotions": ["groundmotions_test"],
    "studies/statistics": ["statistics_test"],
    "studies/analysis": ["analysis_test"],
    "studies/results": ["results_test"],
    "studies/calibration/trials": ["trials_test"],
    "studies/calibration/fit": ["calibration_test"],
    "studies/calibration/pulling": ["pulling_test"],
}
SECONDS = 600  # that a program may take; none needs more than 100

# What is replaced, by which of several.
FAULTS = [
    (r" \+ ", [" - "]),
    (r" - ", [" + "]),
    (r" \* ", [" / "]),
    (r" / ", [" * "]),
    (r" \+= ", [" -= "]),
    (r" -= ", [" += "]),
    (r" \*= ", [" /= "]),
    (r" /= ", [" *= "]),
    (r" < ", [" > ", " <= "]),
    (r" > ", [" < ", " >= "]),
    (r" <= ", [" >= ", " < "]),
    (r" >= ", [" <= ", " > "]),
    (r" == ", [" != "]),
    (r" != ", [" == "]),
    (r" && ", [" || "]),
    (r" \|\| ", [" && "]),
    (r"\bstd::max\b", ["std::min"]),
    (r"\bstd::min\b", ["std::max"]),
    (r"\bstd::sin\b", ["std::cos"]),
    (r"\bstd::cos\b", ["std::sin"]),
    (r"\bstd::(abs|sqrt)(?=\()", [""]),
    (r"(?:(?<=[(=,?:] )|(?<=\()|(?<=return ))-(?=[\w(])", [""]),
    (r"(?<![\w.\"'])\d+\.?\d*(e-?\d+)?(?![\w.\"'])", None),
]

# Comments, strings, characters, directives, and what is not compiled into a release.
NO_CODE = (r'//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"|(?<!\d)\'(?:\\.|[^\'\\\n])\'|^#[^\n]*'
           r"|\b(?:static_)?assert\([^;]*;")


def constant(text):
    """Another constant: one more of a count, a tenth more of a number."""
    return str(int(text) + 1) if text.isdigit() else repr(float(text) * 1.1)


def code_of(text):
    """The text with what is no code blanked, at the same places."""
    blank = lambda match: re.sub(r"[^\n]", " ", match.group())
    return re.sub(NO_CODE, blank, text, flags=re.M | re.S)


def faults_in(text):
    """All (begin, end, replacement) of a source."""
    code = code_of(text)
    for pattern, others in FAULTS:
        for match in re.finditer(pattern, code):
            for other in others or [constant(match.group())]:
                yield match.start(), match.end(), other


def room_of(source):
    return max((room for room in PROGRAMS if source.startswith(room + "/")), key=len)


class Mutant:
    def __init__(self, tree, source, begin, end, other):
        self.path, self.source = tree / source, source
        self.original = self.path.read_text()
        self.text = self.original[:begin] + other + self.original[end:]
        number = self.original.count("\n", 0, begin)
        before, after = self.original.split("\n")[number], self.text.split("\n")[number]
        self.label = f"{source}:{number + 1}: {before.strip()}\n    {after.strip()}"
        self.programs = PROGRAMS[room_of(source)]


def draw(tree, count, seed):
    """`count` of all faults, each as likely as any other."""
    sites = []
    for room in {room.split("/")[0] for room in PROGRAMS}:
        for path in sorted((tree / room).rglob("*.cpp")):
            source = str(path.relative_to(tree))
            if any(source.startswith(each + "/") for each in PROGRAMS):
                sites += [(source, *fault) for fault in faults_in(path.read_text())]
    chosen = random.Random(seed).sample(sorted(sites), min(count, len(sites)))
    return [Mutant(tree, *site) for site in chosen]


def build(tree, programs):
    command = ["ninja", "-C", str(tree / "build/release"), *programs]
    return subprocess.run(command, capture_output=True, text=True)


def passes(tree, program):
    """Whether its tests pass, in one process for each core."""
    shards = os.cpu_count()
    environment = {key: value for key, value in os.environ.items() if key != "GURNEY_RECORDS"}
    environment |= {"GTEST_FAIL_FAST": "1", "GTEST_TOTAL_SHARDS": str(shards), "OMP_NUM_THREADS": "1"}
    running = [
        subprocess.Popen([tree / "build/release" / program], cwd=tree / "build/release", stdout=subprocess.DEVNULL,
                         stderr=subprocess.DEVNULL, env=environment | {"GTEST_SHARD_INDEX": str(i)})
        for i in range(shards)
    ]
    deadline, good = time.monotonic() + SECONDS, True
    try:
        for process in running:
            try:
                good &= process.wait(max(0, deadline - time.monotonic()) if good else 0) == 0
            except subprocess.TimeoutExpired:
                good = False
    finally:  # a fault may loop for ever
        for process in running:
            process.kill()
            process.wait()
    return good


def judge(tree, mutant):
    """`caught` with the program that did it, `lived`, or `not compiled`."""
    try:
        mutant.path.write_text(mutant.text)
        for program in mutant.programs:
            if build(tree, [program]).returncode != 0:
                return "not compiled"
            if not passes(tree, program):
                return f"caught by {program}"
        return "lived"
    finally:
        mutant.path.write_text(mutant.original)


def main(arguments):
    listed = arguments[:1] == ["--list"]
    if listed:
        arguments = arguments[1:]
    if not 1 <= len(arguments) <= 3 or not all(each.isdigit() for each in arguments[1:]):
        sys.exit(__doc__)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # after what `finally` asks for
    tree = Path(arguments[0]).resolve()
    count, seed = [*map(int, arguments[1:]), *[20, 1][len(arguments) - 1:]]
    if listed:
        print(*(mutant.label for mutant in draw(tree, count, seed)), sep="\n")
        return
    mutants = draw(tree, 3 * count, seed)
    needed = sorted({program for mutant in mutants for program in mutant.programs})
    print("building", *needed, flush=True)
    built = build(tree, needed)
    if built.returncode != 0:
        sys.exit(built.stdout[-3000:])
    tested, lived, sound = 0, [], {}
    for mutant in mutants:
        if tested == count:
            break
        for program in mutant.programs:
            if not sound.setdefault(program, passes(tree, program)):
                sys.exit(f"{program} fails without a fault")
        began = time.monotonic()
        outcome = judge(tree, mutant)
        if outcome == "not compiled":
            continue
        tested += 1
        if outcome == "lived":
            lived.append(mutant)
        print(f"{tested:3} {outcome} ({time.monotonic() - began:.0f} s): {mutant.label}", flush=True)
    print(f"\n{tested} faults, {tested - len(lived)} caught, {len(lived)} lived")
    for mutant in lived:
        print(mutant.label)


if __name__ == "__main__":
    main(sys.argv[1:])
