#!/usr/bin/env python3
"""Makes a package index for pip of distributions that the system has installed:

  wheel_index.py FOLDER NAME...

Each becomes a wheel in FOLDER/NAME, where pip looks for it: PIP_INDEX_URL=file://FOLDER pip install ...
"""
import base64
import hashlib
import re
import sys
import zipfile
from importlib import metadata
from pathlib import Path


def normal(name):
    return re.sub(r"[-_.]+", "-", name).lower()


def top_level(distribution):
    """Names of its modules and packages."""
    listed = distribution.read_text("top_level.txt")
    if listed:
        return listed.split()
    names = {file.parts[0] for file in distribution.files or []}
    found = sorted(name for name in names if name != ".." and not name.endswith(("-info", "__pycache__")))
    return found or [normal(distribution.metadata["Name"]).replace("-", "_")]


def files_of(distribution):
    """Pairs of the name in the wheel, and the file."""
    site = Path(distribution.locate_file(""))
    for name in top_level(distribution):
        place = site / name
        found = sorted(place.rglob("*")) if place.is_dir() else [place, site / (name + ".py")]
        for file in found:
            if file.is_file() and "__pycache__" not in file.parts:
                yield str(file.relative_to(site)), file


def make_wheel(name, folder):
    distribution = metadata.distribution(name)
    files = list(files_of(distribution))
    is_native = any(file.suffix == ".so" for _, file in files)
    python = "cp%d%d" % sys.version_info[:2]
    tag = "%s-%s-linux_x86_64" % (python, python) if is_native else "py3-none-any"
    base = "%s-%s" % (normal(name).replace("-", "_"), distribution.version)
    contents = {inside: file.read_bytes() for inside, file in files}
    contents[base + ".dist-info/METADATA"] = (
        distribution.read_text("METADATA") or distribution.read_text("PKG-INFO")).encode()
    contents[base + ".dist-info/WHEEL"] = (
        "Wheel-Version: 1.0\nGenerator: wheel_index\nRoot-Is-Purelib: %s\nTag: %s\n" % (not is_native, tag)).encode()
    entry_points = distribution.read_text("entry_points.txt")
    if entry_points:
        contents[base + ".dist-info/entry_points.txt"] = entry_points.encode()
    record = base + ".dist-info/RECORD"
    lines = ["%s,sha256=%s,%d" % (inside, digest(data), len(data)) for inside, data in contents.items()]
    contents[record] = "\n".join(lines + [record + ",,", ""]).encode()
    wheel = folder / ("%s-%s.whl" % (base, tag))
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for inside, data in contents.items():
            archive.writestr(inside, data)
    return wheel


def digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def main(folder, names):
    for name in names:
        place = Path(folder) / normal(name)
        place.mkdir(parents=True, exist_ok=True)
        wheel = make_wheel(name, place)
        (place / "index.html").write_text('<a href="%s">%s</a>\n' % (wheel.name, wheel.name))
        print(wheel)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
