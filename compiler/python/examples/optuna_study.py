# %% [markdown]
# # Transmission error and root stress as two objectives, with Optuna
#
# The trials run on two threads: a run leaves the interpreter free. The variables have the bounds of
# the params. Values that make an impossible gear are pruned.

# %%
import optuna

import calyx

pair = calyx.load("../../../examples/spur_pair.cx")
optuna.logging.set_verbosity(optuna.logging.WARNING)
pair.params


# %%
def objectives(trial):
    varied = ["tip_relief", "tooth_thickness", "tip_radius"]
    params = {name: trial.suggest_float(name, *pair.params[name].bounds) for name in varied}
    try:
        results = pair.run(params, steps=4, fidelity="plane", error_estimates="none")
    except calyx.RunError as error:
        trial.set_user_attr("code", error.code)
        raise optuna.TrialPruned(error.message) from None
    return (
        results["transmission_error"].to("urad").peak_to_peak,
        results["max_root_stress_pinion"].to("MPa").max,
    )


# %%
study = optuna.create_study(
    directions=["minimize", "minimize"], sampler=optuna.samplers.RandomSampler(seed=1)
)
study.optimize(objectives, n_trials=24, n_jobs=2)

# %%
pruned = [trial for trial in study.trials if trial.state == optuna.trial.TrialState.PRUNED]
print(
    f"{len(study.trials)} trials, {len(pruned)} impossible gears,",
    f"{len(study.best_trials)} on the Pareto front",
)
for trial in sorted(study.best_trials, key=lambda trial: trial.values):
    error, stress = trial.values
    print(f"{error:8.2f} urad {stress:8.1f} MPa  {trial.params}")

# %%
assert len(study.trials) == 24 and 1 <= len(study.best_trials) < 24
assert all(trial.user_attrs["code"].startswith("E") for trial in pruned)
