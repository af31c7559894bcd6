"""Units of limits, hazards and drawn parameters."""

from __future__ import annotations

import math

from .errors import Error

#: unit: (SI unit, value of one in it)
_TO_SI = {
    "m": ("m", 1.0), "cm": ("m", 0.01), "mm": ("m", 0.001),
    "m/s": ("m/s", 1.0), "cm/s": ("m/s", 0.01),
    "m/s2": ("m/s2", 1.0), "cm/s2": ("m/s2", 0.01), "g": ("m/s2", 9.80665),
    "rad": ("rad", 1.0), "deg": ("rad", math.pi / 180),
    "s": ("s", 1.0), "N": ("N", 1.0), "kN": ("N", 1000.0), "N s": ("N s", 1.0), "J": ("J", 1.0),
    "1": ("1", 1.0),
}

#: An ending stands before those it ends with.
_ENDINGS = {
    "_n_m_s_per_rad": "N m s/rad", "_n_s_per_m": "N s/m", "_n_per_m": "N/m", "_m_per_s2": "m/s2",
    "_m_per_s": "m/s", "_deg_per_s": "deg/s", "_kg_m2": "kg m2", "_n_m": "N m", "_mm": "mm",
    "_kg": "kg", "_hz": "Hz", "_deg": "deg", "_m": "m", "_s": "s", "_n": "N", "_j": "J",
}


def factor(unit: str, si: str) -> float:
    """The value of one ``unit`` in the SI unit ``si``; refuses units of other quantities."""
    if unit in _TO_SI and _TO_SI[unit][0] == si:
        return _TO_SI[unit][1]
    known = [name for name, (of, _) in _TO_SI.items() if of == si]
    raise Error(f"the unit must be {' or '.join(known) or si}, not '{unit}'")


def unit_of_key(key: str) -> str:
    """The unit that the name of a parameter ends with: ``chassis.mass_kg`` is in kg."""
    name = key[:key.rindex("[")] if key.endswith("]") else key
    if len(name) > 2 and name[-2] == ".":  # an axis
        name = name[:-2]
    return next((unit for ending, unit in _ENDINGS.items() if name.endswith(ending)), "1")
