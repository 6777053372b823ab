#!/usr/bin/env python3
"""Measures again what docs/performance.md and docs/tradeoffs.md say, and writes it into them.

    docs/measure.py [--rounds N] [--only errors,frame,scaling,tradeoff] [--kept FOLDER]
                    [--error-spp N] [--reference-spp N]

runs `./dirt bench` on the atrium, and on Crytek Sponza and conference where $DIRT_SCENES (or
../shared/scenes) has them. Tables stand between <!-- measured NAME --> and <!-- end -->; plots and
pictures go to docs/images/tradeoffs.

`errors` takes what no other load on the machine changes, the errors of images and of rays, and
leaves it in FOLDER (default: build/tradeoff), where a later `tradeoff` finds it: with the references
one to two hours of two cores, which may be shared; references that are there are not traced again. The rest
are times, for which nothing else should use the machine: about a quarter of an hour each.
"""

import argparse
import datetime
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs/images/tradeoffs"


def scenes():
    """Path and title of each scene that is here."""
    folder = pathlib.Path(os.environ.get("DIRT_SCENES", ROOT.parent / "shared/scenes"))
    camera = {
        "crytek-sponza/sponza.obj": ["--eye=-1100,250,-50", "--target=1000,300,0", "--fov", "53"],
        "conference/conference.obj": ["--eye=900,400,500", "--target=0,150,-300", "--fov", "53"],
    }
    yield ROOT / "scenes/atrium.scene", "atrium", []
    for file, options in camera.items():
        if (folder / file).exists():
            yield folder / file, file.split("/")[0], options


def dirt(*arguments, statuses=(0,)):
    """Runs the program and gives its JSON."""
    command = [str(ROOT / "dirt"), *map(str, arguments), "--json", "--quiet"]
    print("$", " ".join(command), file=sys.stderr, flush=True)
    run = subprocess.run(command, stdout=subprocess.PIPE)
    if run.returncode not in statuses:
        sys.exit(f"exit status {run.returncode}")
    return json.loads(run.stdout)


def machine():
    """The processor and the compiler, in words."""
    model = platform.machine()
    for line in open("/proc/cpuinfo"):
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    compiler = subprocess.run(["c++", "--version"], stdout=subprocess.PIPE, text=True).stdout
    return (f"{os.cpu_count()} threads of a machine whose processor calls itself “{model}”, "
            f"{compiler.splitlines()[0]}, {datetime.date.today():%d %B %Y}.")


def table(head, rows):
    """A Markdown table; all columns but the first are numbers."""
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def number(value):
    """Three digits, or all of an integer's."""
    if value >= 1000:
        return f"{value:,.0f}"
    if value >= 100:
        return f"{value:.0f}"
    return f"{value:.3g}"


def fill(page, blocks):
    """Replaces the measured blocks of a page."""
    path = ROOT / "docs" / page
    text = path.read_text()
    for name, content in blocks.items():
        pattern = re.compile(rf"(<!-- measured {re.escape(name)} -->\n).*?(<!-- end -->)", re.S)
        text, found = pattern.subn(lambda match: match[1] + content + "\n" + match[2], text)
        if found != 1:
            sys.exit(f"{page}: {found} blocks are called {name}")
    path.write_text(text)


def measure_frame(rounds):
    """Each part of a frame beside Embree's time."""
    rows, work = [], []
    for path, title, camera in scenes():
        scene = dirt("bench", "frame", path, *camera, "--rounds", rounds)["scenes"][0]
        for part, ratio in scene["ratio"].items():
            ours, theirs = scene["dirt_ms"].get(part), scene["embree_ms"].get(part)
            if ours is None or theirs is None:
                continue
            spread = scene["spread"]
            rows.append([f"{title}, {scene['triangles']:,}" if part == "build" else "", part,
                         f"{number(ours)} ({number(spread['dirt_least_ms'][part])}–"
                         f"{number(spread['dirt_most_ms'][part])})",
                         f"{number(theirs)} ({number(spread['embree_least_ms'][part])}–"
                         f"{number(spread['embree_most_ms'][part])})", f"**{ratio:.2f}**"])
        morton, floor = scene["embree_morton"], scene["build_floor"]
        rows.append(["", "build, Morton", number(scene["dirt_ms"]["build"]),
                     number(morton["build_ms"]), f"**{morton['build_ratio']:.2f}**"])
        rows.append(["", f"build, floor at {floor['bandwidth_gb_s']:.1f} GB/s",
                     number(scene["dirt_ms"]["build"]), number(floor["ms"]),
                     f"{scene['dirt_ms']['build'] / floor['ms']:.1f}"])
        memory = scene["memory"]
        rows.append(["", "memory, MB", number(memory["dirt_ads"] / 1e6),
                     number(memory["embree_bvh"] / 1e6),
                     f"**{memory['dirt_ads'] / memory['embree_bvh']:.2f}**"])
        for part, counts in scene.get("work", {}).items():
            rays = counts["rays"]
            work.append([f"{title}, {part}", f"{rays:,}"] +
                        [number(counts[key] / rays) for key in counts if key != "rays"])
            keys = [key for key in counts if key != "rays"]
    return {
        "frame": table(["scene, triangles", "", "dirt, ms", "Embree, ms", "ratio"], rows),
        "work": table(["", "rays", *keys], work),
    }


