#!/usr/bin/env python3
"""Whole programs, from start to picture, on two threads: girasol against Sunflow and POV-Ray. See README.md."""

import argparse
import os
import re
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

import pictures
import spheres

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
WORK = TARGET / "peers"
THREADS = 2
# In the folder of the course's scenes.
SCENES = [f"course/{name}" for name in ("bunny", "chainlink", "marbles", "watertower")] + ["parity/knot", "parity/spheres64"]
# girasol's own, where that folder is not there: those that Sunflow reads.
BUILT_IN = ["chainlink", "organic", "marbles", "watertower", "spheres64"]
JARS = ["/usr/share/java/sunflow.jar", "/usr/share/java/janino.jar"]
# How many times as fast as its peer girasol is to be: on every scene, and in the median.
AIMS = {"Sunflow": (8, 12), "POV-Ray": (5, 5), "Sunflow at equal error": (8, 8)}
# How far girasol's and POV-Ray's pictures may be apart, as RMSE: edges are, for Sunflow's camera is half a pixel off centre.
LIKENESS = 0.03
# How many rays girasol's adaptive pictures give a pixel, least and most, as `--aa` has it; and between which contrasts the one that is just good
# enough is looked for.
ADAPTIVE = ("0,2", "0,4", "1,4")
CONTRASTS = (0.003, 0.3)
# Rays in every pixel, where all have as many.
EVEN = ("2", "4", "8", "16", "32", "64")


def main():
    arguments = read_arguments()
    for package, tool in [("libsunflow-java", JARS[0]), ("default-jdk-headless", "javac"), ("povray", "povray")]:
        install(package, tool)
    WORK.mkdir(parents=True, exist_ok=True)
    run(["javac", "-cp", JARS[0], "-d", WORK, HERE / "RenderWithSunflow.java"])
    if "GIRASOL" not in os.environ:
        run(["cargo", "build", "--release", "--locked", "--bin", "girasol"], cwd=ROOT)
    rows = [against_sunflow(name, scene, arguments.runs) for name, scene in find_scenes(arguments.scene)]
    if not arguments.scene:
        rows.append(against_pov_ray(arguments.runs))
    if arguments.equal_error:
        rows += [at_equal_error(name, scene, arguments.runs) for name, scene in find_scenes(arguments.scene)]
    show([row for row in rows if row])


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene", nargs="*", help="only scenes whose name holds one of these words, and not POV-Ray's")
    parser.add_argument("--runs", type=int, default=3, help="rounds of each contest, of which the medians count")
    parser.add_argument("--equal-error", action="store_true", help="also against Sunflow's adaptive pictures; takes minutes the first time")
    return parser.parse_args()


def install(package, tool):
    """Gets a Debian package, if what it brings is not there."""
    if shutil.which(tool) or Path(tool).exists():
        return
    if subprocess.run(["apt-get", "install", "--yes", "--no-install-recommends", package]).returncode:
        sys.exit(f"{package} is not installed, and apt-get could not get it: be root, and try `apt-get update` first.")


def run(command, **keywords):
    subprocess.run([str(word) for word in command], check=True, **keywords)


def find_scenes(words):
    """Names and paths of the scenes asked for."""
    shared = os.environ.get("GIRASOL_SHARED")
    if shared:
        found = [(name.split("/")[1], Path(shared) / "scenes" / f"{name}.sc") for name in SCENES]
    else:
        print("GIRASOL_SHARED does not name the folder of the course's scenes: with girasol's own instead.", file=sys.stderr)
        for name in BUILT_IN:
            run([girasol(), "scenes", name, "--write", WORK / "scenes"], stdout=subprocess.DEVNULL)
        found = [(name, WORK / "scenes" / f"{name}.sc") for name in BUILT_IN]
    return [(name, path) for name, path in found if not words or any(word in name for word in words)]


def girasol():
    return os.environ.get("GIRASOL", str(TARGET / "release" / "girasol"))


def by_girasol(scene, picture, *options):
    return [girasol(), "render", scene, "-o", picture, "--quiet", "--lighting", "sunflow", "--threads", THREADS, *options]


def by_sunflow(scene, picture, least, most, kernel):
    classes = os.pathsep.join([*JARS, str(WORK)])
    java = ["java", "-Djava.awt.headless=true", "-cp", classes, "RenderWithSunflow"]
    return [*java, scene, picture, least, most, kernel, THREADS]


def by_pov_ray(scene, picture):
    # 4 x 4 rays in every pixel, as no contrast is below the threshold of 0; no jitter, no window.
    width, height = spheres.SIZE
    return ["povray", f"+I{scene}", f"+O{picture}", f"+W{width}", f"+H{height}", "+FN8", "+AM1", "+A0.0", "+R4", "-J", f"+WT{THREADS}", "-D", "-V"]


def timed(command):
    """Seconds by the clock, and on all processors together, from start to end of a program; `None` if it fails."""
    start = time.monotonic()
    with open(WORK / "log.txt", "w") as log:
        process = subprocess.Popen([str(word) for word in command], stdout=log, stderr=log)
        _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        print(f"failed: {' '.join(map(str, command))}\n{(WORK / 'log.txt').read_text()[-500:]}", file=sys.stderr)
        return None
    return time.monotonic() - start, usage.ru_utime + usage.ru_stime


