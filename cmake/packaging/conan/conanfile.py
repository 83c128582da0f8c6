# Recipe for Conan 2: `conan create cmake/packaging/conan` in a checkout.
import re
from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy

HERE = Path(__file__).resolve().parent


class Tagmint(ConanFile):
    name = "tagmint"
    license = "BSD-2-Clause"
    description = "Make, print and find square fiducial tags (AprilTags)"
    topics = ("apriltag", "fiducial", "computer-vision", "robotics")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": False}
    # What the libraries need; the program, which needs Cairo and more, is not part of the package.
    requires = ("fmt/9.1.0", "highway/1.0.3", "openssl/3.0.13", "onetbb/2021.10.0",
                "eigen/3.4.0", "nlohmann_json/3.11.2")

    def set_version(self):
        self.version = re.search(r"project\(tagmint VERSION ([0-9.]+)",
                                 self._project_file().read_text()).group(1)

    @staticmethod
    def _project_file():
        """CMakeLists.txt of the project: beside the exported recipe, or three folders above it."""
        beside = HERE / "CMakeLists.txt"
        return beside if beside.exists() else HERE.parents[2] / "CMakeLists.txt"

    def export(self):
        copy(self, "CMakeLists.txt", src=str(HERE.parents[2]), dst=self.export_folder)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "families/*.json", "libcodec/*",
                        "libdetect/*"):
            copy(self, pattern, src=str(HERE.parents[2]), dst=self.export_sources_folder)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["TAGMINT_BUILD_TOOLS"] = False
        toolchain.cache_variables["TAGMINT_BUILD_TESTS"] = False
        toolchain.cache_variables["TAGMINT_SHARED"] = bool(self.options.shared)
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", src=self.source_folder, dst=str(Path(self.package_folder) / "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # tagmint installs its own package
        self.cpp_info.builddirs = ["lib/cmake/tagmint"]
        self.cpp_info.libs = (["tagmint"] if self.options.shared
                              else ["tagmint_c", "tagmint_detect", "tagmint_codec"])
