#!/usr/bin/env python3
"""Runs what is too long for the suite, one stage after the other, and prints a table.

    tests/nightly/nightly.py [--only NAME[,NAME...]] [--fuzz-minutes N] [--soak-minutes N] [-o FILE]

Each stage is a command, or some, in the repository's root; its output goes to build/nightly/NAME.log. A
stage is green if all its commands end with status 0. The table, in Markdown, has the time and the peak
memory of the largest process of each stage. The exit status is 1 if a stage is not green.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOGS = ROOT / "build" / "nightly"
DIRT = str(ROOT / "dirt")
FUZZERS = ["cache", "gltf", "gltf_tree", "image", "manifest", "mtl", "obj", "replay",
           "scene", "texture"]
# Also for the program that builds run to make the scenes.
SANITIZERS = {"TSAN_OPTIONS": f"suppressions={ROOT}/tests/tsan.supp"}
SCENES = pathlib.Path(os.environ.get("DIRT_SCENES", ROOT / "../shared/scenes"))


class Skip(Exception):
    """A stage that cannot run here; says why."""


class Stage:
    """Commands that run one after the other, until one fails."""

    def __init__(self, name):
        self.log = open(LOGS / f"{name}.log", "w", buffering=1)
        self.peak = 0  # bytes

    def run(self, *command, env=None, output=None):
        """Returns whether the command ends with status 0."""
        self.log.write(f"$ {' '.join(map(str, command))}\n")
        process = subprocess.Popen([str(part) for part in command], cwd=ROOT,
                                   env={**os.environ, **SANITIZERS, **(env or {})},
                                   stdin=subprocess.DEVNULL,
                                   stdout=output or self.log, stderr=self.log)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.peak = max(self.peak, usage.ru_maxrss * 1024)
        return process.returncode == 0


def full(stage, _):
    """./dirt test --full without the fuzzers, which have a stage of their own."""
    return stage.run(DIRT, "test", "--full", env={"DIRT_TEST_NO_FUZZ": "1"})


def sanitized(preset):
    def run(stage, _):
        build = ROOT / "build" / preset
        return (stage.run("cmake", "--preset", preset)
                and stage.run("cmake", "--build", build)
                and stage.run("ctest", "--test-dir", build, "-j", os.cpu_count() or 1,
                              "--output-on-failure", "--timeout", "7200"))
    return run


def fuzz(stage, options):
    build = ROOT / "build" / "fuzz"
    if not (stage.run("cmake", "--preset", "fuzz") and stage.run("cmake", "--build", build)):
        raise Skip("the fuzzers do not build: they need clang and libclang-rt-14-dev")
    green = True
    for name in FUZZERS:
        seeds = {"gltf_tree": "gltf", "image": "texture"}.get(name, name)
        green &= stage.run(build / "tests" / "fuzz" / f"{name}_fuzzer",
                           f"-max_total_time={60 * options.fuzz_minutes}", "-max_len=20000",
                           "-timeout=30", "-rss_limit_mb=4096",
                           f"-artifact_prefix={build}/finds/{name}-",
                           build / "corpus" / name, ROOT / "tests" / "fuzz" / "seeds" / seeds)
    return green


def tidy(stage, _):
    """clang-tidy over all sources but the tests, the files of a folder together."""
    build = ROOT / "build" / "tidy"
    if not shutil.which("clang-tidy"):
        raise Skip("needs clang-tidy")
    if not stage.run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DDIRT_UNITY=ON",
                     "-DDIRT_TESTS=OFF", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"):
        return False
    files = [entry["file"] for entry in json.loads((build / "compile_commands.json").read_text())]
    # What the build itself makes is there after it; of the shaders' text there is nothing to say.
    return all([stage.run("clang-tidy", "-p", build, "--quiet", file) for file in files
                if not file.endswith("embedded_shaders.cpp")])


def scene_files():
    if not SCENES.is_dir():
        raise Skip(f"no {SCENES}")
    files = [file for suffix in ("*.obj", "*.glb", "*.gltf") for file in SCENES.rglob(suffix)
             if "invalid" not in file.parts and "OBJ" not in file.parts]
    return sorted(files)


def extremes(stage, _):
    """verify --extremes over all real scenes on the CPU, over three with OpenGL."""
    files = scene_files()
    green = all([stage.run(DIRT, "verify", file, "--extremes", "--no-cache", "--quiet")
                 for file in files])
    small = sorted(files, key=lambda file: file.stat().st_size)[:3]
    return green and all([stage.run(DIRT, "verify", file, "--extremes", "--no-cache", "--quiet",
                                    "--backend", "gl") for file in small])


def scenes(preset):
    """The sanitized program over the real scenes: render, dump, verify."""
    def run(stage, _):
        program = ROOT / "build" / preset / "dirt"
        green = True
        with tempfile.TemporaryDirectory() as folder:
            for file in scene_files():
                common = ["--size", "48x32", "--no-cache", "--quiet", "--threads", "8"]
                green &= stage.run(program, "render", file, "--spp", "1", *common, "-o",
                                   f"{folder}/a.png")
                green &= stage.run(program, "dump", file, *common, "-o", f"{folder}/dump")
                if preset != "tsan":  # Embree, which verify needs, has races of its own
                    green &= stage.run(program, "verify", file, "--rays", "200", *common)
        return green
    return run


def soak(stage, options):
    """Thousands of frames of a scene that moves: the peak of the second half is that of the first."""
    peaks = []
    with tempfile.TemporaryDirectory() as folder:
        end = time.monotonic() + 60 * options.soak_minutes
        frames = 250
        while time.monotonic() < end:
            part = Stage("soak-part")
            if not part.run(DIRT, "render", "scenes/turning.scene", "--frames", f"0:{frames}",
                            "--size", "32x16", "--spp", "1", "--quiet", "-o", f"{folder}/a.png"):
                return False
            peaks.append((frames, part.peak))
            stage.peak = max(stage.peak, part.peak)
            frames = min(2 * frames, 8000)
    stage.log.write("".join(f"{n} frames: {peak} bytes\n" for n, peak in peaks))
    return len(peaks) > 1 and peaks[-1][1] < 1.02 * peaks[0][1]


STAGES = {
    "full": full,
    "asan-ubsan": sanitized("asan-ubsan"),
    "tsan": sanitized("tsan"),
    "asan-scenes": scenes("asan-ubsan"),
    "tsan-scenes": scenes("tsan"),
    "fuzz": fuzz,
    "tidy": tidy,
    "extremes": extremes,
    "soak": soak,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", help="of " + ", ".join(STAGES))
    parser.add_argument("--fuzz-minutes", type=int, default=10, help="each (default: 10)")
    parser.add_argument("--soak-minutes", type=int, default=20, help="(default: 20)")
    parser.add_argument("-o", "--output", help="file for the table, beside standard output")
    options = parser.parse_args()
    names = options.only.split(",") if options.only else list(STAGES)
    for name in names:
        if name not in STAGES:
            parser.error(f"--only {name}: there are {', '.join(STAGES)}")
    LOGS.mkdir(parents=True, exist_ok=True)

    lines = ["| stage | result | minutes | peak memory, MB |", "|---|---|---:|---:|"]
    print("\n".join(lines), flush=True)
    failed = False
    for name in names:
        stage = Stage(name)
        start = time.monotonic()
        try:
            green = STAGES[name](stage, options)
            result = "green" if green else f"FAILED, see {stage.log.name}"
            failed |= not green
        except Skip as reason:
            result = f"skipped: {reason}"
        minutes = (time.monotonic() - start) / 60
        lines.append(f"| {name} | {result} | {minutes:.1f} | {stage.peak / 1e6:.0f} |")
        print(lines[-1], flush=True)
    if options.output:
        pathlib.Path(options.output).write_text("\n".join(lines) + "\n")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
