"""Build backend of the Python package (PEP 517), with nothing but Python, CMake and the system's libraries.

A wheel holds what `cmake --install` places: the package with its module, the program among the
scripts, and the catalogue, records and jobs below share/gurney, where both find them.

--config-settings engine=off  a wheel of the readers alone, for any machine
GURNEY_BUILD                  environment variable: a build folder to take instead of a new build
CMAKE_ARGS                    the same: further arguments of the configuration
"""

import base64
import csv
import gzip
import hashlib
import io
import os
import pathlib
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import time
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
NAME = f"{PROJECT['name']}-{PROJECT['version']}"
TIME = int(os.environ.get("SOURCE_DATE_EPOCH", 946684800))  # the same bytes at any time


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as folder:
        stage = pathlib.Path(folder)
        if _has_engine(config_settings):
            _install(_build_folder(), stage)
            files = dict(_placed(stage))
        else:
            package = ROOT / "studies/python"
            files = {path.relative_to(package).as_posix(): path
                     for path in sorted((package / "gurney").iterdir())
                     if path.suffix in (".py", ".typed")}
        wheel = f"{NAME}-{_tag(config_settings)}.whl"
        _write_wheel(pathlib.Path(wheel_directory) / wheel, files, _information(config_settings))
    return wheel


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    for name, text in _information(config_settings).items():
        path = pathlib.Path(metadata_directory) / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return f"{NAME}.dist-info"


def build_sdist(sdist_directory, config_settings=None):
    path = pathlib.Path(sdist_directory) / f"{NAME}.tar.gz"
    with open(path, "wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=TIME) as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name in sorted(_sources()):
            entry = archive.gettarinfo(ROOT / name, f"{NAME}/{name}")
            entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname = TIME, 0, 0, "", ""
            with open(ROOT / name, "rb") as source:
                archive.addfile(entry, source)
        text = _metadata().encode()
        entry = tarfile.TarInfo(f"{NAME}/PKG-INFO")
        entry.size, entry.mtime = len(text), TIME
        archive.addfile(entry, io.BytesIO(text))
    return path.name


def _has_engine(settings):
    value = (settings or {}).get("engine", "on")
    if value not in ("on", "off"):
        sys.exit(f"--config-settings engine={value}: must be on or off")
    return value == "on"


def _build_folder():
    """That of the environment, or build/wheel, which is built."""
    if os.environ.get("GURNEY_BUILD"):
        return pathlib.Path(os.environ["GURNEY_BUILD"])
    folder = ROOT / "build/wheel"
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_AVPHYS_PAGES")
    threads = max(1, min(os.cpu_count() or 1, memory // 1_300_000_000))  # a compiler takes 1.3 GB
    environment = {"CMAKE_BUILD_PARALLEL_LEVEL": str(threads), **os.environ}
    _run("cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         "-DGURNEY_UNITY=ON", "-DGURNEY_TESTS=OFF", "-DGURNEY_BENCHMARKS=OFF",
         f"-DGURNEY_PYTHON={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", "")))
    _run("cmake", "--build", folder, "--target", "product", environment=environment)
    return folder


def _install(build, stage):
    for component in ("program", "python"):
        _run("cmake", "--install", build, "--prefix", stage, "--component", component, "--strip")
    module = f"_engine{sysconfig.get_config_var('EXT_SUFFIX')}"
    if not list(stage.glob(f"lib/python3*/*-packages/gurney/{module}")):
        sys.exit(f"{build}: it has no {module}: install python3-dev and pybind11-dev, and build again")


def _placed(stage):
    """What is installed, by its place in a wheel."""
    for path in sorted(stage.rglob("*")):
        top, *below = path.relative_to(stage).parts
        if path.is_dir():
            continue
        if top == "lib":  # lib/python3/dist-packages/gurney
            yield "/".join(below[2:]), path
        else:
            scheme = f"{NAME}.data/" + ("scripts" if top == "bin" else f"data/{top}")
            yield "/".join([scheme, *below]), path


def _tag(settings):
    if not _has_engine(settings):
        return "py3-none-any"
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def _information(settings):
    """The texts of dist-info but for the list of files."""
    wheel = (f"Wheel-Version: 1.0\nGenerator: gurney_wheel\nRoot-Is-Purelib: "
             f"{str(not _has_engine(settings)).lower()}\nTag: {_tag(settings)}\n")
    texts = {"METADATA": _metadata(), "WHEEL": wheel,
             "LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8")}
    return {f"{NAME}.dist-info/{name}": text for name, text in texts.items()}


def _metadata():
    extras = PROJECT["optional-dependencies"]
    lines = ["Metadata-Version: 2.1", f"Name: {PROJECT['name']}", f"Version: {PROJECT['version']}",
             f"Summary: {PROJECT['description']}", f"License: {PROJECT['license']['text']}",
             f"Keywords: {','.join(PROJECT['keywords'])}",
             f"Requires-Python: {PROJECT['requires-python']}", "License-File: LICENSE",
             "Description-Content-Type: text/markdown"]
    lines += [f"Project-URL: {name}, {url}" for name, url in PROJECT.get("urls", {}).items()]
    lines += [f"Classifier: {each}" for each in PROJECT["classifiers"]]
    lines += [f"Requires-Dist: {each}" for each in PROJECT["dependencies"]]
    for extra, needs in extras.items():
        lines += [f"Provides-Extra: {extra}"]
        lines += [f"Requires-Dist: {each}; extra == '{extra}'" for each in needs]
    return "\n".join(lines) + "\n\n" + (ROOT / PROJECT["readme"]).read_text(encoding="utf-8")


def _write_wheel(path, files, texts):
    """@param files  paths by their names in the wheel; `texts` the same with their text"""
    record = io.StringIO()
    rows = csv.writer(record, lineterminator="\n")
    listed = f"{NAME}.dist-info/RECORD"

    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        def add(name, data, mode=0o644):
            entry = zipfile.ZipInfo(name, time.gmtime(TIME)[:6])
            entry.external_attr = (0o100000 | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
            rows.writerow([name, f"sha256={digest}", len(data)])

        for name, file in files.items():
            add(name, file.read_bytes(), 0o755 if os.access(file, os.X_OK) else 0o644)
        for name, text in texts.items():
            add(name, text.encode())
        rows.writerow([listed, "", ""])
        add(listed, record.getvalue().encode())


def _sources():
    """What git knows; of an unpacked archive everything but what was built."""
    known = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], capture_output=True, text=True) \
        if (ROOT / ".git").exists() else None
    if known is not None and known.returncode == 0:
        names = known.stdout.split("\0")
    else:
        names = [path.relative_to(ROOT).as_posix() for path in ROOT.rglob("*")]
        names = [each for each in names if each.split("/")[0] not in ("build", "out", "PKG-INFO", ".git")
                 and "__pycache__" not in each]
    return [each for each in names if each and (ROOT / each).is_file()]


def _run(*command, environment=None):
    done = subprocess.run([str(each) for each in command], env=environment)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed")
