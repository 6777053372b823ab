#!/usr/bin/env python3
"""Renders the gallery's five scenes, full and single, and writes docs/gallery.md's pictures,
commands and times.

    docs/measure_gallery.py [--spp N] [--size WxH] [--only NAME,…] [--output FOLDER]

renders 1024x512 at 64 samples unless told otherwise, on the default backend. Pictures go to
docs/images; tables of what was measured stand in the page between <!-- measured NAME --> and
<!-- end -->. With --output nothing in docs changes: pictures and page go to that folder, to try
things out.
"""

import argparse
import datetime
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = ["atrium", "hangar", "temples", "bunny_day", "bunny_night"]
VIEWS = ["full", "single"]
WIDTH = 768  # of the pictures


def command_of(scene, view, arguments):
    """What the page says; defaults are left out."""
    parts = ["./dirt render", f"scenes/{scene}.scene", f"--spp {arguments.spp}"]
    if arguments.size != "1024x512":
        parts.append(f"--size {arguments.size}")
    if view == "single":
        parts.append("--view single")
    return " ".join(parts)


def render(scene, view, arguments, folder):
    """The picture, and what the program says of the frame."""
    png, stats = folder / f"{scene}_{view}.png", folder / f"{scene}_{view}.json"
    command = command_of(scene, view, arguments)
    print("$", command, file=sys.stderr, flush=True)
    subprocess.run(["./dirt", *command.split()[1:], "-o", png, "--stats", stats, "--quiet"],
                   cwd=ROOT, check=True)
    return png, json.loads(stats.read_text())


def shrink(png, target):
    """A JPEG that a page can carry: the same encoding, every pixel the mean of those it stands for."""
    if not shutil.which("oiiotool"):
        sys.exit("oiiotool is missing: apt-get install openimageio-tools")
    subprocess.run(["oiiotool", png, "--resize:filter=box", f"{WIDTH}x0", "--compression", "jpeg:88",
                    "--attrib", "jpeg:subsampling", "4:2:0", "--eraseattrib", ".*", "-o", target],
                   check=True)


def seconds(stats, *passes):
    """Of the named passes together."""
    return sum(p["ms"] for p in stats["passes"] if p["name"] in passes) / 1000


def table(rows):
    """One row a view; the rest of a frame is what no column names."""
    columns = {"build": ("Clear", "FillDepth", "FillDepthMipmap", "FillPrimitives", "ShadowMap"),
               "first surfaces": ("DirectVisibility",),
               "Trace": ("Trace",), "Fetch": ("Fetch",), "Visibility": ("Visibility",),
               "Shade": ("Shade",)}
    lines = ["| view | rays, millions | frame, s | " + " | ".join(columns) + " | memory, MB |",
             "|---|" + "---:|" * (len(columns) + 3)]
    for view, stats in rows:
        cells = [view, f"{stats['rays'] / 1e6:.1f}", f"{stats['frame_ms'] / 1000:.1f}"]
        cells += [f"{seconds(stats, *passes):.2f}" for passes in columns.values()]
        cells.append(f"{stats['memory']['total'] / 1e6:.0f}")
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def machine(stats):
    model = "an unknown processor"
    for line in open("/proc/cpuinfo"):
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    return (f"Times are from {stats['threads']} threads of {os.cpu_count()} that call themselves "
            f"“{model}”, {datetime.date.today():%d %B %Y}, by `docs/measure_gallery.py`.")


def fill(text, name, content):
    """Replaces a measured block of the page."""
    pattern = re.compile(rf"(<!-- measured {re.escape(name)} -->\n).*?(<!-- end -->)", re.S)
    text, found = pattern.subn(lambda match: match[1] + content + "\n" + match[2], text)
    if found != 1:
        sys.exit(f"gallery.md: {found} blocks are called {name}")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--size", default="1024x512")
    parser.add_argument("--only", default=",".join(SCENES))
    parser.add_argument("--output", type=pathlib.Path)
    arguments = parser.parse_args()
    output = arguments.output.resolve() if arguments.output else ROOT / "docs"
    (output / "images").mkdir(parents=True, exist_ok=True)
    text = (ROOT / "docs/gallery.md").read_text()
    with tempfile.TemporaryDirectory() as name:
        for scene in arguments.only.split(","):
            rows = []
            for view in VIEWS:
                png, stats = render(scene, view, arguments, pathlib.Path(name))
                picture = scene if view == "full" else f"{scene}_{view}"
                shrink(png, output / "images" / f"{picture}.jpg")
                rows.append((f"`{command_of(scene, view, arguments)}`", stats))
            alone = f"![By the camera's view alone](images/{scene}_single.jpg)"
            text = fill(text, scene, alone + "\n\n" + table(rows))
            text = fill(text, "machine", machine(rows[-1][1]))
            # What is done is kept, as a whole run takes long.
            (output / "gallery.md").write_text(text)


main()
