"""Many cases, several at a time."""

import pytest

import calyx
from support import QUICK, optional


def test_cases_are_equal_to_single_runs(spur):
    sweep = spur.sweep({"torque": [500, "100 N*m"], "tip_relief": [0, 0.001]}, parallel=3, **QUICK)
    assert [case["torque"] for case in sweep.cases] == [500, 500, "100 N*m", "100 N*m"]
    for case, results in zip(sweep.cases, sweep):
        alone = spur.run(case, **QUICK)
        assert all(alone[name].si.tobytes() == results[name].si.tobytes() for name in alone)


@pytest.mark.parametrize("value", [500, "100 N*m"])
def test_one_value_is_no_axis(spur, value):
    with pytest.raises(TypeError, match="give a list of values"):
        spur.sweep({"torque": value})
    with pytest.raises(TypeError, match="is no case"):
        spur.run_many([value])


@pytest.mark.parametrize("engine", ["pandas", "polars", "pyarrow"])
def test_tables_have_a_row_for_each_case(spur, engine):
    optional(engine)
    sweep = spur.sweep({"torque": [500, 600], "tip_corner_contact": [True]}, **QUICK)
    frame = sweep.frame("arrow" if engine == "pyarrow" else engine, statistics=["max"])
    columns = {name: list(frame[name]) for name in ("torque", "load_share.max")}
    if engine == "pyarrow":
        columns = {name: [cell.as_py() for cell in column] for name, column in columns.items()}
    assert columns["torque"] == [500, 600]
    assert columns["load_share.max"] == [results["load_share"].max for results in sweep]
    # The rows of a table are cases.
    again = spur.run_many(frame[["torque"]] if engine != "pyarrow" else frame.select(["torque"]), **QUICK)
    assert [results["load_share"].max for results in again] == columns["load_share.max"]


def test_failures_are_raised_or_returned(spur):
    cases = [{"torque": 500}, {"torque": -1}]
    with pytest.raises(calyx.ParamError, match="outside its range"):
        spur.run_many(cases, **QUICK)
    sweep = spur.run_many(cases, on_error="return", **QUICK)
    assert list(sweep.failures) == [1] and isinstance(sweep[1], calyx.Failure)
    assert "1 failed" in repr(sweep) and "outside its range" in sweep._repr_html_()
    with pytest.raises(ValueError, match="on_error"):
        spur.run_many(cases, on_error="ignore")


def test_failures_have_a_column(spur):
    optional("pandas")
    frame = spur.run_many([{"torque": 500}, {"torque": -1}], on_error="return", **QUICK).frame("pandas")
    assert frame["load_share.max"].isna().tolist() == [False, True]
    assert "outside its range" in frame["error"][1] and frame["error"][0] == ""
    # The column of a param stays one of numbers.
    frame = spur.run_many([{"torque": "500 N*m"}, {"torque": "3 mm"}], on_error="return", **QUICK).frame()
    assert frame["torque"].dtype == float and frame["torque"].isna().tolist() == [False, True]


def test_an_error_cancels_the_other_cases(spur):
    cancel = calyx.Cancel()
    with pytest.raises(calyx.ParamError):
        spur.run_many([{"steps": 5000}, {"torque": -1}], fidelity="plane", cancel=cancel, parallel=2)
    assert not cancel.cancelled
