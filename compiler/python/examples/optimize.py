# %% [markdown]
# # Tip relief that minimizes the transmission error, with scipy.optimize
#
# Amount and start of the tip relief of a spur pair are chosen for the smallest peak-to-peak
# transmission error. The fidelity "analytic" or "plane" suits a search; check the optimum with a
# three-dimensional one.

# %%
import numpy as np
from scipy.optimize import minimize

import calyx

pair = calyx.load("../../../examples/spur_pair.cx")
pair

# %% [markdown]
# Numbers are in the units of the params. Both variables are scaled to the range from 0 to 1 by the
# bounds, because a tip relief of 0.0005 inch and a roll angle of 27 deg differ by five orders.

# %%
names = ["tip_relief", "pinion_relief_start"]
low = np.array([0.0, 20.0])
high = np.array([0.002, 31.0])
options = {"torque": "90 N*m", "steps": 8, "fidelity": "plane", "error_estimates": "none"}


def params(x):
    return dict(zip(names, low + np.asarray(x) * (high - low)))


def peak_to_peak(x):
    """Returns the peak-to-peak transmission error in microradians."""
    return pair.run(params(x), **options)["transmission_error"].to("urad").peak_to_peak


# %%
start = np.array([0.1, 0.5])
found = minimize(
    peak_to_peak,
    start,
    method="Nelder-Mead",
    bounds=[(0, 1)] * 2,
    options={"maxfev": 40, "xatol": 1e-2, "fatol": 1e-2},
)
before, after = peak_to_peak(start), found.fun
print(f"{found.nfev} runs: {before:.2f} urad -> {after:.2f} urad")
print({name: float(f"{value:.4g}") for name, value in params(found.x).items()})

# %% [markdown]
# The report of the optimum, with its plots:

# %%
best = pair.run(params(found.x), **options)
best

# %%
assert after < 0.8 * before
assert best["transmission_error"].to("urad").peak_to_peak == after
