"""A wheel of the module: CMake builds the project, and its component `python` becomes the package.

An sdist holds kernel and csg in its folder `repository`. CNRG_BUILD names a build folder where the target cnrg_package
is up to date; nothing is compiled then.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

HERE = Path(__file__).resolve().parent
ROOT = HERE / "repository" if (HERE / "repository").exists() else HERE.parents[1]
PACKAGE = os.path.relpath(ROOT / "csg/python/cnrg", HERE)


def cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], check=True)


def built_package(folder):
    """A build folder where cnrg_package is up to date: CNRG_BUILD, or `folder`."""
    if "CNRG_BUILD" in os.environ:
        return Path(os.environ["CNRG_BUILD"])
    options = ["-DCNRG_PYTHON=ON", "-DCNRG_EXAMPLES=OFF", "-DBUILD_TESTING=OFF",
               f"-DPython_EXECUTABLE={sys.executable}"]
    try:
        import pybind11

        options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
    except ImportError:
        pass  # where the system has it, CMake finds it
    cmake("-S", ROOT, "-B", folder, *options)
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", os.cpu_count() or 1)
    cmake("--build", folder, "--target", "cnrg_package", "--parallel", jobs)
    return folder


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        folder = Path(self.build_temp).resolve()
        staged = folder / "staged"
        shutil.rmtree(staged, ignore_errors=True)
        cmake("--install", built_package(folder / "build"), "--component", "python", "--strip", "--prefix", staged)
        built, = staged.rglob("_cnrg*.so")
        target = Path(self.get_ext_fullpath(extension.name)).parent
        shutil.copytree(built.parent, target, dirs_exist_ok=True)
        shutil.copy2(ROOT / "LICENSE", target)


class SourcesOfAll(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, [f for f in files if not f.startswith("cnrg/")])
        for part in ("CMakeLists.txt", "LICENSE", "README.md", ".github/CHANGELOG.md", "kernel", "csg"):
            target = Path(base_dir) / "repository" / part
            target.parent.mkdir(parents=True, exist_ok=True)
            if (ROOT / part).is_dir():
                left_out = shutil.ignore_patterns("__pycache__", "build", "dist", "*.egg-info", Path(base_dir).name)
                shutil.copytree(ROOT / part, target, dirs_exist_ok=True, ignore=left_out)
            else:
                shutil.copy2(ROOT / part, target)


def version():
    """The project's version: the root's CMakeLists.txt is its one place."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^project\(cnrg VERSION ([0-9.]+)", text, re.M).group(1)


setup(version=version(), packages=["cnrg"], package_dir={"cnrg": PACKAGE}, package_data={"cnrg": ["py.typed"]},
      ext_modules=[Extension("cnrg._cnrg", [])], cmdclass={"build_ext": BuildByCMake, "sdist": SourcesOfAll})
