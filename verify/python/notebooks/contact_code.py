# %% [markdown]
# # How wrong is a contact code?
# The code audited here is short, as many are: Hertz's contact of a rigid roller on a half-space, used for a sheet between
# two rollers. nipref solves the same sheet with an error for each number, so that what differs by more is the code's.

# %%
import math

import numpy as np

import nipref


def my_contact(load: float, radius: float = 6.0, young: float = 1.45e5, poisson: float = 1 / 3) -> "tuple[float, float]":
    """Length and peak pressure of the contact under a load per unit of length: the code under audit."""
    half = math.sqrt(4 * load * radius * (1 - poisson**2) / (math.pi * young))
    return 2 * half, 2 * load / (math.pi * half)


# %% [markdown]
# Thirty contacts, from those that are short beside the sheet's thickness of 1 to those that are as long.

# %%
loads = np.geomspace(0.1, 5000, 30)
truth = nipref.solve("thick-frictionless", {"wanted": '["contact_length", "peak_pressure"]', "material.poisson": 1 / 3,
                                            "load.per_length": loads})
mine = dict(zip(("contact_length", "peak_pressure"), np.array([my_contact(load) for load in loads]).T))

print(f"{'load':>10} {'L/B':>8} {'length':>10} {'pressure':>10}   relative errors")
errors = {name: mine[name] / truth[name].value - 1 for name in mine}
for i in range(0, 30, 5):
    print(f"{loads[i]:10.3g} {truth['contact_length'].value[i]:8.3g} {errors['contact_length'][i]:10.1e} "
          f"{errors['peak_pressure'][i]:10.1e}")

# %% [markdown]
# Where is it right to 1 %, and is nipref accurate enough to say so?

# %%
right = np.maximum(abs(errors["contact_length"]), abs(errors["peak_pressure"])) < 0.01
print(f"right to 1 % for L/B up to {truth['contact_length'].value[right].max():.2g}")
assert all(np.all(one.error < 1e-9 * one.value) for one in truth.values())
assert right[:5].all() and not right[-5:].any()

# %% [markdown]
# One of them by the reference, whose error is a proven bound.

# %%
proof = nipref.solve("thick-frictionless", {"wanted": '["contact_length"]', "load.per_length": 100.0}, path="ref", digits=25)
print("L =", proof["contact_length"].text, "+-", proof["contact_length"].error, "proven:", proof["contact_length"].proven)
assert proof["contact_length"].proven

# %%
try:
    import matplotlib
except ImportError:
    print("not drawn: matplotlib is not installed")
else:
    matplotlib.use("Agg")
    import matplotlib.pyplot as plot

    for name, error in errors.items():
        plot.loglog(truth["contact_length"].value, abs(error), label=name.replace("_", " "))
    plot.xlabel("contact length/thickness")
    plot.ylabel("relative error of Hertz's contact")
    plot.legend()
    plot.savefig("contact_code.png")
