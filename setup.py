"""Builds the Python module through CMake; the version is that of CMakeLists.txt."""
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
VERSION = re.search(r"project\(tagmint VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class BuildWithCMake(build_ext):
    def build_extension(self, ext):
        folder = Path(os.environ.get("TAGMINT_PYTHON_BUILD", Path(self.build_temp).resolve() / "cmake"))
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja",
                        "-DCMAKE_BUILD_TYPE=Release", "-DTAGMINT_BUILD_TESTS=OFF",
                        "-DTAGMINT_BUILD_PYTHON=ON", "-DTAGMINT_WITH_MPI=OFF",
                        f"-DPython_EXECUTABLE={sys.executable}",
                        *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", str(folder), "--target", "tagmint_python"], check=True)
        built = next((folder / "python" / "tagmint").glob("_core*.so"))
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built, target)


setup(version=VERSION,
      packages=["tagmint"],
      package_dir={"tagmint": "tools/python/tagmint"},
      package_data={"tagmint": ["*.pyi", "py.typed"]},
      ext_modules=[Extension("tagmint._core", sources=[])],
      cmdclass={"build_ext": BuildWithCMake})
