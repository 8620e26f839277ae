#!/usr/bin/env python3
"""Renders the six scenes by POV-Ray's isosurface and by graze-render; prints Markdown tables.

usage: bench/povray.py GRAZE_RENDER [--quick] [--mode cast|trace] [--scene NAME]... [--gradients] [--threads]
--quick      leaves out tracing of the asterisks by POV-Ray
--gradients  prints instead what POV-Ray loses of the casted masks at other values of max_gradient
--threads    prints instead graze-render with two threads beside one, at 2048x2048

Both sides on one thread, in turn in one run; rendering alone, as each tells it: POV-Ray's CPU-seconds
of tracing, and graze-render's seconds by the clock, the octree's included, or the processor time of
its process less that of graze-render --version (libraries are loaded), where that is less. Each the
least of 3 runs; of 9 where graze-render takes less than a second, of 1 for what takes more than 5 s:
medians would tell of what else the machine does. Needs povray 3.7 (Debian's package: povray).

The same domain as the container box (open: its faces are no surface), camera, lights, 512x512, no
anti-aliasing, accuracy 1e-9; in tracing shadows and five reflections. max_gradient, on which
POV-Ray's correctness rests, is the greatest |grad f| in the container: for three polynomials at its
corners, for the spheres on a grid of 65^3 points and a twentieth more. The asterisks' is about n/R,
without bound at the origin: the number is what it is where R >= 1/10, and the masks judge it.
"""
import json
import math
import os
import pathlib
import re
import resource
import shutil
import statistics
import struct
import subprocess
import sys
import tempfile
import zlib

SIZE = 512
BALLS = [(0, 0, 0, 1), (1.75, 0, 0, .625), (-1.75, .25, 0, .625), (0, 1.75, .25, .625), (0, -1.75, 0, .625),
         (.25, 0, 1.75, .625), (0, 0, -1.75, .625), (1.25, 1.25, 1.25, .375), (-1.25, -1.25, 1.25, .375)]


def asterisk(m, n):
    return f"sqrt(x*x+y*y+z*z) - sin({m}*atan2(y,x))*sin({n}*atan2(sqrt(x*x+y*y),z))"


# name: formula (negative within), camera's scale S, half of the domain's side, max_gradient
SCENES = {
    "spheres": ("min(" + ",".join(f"(x-({a}))*(x-({a}))+(y-({b}))*(y-({b}))+(z-({c}))*(z-({c}))-{r * r}"
                                  for a, b, c, r in BALLS) + ")", 1.5, 2.5, None),
    "quartdef": ("(x*x-1)*(x*x-1)+(y*y-1)*(y*y-1)+(z*z-1)*(z*z-1)-1", 1.125, 1.5, None),
    "tanglecube": ("x*x*x*x-5*x*x+y*y*y*y-5*y*y+z*z*z*z-5*z*z+11.8", 2, 2.5, None),
    "holesrot": ("x*x*x+y*y*y+z*z*z-x-y-z", 2, 2, None),
    "asterisk(3,4)": (asterisk(3, 4), 0.5, 1, 40),
    "asterisk(9,18)": (asterisk(9, 18), 0.5, 1, 180),
}
SLOPES = {"quartdef": lambda x: 4 * x * (x * x - 1), "tanglecube": lambda x: 4 * x ** 3 - 10 * x,
          "holesrot": lambda x: 3 * x * x - 1}


def max_gradient(name):
    """|grad f|'s greatest value in the container, rounded up to a tenth; see above."""
    half, given = SCENES[name][2:]
    if given is not None:
        return given
    grid = [half * k / 32 for k in range(-32, 33)]
    if name in SLOPES:  # a sum of functions of one coordinate, each steepest at an end of the domain
        most = math.sqrt(3) * max(abs(SLOPES[name](x)) for x in grid)
    else:  # of the least of the nine: twice the distance from that ball's centre
        most = 1.05 * max(2 * min((math.dist((x, y, z), b[:3]) ** 2 - b[3] ** 2, math.dist((x, y, z), b[:3]))
                                  for b in BALLS)[1] for x in grid for y in grid for z in grid)
    return math.ceil(most * 10) / 10


def isosurface(name, gradient, accuracy, rest):
    formula, _, half, _ = SCENES[name]
    return (f"isosurface {{ function {{ {formula} }} contained_by {{ box {{ {-half}, {half} }} }} open\n"
            f"  accuracy {accuracy:g} max_gradient {gradient} {rest} }}\n")


