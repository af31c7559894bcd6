"""Recipe for Spack, of Bullet in both precisions. Not tried yet. For gurney, beside this folder."""

from spack.package import *


class Bullet3(CMakePackage):
    """Collision detection and dynamics of rigid bodies."""

    homepage = "https://github.com/bulletphysics/bullet3"
    git = "https://github.com/bulletphysics/bullet3.git"
    license("Zlib")

    version("3.25", tag="3.25")
    version("3.24", tag="3.24")

    variant("double", default=False, description="Double precision")
    variant("shared", default=True, description="Shared libraries")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.10:3", type="build")

    def cmake_args(self):
        off = ["BULLET2_DEMOS", "CPU_DEMOS", "OPENGL3_DEMOS", "EXTRAS", "UNIT_TESTS", "PYBULLET"]
        return [
            self.define_from_variant("USE_DOUBLE_PRECISION", "double"),
            self.define_from_variant("BUILD_SHARED_LIBS", "shared"),
            self.define("INSTALL_LIBS", True),
        ] + [self.define(f"BUILD_{part}", False) for part in off]
