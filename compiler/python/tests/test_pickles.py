"""Pickles of models, results and exceptions, for processes of Dask, joblib and multiprocessing."""

import multiprocessing
import pickle

import pytest

import calyx
from support import QUICK, bits, optional, solve


def test_models_are_the_same_after_pickling(spur):
    data = pickle.dumps(spur)
    copy = pickle.loads(data)
    assert copy.params == spur.params and copy.source == spur.source
    assert bits(solve(copy, 500)) == bits(solve(spur, 500))
    # A process compiles and loads a model once.
    assert pickle.loads(data) is copy and pickle.dumps(copy) == data
    with pytest.raises(calyx.RunError) as caught:
        copy.run(tooth_thickness=0.08, **QUICK)
    assert "spur_pair.cx:" in caught.value.rendered


def test_damaged_models_are_errors(spur):
    function, (data,) = spur.__reduce__()
    for damaged in (b"", b"nothing", data[:-1], data[:200] + bytes([data[200] ^ 1]) + data[201:]):
        with pytest.raises(calyx.ModelError):
            function(damaged)


def test_results_keep_their_numbers(spur_results):
    copy = pickle.loads(pickle.dumps(spur_results))
    assert bits(copy) == bits(spur_results) and copy.params == spur_results.params
    assert copy["load_share"].summary == spur_results["load_share"].summary
    assert copy["max_contact_pressure"].to("MPa").max == spur_results["max_contact_pressure"].to("MPa").max
    pressure = [fields.contacts[0].pressure.tobytes() for fields in spur_results.fields.values()]
    assert [fields.contacts[0].pressure.tobytes() for fields in copy.fields.values()] == pressure
    assert copy._repr_html_().startswith("<table>") and repr(copy) == repr(spur_results)
    with pytest.raises(calyx.CalyxError, match="call save"):
        copy.save("anywhere")


def test_exceptions_keep_their_texts(spur):
    with pytest.raises(calyx.ParamError) as caught:
        spur.values(torqe=3)
    copy = pickle.loads(pickle.dumps(caught.value))
    assert type(copy) is calyx.ParamError and (str(copy), copy.help) == (str(caught.value), caught.value.help)


@pytest.mark.slow
def test_processes(spur):
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        copy = pool.apply_async(solve, (spur, 500)).get(timeout=120)
    assert bits(copy) == bits(solve(spur, 500))


@pytest.mark.slow
def test_joblib(spur):
    joblib = optional("joblib")
    tasks = [joblib.delayed(solve)(spur, torque) for torque in (500, 600)]
    found = joblib.Parallel(n_jobs=2)(tasks)
    assert [bits(results) for results in found] == [bits(solve(spur, torque)) for torque in (500, 600)]