def measure_scaling(rounds):
    """Time against triangles and pixels."""
    with tempfile.TemporaryDirectory() as folder:
        report = dirt("bench", "scaling", "--rounds", rounds, "-o", folder)
        for name in ("scaling-triangles.svg", "scaling-size.svg"):
            shutil.copy(pathlib.Path(folder) / name, IMAGES)
    rows = [[f"{point['triangles']:,}", "×".join(map(str, point["size"])),
             number(point["build_ms"]), number(point["embree_build_ms"]),
             number(point["sample_ms"]), number(point["embree_sample_ms"]),
             number(point["memory"] / 1e6)] for point in report["triangles"] + report["sizes"]]
    return {
        "scaling": table(["triangles", "size", "build, ms", "Embree's", "sample, ms", "Embree's",
                          "memory, MB"], rows),
        "exponent": f"From 100,000 triangles on, build time grows with exponent "
                    f"**{report['build_exponent']:.3f}** (Embree's: "
                    f"{report['embree_build_exponent']:.3f}).",
    }


def sweep_table(reports, sweep):
    """Build, sample and memory of one sweep, scene beside scene."""
    head = [sweep]
    rows = {}
    for title, report in reports.items():
        head += [f"{title}: build", "sample", "MB"]
        for point in report["points"]:
            if point["sweep"] == sweep:
                rows.setdefault(point["value"], [point["value"]])
                rows[point["value"]] += [number(point["build_ms"]), number(point["sample_ms"]),
                                         number(point["memory"] / 1e6)]
    return table(head, rows.values())


def name_of(report, settings):
    """The first point with these settings."""
    if settings == 0:
        return "as given"
    point = next(p for p in report["points"] if p["settings"] == settings)
    return f"{point['sweep']} {point['value']}"


def error_table(report):
    """Error at equal samples and at equal time of each different image."""
    curves = {}
    for error in report["errors"]:
        curves.setdefault(error["settings"], []).append(error)
    budget = curves[0][-1]["ms"] / 4
    rows = []
    for settings, curve in curves.items():
        last = curve[-1]
        within = [e for e in curve if e["ms"] <= budget * 1.5] or curve[:1]
        near = min(within, key=lambda e: abs(e["ms"] - budget))
        rows.append([name_of(report, settings), number(last["relative_mse"]),
                     number(last["flip"]), number(near["relative_mse"]), number(near["flip"]),
                     near["samples"]])
    return table(["", f"relative MSE at {curves[0][-1]['samples']} spp", "FLIP",
                  f"relative MSE after {budget / 1000:.1f} s", "FLIP", "spp then"], rows)


def samples_table(reports):
    """Time and error of the settings as given against the samples."""
    head = ["samples"]
    rows = {}
    for title, report in reports.items():
        head += [f"{title}: s", "relative MSE", "FLIP"]
        for error in report["errors"]:
            if error["settings"] == 0:
                rows.setdefault(error["samples"], [error["samples"]])
                rows[error["samples"]] += [number(error["ms"] / 1000),
                                           number(error["relative_mse"]), number(error["flip"])]
    return table(head, rows.values())


def grid_table(reports):
    """The best tile and bins for each wish, by the cross sweep."""
    rows = []
    for title, report in reports.items():
        points = [p for p in report["points"] if p["sweep"] == "tile/bins"]
        wishes = {
            "one sample a frame, everything moves": lambda p: p["build_ms"] + p["sample_ms"],
            "16 samples a frame": lambda p: p["build_ms"] + 16 * p["sample_ms"],
            "the quickest build": lambda p: p["build_ms"],
            "the least memory": lambda p: p["memory"],
        }
        for wish, cost in wishes.items():
            best = min(points, key=cost)
            rows.append([f"{title}: {wish}", best["value"], number(best["build_ms"]),
                         number(best["sample_ms"]), number(best["memory"] / 1e6)])
    return table(["what counts", "tile/bins", "build, ms", "sample, ms", "MB"], rows)


CHOICES = ("fetch", "primary", "precision", "shading", "visibility", "view", "bounces")


def choice_table(reports):
    """What each choice saves or costs against the settings as given: the least and the most of the
    scenes."""
    rows = []
    shown = next(iter(reports.values()))["points"]
    for place, point in enumerate(shown):
        if point["sweep"] not in CHOICES or point["settings"] == 0:
            continue
        cells = {"build": [], "sample": [], "MB": [], "error": [], "flip": []}
        for report in reports.values():
            here = report["points"][place]
            given = next(p for p in report["points"] if p["settings"] == 0)
            cells["build"].append(here["build_ms"] / given["build_ms"])
            cells["sample"].append(here["sample_ms"] / given["sample_ms"])
            cells["MB"].append(here["memory"] / given["memory"])
            last = {e["settings"]: e for e in report["errors"]}
            image, reference = last[here["same_image_as"]], last[0]
            cells["error"].append(image["relative_mse"] / reference["relative_mse"])
            cells["flip"].append(image["flip"] - reference["flip"])
        same = all(r["points"][place]["same_image_as"] == 0 for r in reports.values())
        span = {key: "–".join(dict.fromkeys(f"{x:.2f}" for x in (min(v), max(v))))
                for key, v in cells.items()}
        rows.append([f"`--{point['sweep']} {point['value']}`", span["build"], span["sample"],
                     span["MB"], "the same" if same else span["error"],
                     "the same" if same else span["flip"]])
    return table(["against the settings as given", "build ×", "sample ×", "memory ×",
                  "relative MSE ×", "FLIP +"], rows)


