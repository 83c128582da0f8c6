"""Runs cmake/packaging/conan/conanfile.py as Conan does, with stand-ins for Conan's modules.

usage: run_conan_recipe.py CHECKOUT VERSION
"""
import importlib.util
import shutil
import sys
import tempfile
import types
from pathlib import Path

root, version = Path(sys.argv[1]), sys.argv[2]
calls = []


class Stand:
    """Anything: remembers what is called."""

    def __init__(self, *_):
        self.cache_variables = {}
        calls.append(self)

    def __getattr__(self, name):
        return lambda *arguments, **named: calls.append((name, self.cache_variables))


class Info:
    def set_property(self, *_):
        pass


def copy(_recipe, pattern, src, dst):
    found = list(Path(src).glob(pattern))
    assert found, f"{pattern} matches nothing in the checkout"
    for path in found:
        if path.is_file():
            Path(dst).mkdir(parents=True, exist_ok=True)
            shutil.copy(path, dst)


for name, content in {
    "conan": {"ConanFile": object},
    "conan.tools": {},
    "conan.tools.build": {"check_min_cppstd": lambda *_: None},
    "conan.tools.cmake": {"CMake": Stand, "CMakeDeps": Stand, "CMakeToolchain": Stand, "cmake_layout": lambda _: None},
    "conan.tools.files": {"copy": copy},
}.items():
    module = types.ModuleType(name)
    module.__dict__.update(content)
    sys.modules[name] = module


def load(path):
    spec = importlib.util.spec_from_file_location("conanfile", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.Tagmint()


recipe = load(root / "cmake/packaging/conan/conanfile.py")
recipe.set_version()
assert recipe.version == version, recipe.version
with tempfile.TemporaryDirectory() as folder:
    recipe.export_folder = folder
    recipe.export()
    recipe.export_sources_folder = folder + "/sources"
    recipe.export_sources()
    # Conan runs the exported recipe, away from the checkout.
    shutil.copy(root / "cmake/packaging/conan/conanfile.py", folder)
    exported = load(Path(folder) / "conanfile.py")
    exported.set_version()
    assert exported.version == version
recipe.options = types.SimpleNamespace(shared=True)
recipe.validate()
recipe.layout()
recipe.generate()
assert ("generate", {"TAGMINT_BUILD_TOOLS": False, "TAGMINT_BUILD_TESTS": False, "TAGMINT_SHARED": True}) in calls
recipe.build()
recipe.source_folder, recipe.package_folder = root, tempfile.mkdtemp()
recipe.package()
shutil.rmtree(recipe.package_folder)
recipe.cpp_info = Info()
recipe.package_info()
assert recipe.cpp_info.libs == ["tagmint"]
