"""nipref for NumPy: quantities of rolling contact and whole contacts, each with its error.

    nipref.eval("I1", alpha=np.linspace(0.1, 5, 50))                           double precision, an array
    nipref.ref("I1", alpha="0.73", digits=50)                                  arbitrary precision, with a bound
    nipref.solve("thick-frictionless", {"load.per_length": [50, 100, 200]})    contacts, with their errors
    nipref.grade(my_kernel, "I1")                                              how wrong a function of yours is
    nipref.golden("I1")                                                        stored values, confirmed twice
    nipref.audit("I1")                                                         the largest error of double precision

Lengths of quantities are over the half-thickness of the sheet and angles in degrees; scenes have any consistent units.
`nipref list NAME` on the command line defines a quantity, its arguments and a result of a scene. What nipref does not
take raises BadInput, a ValueError whose text is one line.
"""

import concurrent.futures
import csv
import decimal
import os
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np

from . import _library
from ._library import BadInput, Failed

__all__ = ["BadInput", "Failed", "Reference", "Result", "Solution", "__version__",
           "audit", "eval", "golden", "grade", "quantities", "ref", "solve"]
__version__: str = _library.library.nipref_version().decode()

Number = Union[float, int, str, decimal.Decimal, np.ndarray, Sequence[float]]


@dataclass(frozen=True)
class Reference:
    """Values of the reference, in the quantity's unit. Each is a number, or an array in the shape of the arguments.

    value and error: nearest doubles, the error rounded upwards; text and error_text: all digits, as decimals;
    proven: whether the error is a bound, otherwise an estimate; met: whether it has all the digits that were asked for.
    """

    text: Any
    error_text: Any
    proven: Any
    met: Any

    @property
    def value(self) -> Any:
        return _doubles(self.text)

    @property
    def error(self) -> Any:
        return _upward(self.error_text)

    @property
    def lower(self) -> Any:
        """The lower end of what holds the truth, a decimal.Decimal."""
        return self._end(decimal.ROUND_FLOOR, -1)

    @property
    def upper(self) -> Any:
        """The upper end, likewise."""
        return self._end(decimal.ROUND_CEILING, 1)

    def _end(self, rounding: str, sign: int) -> Any:
        context = decimal.Context(prec=2000, rounding=rounding)
        end = lambda text, error: context.add(decimal.Decimal(text), sign * decimal.Decimal(error))
        return np.frompyfunc(end, 2, 1)(self.text, self.error_text)


@dataclass(frozen=True)
class Result:
    """A result of contacts: axes of the sweep come first, then those of a profile, or depths and places of a field.

    value and error: doubles in the scene's units, NaN where a scene was refused; the error is absolute. text: all digits
    of the reference. proven: whether all errors are bounds. met: whether each contact has the accuracy requested, None
    where none was.
    """

    value: np.ndarray
    error: np.ndarray
    proven: bool
    met: np.ndarray
    unit: str
    text: Any = None


class Solution(dict):
    """Results of contacts by their names, in the order of the scene's `wanted`.

    positions: of profiles, a length (on a half-space an angle in radians); field_positions, a length, and field_depths, over
    half the thickness: of fields; None where none is wanted. refused: why a contact of the sweep has no results, "" where
    it has. warnings: of each contact, what is beyond linear theory.
    """

    def __init__(self, results: Mapping[str, Result], places: Mapping[str, Any], refused: np.ndarray,
                 warnings: np.ndarray) -> None:
        super().__init__(results)
        array = lambda numbers: None if numbers is None else np.array(numbers)
        inside = places["field"] or {}
        self.positions = array(places["positions"])
        self.field_positions, self.field_depths = array(inside.get("positions")), array(inside.get("depths"))
        self.refused, self.warnings = refused, warnings


def quantities() -> "dict[str, str]":
    """Names of all quantities, with their definitions."""
    library = _library.library
    handles = [library.nipref_quantity_at(i) for i in range(library.nipref_quantity_count())]
    return {library.nipref_name(one).decode(): library.nipref_definition(one).decode() for one in handles}


