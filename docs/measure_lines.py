#!/usr/bin/env python3
"""Lines of C++ and GLSL a folder, at commits beside each other.

    docs/measure_lines.py COMMIT…      (default: HEAD)

Lines of code: neither empty nor comment alone. The last row is core and shaders together, where what
one language computes after the other stands once.
"""

import collections
import io
import subprocess
import sys
import tarfile

ENDINGS = (".h", ".cpp", ".glsl", ".comp", ".frag", ".geom", ".vert")
FOLDERS = ("core", "shaders", "backend_cpu", "backend_gl", "backend_embree", "app", "bench", "scenes",
           "tests")


def lines_of_code(text):
    lines = (line.strip() for line in text.splitlines())
    return sum(bool(line) and not line.startswith("//") for line in lines)


def count(commit):
    archive = subprocess.run(["git", "archive", commit], check=True, stdout=subprocess.PIPE).stdout
    counts = collections.Counter()
    with tarfile.open(fileobj=io.BytesIO(archive)) as files:
        for member in files:
            folder = member.name.split("/")[0]
            if member.isfile() and folder in FOLDERS and member.name.endswith(ENDINGS):
                counts[folder] += lines_of_code(files.extractfile(member).read().decode())
    counts["core and shaders"] = counts["core"] + counts["shaders"]
    return counts


def main():
    commits = sys.argv[1:] or ["HEAD"]
    names = [subprocess.run(["git", "rev-parse", "--short", commit], check=True, text=True,
                            stdout=subprocess.PIPE).stdout.strip() for commit in commits]
    counts = [count(commit) for commit in commits]
    print(f"{'lines of code':18}" + "".join(f"{name:>10}" for name in names))
    for folder in FOLDERS + ("core and shaders",):
        print(f"{folder:18}" + "".join(f"{each[folder]:>10}" for each in counts))


if __name__ == "__main__":
    main()