def single_pictures(titles):
    """Full and single views side by side, and where they differ."""
    lines = ["| | full | single | relative error of single |", "|---|---|---|---|"]
    for title in titles:
        cells = [f"![](images/tradeoffs/{title}-{name}.png)"
                 for name in ("as-given", "view-single", "view-single-error")]
        lines.append("| " + " | ".join([title, *cells]) + " |")
    return "\n".join(lines)


def misses_table(misses):
    """What the fast test loses, invents and takes for another, of each kind of ray."""
    rows = [[f"{title}, {kind}", f"{counts['rays']:,}", f"{counts['missed']:,}",
             f"{counts['false_hits']:,}", f"{counts['wrong_primitive']:,}"]
            for title, report in misses.items() for kind, counts in report["kinds"].items()]
    return table(["", "rays", "missed", "false hits", "wrong triangles"], rows)


# Pictures of a quarter of the default's pixels.
TRADEOFF = ["--size", "512x256", "--tile", 16, "--bins", 16]


def keep_errors(kept, samples, reference):
    """Leaves the errors of images and of rays in a folder."""
    for path, title, camera in scenes():
        dirt("bench", "tradeoff", path, *camera, *TRADEOFF, "--rounds", 1, "--error-spp", samples,
             "--reference-spp", reference, "--references", kept / "references", "-o", kept / title)
        misses = dirt("verify", path, *camera, "--precision", "fast", "--rays", 100000,
                      statuses=(0, 1))  # 1: it misses some
        (kept / title / "misses.json").write_text(json.dumps(misses, indent=2) + "\n")


def measure_tradeoff(rounds, kept):
    """Every choice against the others."""
    reports, misses = {}, {}
    for path, title, camera in scenes():
        known = next((kept / title).glob("*-tradeoff.json"), None)
        if not known or not (kept / title / "misses.json").exists():
            sys.exit(f"{kept / title} has no errors: first --only errors")
        misses[title] = json.loads((kept / title / "misses.json").read_text())
        with tempfile.TemporaryDirectory() as folder:
            reports[title] = dirt("bench", "tradeoff", path, *camera, *TRADEOFF, "--rounds", rounds,
                                  "--errors", known, "-o", folder)
            stem = reports[title]["scene"]
            for file in pathlib.Path(folder).glob(f"{stem}-*.svg"):
                shutil.copy(file, IMAGES / file.name.replace(stem, title, 1))
            for name in ("as-given", "view-single", "view-single-error"):
                shutil.copy(kept / title / f"{stem}-{name}.png", IMAGES / f"{title}-{name}.png")
    first = next(iter(reports.values()))
    sweeps = dict.fromkeys(p["sweep"] for p in first["points"])
    blocks = {sweep: sweep_table(reports, sweep) for sweep in sweeps}
    blocks["errors"] = "\n\n".join(f"**{title}**\n\n{error_table(report)}"
                                   for title, report in reports.items())
    blocks["single"] = single_pictures(reports)
    blocks["samples"] = samples_table(reports)
    blocks["grids"] = grid_table(reports)
    blocks["choice"] = choice_table(reports)
    blocks["misses"] = misses_table(misses)
    blocks["how"] = (f"{rounds} rounds; errors at {first['errors'][-1]['samples']} samples a pixel, "
                     f"against {first['reference_spp']:,} of the reference.")
    return blocks


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--only", default="errors,frame,scaling,tradeoff")
    parser.add_argument("--kept", type=pathlib.Path, default=ROOT / "build/tradeoff")
    parser.add_argument("--error-spp", type=int, default=64, help="samples of images with errors")
    parser.add_argument("--reference-spp", type=int, default=1024)
    options = parser.parse_args()
    IMAGES.mkdir(parents=True, exist_ok=True)
    parts = options.only.split(",")
    kept = options.kept.resolve()
    if "errors" in parts:
        keep_errors(kept, options.error_spp, options.reference_spp)
    if "frame" in parts:
        fill("performance.md", {"machine": machine()} | measure_frame(options.rounds))
    if "scaling" in parts:
        fill("performance.md", {"scaling machine": machine()} | measure_scaling(options.rounds))
    if "tradeoff" in parts:
        fill("tradeoffs.md", {"machine": machine()} | measure_tradeoff(options.rounds, kept))


if __name__ == "__main__":
    main()
