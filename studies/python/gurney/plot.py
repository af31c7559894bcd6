"""Figures with matplotlib; each function draws into ``ax`` and returns it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy

from .errors import Error

if TYPE_CHECKING:
    from .records import Selection
    from .results import Results


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise Error("figures need matplotlib (Debian: python3-matplotlib); "
                    "`gurney plot` needs no Python") from error
    return pyplot.subplots()[1]


def history(results: Results, name: str = "displacement", run: int | None = None,
            item: str | None = None, ax: Any = None) -> Any:
    """A history of a run over time, a line for each item, wheel or axis that it has."""
    ax = _axes(ax)
    data = results.histories(run, item)
    if name not in data:
        raise Error(f"{results.path}: no history '{name}'; it has: {', '.join(data)}")
    variable = data[name]
    lines = variable.stack(line=[dim for dim in variable.dims if dim != "time"] or None) \
        if variable.ndim > 1 else variable.expand_dims("line", axis=1)
    for i in range(lines.sizes["line"]):
        label = lines["line"].values[i] if "line" in lines.coords else ""
        ax.plot(data["time"], lines[:, i], lw=0.8, label=" ".join(numpy.atleast_1d(label)))
    ax.set_xlabel("time [s]")
    ax.set_ylabel(f"{name.replace('_', ' ')} [{variable.attrs['units']}]")
    if lines.sizes["line"] > 1:
        ax.legend(frameon=False)
    return ax


def fragility(results: Results, limit_state: str, measure: str | None = None,
              configuration: str | None = None, ax: Any = None) -> Any:
    """Fragility curves of the configurations, with the observed fractions of stripes."""
    ax = _axes(ax)
    names = results.configurations["name"] if configuration is None else [configuration]
    for name in names:
        curve = results.fragility(limit_state, measure, name)
        line, = ax.plot([], [], label=f"{name or 'all runs'}: {curve.status}"
                        if curve.status != "fitted" else
                        f"{name or 'all runs'}: {curve.theta:.3g} {curve.units}, "
                        f"{curve.beta:.2f}")
        stripes = curve.stripes
        if len(stripes) <= 40:
            ax.plot(stripes["im"], stripes["exceeded"] / stripes["runs"], "o", ms=4,
                    color=line.get_color(), mfc="none")
        if curve.status == "fitted":
            im = numpy.geomspace(stripes["im"].min() / 1.5, stripes["im"].max() * 1.5, 200)
            line.set_data(im, curve.probability(im))
    ax.set_xscale("log")
    ax.set_xlabel(f"{curve.measure} [{curve.units}]")
    ax.set_ylabel(f"P({curve.limit_state})")
    ax.set_ylim(0, 1)
    ax.relim()
    ax.autoscale_view()
    ax.legend(frameon=False, title="median, beta")
    return ax


def cloud(results: Results, demand: str = "peak_displacement", measure: str = "intensity",
          ax: Any = None) -> Any:
    """A demand over an intensity measure, one mark for each item of each run."""
    ax = _axes(ax)
    data = results.demands.join(results.runs[["configuration", measure]])
    for name, rows in data.groupby("configuration"):
        ax.plot(rows[measure], rows[demand], "o", ms=3, mfc="none", label=name or None)
    units, of_runs = results.demands.attrs["units"], results.runs.attrs
    ax.set(xscale="log", yscale="log", ylabel=f"{demand.replace('_', ' ')} [{units[demand]}]")
    shown = of_runs["intensity_measure"] if measure == "intensity" else measure
    ax.set_xlabel(f"{shown} [{of_runs['units'][measure]}]")
    if data["configuration"].nunique() > 1:
        ax.legend(frameon=False)
    return ax


def selection(suite: Selection, ax: Any = None) -> Any:
    """Spectra of selected records with the median of the target, and one standard deviation around it."""
    ax = _axes(ax)
    ax.plot(suite.periods, suite.spectra.T, color="0.6", lw=0.7)
    ax.plot(suite.periods, suite.median, color="C0", label="target, median and 16 to 84 %")
    for sign in (-1, 1):
        ax.plot(suite.periods, suite.median * numpy.exp(sign * suite.sigma), color="C0", ls="--")
    ax.set(xscale="log", yscale="log", xlabel="period [s]", ylabel=f"Sa, {100 * suite.facts['damping_ratio']:g} % damping [m/s2]")
    ax.legend(frameon=False)
    return ax
