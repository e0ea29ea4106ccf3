"""Builds the extension by its CMakeLists.txt, which finds the installed library (CMAKE_PREFIX_PATH says where)."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        build = Path(self.build_temp).resolve()
        build.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cmake", "-S", HERE, "-B", build, f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.run(["cmake", "--build", build, "--parallel", jobs], check=True)
        target = Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        built, = (build / "cnrg").glob("_cnrg*.so")
        shutil.copy2(built, target)
        for name in ("_cnrg.pyi", "view.html"):  # types of the extension; the page of Result.view, if there is one
            if (build / "cnrg" / name).exists():
                shutil.copy2(build / "cnrg" / name, target.parent)


def version():
    """That of the project, which the library has, too."""
    text = (HERE.parents[1] / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^project\(cnrg VERSION ([0-9.]+)", text, re.M).group(1)


setup(version=version(), ext_modules=[Extension("cnrg._cnrg", [])], cmdclass={"build_ext": BuildByCMake})
