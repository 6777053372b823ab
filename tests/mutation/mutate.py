#!/usr/bin/env python3
"""Changes each margin of shaders/shared/margins.h, one at a time, and shows which test notices.

    tests/mutation/mutate.py [--side core|cpu|gl] [--margin NAME] [--factor 0|0.5]

Every margin is set to zero and halved on each side that uses it: core, backend_cpu, and the shaders.
The tests are built in build/mutation/plain, file by file. For C++ the sources that see a margin are compiled once more,
into build/mutation, with a header before all others that reads the margins from the environment, and
linked before the libraries; so one build serves all. For the shaders DIRT_SHADERS names edited
copies. Only the tests that concern a margin are run, in their short form. Prints a
table, and ends with status 1 if something survives that ROOM does not explain.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "mutation"
PLAIN = BUILD / "plain"
MARGINS = ROOT / "shaders" / "shared" / "margins.h"
DECLARATION = re.compile(r"const (float|double) (k\w+) = ([^;]+);")

SOURCES = {
    "core": ["core/**/*.cpp", "core/**/*.h", "shaders/shared/*.h"],
    "cpu": ["backend_cpu/**/*.cpp", "backend_cpu/**/*.h", "shaders/shared/hit_rules.h"],
    "gl": ["shaders/*.*", "shaders/include/*", "shaders/shared/hit_rules.h",
           "shaders/shared/border_crossing.h", "shaders/shared/tile_clip.h"],
}

# Test programs that concern a margin, those that end soonest first.
# The last of a list counts a derivation anew: what only that one notices has room behind it.
GRID = ["grid_coverage_test", "bounds_grid_test", "grid_margins_test"]
HITS = ["trace_offset_test", "trace_intersect_test", "bounds_trace_test", "grid_margins_test"]
WALK = ["trace_margins_test", "trace_view_cone_test", "bounds_trace_test", "trace_visit_test",
        "trace_closest_hit_test", "grid_margins_test"]
FILTER = ["trace_ray_filter_test", "bounds_filter_test", "grid_margins_test"]
LEAVES = ["cpu_leaf_boxes_test", "bounds_cpu_test", "cpu_margins_test"]
LIGHT = ["cpu_light_lists_test", "cpu_light_grid_test", "cpu_margins_test"]
TESTS = {
    "core": {"kGuardBand": GRID, "kSignDoubt": GRID, "kDepthMargin": GRID,
             "kLateralError": FILTER,
             "kCrossingSlack": WALK, "kCornerDoubt": WALK, "kDepthSlack": WALK,
             "kConeInset": WALK, "kFinality": WALK, "kRelativeErrorT": WALK},
    "cpu": {"kSignDoubt": ["cpu_builder_test", "cpu_margins_test"],
            "kDepthMargin": ["cpu_builder_test", "cpu_margins_test"],
            "kCellSlack": LEAVES, "kThinDoubt": LEAVES},
    "gl": {"kSignDoubt": ["gl_build_test"], "kDepthMargin": ["gl_build_test"],
           "kRelativeErrorT": ["gl_trace_test"], "kFinality": ["gl_trace_test"]},
}
OTHERWISE = {"core": HITS, "cpu": ["cpu_tracer_test", "cpu_margins_test"],
             "gl": ["gl_margins_test"]}

# (margin, side, factor): why nothing has to notice.
ROOM = {
    ("kLeastDirection", "cpu", "0.5"):
        "smaller is more exact; only overflow bounds it from below",
    ("kNeedle", "gl", "0.5"):
        "a normal good for 2^-19: 2^-42 of the point, which no float shows; core's side holds it",
    ("kLateralError", "gl", "0.5"):
        "then 8 u N, core's own, enough where division is exact; 12 are for 2.5 ulp of it",
}


def margins():
    return [match[1] for match in DECLARATION.findall(MARGINS.read_text())]


def sides_of(margin):
    """The sides whose code names a margin."""
    word = re.compile(rf"\b{margin}\b")
    return [side for side, patterns in SOURCES.items()
            if any(word.search(path.read_text()) for pattern in patterns
                   for path in ROOT.glob(pattern) if path.is_file() and path != MARGINS)]


def tests_of(margin, side):
    if side == "cpu" and margin.startswith("kLight"):
        return LIGHT
    return TESTS[side].get(margin, OTHERWISE[side])


HEADER = """
#include <cstdlib>
#include <cstring>
namespace dirt {
inline double mutated(const char* source, const char* name, double value) {
    const char* const wish = std::getenv("DIRT_MUTATE");
    const char* const side =
        std::strstr(source, "backend_cpu/") || std::strstr(source, "tests/cpu/") ? "cpu" : "core";
    if (!wish || std::strncmp(wish, side, std::strlen(side)) != 0) return value;
    const char* const rest = wish + std::strlen(side) + 1;
    const size_t length = std::strlen(name);
    if (std::strncmp(rest, name, length) != 0 || rest[length] != ':') return value;
    return value * std::atof(rest + length + 1);
}
}
#undef DIRT_FUNCTION
#define DIRT_FUNCTION static inline
"""


def write_header():
    """Margins that DIRT_MUTATE=SIDE:NAME:FACTOR multiplies."""
    text = DECLARATION.sub(
        r'static const \1 \2 = (\1) dirt::mutated(__BASE_FILE__, "\2", \3);', MARGINS.read_text())
    text = text.replace("DIRT_SHARED_BEGIN", HEADER + "DIRT_SHARED_BEGIN", 1)
    header = BUILD / "margins.h"
    if not header.exists() or header.read_text() != text:
        BUILD.mkdir(parents=True, exist_ok=True)
        header.write_text(text)
    return header


def ninja(*arguments):
    return subprocess.run(["ninja", "-C", PLAIN, *arguments], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def names_margin(file, known={}):
    """Whether the code of a file, but for comments, names a margin."""
    if file not in known:
        code = re.sub(r"//.*", "", pathlib.Path(file).read_text(errors="replace"))
        known[file] = bool(re.search(rf"\b({'|'.join(margins())})\b", code))
    return known[file]


def build_cpp(jobs, programs):
    header = write_header()
    commands = {entry["output"]: entry for entry in json.loads(ninja("-t", "compdb"))}
    of_test = {f"tests/CMakeFiles/{program}.dir/" for program in programs}
    objects = {}
    for block in ninja("-t", "deps").split("\n\n"):
        output, *files = block.strip().split("\n")
        output = output.split(":")[0]
        if output not in commands or not (
                output.startswith(("core/", "backend_cpu/")) or
                any(output.startswith(folder) for folder in of_test)):
            continue
        files = [os.path.normpath(PLAIN / file.strip()) for file in files]
        files = [file for file in files if file.startswith(str(ROOT)) and file != str(MARGINS)]
        if any(names_margin(file) for file in files):
            objects[output] = files

    def compile_one(output):
        target = BUILD / output
        newest = max(os.path.getmtime(file) for file in [*objects[output], header])
        if target.exists() and target.stat().st_mtime > newest:
            return
        target.parent.mkdir(parents=True, exist_ok=True)
        command = re.sub(r"-M[DTF]+( \S+\.o(\.d)?)?", "", commands[output]["command"])
        command = command.replace(f"-o {output}", f"-include {header} -o {target}")
        subprocess.run(command + " -Wno-unused-variable -Wno-unused-function", shell=True, check=True,
                       cwd=PLAIN)

    def link(program):
        command = ninja("-t", "commands", f"tests/{program}").strip().split("\n")[-1]
        own = re.search(r"(tests/\S+\.o) -o", command)[1]
        inputs = [BUILD / own if own in objects else own,
                  *(BUILD / o for o in objects if o.startswith(("core/", "backend_cpu/")))]
        (BUILD / "tests").mkdir(exist_ok=True)
        command = command.replace(f"{own} -o tests/{program}",
                                  " ".join(map(str, inputs)) + f" -o {BUILD}/tests/{program}")
        subprocess.run(command, shell=True, check=True, cwd=PLAIN)

    with ThreadPoolExecutor(int(jobs)) as pool:
        list(pool.map(compile_one, objects))
        list(pool.map(link, programs))


def edited_shaders(margin, factor):
    folder = BUILD / "shaders"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "shaders", folder)
    file = folder / "shared" / "margins.h"
    file.write_text(re.sub(rf"(const (?:float|double) {margin} =) ([^;]+);",
                           rf"\1 {factor} * (\2);", file.read_text()))
    return folder


def killer(margin, side, factor):
    """The first test that fails, or None."""
    environment = dict(os.environ)
    folder = BUILD
    if side == "gl":
        folder = PLAIN
        if margin:
            environment["DIRT_SHADERS"] = str(edited_shaders(margin, factor))
    elif margin:
        environment["DIRT_MUTATE"] = f"{side}:{margin}:{factor}"
    for program in tests_of(margin, side):
        run = subprocess.run([folder / "tests" / program, "--gtest_fail_fast"], env=environment,
                             capture_output=True, text=True, errors="replace")
        if run.returncode != 0:
            failed = re.findall(r"\[  FAILED  \] ([\w./]+)", run.stdout)
            return f"{program}: {failed[0] if failed else 'ends with ' + str(run.returncode)}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--side", choices=SOURCES, action="append")
    parser.add_argument("--margin", action="append")
    parser.add_argument("--factor", choices=["0", "0.5"], action="append")
    parser.add_argument("--jobs", default=str(os.cpu_count()))
    parser.add_argument("--no-build", action="store_true")
    wanted = parser.parse_args()

    rows = [(margin, side) for margin in wanted.margin or margins() for side in sides_of(margin)
            if side in (wanted.side or SOURCES)]
    programs = {side: sorted({t for m, s in rows if s == side for t in tests_of(m, s)})
                for side in SOURCES}
    if not wanted.no_build:
        subprocess.run(["cmake", "-S", ROOT, "-B", PLAIN, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DDIRT_UNITY=OFF"], check=True, stdout=subprocess.DEVNULL)
        everything = sorted({program for side in programs.values() for program in side})
        ninja(f"-j{wanted.jobs}", *everything)
        build_cpp(wanted.jobs, sorted({*programs["core"], *programs["cpu"]}))

    survivors = 0
    print("| margin | side | zero | half |\n|---|---|---|---|", flush=True)
    for margin, side in rows:
        cells = []
        for factor in wanted.factor or ["0", "0.5"]:
            found = killer(margin, side, factor)
            reason = ROOM.get((margin, side, factor)) or ROOM.get((margin, factor))
            survivors += not found and not reason
            cells.append(found or reason or "SURVIVES")
        print(f"| `{margin}` | {side} | " + " | ".join(cells) + " |", flush=True)
    print(f"{survivors} unexplained survivors")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
