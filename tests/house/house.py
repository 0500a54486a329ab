"""Checks the rules of the house: which room may use which, and which files a commit may contain.

The functions use_violations, chapter_violations, folder_violations and file_violations take the root
of a tree and return the violations that they find, as text.
"""

import pathlib
import re
import subprocess

ONE_TO_THREE = {"trapezoid", "double_layer", "closure"}
METHODS = ONE_TO_THREE | {
    "null_space", "krylov", "near_singular", "stress", "fmm", "time_stepping", "stiv", "lcp",
    "preconditioning", "periodic"}

# Room of src/ -> rooms that it may use, without cycles. Only suspension and cli use all methods.
MAY_USE = {
    "text": set(),
    "trapezoid": set(),
    "double_layer": {"trapezoid"},
    "closure": {"trapezoid", "double_layer"},
    "null_space": ONE_TO_THREE,
    "krylov": ONE_TO_THREE | {"null_space"},
    "near_singular": {"trapezoid", "double_layer"},
    "stress": ONE_TO_THREE | {"near_singular"},
    "fmm": {"trapezoid", "double_layer"},
    "time_stepping": set(),
    "stiv": {"trapezoid"},
    "lcp": set(),
    "preconditioning": ONE_TO_THREE | {"null_space", "krylov", "fmm"},
    "periodic": {"trapezoid", "fmm"},
    "suspension": METHODS | {"text", "scene", "record"},
    "scene": {"text", "trapezoid", "time_stepping"},
    "record": {"text", "trapezoid", "periodic"},
    "sweep": {"text", "scene", "record"},
    "study": {"text", "record"},
    "analysis": {"text", "trapezoid", "scene", "record", "study"},
    "statistics": {"trapezoid", "near_singular", "suspension", "text", "scene", "record", "sweep",
                   "study", "analysis"},
    "cli": METHODS | {"text", "suspension", "scene", "record", "sweep", "study", "analysis",
                      "statistics"},
}

# Methods that a library may use although their chapters are read later.
READ_LATER = {"suspension": {"preconditioning", "periodic"}}

# Folders of src/suspension: each folder may use itself and the folders before it.
FOLDERS_OF_SUSPENSION = ["bodies", "nodes", "system", "solver", "contact", "motion"]
MOST_FILES_OF_A_FOLDER = 20

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
BUILDS_ON = re.compile(r"\*\*Builds on:\*\*(.*?)\*\*Library", re.DOTALL)
LIBRARY = re.compile(r"^stokesbook_library\(([^)]*)\)", re.MULTILINE)

# Absolute paths into folders of one machine; a URL or a relative path may contain such folders.
MACHINE_PATH = re.compile(r"(?<![\w.}])/(?:work|root|home|tmp)/\w+")
BUILD_OUTPUT = re.compile(
    r"(^|/)(build|out|__pycache__|CMakeFiles)/|CMakeCache\.txt$|\.(o|a|so|pyc|ninja|log)$")


def included_rooms(source):
    """Returns the rooms of all quoted includes of a source file; "" for an include without room."""
    return {name.partition("/")[0] if "/" in name else ""
            for name in INCLUDE.findall(source.read_text())}


def declared_uses(cmake_lists):
    """Returns the USES of the room's stokesbook_library(...), or None if it declares no library."""
    declaration = LIBRARY.search(cmake_lists.read_text())
    if declaration is None:
        return None
    uses, keyword = set(), None
    for word in declaration[1].split():
        if word.isupper():
            keyword = word
        elif keyword == "USES":
            uses.add(word)
    return uses


