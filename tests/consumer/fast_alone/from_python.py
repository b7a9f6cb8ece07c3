import ctypes
import math
import sys

library = ctypes.CDLL(sys.argv[1])
library.nipref_last_error.restype = ctypes.c_char_p


def call(name, *arguments):
    value = ctypes.c_double(-1)
    status = getattr(library, "nipref_fast_" + name)(*map(ctypes.c_double, arguments), ctypes.byref(value))
    return status, value.value


print("I1(0.73) = %.17g" % call("I1", 0.73)[1])
assert call("I2", -3) == (0, -math.pi / 2)
far = {"I3": 1, "I4": 1, "I5": 1, "I7": 0}  # limits in units of pi/4
for name, limit in far.items():
    status, value = call(name, 1e3)
    assert status == 0 and abs(value - limit * math.pi / 4) < 1e-15, name
status, value = call("I6", 1e3, 1.5e3)
assert status == 0 and abs(value / (math.pi / 4 * 500) - 1) < 1e-15
assert call("F1", 0, 0.3) == (0, 0)
assert abs(call("F2", 1e3, 0.3)[1] / 250 - 1) < 1e-15
refused = {"I1": [0], "I3": [math.nan], "I6": [0, 1], "I7": [math.inf], "F1": [1, 0.6], "F2": [1, -1]}
for name, arguments in refused.items():
    assert call(name, *arguments) == (2, -1), name  # refused, and nothing written
print(library.nipref_last_error().decode())
assert library.nipref_fast_I7(ctypes.c_double(1), None) == 2
