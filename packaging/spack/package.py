# SPDX-License-Identifier: MIT
# Not built here: a draft for Spack.
from spack.package import *


class TouchstoneContact(CMakePackage):
    """Certified reference values for the elastic contact of the Weierstrass profile."""

    homepage = "https://example.org/touchstone"
    git = "https://example.org/touchstone.git"

    license("MIT AND GPL-3.0-or-later")

    version("main", branch="main")

    variant("program", default=True, description="The touchstone program and the ledger (GPL)")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("boost@1.74:")
    depends_on("flint@3:")
    depends_on("fmt")
    depends_on("gmp+cxx")
    depends_on("mpfr")
    depends_on("nlohmann-json")
    depends_on("openssl")
    depends_on("cli11", when="+program")
    depends_on("ginac", when="+program")
    depends_on("gsl", when="+program")

    def cmake_args(self):
        return [self.define_from_variant("TOUCHSTONE_PROGRAM", "program"), self.define("TOUCHSTONE_TESTS", False)]
