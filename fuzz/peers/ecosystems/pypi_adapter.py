"""Libraries of PyPI, asked by graze-fuzz about boxes: pypi_adapter.py LIBRARY (run.py builds and runs)."""
import json
import sys

import numpy as np


def is_flat(box):
    return any(l == h for l, h in zip(box["lo"], box["hi"]))


def is_inside(point, box):
    return all(l <= x <= h for l, x, h in zip(box["lo"], point, box["hi"]))


def is_for_surfaces(r):
    """A mesh is met at its surface: what a ray from inside meets first need not be the box that it is in."""
    return not any(is_flat(b) or is_inside(r["origin"], b) for b in r["boxes"])


def unit(r):
    """The ray with a direction of length 1, and how that is told."""
    direction = np.array(r["direction"]) / np.linalg.norm(r["direction"])
    return direction, {"received": {"origin": r["origin"], "direction": direction.tolist()}}


def centre_and_half(box):
    """Doubles that give the box back without a rounding, or None."""
    centre, half = [], []
    for l, h in zip(box["lo"], box["hi"]):
        c = (l + h) / 2
        if c - (c - l) != l or c + (c - l) != h:
            return None
        centre.append(c), half.append(c - l)
    return centre, half


CORNERS = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
           [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]


def triangles(boxes):
    """Vertices, and 12 triangles a box."""
    vertices = [[b["hi" if k >> a & 1 else "lo"][a] for a in range(3)] for b in boxes for k in range(8)]
    faces = [[8 * i + k for k in face] for i in range(len(boxes)) for face in CORNERS]
    return np.array(vertices), np.array(faces)


def listed(test):
    """Of a test of one box: those that are hit."""
    def answer(r):
        return {"visited": [i for i, b in enumerate(r["boxes"]) if test(r, b)]}
    return answer


def trimesh_library(engine):
    import trimesh
    from trimesh.ray import ray_triangle
    if engine == "embree":
        from trimesh.ray import ray_pyembree

    def answer(r):
        if not is_for_surfaces(r):
            return {"skip": True}
        vertices, faces = triangles(r["boxes"])
        mesh = trimesh.Trimesh(vertices, faces, process=False)
        rays = (ray_pyembree if engine == "embree" else ray_triangle).RayMeshIntersector(mesh)
        direction, received = unit(r)
        hit = rays.intersects_first([r["origin"]], [direction])[0]
        return {"first": None if hit < 0 else int(hit) // 12, **received}
    return answer


def open3d_library():
    import open3d

    def answer(r):
        if not is_for_surfaces(r):
            return {"skip": True}
        scene = open3d.t.geometry.RaycastingScene(1)
        vertices, faces = triangles(r["boxes"])
        scene.add_triangles(open3d.core.Tensor(vertices.astype(np.float32)),
                            open3d.core.Tensor(faces.astype(np.uint32)))
        ray = open3d.core.Tensor([r["origin"] + r["direction"]], dtype=open3d.core.Dtype.Float32)
        hit = scene.cast_rays(ray)["primitive_ids"].numpy()[0]
        return {"first": None if hit == scene.INVALID_ID else int(hit) // 12}
    return answer


def vtk_box():
    import vtk

    def test(r, b):
        bounds = [x for a in range(3) for x in (b["lo"][a], b["hi"][a])]
        t1, t2, first, last = vtk.reference(0.0), vtk.reference(0.0), vtk.reference(0), vtk.reference(0)
        return vtk.vtkBox.IntersectWithLine(bounds, r["origin"], r["end"], t1, t2, [0] * 3, [0] * 3, first, last)
    return listed(test)


def vtk_locator(kind):
    import vtk

    def answer(r):
        if not is_for_surfaces(r):
            return {"skip": True}
        vertices, faces = triangles(r["boxes"])
        points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
        points.SetDataTypeToDouble()
        for v in vertices:
            points.InsertNextPoint(v)
        for face in faces:
            cells.InsertNextCell(3, [int(i) for i in face])
        mesh = vtk.vtkPolyData()
        mesh.SetPoints(points), mesh.SetPolys(cells)
        locator = getattr(vtk, kind)()
        locator.SetDataSet(mesh), locator.BuildLocator()
        t, x, uv, sub, cell = vtk.reference(0.0), [0] * 3, [0] * 3, vtk.reference(0), vtk.reference(0)
        hit = locator.IntersectWithLine(r["origin"], r["end"], 0.0, t, x, uv, sub, cell)
        return {"first": int(cell) // 12 if hit else None}
    return answer


def mujoco_library():
    import mujoco
    identity = np.eye(3).flatten()

    def answer(r):
        visited = []
        direction, received = unit(r)
        for i, b in enumerate(r["boxes"]):
            box = centre_and_half(b)
            if box is None or is_flat(b):
                return {"skip": True}
            if mujoco.mju_rayGeom(np.array(box[0]), identity, np.array(box[1]), np.array(r["origin"]),
                                  direction, mujoco.mjtGeom.mjGEOM_BOX) >= 0:
                visited.append(i)
        return {"visited": visited, **received}
    return answer


def pybullet_library():
    import pybullet
    pybullet.connect(pybullet.DIRECT)

    def answer(r):
        pybullet.resetSimulation()
        place = {}
        for i, b in enumerate(r["boxes"]):
            box = centre_and_half(b)
            if box is None or is_flat(b) or is_inside(r["origin"], b):
                return {"skip": True}  # Bullet does not say what a ray from inside hits
            shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=box[1])
            place[pybullet.createMultiBody(0, shape, -1, box[0])] = i
        hit = pybullet.rayTest(r["origin"], r["end"])[0][0]
        return {"first": place.get(hit)}
    return answer


LIBRARIES = {
    "trimesh": ({"promise": "first"}, lambda: trimesh_library("triangle")),
    "embreex": ({"promise": "first", "float": True}, lambda: trimesh_library("embree")),
    "open3d": ({"promise": "first", "float": True}, open3d_library),
    "vtk-box": ({"promise": "crossed", "segments": True}, vtk_box),
    "vtk-cell-locator": ({"promise": "first", "segments": True}, lambda: vtk_locator("vtkCellLocator")),
    "vtk-static-cell-locator": ({"promise": "first", "segments": True},
                                lambda: vtk_locator("vtkStaticCellLocator")),
    "vtk-obb-tree": ({"promise": "first", "segments": True}, lambda: vtk_locator("vtkOBBTree")),
    "mujoco": ({"promise": "crossed"}, mujoco_library),
    "pybullet": ({"promise": "first", "segments": True}, pybullet_library),
}

if __name__ == "__main__":
    hello, make = LIBRARIES[sys.argv[1]]
    library = make()
    print(json.dumps({"cells": "boxes", **hello}), flush=True)
    for line in sys.stdin:
        request = json.loads(line)
        print(json.dumps({**library(request), "id": request["id"], "echo": request.get("echo")}), flush=True)
