"""Makes a wheel of an installation: wheel.py PREFIX PACKAGE VERSION FOLDER. It holds the package, the program with what it
reads, libnipref, and the libraries that these need and glibc has not. Of one installation it is the same bytes."""

import base64
import functools
import hashlib
import re
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

prefix, package, version, folder = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3], Path(sys.argv[4])
tag = "py3-none-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")
of_every_linux = re.compile(r"(ld-linux.*|lib(c|m|dl|pthread|rt|gcc_s|stdc\+\+))\.so\.")


@functools.cache
def needed(file: Path) -> "dict[str, Path]":
    """Names and files of the libraries that a file needs, each before those that need it."""
    found = {}
    for name in re.findall(r"NEEDED.*\[(.*)\]", subprocess.check_output(["readelf", "--dynamic", file], text=True)):
        listed = re.search(rf"{re.escape(name)} => (\S+)", subprocess.check_output(["ldd", file], text=True))
        if not of_every_linux.match(name) and listed:
            found.update(needed(Path(listed[1])))
            found[name] = Path(listed[1])
    return found


library = next(prefix.glob("lib/**/libnipref.so.[0-9].[0-9]"))
program = prefix / "bin" / "nipref"
libraries = {**needed(library), **needed(program)}
files = {f"nipref/{file.name}": file for file in package.glob("*") if file.suffix in (".py", ".typed")}
inside = f"nipref/prefix/{library.parent.relative_to(prefix)}"
files |= {f"{inside}/{name}": file for name, file in [*libraries.items(), (library.name, library)]}
for part in ("bin/nipref", "libexec/nipref", "share/nipref"):
    found = [prefix / part, *(prefix / part).rglob("*")]
    files |= {f"nipref/prefix/{file.relative_to(prefix)}": file for file in found if file.is_file()}
contents = {name: (file.read_bytes(), file.stat().st_mode & 0o777) for name, file in files.items()}
contents[f"{inside}/needed"] = ("\n".join(libraries).encode(), 0o644)
information = f"nipref-{version}.dist-info"
for name, text in {
    "METADATA": f"""Metadata-Version: 2.1
Name: nipref
Version: {version}
Summary: Verification reference for rolling contact
Requires-Python: >=3.9
Requires-Dist: numpy
""",
    "WHEEL": f"Wheel-Version: 1.0\nGenerator: nipref\nRoot-Is-Purelib: false\nTag: {tag}\n",
    "entry_points.txt": "[console_scripts]\nnipref = nipref._library:main\n",
}.items():
    contents[f"{information}/{name}"] = (text.encode(), 0o644)


def checksum(data: bytes) -> str:
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


record = "".join(f"{name},{checksum(data)},{len(data)}\n" for name, (data, _) in sorted(contents.items()))
contents[f"{information}/RECORD"] = (f"{record}{information}/RECORD,,\n".encode(), 0o644)
folder.mkdir(parents=True, exist_ok=True)
wheel = folder / f"nipref-{version}-{tag}.whl"
with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
    for name, (data, mode) in sorted(contents.items()):
        entry = zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0))
        entry.external_attr = (0o100000 | mode) << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        archive.writestr(entry, data)
print(wheel)
