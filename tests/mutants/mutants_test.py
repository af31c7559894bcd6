"""Faults of a small source, and a small project whose only test sees some of them.

usage: mutants_test.py
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import mutants  # noqa: E402

SOURCE = """// a + b is no code
#include <cmath>
const char* kText = "a + b, 2";
static_assert(2 + 2 == 4);
static double unused(double x) { return x * 0.5; }
int main() {
  const double size = std::abs(-3.0);
  return size > 2.5 && unused(1) < 1 ? 0 : 1;
}
"""


def lines_of(source):
    """The changed lines that faults of a source give."""
    result = set()
    for begin, end, other in mutants.faults_in(source):
        changed = source[:begin] + other + source[end:]
        result |= set(changed.split("\n")) - set(source.split("\n"))
    return {line.strip() for line in result}


class Mutants(unittest.TestCase):
    def test_faults(self):
        self.assertEqual(lines_of("x = -a + 1;  // a - b\ny = \"2 * 3\";"),
                         {"x = a + 1;  // a - b", "x = -a - 1;  // a - b", "x = -a + 2;  // a - b"})
        self.assertEqual(lines_of("if (a < 0.5 || p == q) b = std::max(x, c1);"), {
            "if (a > 0.5 || p == q) b = std::max(x, c1);", "if (a <= 0.5 || p == q) b = std::max(x, c1);",
            "if (a < 0.55 || p == q) b = std::max(x, c1);", "if (a < 0.5 && p == q) b = std::max(x, c1);",
            "if (a < 0.5 || p != q) b = std::max(x, c1);", "if (a < 0.5 || p == q) b = std::min(x, c1);"})
        self.assertEqual(lines_of("return -std::sqrt(2e-3);"),
                         {"return std::sqrt(2e-3);", "return -(2e-3);", "return -std::sqrt(0.0022);"})
        found = "".join(lines_of(SOURCE))
        for text in ("no code", "kText", "static_assert"):
            self.assertNotIn(text, found)

    def test_project(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder, "engine/config/a.cpp")
            source.parent.mkdir(parents=True)
            source.write_text(SOURCE)
            release = Path(folder, "build/release")
            release.mkdir(parents=True)
            release.joinpath("build.ninja").write_text(
                f"rule cxx\n  command = c++ -o $out $in\nbuild config_test: cxx {source}\n")
            program = [sys.executable, mutants.__file__]
            count = len(list(mutants.faults_in(SOURCE)))
            listed = [subprocess.run([*program, "--list", folder, "4", seed], capture_output=True, text=True,
                                     check=True).stdout for seed in ("1", "1", "2")]
            self.assertEqual(listed[0], listed[1])
            self.assertNotEqual(listed[0], listed[2])
            done = subprocess.run([*program, folder, str(count), "1"], capture_output=True, text=True, check=True)
            self.assertEqual(source.read_text(), SOURCE)
            lived = done.stdout.rsplit(" lived\n", 1)[1]
            self.assertRegex(done.stdout, r"caught by config_test .*\n.*size < 2.5")
            # 0.5 x and 0.55 x are below 1 alike, and 3 is above 2.75 too.
            for text in ("x * 0.55", "size > 2.75", "std::abs(3.0)"):
                self.assertIn(text, lived)
            self.assertNotIn("size < 2.5", lived)
            self.assertIn(f"\n{count} faults, ", done.stdout)


if __name__ == "__main__":
    unittest.main()
