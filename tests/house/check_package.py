"""Builds the Debian packages of a build, and tries them: lintian finds nothing wrong, the program and
the Python module run from where they were unpacked.

    check_package.py BUILD ROOT FOLDER
"""

import os
import pathlib
import shutil
import subprocess
import sys

CASE = """
[water]
depth = 20.0
[plate]
thickness = 1.0
youngs_modulus = 1e10
poisson_ratio = 0.3
density = 500.0
[mesh]
rectangle = { length = 40.0, width = 20.0, nx = 4, ny = 2 }
[modes]
count = 6
[waves]
omega = [1.0]
heading_deg = [0]
[output]
points = { middle = [0, 0] }
"""


def run(*command, **options):
    result = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            text=True, **options)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{result.stdout}exit code {result.returncode}")
    return result.stdout


def field(package, name):
    return run("dpkg-deb", "--field", package, name).strip()


def make_packages(build, folder):
    """The packages by name; gzip, since xz takes longer than all the rest."""
    run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip")
    packages = {field(path, "Package"): path for path in folder.glob("*.deb")}
    if not {"floe", "libfloe-dev"} <= set(packages):
        sys.exit(f"packages {sorted(packages)} (must be floe, libfloe-dev and, where it is built, python3-floe)")
    return packages


def check_lintian(packages):
    print(run("lintian", "--allow-root", "--fail-on", "error,warning", *packages.values()))


def check_dependencies(packages):
    for name, library in (("floe", "libc6"), ("floe", "libfftw3-double3"), ("floe", "libcholmod3"),
                          ("python3-floe", "python3-numpy"), ("libfloe-dev", "libeigen3-dev")):
        if name in packages and library not in field(packages[name], "Depends"):
            sys.exit(f"{name} does not depend on {library}: {field(packages[name], 'Depends')}")


def check_program(root, folder):
    program = root / "usr/bin/floe"
    (folder / "small.toml").write_text(CASE, encoding="utf-8")
    run(program, "run", "small.toml", "-o", "small.out", cwd=folder)
    rows = (folder / "small.out/rao_points.csv").read_text(encoding="utf-8").splitlines()
    if len([row for row in rows if not row.startswith("#")]) != 2:
        sys.exit(f"the unpacked program wrote {rows}")


def check_module(root, folder):
    script = ("import floe, pathlib; assert floe.__file__.startswith('" + str(root) + "'), floe.__file__;"
              "result = floe.run('small.toml'); assert result.point_deflection.shape == (1, 1, 1)")
    run("/usr/bin/python3", "-B", "-c", script, cwd=folder,
        env=os.environ | {"PYTHONPATH": str(root / "usr/lib/python3/dist-packages")})


def main(build, root, folder):
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    packages = make_packages(pathlib.Path(build), folder / "packages")
    check_lintian(packages)
    check_dependencies(packages)
    for path in packages.values():
        run("dpkg-deb", "--extract", path, folder / "root")
    check_program(folder / "root", folder)
    if "python3-floe" in packages:
        check_module(folder / "root", folder)
    print(", ".join(f"{path.name} {path.stat().st_size / 1e6:.1f} MB" for path in packages.values()))


if __name__ == "__main__":
    main(*sys.argv[1:])
