"""Images: seconds against depth error and wrong pixels, beside POV-Ray and fidget; the paper's Table 1 today.

Every pixel's ray has an exact first root (Sturm's theorem and bisection over rationals; for the asterisks, which
are no polynomials, the certified enclosure), which graze-traversal-bench writes to a file once a scene. Depth errors
are distances along the ray in the scene's units.
"""
import array
import math
import os
import pathlib
import shlex
import shutil

import povray
from report import statistics
from report.context import MeasurementFailed
from report.sections.images_page import CERTIFIED, FIDGET, OLD, SOUND, show, summary

NAME = "images"
TITLE = "Images: seconds against depth error and wrong pixels"
TARGETS = ["graze-traversal-bench"]

LEVELS = [10, 15, 20, 25, 30, 35, 40, 45, 50, 53]
COARSE = [10, 20, 40, 50, 53]  # of the slower methods, and 30
ALL_ACCURACIES = [10.0 ** -k for k in range(3, 10)]
FEW_ACCURACIES = ALL_ACCURACIES[::2]
# scene: pixels a side, POV-Ray's accuracies and its max_gradients that are too small
FULL = {"tanglecube": (512, ALL_ACCURACIES, [10, 20]), "quartdef": (512, ALL_ACCURACIES, [3, 6]),
        "spheres": (512, FEW_ACCURACIES, []), "holesrot": (512, FEW_ACCURACIES, []),
        "asterisk(3,4)": (192, FEW_ACCURACIES, []), "asterisk(9,18)": (128, FEW_ACCURACIES, [])}
QUICK = {"tanglecube": (128, ALL_ACCURACIES[::3], [10, 20])}


def measure(context):
    program, data = context.needed("graze-traversal-bench"), {"scenes": {}, "fidget": []}
    with_povray = shutil.which("povray") is not None
    if not with_povray:
        context.missing("POV-Ray", "povray")
    plan = context.share(FULL, QUICK)
    for name, (size, accuracies, gradients) in plan.items():
        context.progress(f"{name}, graze")
        scene = graze_scene(context, program, name, size)
        if with_povray:
            context.progress(f"{name}, POV-Ray")
            scene["povray"] = povray_scene(context, name, size, accuracies, gradients)
        data["scenes"][name] = scene
    context.progress("fidget")
    fidget = fidget_program(context)
    for name in FIDGET if fidget else []:
        if name in plan:
            data["fidget"].append(fidget_scene(context, program, fidget, name, plan[name][0]))
    return data


# graze's methods, the paper's and its peers'

def truth_file(context, name, size):
    return context.scratch / f"{name}.{size}.roots"


def graze_scene(context, program, name, size):
    """Every method against NL; NL 30, where Table 1 is, with more repetitions."""
    def run(levels, methods, repetitions, seconds):
        options = ["images", "--json", "--scene", name, "--size", size, "--levels", ",".join(map(str, levels)),
                   "--methods", ",".join(methods), "--repetitions", repetitions, "--seconds", seconds]
        commands.append(shlex.join(map(str, [program.name, *options])))
        return context.json_lines([program, *options, "--truth", truth_file(context, name, size)])

    commands = []
    first, *rows = run([30], CERTIFIED + SOUND + OLD + ["split", "exact"], 7, context.share(2, 0.4))
    if context.quick:
        rows += run([10, 50, 53], SOUND + OLD, 3, 0.3)[1:]
    else:
        rows += run(COARSE, SOUND + OLD, 3, 0.5)[1:]
        rows += run([n for n in LEVELS if n not in COARSE + [30]], SOUND, 3, 0.5)[1:]
    return {**first, "rows": sorted(rows, key=lambda r: (r["method"], r["levels"])), "povray": [], "commands": commands}


def roots(context, name, size):
    """t of the exact first root by pixels; no number where the ray misses, infinity where it is not known."""
    return array.array("d", truth_file(context, name, size).read_bytes())[::3]


# POV-Ray

def povray_scene(context, name, size, accuracies, gradients):
    """A row for each accuracy with the correct max_gradient, and for each max_gradient that is too small."""
    right = povray.max_gradient(name)
    rows = [{"accuracy": a, "max_gradient": right, "correct": True, "seconds": []} for a in accuracies]
    rows += [{"accuracy": accuracies[-1], "max_gradient": g, "correct": False, "seconds": []} for g in gradients]
    for row in rows:
        row.update(povray_hits(context, name, size, row))
    for _ in range(context.share(3, 2)):  # in turn; what takes long is not repeated
        for row in rows:
            if sum(row["seconds"]) < context.share(3.5, 1):
                row["seconds"].append(povray_render(context, name, size, row))
    return rows


def povray_run(context, text, image, size):
    """What povray tells of a scene. It may write where it runs."""
    (context.scratch / "scene.pov").write_text(text)
    command = shlex.join(povray.pov_command("scene.pov", image, size))
    return context.run(["sh", "-c", f"cd {shlex.quote(str(context.scratch))} && exec {command} 2>&1"])


def povray_render(context, name, size, row):
    """CPU-seconds of tracing. The row gets what the picture's mask has."""
    output = povray_run(context, povray.pov_scene(name, False, row["max_gradient"], row["accuracy"]), "pov.ppm", size)
    seconds = povray.pov_seconds(output)
    if seconds is None:
        raise MeasurementFailed("povray does not tell its CPU-seconds of tracing")
    mask = povray.pov_mask(context.scratch / "pov.ppm", size)
    row.update(judged_mask(mask, roots(context, name, size)), povray_warns="max_gradient to get a proper" in output)
    return seconds


