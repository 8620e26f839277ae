#!/usr/bin/env python3
"""Libraries of npm, crates.io, Maven Central and PyPI under graze-fuzz: installs pinned packages in a temporary
folder, asks each library about tame rays, and prints the rows of docs/fuzz.md.

usage: run.py GRAZE_FUZZ [--rays N] [--seconds S] [--only REGEX] [--keep FOLDER]

It is no part of ./check: it needs the registries' clients (pip, npm, cargo, mvn with a JDK), some 3 GB and an hour of
one core. An ecosystem whose client is missing is left out with a word.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))

# name, version, what of it
PYPI = [
    ("trimesh", "5.2.0", "ray.ray_triangle intersects_first", ["trimesh==5.2.0", "rtree==1.4.1"]),
    ("embreex", "4.4.0.post1", "through trimesh, intersects_first", ["embreex==4.4.0.post1"]),
    ("open3d", "0.20.0", "RaycastingScene cast_rays", ["open3d==0.20.0"]),
    ("vtk-box", "9.7.2", "vtkBox IntersectWithLine", ["vtk==9.7.2"]),
    ("vtk-cell-locator", "9.7.2", "vtkCellLocator IntersectWithLine", []),
    ("vtk-static-cell-locator", "9.7.2", "vtkStaticCellLocator IntersectWithLine", []),
    ("vtk-obb-tree", "9.7.2", "vtkOBBTree IntersectWithLine", []),
    ("mujoco", "4.0.0", "mju_rayGeom, boxes", ["mujoco==4.0.0"]),
    ("pybullet", "3.2.7", "rayTest, boxes", ["pybullet==3.2.7"]),
]
NPM = [
    ("three", "0.187.0", "Ray intersectsBox", ["three@0.187.0"]),
    ("three-mesh-bvh", "0.9.17", "MeshBVH raycastFirst", ["three-mesh-bvh@0.9.17"]),
    ("fast-voxel-raycast", "0.1.1", "", ["fast-voxel-raycast@0.1.1"]),
    ("ray-aabb-intersection", "1.0.1", "", ["ray-aabb-intersection@1.0.1"]),
    ("playcanvas", "2.23.3", "BoundingBox intersectsRay", ["playcanvas@2.23.3"]),
]
CRATES = [
    ("parry3d-f64", "0.31.1", "Aabb cast_local_ray"),
    ("parry3d-f64-bvh", "0.31.1", "Bvh cast_ray"),
    ("bvh", "0.13.0", "Bvh traverse"),
    ("collision", "0.20.1", "Aabb3 intersects Ray3"),
    ("obvhs", "0.4.0", "Aabb intersect_ray"),
]
MAVEN = [
    ("joml", "1.10.8", "Intersectiond intersectRayAab"),
    ("gdx", "1.13.1", "Intersector intersectRayBounds"),
    ("jme3-box", "3.7.0", "BoundingBox intersects"),
    ("jme3-tree", "3.7.0", "BIHTree, Mesh collideWith"),
    ("commons-geometry", "1.0", "Parallelepiped linecastFirst, precision 1e-12 of the largest coordinate"),
]


def call(folder, *command):
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)


def pypi(folder):
    call(folder, sys.executable, "-m", "venv", "venv")
    call(folder, "venv/bin/pip", "-q", "install", *[p for row in PYPI for p in row[3]])
    python, adapter = f"{folder}/venv/bin/python", f"{HERE}/pypi_adapter.py"
    return [(row, f"'{python}' '{adapter}' {row[0]}") for row in PYPI]


def npm(folder):
    call(folder, "npm", "init", "-y")
    call(folder, "npm", "install", "--silent", "--no-audit", "--no-fund", *[p for row in NPM for p in row[3]])
    shutil.copy(f"{HERE}/npm_adapter.mjs", folder)
    return [(row, f"node '{folder}/npm_adapter.mjs' {row[0]}") for row in NPM]


def crates(folder):
    shutil.copytree(f"{HERE}/crates", folder, dirs_exist_ok=True)
    call(folder, "cargo", "build", "--quiet", "--release")
    return [(row, f"'{folder}/target/release/crates_adapter' {row[0]}") for row in CRATES]


def maven(folder):
    for name in ("pom.xml", "Adapter.java"):
        shutil.copy(f"{HERE}/maven/{name}", folder)
    call(folder, "mvn", "-B", "-q", "dependency:copy-dependencies", "-DoutputDirectory=lib")
    call(folder, "javac", "-cp", "lib/*", "-d", ".", "Adapter.java")
    return [(row, f"java -cp '{folder}:{folder}/lib/*' Adapter {row[0]}") for row in MAVEN]


ECOSYSTEMS = {"PyPI": (pypi, "pip3"), "npm": (npm, "npm"), "crates.io": (crates, "cargo"), "Maven": (maven, "mvn")}


def row_of(fuzz, ecosystem, library, command, options):
    name, version, what = library[:3]
    level = ["--level", "10"] if name == "fast-voxel-raycast" else []
    ran = subprocess.run([fuzz, "run", "--command", command, "--tame", "--json", "--no-shrink", "--timeout", "20",
                          "--threads", "1", "--rays", str(options.rays), "--seconds", str(options.seconds), *level],
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if ran.returncode not in (0, 1):
        return f"| {name} | {ecosystem} {version} | {what} | {ran.stderr.strip().splitlines()[-1]} |"
    said = json.loads(ran.stdout)
    judged = said["rays"] - said["declined"] - said["faults"] - said.get("unsent", 0)
    kinds = {kind: n for kind, n in said["rays_with"].items() if n}
    share = [f"{100 * kinds.get(kind, 0) / judged:.2g} %" if judged else "" for kind in ("crossed-miss", "gross-miss")]
    others = ", ".join(f"{kind} {n}" for kind, n in kinds.items() if not kind.endswith("-miss"))
    first = said["first_miss_seconds"]
    return (f"| {name} | {ecosystem} {version} | {what} | {said['promise']} | {judged} | {share[0]} | {share[1]} | "
            f"{'none' if first is None else f'{first:.2g} s'} | {others} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("fuzz", metavar="GRAZE_FUZZ")
    parser.add_argument("--rays", type=int, default=20000)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--only", default="", help="libraries and ecosystems that this regular expression finds")
    parser.add_argument("--keep", help="build here, and leave it there")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        root = os.path.abspath(options.keep or temporary)
        print("| library | package | what of it | promise | rays | miss | gross | first after | besides |")
        print("|---|---|---|---|---|---|---|---|---|")
        for ecosystem, (build, client) in ECOSYSTEMS.items():
            rows = {"PyPI": PYPI, "npm": NPM, "crates.io": CRATES, "Maven": MAVEN}[ecosystem]
            if not any(re.search(options.only, f"{ecosystem} {row[0]}") for row in rows):
                continue
            if not shutil.which(client):
                print(f"{ecosystem}: left out, no {client}", file=sys.stderr)
                continue
            folder = os.path.join(root, ecosystem)
            os.makedirs(folder, exist_ok=True)
            try:
                commands = build(folder)
            except subprocess.CalledProcessError as e:
                print(f"{ecosystem}: left out: {e}", file=sys.stderr)
                continue
            for library, command in commands:
                if re.search(options.only, f"{ecosystem} {library[0]}"):
                    print(row_of(options.fuzz, ecosystem, library, command, options), flush=True)


main()
