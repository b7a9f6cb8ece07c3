import ctypes
import sys

nipref = ctypes.CDLL(sys.argv[1])
for name in ("nipref_find", "nipref_quantity_at"):
    getattr(nipref, name).restype = ctypes.c_void_p
for name in ("nipref_version", "nipref_last_error", "nipref_name", "nipref_definition", "nipref_argument"):
    getattr(nipref, name).restype = ctypes.c_char_p
nipref.nipref_quantity_count.restype = nipref.nipref_arity.restype = ctypes.c_size_t
nipref.nipref_promise.restype = ctypes.c_double


def quantity(name):
    return ctypes.c_void_p(nipref.nipref_find(name.encode()))


def fast(name, *arguments, rtol=0.0):
    value = ctypes.c_double(-1)
    columns = (ctypes.c_double * len(arguments))(*arguments)
    status = nipref.nipref_fast(quantity(name), columns, ctypes.c_double(rtol), ctypes.byref(value))
    return status, value.value


def ref(name, *arguments, digits=30):
    texts = (ctypes.c_char_p * len(arguments))(*(text.encode() if text else None for text in arguments))
    value, error, proven = ctypes.create_string_buffer(digits + 40), ctypes.create_string_buffer(40), ctypes.c_int(-1)
    status = nipref.nipref_ref(quantity(name), texts, digits, value, ctypes.c_size_t(len(value)), error,
                               ctypes.c_size_t(len(error)), ctypes.byref(proven))
    return status, value.value.decode(), error.value.decode(), proven.value


# Every quantity can be found by its name, and says what it takes.
for number in range(nipref.nipref_quantity_count()):
    entry = ctypes.c_void_p(nipref.nipref_quantity_at(ctypes.c_size_t(number)))
    assert quantity(nipref.nipref_name(entry).decode()).value == entry.value
    assert nipref.nipref_definition(entry) and nipref.nipref_promise(entry) > 0
    for argument in range(nipref.nipref_arity(entry)):
        assert nipref.nipref_argument(entry, ctypes.c_size_t(argument))
assert not nipref.nipref_quantity_at(ctypes.c_size_t(nipref.nipref_quantity_count()))

status, value = fast("I1", 0.73)
print("I1(0.73) = %.17g" % value)
status, text, error, proven = ref("I1", "0.73")
print("I1(0.73) = %s +- %s" % (text, error))
assert status == 0 and proven == 1 and abs(float(text) - value) < 1e-16 and float(error) < 1e-30
assert abs(fast("I1", 0.73, rtol=1e-6)[1] - value) < 1e-6

# What is estimated says so, and has its digits.
status, text, error, proven = ref("nip.peak_pressure", "5", "0.3", "full", digits=16)
assert status == 0 and proven == 0 and 0 < float(error) / float(text) < 1e-16

assert fast("I1", 0.0) == (2, -1)  # refused, and nothing written
print(nipref.nipref_last_error().decode())
assert fast("I1", 0.73, rtol=2.0)[0] == 2
assert fast("nothing", 1.0)[0] == 2
assert ref("I1", "x")[0] == 2 and ref("I1", "1", digits=5)[0] == 2 and ref("I1", None)[0] == 2
assert not nipref.nipref_find(b"I8") and b"I1" in nipref.nipref_last_error()

# All or nothing, in batches as one by one.
points = (ctypes.c_double * 3)(0.5, 1.0, 2.0)
values = (ctypes.c_double * 3)(-1, -1, -1)
columns = (ctypes.POINTER(ctypes.c_double) * 1)(points)
assert nipref.nipref_fast_batch(quantity("I3"), ctypes.c_size_t(3), columns, ctypes.c_double(0), values) == 0
assert list(values) == [fast("I3", point)[1] for point in points]
points[1] = float("nan")
values[0] = -1
assert nipref.nipref_fast_batch(quantity("I3"), ctypes.c_size_t(3), columns, ctypes.c_double(0), values) == 2
assert values[0] == -1

# A buffer that is too small is refused, and left as it was.
value, error, proven = ctypes.create_string_buffer(b"as it was", 10), ctypes.create_string_buffer(40), ctypes.c_int()
texts = (ctypes.c_char_p * 1)(b"0.73")
assert nipref.nipref_ref(quantity("I1"), texts, 30, value, ctypes.c_size_t(10), error, ctypes.c_size_t(40),
                         ctypes.byref(proven)) == 2
assert value.value == b"as it was"
