# %% [markdown]
# # Sensitivity of the transmission error to tolerances, with SALib
#
# Morris' elementary effects rank the params by their influence. `run_many` solves the cases of the
# sample on all cores; cases of equal geometry share their structures.

# %%
import numpy as np
from SALib.analyze import morris as analysis
from SALib.sample import morris as sample

import calyx

pair = calyx.load("../../../examples/spur_pair.cx")

# %%
problem = {
    "names": ["torque", "center_distance", "tip_relief"],
    "bounds": [[800, 1200], [2.998, 3.002], [0.0004, 0.0006]],
}
problem["num_vars"] = len(problem["names"])
points = sample.sample(problem, N=4, num_levels=4, seed=1)
cases = [dict(zip(problem["names"], point)) for point in points]
sweep = pair.run_many(cases, steps=4, fidelity="plane", error_estimates="none")
sweep

# %%
values = np.array([results["transmission_error"].to("urad").peak_to_peak for results in sweep])
effects = analysis.analyze(problem, points, values, seed=1)
for name, mean in zip(problem["names"], effects["mu_star"]):
    print(f"{name:16} {mean:8.3f} urad")

# %%
assert len(sweep) == len(points) == 16 and not sweep.failures
assert np.all(effects["mu_star"] > 0)
