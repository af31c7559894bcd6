"""Draws the spectra of suites beside the median and the scatter of their target (docs/catalogue/motions.md).

usage: suite_figure.py FIGURE.svg SPECTRA.csv TITLE [SPECTRA.csv TITLE]...

The tables are those of suite.py. Needs numpy and matplotlib.
"""

import sys

import matplotlib
import numpy as np

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "gurney", "font.size": 9})
import matplotlib.pyplot as plt  # noqa: E402


def panel(axes, path, title):
    period, mean, sigma, *motions = np.loadtxt(path, delimiter=",", skiprows=1).T
    chosen = np.array(motions)
    for i, spectrum in enumerate(chosen):
        axes.loglog(period, np.exp(spectrum), color="0.75", lw=0.6, label="motions" if i == 0 else None)
    for centre, width, style, name in ((mean, sigma, "k-", "model"),
                                       (chosen.mean(axis=0), chosen.std(axis=0, ddof=1), "C1--", "suite")):
        axes.loglog(period, np.exp(centre), style, lw=1.8, label=f"{name}: median")
        for side in (-1, 1):
            axes.loglog(period, np.exp(centre + side * width), style, lw=0.9,
                        label=f"{name}: one sigma" if side == 1 else None)
    axes.set(title=title, xlabel="T [s]", xlim=(period[0], period[-1]), ylim=(0.2, 60))


def main():
    if len(sys.argv) < 4 or len(sys.argv) % 2:
        sys.exit(__doc__)
    pairs = list(zip(sys.argv[2::2], sys.argv[3::2]))
    figure, axes = plt.subplots(1, len(pairs), figsize=(3.6 * len(pairs), 3.4), sharey=True, squeeze=False,
                                layout="constrained")
    for each, (path, title) in zip(axes[0], pairs):
        panel(each, path, title)
    axes[0][0].set_ylabel("Sa / PGV, RotD50 [1/s]")
    axes[0][0].legend(frameon=False, fontsize=7, loc="lower left")
    figure.savefig(sys.argv[1], metadata={"Date": None})


if __name__ == "__main__":
    main()