def eval(quantity: str, *, path: str = "fast", rtol: float = 0.0, digits: int = 30, **arguments: Number) -> Any:
    """Values of a quantity in double, in the shape that its arguments have together.

    path: "fast", or "ref" for the doubles nearest to the reference's values. rtol: the error that fast may make, as a part
    of the quantity's scale; 0 for full accuracy. Arguments are numbers, arrays, or texts: decimals that are taken
    exactly by ref, names of choices, materials: material="elastic(shear=1)".
    """
    if path == "ref":
        return ref(quantity, digits=digits, **arguments).value
    if path != "fast":
        raise BadInput(f"path = {path}: must be fast or ref")
    what = _library.Quantity(quantity)
    shape, columns, texts = _arguments(what, arguments)
    numbers, _ = what.parse(texts)
    filled = [columns.get(name, np.full(shape, number)) for name, number in zip(what.arguments, numbers)]
    filled = [np.ascontiguousarray(column, dtype=float) for column in filled]
    pointer = _library.POINTER(_library.c_double)
    values = np.empty(shape)
    pointers = (pointer * max(1, len(filled)))(*(column.ctypes.data_as(pointer) for column in filled))
    _library.checked(_library.library.nipref_fast_batch(what.handle, values.size, pointers, rtol,
                                                        values.ctypes.data_as(pointer)))
    return values[()]


def ref(quantity: str, *, digits: int = 30, **arguments: Number) -> Reference:
    """Values of a quantity with errors, each at most 10^-digits of its scale. A float is taken exactly, and so is a text:
    "0.1" and 0.1 differ."""
    what = _library.Quantity(quantity)
    shape, columns, texts = _arguments(what, arguments)
    _, fixed = what.parse(texts)

    def at(index: int) -> "tuple[str, str, bool, bool]":
        point = [_text(columns[name].flat[index]) if name in columns else text for name, text in zip(what.arguments, fixed)]
        return what.ref(point, digits)

    parts = zip(*_parallel(at, int(np.prod(shape))))
    types = (object, object, bool, bool)
    return Reference(*(np.array(part, dtype=one).reshape(shape)[()] for part, one in zip(parts, types)))


def solve(scene: Union[str, os.PathLike], sweep: Union[Mapping[str, Number], None] = None, *, path: str = "fast",
          digits: int = 30) -> Solution:
    """Solves a contact, or many of them.

    scene: a TOML file, the name of an example, or the text of a scene, which has a line break. sweep: keys of the scene with
    the values that stand there; arrays are broadcast against each other as NumPy does, a contact for each element; a
    text may be a list as TOML writes it. path: "fast", or "ref" to so many `digits`. A contact that is refused is NaN and
    says why in `refused`; BadInput if all are.
    """
    if path not in ("fast", "ref"):
        raise BadInput(f"path = {path}: must be fast or ref")
    given = dict(sweep or {})
    values = np.broadcast_arrays(*(np.asarray(value) for value in given.values())) if given else [np.array(0)]
    shape = values[0].shape

    def at(index: int) -> Any:
        overrides = {key: _shortest(column.flat[index]) for key, column in zip(given, values)}
        try:
            return _library.solved(os.fspath(scene), overrides, digits if path == "ref" else 0)
        except BadInput as error:
            return error

    answers = list(_parallel(at, int(np.prod(shape))))
    good = [answer for answer in answers if not isinstance(answer, BadInput)]
    if not good:
        raise answers[0] if answers else BadInput("sweep: must not be empty")
    is_refused = [isinstance(answer, BadInput) for answer in answers]
    refused = np.array([str(one) if bad else "" for one, bad in zip(answers, is_refused)]).reshape(shape)
    warnings = _objects([[] if bad else one["warnings"] for one, bad in zip(answers, is_refused)], shape)
    results = {name: _result([None if bad else one["results"][name] for one, bad in zip(answers, is_refused)], shape,
                             path == "ref") for name in good[0]["results"]}
    return Solution(results, good[0], refused, warnings)


def grade(kernel: Callable[..., Any], quantity: str, *, points: Union[int, None] = None, promise: Union[float, str, None] = None,
          seed: str = "1", **ranges: Union[float, str]) -> "dict[str, Any]":
    """How wrong a function is, against the reference, at points chosen as for nipref's own: what `nipref grade --json` says.

    kernel: takes an array for each argument of the quantity, in its order (choices: names), and returns an array; make
    one that takes numbers into such by np.vectorize. promise: the largest error allowed, as `grade` has it: 4 units in the
    last place, 1e-6 of the scale, "1e-9abs". ranges: name="lo..hi", with :log, :linear or :bits, or a number. The member "passed" is the verdict.
    """
    options = [f"{name}={value}" for name, value in ranges.items()] + ["--seed", seed]
    table = _library.printed("points", quantity, *options, *(["--points", str(points)] if points else []))
    lines = table.splitlines()
    head = [line for line in lines if line.startswith("#")]
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    names = [name for name in rows[0] if not name.endswith("_decimal")]
    values = np.broadcast_to(kernel(*(_column([row[name] for row in rows]) for name in names)), (len(rows),))
    body = [",".join([*(row[name] for name in names), float(value).hex()]) for row, value in zip(rows, values)]
    text = "\n".join([*head, ",".join([*names, "value"]), *body]) + "\n"
    wanted = ["--promise", str(promise)] if promise is not None else []
    return _library.answer("grade", "-", quantity, *wanted, text=text)["rows"][0]