def contest(name, peer, commands, runs):
    """Medians of two programs that take turns."""
    times = ([], [])
    for _ in range(runs):
        for command, list_of_times in zip(commands, times):
            once = timed(command)
            if once is None:
                return None
            list_of_times.append(once)
    (wall, cpu), (peer_wall, peer_cpu) = (map(statistics.median, zip(*list_of_times)) for list_of_times in times)
    return {"scene": name, "peer": peer, "wall": wall, "cpu": cpu, "peer wall": peer_wall, "peer cpu": peer_cpu}


def camera_rays(scene, *options):
    """Rays a pixel that girasol says it traces."""
    command = [str(word) for word in by_girasol(scene, WORK / "counted.png", "--time", *options)]
    lines = subprocess.run(command, check=True, capture_output=True, text=True)
    count = int(re.search(r"(\d+) camera", lines.stdout + lines.stderr).group(1))
    width, height, _ = pictures.read(WORK / "counted.png")
    return count / (width * height)


def against_sunflow(name, scene, runs):
    """Sixteen rays a pixel. Sunflow's filter is its cheapest, for which it traces no rays beyond the edges of its buckets."""
    ours, theirs = WORK / f"{name}-girasol.png", WORK / f"{name}-sunflow.png"
    rays = camera_rays(scene, "--aa", "2")
    if rays != 16:
        sys.exit(f"{name}: girasol traces {rays} rays a pixel")
    return contest(name, "Sunflow", [by_girasol(scene, ours, "--aa", "2"), by_sunflow(scene, theirs, 2, 2, "box")], runs)


def against_pov_ray(runs):
    ours, theirs = WORK / "spheres-girasol.png", WORK / "spheres-povray.png"
    (WORK / "spheres.sc").write_text(spheres.sc())
    (WORK / "spheres.pov").write_text(spheres.pov())
    row = contest("spheres", "POV-Ray", [by_girasol(WORK / "spheres.sc", ours, "--aa", "2"), by_pov_ray(WORK / "spheres.pov", theirs)], runs)
    if not row:
        return None
    samples = re.search(r"Samples: *(\d+)", (WORK / "log.txt").read_text())
    if not samples or int(samples.group(1)) != 16 * spheres.SIZE[0] * spheres.SIZE[1]:
        sys.exit("POV-Ray does not trace 16 rays a pixel")
    apart = pictures.rmse(ours, theirs)
    if apart > LIKENESS:
        sys.exit(f"girasol and POV-Ray do not show the same scene: their pictures are {apart:.4f} apart")
    return row


def at_equal_error(name, scene, runs):
    """Sunflow's adaptive picture, and girasol's cheapest whose error is no larger, each held against its own reference."""
    ours, theirs = WORK / f"{name}-equal-girasol.png", WORK / f"{name}-equal-sunflow.png"
    our_reference, their_reference = WORK / f"{name}-reference-girasol.png", WORK / f"{name}-reference-sunflow.png"
    if not their_reference.exists():
        timed(by_sunflow(scene, their_reference, 4, 4, "mitchell"))
    timed(by_girasol(scene, our_reference, "--aa", "4", "--samples", "4", "--sampler", "sobol"))
    adaptive = by_sunflow(scene, theirs, 0, 2, "mitchell")
    if timed(adaptive) is None or not their_reference.exists():
        return None
    aim = pictures.rmse(theirs, their_reference)
    good = []

    def is_good(*options):
        way = [*options, "--sampler", "sobol"]
        once = timed(by_girasol(scene, ours, *way))
        if once is None:
            return False
        error, seconds = pictures.rmse(ours, our_reference), once[1]
        print(f"{name}: {' '.join(way)}: error {error:.4f} (Sunflow {aim:.4f}), {seconds:.3f} s", file=sys.stderr)
        if error <= aim:
            good.append((seconds, way))
        return error <= aim

    for aa in ADAPTIVE:
        least, most = CONTRASTS
        for _ in range(7):
            middle = (least * most) ** 0.5
            least, most = (middle, most) if is_good("--aa", aa, f"--adaptive={middle:.4f}") else (least, middle)
    for samples in EVEN:
        if is_good("--aa", "0", "--samples", samples):
            break
    if not good:
        print(f"{name}: girasol does not reach the error {aim:.4f}", file=sys.stderr)
        return None
    way = min(good)[1]
    return contest(name, "Sunflow at equal error", [by_girasol(scene, ours, *way), adaptive], runs)


def show(rows):
    print("| scene | peer | girasol, s | peer, s | ratio | girasol, CPU s | peer, CPU s | ratio |")
    print("|---|---|---|---|---|---|---|---|")
    for row in rows:
        ours, theirs, cpu, peer_cpu = row["wall"], row["peer wall"], row["cpu"], row["peer cpu"]
        print(
            f"| {row['scene']} | {row['peer']} | {ours:.3f} | {theirs:.2f} | {theirs / ours:.1f} "
            f"| {cpu:.3f} | {peer_cpu:.2f} | {peer_cpu / cpu:.1f} |"
        )
    print("\n| against | scenes | least | aim | median | aim | |\n|---|---|---|---|---|---|---|")
    for peer, (least, median) in AIMS.items():
        ratios = [row["peer wall"] / row["wall"] for row in rows if row["peer"] == peer]
        if ratios:
            met = min(ratios) >= least and statistics.median(ratios) >= median
            print(
                f"| {peer} | {len(ratios)} | {min(ratios):.1f} | {least} | {statistics.median(ratios):.1f} | {median} "
                f"| {'met' if met else '**missed**'} |"
            )
    print(f"\nThe pictures are in {WORK}.")


if __name__ == "__main__":
    main()
