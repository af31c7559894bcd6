"""OpenQuake's own reader reads the exported NRML, and its functions give the probabilities of the
curves. Skipped unless GURNEY_OPENQUAKE names a folder that holds its package `openquake`: the engine,
or its libraries of 2016, which read the same NRML 0.5.
"""

import collections
import collections.abc
import inspect
import math
import os
import sys
import tempfile
import types
import warnings

import support

folder = os.environ.get("GURNEY_OPENQUAKE")
if not folder:
    support.skip("GURNEY_OPENQUAKE names no folder with the package openquake")
support.need("numpy", "scipy", "h5py", "shapely")
sys.dont_write_bytecode = True
warnings.simplefilter("ignore")


def allow_libraries_of_2016():
    """Names that Python, numpy and scipy have dropped since."""
    import numpy
    import scipy
    for name in collections.abc.__all__:
        if not hasattr(collections, name):
            setattr(collections, name, getattr(collections.abc, name))
    for kind in (bool, float, int, object, str):
        if kind.__name__ not in vars(numpy):
            setattr(numpy, kind.__name__, kind)
    scipy.random = numpy.random
    sys.modules.setdefault("imp", types.ModuleType("imp"))


sys.path.insert(0, folder)
try:
    from openquake.hazardlib.nrml import to_python as read
    from openquake.risklib import riskmodels  # noqa: F401  (adds the reader of fragilities)
except (AttributeError, ImportError):
    for name in [each for each in sys.modules if each.split(".")[0] == "openquake"]:
        del sys.modules[name]
    allow_libraries_of_2016()
    from openquake.commonlib.nrml import parse as read
import numpy  # noqa: E402
from openquake.risklib.scientific import (  # noqa: E402
    FragilityFunctionContinuous, FragilityFunctionDiscrete)


def parameters_of(curves, number):
    """Mean and standard deviation of a limit state. The engine's array has a row of minIML.. or of
    mean and stddev for each; the libraries of 2016 name its columns."""
    array = curves.array
    if getattr(array, "dtype", None) is not None and array.dtype.names:
        return array["mean"][number], array["stddev"][number]
    return tuple(numpy.asarray(array)[number][:2])


def function_of(limit_state, curves):
    """OpenQuake's function of the first limit state of a file."""
    mean, stddev = parameters_of(curves, 0)
    given = {"limit_state": limit_state, "mean": mean, "stddev": stddev,
             "minIML": getattr(curves, "minIML", None), "maxIML": getattr(curves, "maxIML", None)}
    known = inspect.signature(FragilityFunctionContinuous.__init__).parameters
    return FragilityFunctionContinuous(**{name: given[name] for name in given if name in known})


with tempfile.TemporaryDirectory() as temporary:
    study, exported = (os.path.join(temporary, name) for name in ("trolley.h5", "nrml"))
    support.gurney("run", os.path.join(support.SOURCE, "studies/jobs/trolley_levels.toml"), "-o",
                   study)
    support.gurney("export", study, "--to", "nrml", "--separate", "-o", exported)
    curves = {each["limit_state"]: each["curve"] for each in
              support.fragilities(study).values() if each["curve"]}
    count = 0
    for name in sorted(os.listdir(exported)):
        model = read(os.path.join(exported, name))
        limit_state = name.removesuffix(".xml")
        for key, found in model.items():
            assert "PGA" in key, key
            function = function_of(limit_state, found)
            curve = curves[limit_state]
            low, high = found.minIML, found.maxIML
            for share in (0.1, 0.3, 0.5, 0.7, 0.9):
                im = low * (high / low) ** share  # [g]
                z = math.log(im * 9.80665 / curve["theta"]) / curve["beta"]
                expected = 0.5 * math.erfc(-z / math.sqrt(2))
                # mean and stddev have 16 digits; beta^2 = ln(1 + cv^2) loses 1 / beta^2 of them
                found_there = float(numpy.ravel(function(numpy.array([im])))[0])
                assert abs(found_there - expected) < 1e-13 / curve["beta"] ** 2, (key, im)
            count += 1
    assert count == len(curves) > 0, (count, curves)

    # Two limit states in one file; their functions as parameters, and as points.
    support.gurney("export", study, "--to", "nrml", *support.STATES, "-o", exported)
    points = os.path.join(temporary, "points")
    support.gurney("export", study, "--to", "nrml", "--discrete", *support.STATES,
                   "-o", points)
    curves = {each["limit_state"]: each["curve"] for each in
              support.fragilities(study, *support.STATES).values()}
    (continuous,) = read(os.path.join(exported, "near_far.xml")).values()
    (discrete,) = read(os.path.join(points, "near_far.xml")).values()
    imls = numpy.array(discrete.imls)
    for number, state in enumerate(("near", "far")):
        curve = curves[state]
        mean, stddev = parameters_of(continuous, number)
        cv2 = (stddev / mean) ** 2
        assert abs(mean / math.sqrt(1 + cv2) * 9.80665 / curve["theta"] - 1) < 1e-12, state
        function = FragilityFunctionDiscrete(
            state, [discrete.nodamage, *imls], [0, *discrete.array[number]], discrete.nodamage)
        for im in numpy.geomspace(0.5 * imls[0], 2 * imls[-1], 300):
            z = math.log(im * 9.80665 / curve["theta"]) / curve["beta"]
            expected = 0.5 * math.erfc(-z / math.sqrt(2))
            # Lines between points that are a share s apart miss by max |F''| (s im)^2 / 8, and
            # im^2 |F''| = |phi(z) (z + beta)| / beta^2 is at most (0.242 + 0.399 beta) / beta^2;
            # 1e-4 is left out at both ends.
            step = imls[1] / imls[0] - 1
            most = (0.242 + 0.399 * curve["beta"]) / curve["beta"] ** 2 * step ** 2 / 8 + 1e-4
            assert abs(float(numpy.ravel(function(numpy.array([im])))[0]) - expected) <= most, (state, im)
print(f"OpenQuake agrees on {count} curves, and on a sequence as parameters and as points")