def golden(quantity: str) -> "dict[str, np.ndarray]":
    """Stored values: a column for each argument, "value" and "bound" as doubles, "text" with all digits, and "status",
    "confirmed_by" and "origin" of each. Of a kind of contacts, as "contacts-frictionless": a column for each key that
    varies, and for each result "load", "load_bound" and "load_text"."""
    file = _library.answer("golden", "list", quantity)["files"][0]["file"]
    with open(file, encoding="utf-8") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    columns = {name: _column([row[name] for row in rows]) for name in rows[0]}
    for bound in [name for name in columns if name.endswith("bound")]:
        stem = bound[:-len("bound")]
        columns[stem + "text"] = _objects([row[stem[:-1] or "value"] for row in rows], (len(rows),))
        columns[bound] = _upward(_objects([row[bound] for row in rows], (len(rows),)))
    return columns


def audit(quantity: str, *, points: Union[int, None] = None, seed: str = "1", **ranges: Union[float, str]) -> "dict[str, Any]":
    """The largest error of nipref's double precision that a search finds: the row of `nipref audit --json`. ranges: as in
    grade."""
    options = [f"{name}={value}" for name, value in ranges.items()] + ["--seed", seed, "--quiet"]
    return _library.answer("audit", quantity, *options, *(["--points", str(points)] if points else []))["rows"][0]


def _arguments(what: _library.Quantity, given: Mapping[str, Number]) -> "tuple[Any, dict[str, np.ndarray], dict[str, str]]":
    """The shape of all together, a column for each that is an array, and a text for each that is given."""
    columns = {name: np.asarray(value, dtype=float) for name, value in given.items()
               if not isinstance(value, (str, decimal.Decimal))}
    shape = np.broadcast_shapes(*(column.shape for column in columns.values()))
    columns = {name: np.broadcast_to(column, shape) for name, column in columns.items()}
    if 0 in shape:
        raise BadInput("arguments: must not be empty")
    texts = {name: _text(columns[name].flat[0]) if name in columns else str(value) for name, value in given.items()}
    return shape, columns, texts


def _result(contacts: "list[Any]", shape: Any, by_ref: bool) -> Result:
    solved = [one for one in contacts if one is not None]
    sizes = [np.shape(one["value"]) for one in solved]
    longest = tuple(int(size) for size in np.max(sizes, axis=0)) if sizes[0] else ()  # lists may differ in length

    def gathered(member: str) -> np.ndarray:
        numbers = np.full((len(contacts), *longest), None, dtype=object)
        for row, one in enumerate(contacts):
            if one is not None:
                part = np.array(one[member], dtype=object)
                numbers[(row, *map(slice, part.shape))] = part
        return numbers.reshape((*shape, *longest))

    met = _objects([one and one["met"] for one in contacts], shape)
    values = gathered("value")
    return Result(_doubles(values), _upward(gathered("error")), all(one["proven"] for one in solved), met,
                  solved[0]["unit"], values if by_ref else None)


def _parallel(at: Callable[[int], Any], count: int) -> Any:
    """Of each index, in order: the library's calls leave Python to other threads."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(at, range(count)))


def _objects(values: "list[Any]", shape: Any) -> np.ndarray:
    array = np.empty(len(values), dtype=object)
    array[:] = values
    return array.reshape(shape)


def _column(texts: "list[str]") -> np.ndarray:
    """Doubles of decimal or hexadecimal texts; the texts where they are none."""
    try:
        return np.array([float.fromhex(text) if "0x" in text else float(text) for text in texts])
    except ValueError:
        return np.array(texts)


def _text(value: Any) -> str:
    return float(value).hex()


def _shortest(value: Any) -> str:
    """As TOML takes it."""
    return value if isinstance(value, str) else repr(value.item())


def _doubles(texts: Any) -> Any:
    return np.asarray(np.frompyfunc(lambda text: np.nan if text is None else float(text), 1, 1)(texts), dtype=float)[()]


def _upward(texts: Any) -> Any:
    def rounded(text: Any) -> float:
        nearest = np.nan if text is None else float(text)
        return nearest if not isinstance(text, str) or decimal.Decimal(nearest) >= decimal.Decimal(text) \
            else float(np.nextafter(nearest, np.inf))
    return np.asarray(np.frompyfunc(rounded, 1, 1)(texts), dtype=float)[()]
