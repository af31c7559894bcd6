"""Recipe for Spack. Not tried yet. docs/install.md, "conda and Spack".

Bullet's recipe is beside this folder. random123, cli11 and tomlplusplus must be among the recipes of your Spack.
"""

from spack.package import *


class Gurney(CMakePackage):
    """Seismic response of hospital equipment on casters under floor motion."""

    homepage = "OWNER-ADDRESS"
    url = "OWNER-ADDRESS/archive/refs/tags/v0.1.0.tar.gz"
    git = "OWNER-ADDRESS.git"
    maintainers("OWNER-MAINTAINERS")
    license("BSD-3-Clause")

    version("main", branch="main")
    version("0.1.0", sha256="OWNER-SHA256")

    variant("python", default=True, description="Python package, with gurney.simulate")
    variant("native", default=False, description="Build for the CPU of this machine: other last digits")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")

    depends_on("bullet3+double")
    depends_on("boost@1.74:+math+random")
    depends_on("cairo@1.16:+pdf+png")
    depends_on("cli11")
    depends_on("eigen@3.4:")
    depends_on("fast-float")
    depends_on("fmt@9:")
    depends_on("hdf5+hl~mpi")
    depends_on("librsvg@2.54:")
    depends_on("nlohmann-json")
    depends_on("openssl")
    depends_on("random123")
    depends_on("tomlplusplus")

    with when("+python"):
        extends("python@3.11:")
        depends_on("py-pybind11@2.10:", type=("build", "link"))
        depends_on("py-h5py", type="run")
        depends_on("py-numpy", type="run")
        depends_on("py-pandas", type="run")

    conflicts("platform=darwin", msg="Gurney is built on Linux only")
    conflicts("platform=windows", msg="Gurney is built on Linux only")
    requires("%gcc@11:", "%clang@14:", policy="one_of")

    generator("ninja")

    def cmake_args(self):
        args = [
            self.define("GURNEY_CPU", "auto" if self.spec.satisfies("+native") else "generic"),
            self.define("GURNEY_UNITY", True),
            self.define("GURNEY_TESTS", False),
            self.define("GURNEY_BENCHMARKS", False),
            self.define_from_variant("GURNEY_BINDINGS", "python"),
        ]
        if self.spec.satisfies("+python"):
            args.append(self.define("GURNEY_PYTHON", python.path))
            args.append(self.define("GURNEY_PYTHON_FOLDER", python_platlib))
        return args

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def check_install(self):
        gurney = Executable(self.prefix.bin.gurney)
        gurney("doctor")
        gurney("verify", "skid_to_roll")