def use_violations(root):
    """Compares the includes and links of src/ with the table, and with each other."""
    violations = []
    for room in sorted(path for path in (root / "src").iterdir() if path.is_dir()):
        if room.name not in MAY_USE:
            violations.append(f"src/{room.name} is not in the table of rooms, MAY_USE")
            continue
        included = set()
        for source in sorted([*room.rglob("*.hpp"), *room.rglob("*.cpp")]):
            for used in sorted(included_rooms(source) - {room.name}):
                name = source.relative_to(root).as_posix()
                if used == "":
                    violations.append(
                        f'{name} includes a file without its room; write "room/file.hpp"')
                    continue
                included.add(used)
                if used not in MAY_USE[room.name]:
                    violations.append(
                        f"{name} includes from {used}, which {room.name} may not use")
        cmake_lists = room / "CMakeLists.txt"
        linked = declared_uses(cmake_lists) if cmake_lists.exists() else None
        if linked is None:
            continue
        for used in sorted(linked - MAY_USE[room.name]):
            violations.append(
                f"src/{room.name}/CMakeLists.txt links {used}, which {room.name} may not use")
        for used in sorted(included - linked):
            violations.append(
                f"src/{room.name} includes from {used}, but its CMakeLists.txt does not list "
                f"{used} in USES")
        for used in sorted(linked - included):
            violations.append(
                f"src/{room.name}/CMakeLists.txt lists {used} in USES, but nothing is included "
                f"from {used}")
    return violations


def chapter_violations(root):
    """Compares the chapters' order with the table of rooms, and with the chapters that they name.

    A library uses the libraries of earlier chapters, except for READ_LATER. The first paragraph of
    a chapter says that the chapter builds on earlier chapters.
    """
    violations = []
    folders = sorted((root / "chapters").glob("[0-9][0-9]_*"))
    numbers = {folder.name[3:]: int(folder.name[:2]) for folder in folders}
    for folder in folders:
        method, number = folder.name[3:], int(folder.name[:2])
        for used in sorted(MAY_USE.get(method, set()) - READ_LATER.get(method, set())):
            if numbers.get(used, 0) > number:
                violations.append(f"{method} may use {used}, whose chapter is read later")
        said = BUILDS_ON.search((folder / "chapter.md").read_text())
        for other in re.findall(r"chapter_(\d+)", said[1] if said else ""):
            if int(other) >= number:
                violations.append(f"{folder.name} builds on chapter {other}, which is not earlier")
    return violations


def folder_violations(root):
    """Compares includes in src/suspension with its folders' order; finds too large folders."""
    suspension, violations = root / "src" / "suspension", []
    for source in sorted([*suspension.rglob("*.hpp"), *suspension.rglob("*.cpp")]):
        name, folder = source.relative_to(root).as_posix(), source.parent.name
        if folder not in FOLDERS_OF_SUSPENSION:
            violations.append(f"{name} is in {folder}, which is not in FOLDERS_OF_SUSPENSION")
            continue
        allowed = FOLDERS_OF_SUSPENSION[:FOLDERS_OF_SUSPENSION.index(folder) + 1]
        for include in INCLUDE.findall(source.read_text()):
            used = include.split("/")
            if used[0] == "suspension" and used[1] not in allowed:
                violations.append(f"{name} includes {include}, which {folder} may not use")
    for folder in FOLDERS_OF_SUSPENSION:
        count = len(list((suspension / folder).glob("*.[hc]pp")))
        if count > MOST_FILES_OF_A_FOLDER:
            violations.append(
                f"src/suspension/{folder} has {count} files, more than {MOST_FILES_OF_A_FOLDER}")
    return violations


def committed_files(root):
    """Returns a checkout's files that are committed, or would be committed by `git add --all`."""
    listing = subprocess.run(
        ["git", "-c", "safe.directory=*", "-C", root,
         "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        check=True, capture_output=True, text=True).stdout
    return sorted({root / name for name in listing.split("\0") if name and (root / name).is_file()})


def file_violations(root):
    """Finds build outputs, and absolute paths that exist on one machine only."""
    violations = []
    for path in committed_files(root):
        name = path.relative_to(root).as_posix()
        content = path.read_bytes()
        if BUILD_OUTPUT.search(name) or content.startswith(b"\x7fELF"):
            violations.append(f"{name} is a build output, which must not be committed")
            continue
        for number, line in enumerate(content.decode("utf-8", "replace").splitlines(), 1):
            if found := MACHINE_PATH.search(line):
                violations.append(f"{name}:{number} contains a path of one machine, {found[0]}")
    return violations
