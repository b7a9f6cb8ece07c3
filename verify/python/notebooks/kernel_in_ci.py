# %% [markdown]
# # A kernel in continuous integration
# A kernel of your own is graded at each commit: at nipref's points, against values with proven bounds. The job fails where an
# assertion does.

# %%
import numpy as np

import nipref

# Chebyshev's expansion of I2(alpha) for 0.1 <= alpha <= 2, fitted once to values of the reference.
nodes = 1.05 + 0.95 * np.cos(np.pi * (np.arange(40) + 0.5) / 40)
fit = np.polynomial.chebyshev.Chebyshev.fit(nodes, nipref.ref("I2", alpha=nodes).value, 25, domain=[0.1, 2])


def my_kernel(alpha: np.ndarray) -> np.ndarray:
    return fit(alpha)


# %% [markdown]
# It is graded where it is made for. The promise is in units in the last place; without one it is that of nipref itself.

# %%
found = nipref.grade(my_kernel, "I2", points=2000, promise=100, alpha="0.1..2")
print(f"largest error {found['max_error_ulp']:.3g} ulp among {found['points']} points, at alpha = {found['worst']['alpha']}")
assert found["passed"]

# %% [markdown]
# A fault is seen, and where it is.

# %%
def faulty(alpha: np.ndarray) -> np.ndarray:
    return np.where((alpha > 1.5) & (alpha < 1.6), fit(alpha) * (1 + 1e-10), fit(alpha))


fault = nipref.grade(faulty, "I2", points=2000, promise=100, alpha="0.1..2")
print("the fault is in alpha =", *(float.fromhex(fault["wrong"][end]["alpha"]) for end in ("first", "last")))
assert not fault["passed"] and 1.5 < float.fromhex(fault["wrong"]["first"]["alpha"]) < 1.6

# %% [markdown]
# Stored values need no program to search for points: each was confirmed by a second method.

# %%
stored = nipref.golden("I2")
inside = (stored["alpha"] > 0.1) & (stored["alpha"] < 2)
worst = np.max(abs(my_kernel(stored["alpha"][inside]) / stored["value"][inside] - 1))
print(f"{inside.sum()} stored values, largest relative error {worst:.1e}")
assert worst < 1e-13

# %% [markdown]
# The largest error of nipref's own there, for comparison.

# %%
own = nipref.audit("I2", points=2000, alpha="0.1..2")
print(f"nipref's own: {own['max_error_ulp']:.2g} ulp")
assert own["passed"]