def pov_scene(name, trace, gradient, accuracy=1e-9):
    s = SCENES[name][1]
    light = "light_source {{ <{:g},{:g},{:g}> rgb {} }}\n"
    return ("#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }\n"
            f"camera {{ perspective location <{3 * s},{2 * s},{6 * s}> direction <-3,-2,-6>\n"
            "  right <3.578125,0,-1.7890625> up <-0.51171875,3.8330078125,-1.0224609375> }\n"
            "background { rgb <0,0,1> }\n"
            + light.format(10 * s, 12 * s, 4 * s, 0.8) + light.format(-8 * s, 6 * s, 10 * s, 0.5)
            + isosurface(name, gradient, accuracy, "pigment { rgb 0.6 }\n"
                         "  finish { ambient 0.2 diffuse 0.6 phong 0.3 phong_size 32"
                         + (" reflection 0.2 }" if trace else " } no_shadow")))


def pov_hits_scene(name, gradient, accuracy, size, file):
    """A scene that writes to the file where trace() meets the surface, a line a pixel: "x y z", or "-"."""
    s = SCENES[name][1]
    return (f"#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n#declare N = {size};\n"
            f"#declare S = {isosurface(name, gradient, accuracy, '')}"
            f'#declare E = <{3 * s},{2 * s},{6 * s}>;\n#fopen F "{file}" write\n#for (J, 0, N-1) #for (I, 0, N-1)\n'
            "#local U = (I+0.5)/N-0.5; #local V = 0.5-(J+0.5)/N; #local H = <0,0,0>;\n"
            "#local D = <-3,-2,-6>+U*<3.578125,0,-1.7890625>+V*<-0.51171875,3.8330078125,-1.0224609375>;\n"
            "#local Q = trace(S, E, D, H);\n"
            '#if (vlength(H) > 0) #write (F, str(Q.x,0,17), " ", str(Q.y,0,17), " ", str(Q.z,0,17), "\\n")\n'
            '#else #write (F, "-\\n") #end\n#end #end\n#fclose F\ncamera { location <0,0,-1> }\n')


def pov_command(scene, image, size):
    return ["povray", str(scene), "+WT1", "-D", "-A", "-V", f"+W{size}", f"+H{size}", "+FP", f"+O{image}"]


def pov_seconds(output):
    """CPU-seconds of tracing, of what povray tells; None where it has not traced."""
    found = re.findall(r"with\s+([0-9.]+)\s+CPU-seconds", output)
    return float(found[-1]) if found else None


def pov_mask(image, size):
    """A byte a pixel, 1 where the surface was hit: red there, by the ambient light at least."""
    data = image.read_bytes()[-3 * size * size:]
    return bytes(1 if r else 0 for r in data[::3])


def pov_run(name, trace, gradient, folder, size=SIZE):
    """CPU-seconds of tracing, and the mask."""
    scene, image = folder / "scene.pov", folder / "pov.ppm"
    scene.write_text(pov_scene(name, trace, gradient))
    done = subprocess.run(pov_command(scene, image, size), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", cwd=folder)
    if done.returncode != 0 or pov_seconds(done.stdout) is None:
        sys.exit("povray failed:\n" + done.stdout[-3000:])
    return pov_seconds(done.stdout), pov_mask(image, size)


def png_mask(file, size):
    """The pixels of an 8-bit RGB(A) PNG that are not of the background's colour."""
    raw, at, bits, channels = file.read_bytes(), 8, b"", 3
    while at < len(raw):
        length, kind = struct.unpack(">I4s", raw[at:at + 8])
        if kind == b"IHDR":
            channels = {2: 3, 6: 4}[raw[at + 17]]
        if kind == b"IDAT":
            bits += raw[at + 8:at + 8 + length]
        at += 12 + length
    bits, stride = zlib.decompress(bits), channels * size
    above, rows = bytearray(stride), []
    for j in range(size):
        filter_type, row = bits[j * (stride + 1)], bytearray(bits[j * (stride + 1) + 1:(j + 1) * (stride + 1)])
        for i in range(stride):
            left, up = row[i - channels] if i >= channels else 0, above[i]
            corner = above[i - channels] if i >= channels else 0
            if filter_type == 1:
                row[i] = row[i] + left & 255
            elif filter_type == 2:
                row[i] = row[i] + up & 255
            elif filter_type == 3:
                row[i] = row[i] + (left + up) // 2 & 255
            elif filter_type == 4:
                p = left + up - corner
                best = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
                row[i] = row[i] + best & 255
        rows.append(row)
        above = row
    pixels = [bytes(row[i:i + 3]) for row in rows for i in range(0, stride, channels)]
    return bytes(0 if p == GRAZE_BACKGROUND else 1 for p in pixels)


def srgb(x):
    return round(255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055))


GRAZE_BACKGROUND = bytes(map(srgb, (0.84, 0.87, 0.91)))


