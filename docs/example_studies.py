"""Runs the commands of the page docs/example_studies.md as they are printed.

example_studies.py ROOT PROGRAM FOLDER RESULTS

The commands run in FOLDER, which has links to the chapters of ROOT and to the program. Commands of
variations do not run. The figures, FOLDER/out/*.svg, are copied to RESULTS.
"""

import pathlib
import re
import shutil
import subprocess
import sys


def studies(root):
    """Returns the shell commands of each study, by its name: (those of the figure, of the variation)."""
    text = (root / "docs/example_studies.md").read_text()
    found = {}
    for part in text.split("\n## ")[1:]:
        name = re.search(r"\{#example_(\w+)\}", part)[1]
        blocks = [re.findall(r"^```sh\n(.*?)^```", piece, re.MULTILINE | re.DOTALL)
                  for piece in part.split("**Variation.**")]
        found[name] = tuple("".join(commands) for commands in blocks)
    return found


def run(commands, root, program, folder):
    """Runs commands in a folder; prints their output and stops if one of them fails."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, target in ("chapters", root / "chapters"), ("stokes", program):
        (folder / name).unlink(missing_ok=True)
        (folder / name).symlink_to(target.resolve())
    done = subprocess.run(["sh", "-e", "-c", commands], cwd=folder, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        raise SystemExit(f"{done.stdout}\nexample_studies.py: a command of the page has failed")


def main(root, program, folder, results):
    shutil.rmtree(folder, ignore_errors=True)
    for commands, _ in studies(root).values():
        run(commands, root, program, folder)
    results.mkdir(parents=True, exist_ok=True)
    for figure in sorted(folder.glob("out/*.svg")):
        shutil.copy(figure, results)


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:]))
