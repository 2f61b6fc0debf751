"""The wheel of faster_sim: the package of python/, its native core, and the program faster-sim. CMake builds both, in
build/wheel, or a build tree that $FASTER_BUILD names already has them (build/release, say). pyproject.toml has the rest."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=32", "-DFASTER_BUILD_TESTS=OFF",
           "-DFASTER_BUILD_EXAMPLES=OFF", "-DFASTER_BUILD_BENCHMARKS=OFF", "-DFASTER_BUILD_PYTHON=ON"]


class BuildByCMake(build_ext):
    def run(self) -> None:
        package = Path(self.get_ext_fullpath("faster_sim._core")).parent
        if self.inplace:
            sys.exit("setup: editable installs are not supported, expected `pip install .`; a build tree's python/ is a package that "
                     "follows the sources")
        build = Path(os.environ.get("FASTER_BUILD") or self.built())
        (package / "bin").mkdir(parents=True, exist_ok=True)
        shutil.copy2(self.one_of(build / "bin", "faster-sim"), package / "bin" / "faster-sim")
        shutil.copy2(self.one_of(build / "python" / "faster_sim", "_core*.so"), package)

    @staticmethod
    def built() -> Path:
        build = ROOT / "build" / "wheel"
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *OPTIONS, f"-DCMAKE_RUNTIME_OUTPUT_DIRECTORY={build}/bin",
                        f"-DPython_EXECUTABLE={sys.executable}", *os.environ.get("CMAKE_ARGS", "").split()], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "faster-sim", "faster_python", "--parallel"], check=True)
        return build

    @staticmethod
    def one_of(folder: Path, pattern: str) -> Path:
        found = sorted(folder.glob(pattern))
        if len(found) != 1:
            sys.exit(f"setup: {len(found)} files {folder}/{pattern}, expected one; FASTER_BUILD is a build tree with faster-sim and faster_python")
        return found[0]


(ROOT / "build").mkdir(exist_ok=True)
setup(
    version=re.search(r"project\(faster-sim VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1),
    package_dir={"": "python"},
    packages=["faster_sim"],
    package_data={"faster_sim": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("faster_sim._core", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
    license_files=["LICENSE", "NOTICE"],
    options={"egg_info": {"egg_base": "build"}, "build": {"build_base": "build/setuptools"}},
)
