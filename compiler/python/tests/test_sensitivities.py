"""Derivatives of outputs with respect to params, and gradients for optimizers."""

import pickle

import pytest

import calyx
from support import optional

BEAM = """
param width = 10.0 mm in 1 mm .. 20 mm;
param height = 5.0 mm in 1 mm .. 20 mm;
param load = 100.0 N in 0 N .. 1000 N;
param count = 3 in 1 .. 9;
param fixed = 1.5 in 1.5 .. 1.5;
output stress := 6 * load * 100 mm / (width * height^2) in MPa;
"""


def test_gradients_are_those_of_the_closed_form():
    beam = calyx.loads(BEAM)
    value, gradient = beam.value_and_gradient("stress", {"width": "8 mm", "height": 5.0})
    assert value == pytest.approx(300, rel=1e-12)
    assert gradient == {
        "width": pytest.approx(-300 / 8, rel=1e-8),
        "height": pytest.approx(-2 * 300 / 5, rel=1e-8),
    }
    value, gradient = beam.value_and_gradient("stress.max", {"width": "8 mm"}, by=["load"])
    assert gradient == {"load": pytest.approx(3, rel=1e-8)}


def test_results_have_both_sides_errors_and_units():
    results = calyx.loads(BEAM).run(sensitivities=["height", "load"])
    first = results.sensitivities[0]
    assert (first.output, first.statistic, first.param, first.unit) == ("stress", "min", "height", "MPa/mm")
    assert first.below == first.above == first.value == pytest.approx(-96, rel=1e-8)
    assert 0 < first.error < 1e-4 and not first.new_structures
    kept = pickle.loads(pickle.dumps(results))
    assert kept.sensitivities == results.sensitivities
    assert kept.gradient("stress.mean") == results.gradient("stress.mean")


def test_derivatives_that_do_not_exist_are_errors():
    beam = calyx.loads(BEAM)
    with pytest.raises(calyx.ParamError, match="`count` takes no decimal numbers"):
        beam.run(sensitivities=["count"])
    with pytest.raises(calyx.RunError, match="the range of `fixed` is a single value"):
        beam.value_and_gradient("stress", {}, by=["fixed"])
    with pytest.raises(calyx.ParamError, match="there is no output `strain`"):
        beam.value_and_gradient("strain", {"load": 5})


def test_an_optimizer_takes_value_and_gradient():
    optimize = optional("scipy.optimize")
    beam = calyx.loads(
        "param x = 3.0 in -9 .. 9; param y = 2.0 in -9 .. 9; output f := (x - 1)^2 + 2 * (y + 1)^2;"
    )

    def objective(at):
        value, gradient = beam.value_and_gradient("f", {"x": at[0], "y": at[1]})
        return value, [gradient["x"], gradient["y"]]

    found = optimize.minimize(objective, [3.0, 2.0], jac=True, method="BFGS")
    assert found.x == pytest.approx([1, -1], abs=1e-6)


def test_the_table_has_a_row_for_each_derivative():
    pandas = optional("pandas")
    frame = calyx.loads(BEAM).run(sensitivities=["height", "load"]).sensitivity_frame("pandas")
    assert isinstance(frame, pandas.DataFrame) and len(frame) == 8
    assert list(frame.columns)[:5] == ["output", "statistic", "param", "unit", "value"]
