"""The compiled module of the engine and of the statistics."""

from __future__ import annotations

from types import ModuleType


def module() -> ModuleType:
    """``gurney._engine``.

    :raises ImportError: it was not built for this Python
    """
    try:
        from . import _engine  # type: ignore[attr-defined]
    except ImportError as error:
        raise ImportError(
            "simulations and statistics need the compiled module gurney._engine for this Python: pip "
            "install ., with the Debian packages python3-dev and pybind11-dev, or the package "
            f"python3-gurney. Reading results works without it. ({error})") from error
    found: ModuleType = _engine
    return found
