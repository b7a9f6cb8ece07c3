"""What is called: libnipref.so by ctypes, and the program nipref, from one installation."""

import ctypes
import json
import os
import shutil
import subprocess
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_size_t, c_void_p
from pathlib import Path
from typing import Any, Iterable, Optional


class BadInput(ValueError):
    """What was given is none that nipref takes; the text is one line that says what it must be."""


class Failed(RuntimeError):
    """nipref itself failed, or an installation of it was not found."""


def _prefix() -> Optional[Path]:
    """The folder that nipref is installed to: inside of a wheel, or the one that this package is installed to."""
    here = Path(__file__).resolve().parent
    for folder in (here / "prefix", here.parents[3]):
        if (folder / "bin" / "nipref").is_file():
            return folder
    return None


prefix = _prefix()
_name = "libnipref.so.0.1"
_file = next(prefix.glob("lib/**/" + _name), None) if prefix else None
# What a wheel brings of other libraries, each behind those that it needs itself.
_list = _file.parent / "needed" if _file else None
_needed = [_list.parent / name for name in _list.read_text().split()] if _list and _list.exists() else []
try:
    for _one in _needed:
        ctypes.CDLL(str(_one), mode=ctypes.RTLD_GLOBAL)
    library = ctypes.CDLL(str(_file or _name))
except OSError as _error:
    raise Failed(f"libnipref is not installed: {_error}") from _error

for _name, _result, *_arguments in (
    ("nipref_version", c_char_p),
    ("nipref_last_error", c_char_p),
    ("nipref_quantity_count", c_size_t),
    ("nipref_quantity_at", c_void_p, c_size_t),
    ("nipref_find", c_void_p, c_char_p),
    ("nipref_name", c_char_p, c_void_p),
    ("nipref_definition", c_char_p, c_void_p),
    ("nipref_arity", c_size_t, c_void_p),
    ("nipref_argument", c_char_p, c_void_p, c_size_t),
    ("nipref_parse", c_int, c_void_p, POINTER(c_char_p), POINTER(c_double), c_char_p, c_size_t),
    ("nipref_fast_batch", c_int, c_void_p, c_size_t, POINTER(POINTER(c_double)), c_double, POINTER(c_double)),
    ("nipref_ref", c_int, c_void_p, POINTER(c_char_p), c_int, c_char_p, c_size_t, c_char_p, c_size_t, POINTER(c_int)),
    ("nipref_solve", c_int, c_char_p, POINTER(c_char_p), c_int, POINTER(c_void_p)),
    ("nipref_solution_free", None, c_void_p),
    ("nipref_solution_json", c_char_p, c_void_p),
):
    getattr(library, _name).restype = _result
    getattr(library, _name).argtypes = _arguments

MISSED = 3


def checked(status: int) -> int:
    """The status of a call that wrote its results: 0, or MISSED. BadInput and Failed otherwise."""
    if status in (0, MISSED):
        return status
    raise (BadInput if status == 2 else Failed)(library.nipref_last_error().decode())


def texts(values: Iterable[str]) -> Any:
    """For C: pointers to the texts and a null pointer behind them."""
    encoded = [value.encode() for value in values]
    return (c_char_p * (len(encoded) + 1))(*encoded, None)


class Quantity:
    """A quantity of the catalogue, for the calls that C offers."""

    def __init__(self, name: str) -> None:
        self.handle = library.nipref_find(name.encode())
        if not self.handle:
            raise BadInput(library.nipref_last_error().decode())
        count = library.nipref_arity(self.handle)
        self.arguments = [library.nipref_argument(self.handle, i).decode() for i in range(count)]

    def parse(self, given: "dict[str, str]") -> "tuple[list[float], list[str]]":
        """Each argument as a double and as a text, from the texts that a user writes."""
        pairs = texts(f"{name}={text}" for name, text in given.items())
        numbers = (c_double * max(1, len(self.arguments)))()
        lines = ctypes.create_string_buffer(64 * (len(self.arguments) + 1) + sum(map(len, given.values())))
        checked(library.nipref_parse(self.handle, pairs, numbers, lines, len(lines)))
        return list(numbers)[: len(self.arguments)], lines.value.decode().splitlines()

    def ref(self, arguments: "list[str]", digits: int) -> "tuple[str, str, bool, bool]":
        """The value and its error as decimal texts, whether it is proven, and whether the digits are all there."""
        value, error, proven = ctypes.create_string_buffer(digits + 400), ctypes.create_string_buffer(400), c_int()
        status = checked(library.nipref_ref(self.handle, texts(arguments), digits, value, len(value), error, len(error),
                                            byref(proven)))
        return value.value.decode(), error.value.decode(), proven.value == 1, status != MISSED


def solved(scene: str, overrides: "dict[str, str]", digits: int) -> "dict[str, Any]":
    """The answer of `nipref solve --json`."""
    solution = c_void_p()
    pairs = texts(f"{key}={text}" for key, text in overrides.items())
    checked(library.nipref_solve(scene.encode(), pairs, digits, byref(solution)))
    try:
        return json.loads(library.nipref_solution_json(solution))
    finally:
        library.nipref_solution_free(solution)


def program_environment() -> "tuple[str, dict[str, str]]":
    """The program, and the environment in which it finds the libraries of a wheel."""
    environment = dict(os.environ)
    if prefix is None:
        program = shutil.which("nipref")
        if program is None:
            raise Failed("the program nipref is not installed")
        return program, environment
    if _needed:
        others = environment.get("LD_LIBRARY_PATH")
        environment["LD_LIBRARY_PATH"] = str(_needed[0].parent) + (":" + others if others else "")
    return str(prefix / "bin" / "nipref"), environment


def printed(*arguments: str, text: Optional[str] = None) -> str:
    """What the program prints, whether or not a check fell short; `text` is its standard input."""
    program, environment = program_environment()
    ran = subprocess.run([program, *arguments], input=text, capture_output=True, text=True, env=environment)
    if ran.returncode in (0, 1):
        return ran.stdout
    lines = ran.stderr.strip().splitlines() or [f"status {ran.returncode}"]
    raise (BadInput if ran.returncode == 2 else Failed)(lines[-1].removeprefix("nipref: "))


def answer(*arguments: str, text: Optional[str] = None) -> "dict[str, Any]":
    """The same from its JSON."""
    return json.loads(printed(*arguments, "--json", text=text))


def main() -> None:
    """The program itself, as the command that a wheel installs."""
    import sys

    program, environment = program_environment()
    os.execve(program, [program, *sys.argv[1:]], environment)
