"""Runs: settings, limits, progress, cancellation and threads."""

import multiprocessing
import os
import signal
import threading
import time

import numpy as np
import pytest

import calyx
from support import QUICK, bits, solve

LONG = {"steps": 2000, "fidelity": "plane"}
"""Run that takes minutes."""


def test_values_of_every_kind_are_equal(spur):
    def largest(torque):
        return spur.run(torque=torque, **QUICK)["max_contact_pressure"].max

    values = [
        1000,
        1000.0,
        np.float64(1000),
        np.int32(1000),
        np.array(1000.0),
        "1000 lbf*inch",
        (1000, "lbf*inch"),
    ]
    assert len({largest(value) for value in values}) == 1


def test_params_with_other_names_are_in_a_mapping(spur):
    # `fidelity` is an option of `run`, and a param of this model.
    by_param = spur.run({"fidelity": "plane", "steps": 2})
    by_option = spur.run(fidelity="plane", steps=2)
    assert by_param["load_share"].si.tobytes() == by_option["load_share"].si.tobytes()
    assert by_param.settings == {} and by_option.settings == {"fidelity": "plane"}
    assert by_param.params["fidelity"] == "plane" and by_option.params["fidelity"] == "medium"


def test_settings_override_those_of_the_model(spur):
    results = spur.run(settings={"contact_cells": 5}, error_estimates="none", **QUICK)
    assert results.settings == {"fidelity": "plane", "contact_cells": "5", "error_estimates": "none"}
    assert results["load_share"].summary.error is None and results.fidelity == "plane"
    with pytest.raises(calyx.ParamError, match="contact_cells") as caught:
        spur.run(settings={"contact_cells": 0})
    assert caught.value.code == "E0795"


def test_impossible_gears_are_run_errors_with_source_lines(spur):
    with pytest.raises(calyx.RunError) as caught:
        spur.run(tooth_thickness=0.08, **QUICK)
    assert caught.value.code == "E0616" and caught.value.help.startswith("reduce the tip diameter")
    assert "spur_pair.cx:" in caught.value.rendered


def test_results_do_not_depend_on_threads(spur):
    assert len({bits(spur.run(threads=threads, **QUICK)) for threads in (0, 1, 2)}) == 1


def test_printed_lines_and_models_without_analysis():
    model = calyx.load(
        'units mm_N_s;\nparam width = 3 mm;\noutput area := width^2;\nprint("one"); print("two");'
    )
    lines = []
    results = model.run(print=lines.append)
    assert lines == results.printed == ["one", "two"]
    assert results["area"].values.tolist() == [9.0] and results["area"].unit == "mm^2"
    assert results.fidelity is None and results.certificate == {}


HOST = """
host function friction(in sliding: Velocity, in dry: Bool = FALSE) -> Number { return 0.05; }
host function named(in name: String, in lengths: Array(Length)) -> String { return name; }
host function turned(in v: Vector(Length)) -> Vector(Length) { return v; }
host function nested(in all: Array(Array(Bool))) -> Number { return 0; }
print(friction(2 m/s), named("a", [1 mm, 2 mm]), turned(1 mm*e1));
"""


def test_python_functions_replace_host_functions():
    model = calyx.load(HOST)
    assert model.run().printed == ["0.05 a [0.001 m, 0 m, 0 m]"]
    host = {
        "friction": lambda sliding, dry: 1.0 if dry else 0.1 * sliding,
        "named": lambda name, lengths: f"{name} {lengths}",
        "turned": lambda v: [v[1], v[0], v[2]],
    }
    assert model.run(host=host).printed == ["0.2 a [0.001, 0.002] [0 m, 0.001 m, 0 m]"]


def test_wrong_host_functions_are_errors():
    model = calyx.load(HOST)
    with pytest.raises(calyx.ParamError, match="frictoin"):
        model.run(host={"frictoin": lambda sliding, dry: 0.1})
    with pytest.raises(TypeError, match="nested"):
        model.run(host={"nested": lambda all: 0.0})
    for function in (lambda sliding, dry: 1 / 0, lambda sliding, dry: "rough"):
        with pytest.raises(calyx.RunError, match="the Python function raised") as caught:
            model.run(host={"friction": function})
        assert "called at model.cx:6:7" in caught.value.rendered


def test_progress_is_reported_in_order(spur):
    seen = []
    results = spur.run(progress=seen.append, **QUICK)
    assert seen[0] == ("structures", 0, None)
    count = len(results.positions)
    solved = [progress for progress in seen if progress.stage == "positions" and progress.total]
    assert [progress.done for progress in solved] == list(range(1, count + 1))
    assert {progress.total for progress in solved} == {count}


def test_progress_is_shown_on_standard_error(spur, capsys):
    spur.run(progress=True, **QUICK)
    assert "positions" in capsys.readouterr().err


def test_exceptions_of_callbacks_end_the_run(spur):
    def fail(progress):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        spur.run(progress=fail, **LONG)


def test_interrupt_ends_the_run(spur):
    sent = []

    def interrupt(progress):
        if progress.stage == "positions" and not sent:
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

    # Processes in the background of a shell ignore this signal.
    former = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            spur.run(progress=interrupt, **LONG)
    finally:
        signal.signal(signal.SIGINT, former)
    assert time.monotonic() - sent[0] < 5


def test_another_thread_cancels(spur):
    cancel = calyx.Cancel()
    with pytest.raises(calyx.CancelledError) as caught:
        spur.run(progress=lambda _: cancel.cancel(), cancel=cancel, **LONG)
    assert caught.value.code and cancel.cancelled


def test_limits(spur):
    with pytest.raises(calyx.LimitError, match="time"):
        spur.run(time_limit=0.2, **LONG)
    with pytest.raises(ValueError, match="time_limit is -1"):
        spur.run(time_limit=-1)


def test_other_threads_continue_while_a_model_is_solved(spur):
    times = []
    ended = threading.Event()

    def tick():
        while not ended.wait(0.005):
            times.append(time.monotonic())

    thread = threading.Thread(target=tick)
    thread.start()
    started = time.monotonic()
    spur.run(steps=30, fidelity="plane")
    duration = time.monotonic() - started
    ended.set()
    thread.join()
    within = [at for at in times if started < at < started + duration]
    assert len(within) > duration / 0.1, (len(within), duration)


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_process_has_its_own_threads(spur):
    expected = bits(solve(spur, 500))
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert bits(pool.apply_async(solve, (spur, 500)).get(timeout=120)) == expected


def test_configured_cache_is_used(tmp_path, spur):
    calyx.configure(threads=1, cache=tmp_path)
    try:
        spur.run(**QUICK)
        assert list(tmp_path.iterdir())
    finally:
        calyx.configure()
    with pytest.raises(ValueError, match="threads is -1"):
        calyx.configure(threads=-1)