def judged_mask(mask, truth):
    """Of bytes a pixel, 1 where something was hit."""
    return {"hits": sum(mask), "wrong_hits": sum(m and math.isnan(t) for m, t in zip(mask, truth)),
            "wrong_misses": sum(not m and math.isfinite(t) for m, t in zip(mask, truth))}


def povray_hits(context, name, size, row):
    """Depth errors of where trace() meets the surface, in a run that is not timed."""
    scene = povray.pov_hits_scene(name, row["max_gradient"], row["accuracy"], size, "hits.txt")
    povray_run(context, scene, "no.ppm", 4)
    lines = (context.scratch / "hits.txt").read_text().splitlines()
    truth, scale, errors, k = roots(context, name, size), povray.SCENES[name][1], [], 0
    if len(lines) != size * size:
        raise MeasurementFailed(f"povray's trace() told of {len(lines)} pixels")
    eye = (3 * scale, 2 * scale, 6 * scale)
    for j in range(size):
        v = 0.5 - (j + 0.5) / size
        for i in range(size):
            line, t, k = lines[k], truth[k], k + 1
            if line == "-" or not math.isfinite(t):
                continue
            u = (i + 0.5) / size - 0.5
            d = (-3 + u * 3.578125 + v * -0.51171875, -2 + v * 3.8330078125, -6 + u * -1.7890625 + v * -1.0224609375)
            length = math.hypot(*d)
            x, y, z = map(float, line.split())
            at = ((x - eye[0]) * d[0] + (y - eye[1]) * d[1] + (z - eye[2]) * d[2]) / length
            errors.append(abs(at - t * length))
    return {"depth": three(errors), "compared": len(errors)}


def three(errors):
    """Median, 99.9th percentile, greatest."""
    return [statistics.quantile(errors, share) for share in (0.5, 0.999, 1)] if errors else None


# fidget

def fidget_program(context):
    """build/fidget's program, made by cargo; None where that cannot be."""
    target = pathlib.Path(context.root) / "build" / "fidget"
    program, cargo = target / "release" / "graze-fidget", find_cargo()
    why = ""
    if context.quick:
        why = "" if program.exists() else "--quick does not build it"
    elif cargo is None:
        why = "there is no cargo"
    else:
        cores = ",".join(map(str, sorted(os.sched_getaffinity(0))))
        try:
            manifest = context.root / "bench" / "fidget" / "Cargo.toml"
            context.run([cargo, "build", "--quiet", "--release", "--locked", "--manifest-path", manifest,
                         "--target-dir", target], core=cores, timeout=600)
        except MeasurementFailed as error:
            why = f"cargo could not build it: {error}"
    if why:
        context.missing("fidget", "a crate; cargo-web", why)
    return None if why else program


def find_cargo():
    at_home = pathlib.Path.home() / ".cargo" / "bin" / "cargo"
    return shutil.which("cargo") or (at_home if at_home.exists() else None)


def fidget_scene(context, program, fidget, name, size):
    """fidget's height map, orthographic, and certified casting of the scene's picture, in turn."""
    depths, seconds, certified = context.scratch / "fidget.depths", [], {}
    for _ in range(3):
        seconds += context.json_lines([fidget, name, size, 5, depths])[0]["seconds"]
        for row in context.json_lines([program, "images", "--json", "--scene", name, "--size", size, "--truth",
                                       truth_file(context, name, size), "--levels", 0, "--methods", ",".join(CERTIFIED),
                                       "--repetitions", 5])[1:]:
            certified.setdefault(row["method"], []).append(row["seconds"])
    return {"scene": name, "size": size, "seconds": seconds, "certified": certified,
            **fidget_errors(name, size, array.array("I", depths.read_bytes()))}


def top_root(name, x, y):
    """The greatest z of the surface over (x, y), None where there is none."""
    if name == "tanglecube":  # z^4 - 5 z^2 + c = 0
        c = 11.8 + x ** 4 - 5 * x * x + y ** 4 - 5 * y * y
        return math.sqrt((5 + math.sqrt(25 - 4 * c)) / 2) if 25 >= 4 * c else None
    rest = 1 - (x * x - 1) ** 2 - (y * y - 1) ** 2  # (z^2 - 1)^2 = rest
    return math.sqrt(1 + math.sqrt(rest)) if rest >= 0 else None


def fidget_errors(name, size, depths):
    """Heights are taken to be midway between the last voxel's sample that is within and the next."""
    half = povray.SCENES[name][2]
    step, errors, wrong_hits, wrong_misses = 2 * half / size, [], 0, 0
    for j in range(size):
        for i in range(size):
            z, depth = top_root(name, (i - size / 2) * step, (size / 2 - 1 - j) * step), depths[j * size + i]
            wrong_hits += depth > 0 and z is None
            wrong_misses += depth == 0 and z is not None
            if depth > 0 and z is not None:
                errors.append(abs((depth - 0.5 - size / 2) * step - z))
    return {"hits": sum(d > 0 for d in depths), "wrong_hits": wrong_hits, "wrong_misses": wrong_misses,
            "depth": three(errors)}