def processor_time(command):
    """What the command prints, and the seconds that it took of the processor."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def graze_run(program, name, options, image, size=SIZE):
    """What the program tells of the picture that it makes; seconds as said above."""
    out, took = processor_time([program, "--scene", name, "--json", "--size", str(size), "-o", str(image), *options])
    result = json.loads(out)
    result["processor"] = took
    result["seconds"] += result["octree_seconds"]
    return result


def graze_mask(program, name, folder, size=SIZE):
    result = graze_run(program, name, ["--threads", "1"], folder / "mask.png", size)
    mask = png_mask(folder / "mask.png", size)
    if sum(mask) != result["hits"] or result["undecided"]:
        sys.exit(f"{name}: the picture's mask has {sum(mask)} hits, not {result['hits']}")
    return mask


def differences(a, b):
    return sum(x != y for x, y in zip(a, b))


def seconds(x):
    return f"{x:.3f}" if x < 1 else f"{x:.2f}" if x < 10 else f"{x:.1f}"


def compare(program, names, modes, quick, folder):
    print("| scene | mode | POV-Ray, s | certified, s | ratio | descent to NL 30, s | ratio | max_gradient |"
          " hits | pixels where POV-Ray's mask differs |\n" + "|---" * 10 + "|", flush=True)
    start = min(processor_time([program, "--version"])[1] for _ in range(9))
    for trace in modes:
        for name in names:
            if quick and trace and name.startswith("asterisk"):
                continue
            mask, gradient = graze_mask(program, name, folder), max_gradient(name)
            times = {"pov": [], "certified": [], "descent": []}
            other = None
            for _ in range(3):
                if not times["pov"] or times["pov"][0] <= 5:
                    took, other = pov_run(name, trace, gradient, folder)
                    times["pov"].append(took)
                for method in ("certified", "descent"):
                    options = ["--mode", "trace" if trace else "cast", "--threads", "1", "--method", method]
                    options += ["--levels", "30"] if method == "descent" else []
                    for again in range(3):
                        if times[method] and times[method][0] > (1 if again else 5):
                            break
                        result = graze_run(program, name, options, folder / "graze.png")
                        times[method].append(min(result["seconds"], result["processor"] - start))
            t = {k: min(v) for k, v in times.items()}
            print(f"| {name} | {'trace' if trace else 'cast'} | {seconds(t['pov'])} | {seconds(t['certified'])} |"
                  f" {t['pov'] / t['certified']:.0f} | {seconds(t['descent'])} | {t['pov'] / t['descent']:.1f} |"
                  f" {gradient:g} | {sum(mask)} | {differences(mask, other)} |", flush=True)


def gradients(program, names, folder):
    print("| scene | max_gradient | POV-Ray, s | pixels where its mask differs |\n" + "|---" * 4 + "|")
    for name in names:
        mask = graze_mask(program, name, folder)
        for part in (1 / 8, 1 / 4, 1 / 2, 1, 2):
            gradient = max_gradient(name) * part
            took, other = pov_run(name, False, gradient, folder)
            print(f"| {name} | {gradient:.3g} | {seconds(took)} | {differences(mask, other)} |", flush=True)


def threads(program, names, folder):
    print("| scene | method | one thread, s | two, s | ratio |\n" + "|---" * 5 + "|")
    for name in names:
        for method in ("certified", "descent"):
            if method == "descent" and name.startswith("asterisk"):
                continue
            wall = {"1": [], "2": []}
            for _ in range(5):
                for n in wall:
                    result = graze_run(program, name, ["--threads", n, "--method", method], folder / "graze.png", 2048)
                    wall[n].append(result["seconds"])
            first, second = (statistics.median(wall[n]) for n in wall)
            print(f"| {name} | {method} | {seconds(first)} | {seconds(second)} | {first / second:.2f} |", flush=True)


def main():
    arguments = sys.argv[1:]
    names = [arguments[i + 1] for i, a in enumerate(arguments[:-1]) if a == "--scene"] or list(SCENES)
    if not arguments or arguments[0].startswith("-") or not set(names) <= set(SCENES):
        sys.exit(__doc__)
    program = os.path.abspath(arguments[0])
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        if "--threads" in arguments:
            return threads(program, names, folder)
        if shutil.which("povray") is None:
            sys.exit("povray is missing (Debian's package: povray); not measured")
        if "--gradients" in arguments:
            return gradients(program, names, folder)
        modes = [m == "trace" for m in ("cast", "trace") if "--mode" not in arguments or m in arguments]
        compare(program, names, modes, "--quick" in arguments, folder)


if __name__ == "__main__":
    main()
