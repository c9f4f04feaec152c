"""Loading of models, their params and outputs, and their errors."""

import pytest

import calyx
from support import EXAMPLES

TEXT = """/// Area of a rectangle.
units mm_N_s;
/// Width of the rectangle.
param width = 3 mm in 1 mm .. 10 mm;
param count = 2 in 1 .. 5;
param shape = "flat" in ["flat", "round"];
param hollow = TRUE;
param masses = [1 kg, 2 kg];
param height = 2 * width;
/// Its area.
output area := count * width * height;
output total := sum(masses);
print("hollow: {hollow}");
"""


def test_params_have_units_ranges_and_documentation():
    params = calyx.load(TEXT).params
    width = params["width"]
    assert (width.unit, width.default, width.bounds, width.kind) == ("mm", 3.0, (1.0, 10.0), "number")
    assert width.doc == "Width of the rectangle." and width.independent
    assert (params["count"].kind, params["count"].default, params["count"].high) == ("integer", 2.0, 5.0)
    assert params["shape"].choices == ("flat", "round") and params["shape"].default == "flat"
    assert (params["hollow"].kind, params["hollow"].default) == ("bool", True)
    assert (params["masses"].kind, params["masses"].default) == ("array", [1.0, 2.0])
    assert not params["height"].independent and params["height"].bounds == (float("-inf"), float("inf"))
    assert "Width of the rectangle." in params._repr_html_()


def test_outputs_have_units_and_documentation(spur):
    error = spur.outputs["transmission_error"]
    assert (error.unit, error.si_unit, error.is_array) == ("urad", "rad", False)
    assert error.doc.startswith("Transmission error: rotation of the pinion")


def test_files_and_texts(tmp_path):
    path = tmp_path / "area.cx"
    path.write_text(TEXT)
    models = [calyx.load(path), calyx.load(str(path)), calyx.load(TEXT), calyx.loads(TEXT, "area.cx")]
    assert {model.doc for model in models} == {"Area of a rectangle."}
    assert models[0].source == TEXT and models[3].name == "area.cx"
    assert "Area of a rectangle." in models[0]._repr_html_()


def test_values_evaluate_defaults_that_depend_on_other_params():
    model = calyx.load(TEXT)
    assert model.values(width="1 cm")["height"] == 0.02
    assert model.values({"masses": [(1.0, "g"), 3]})["masses"] == [0.001, 3.0]


def test_errors_of_the_language_have_source_lines():
    with pytest.raises(calyx.ModelError) as caught:
        calyx.loads("param width = 3 mm;\noutput area := widht^2;\n", "area.cx")
    error = caught.value
    assert error.code == "E0201" and "widht" in error.message and error.help
    assert "area.cx:2:16" in error.rendered and "output area := widht^2;" in str(error)


def test_missing_files():
    with pytest.raises(FileNotFoundError, match="no_such_model.cx"):
        calyx.load(EXAMPLES / "no_such_model.cx")


def test_diagnostics_report_warnings():
    assert "W0201" in calyx.load("var unused = 3;\nprint(1);").diagnostics
    assert calyx.load(TEXT).diagnostics == ""


@pytest.mark.parametrize(
    ("params", "words"),
    [
        ({"widht": 3}, "did you mean `width`"),
        ({"width": "3 kg"}, "a mass"),
        ({"width": 11}, "outside its range"),
        ({"width": "three"}, "three"),
        ({"width": (3, "parsec")}, "parsec"),
        ({"count": 2.5}, "whole number"),
        ({"shape": "square"}, "flat"),
        ({"hollow": 3}, "hollow"),
        ({"width": float("nan")}, "width"),
    ],
)
def test_wrong_values_name_param_and_remedy(params, words):
    with pytest.raises(calyx.ParamError) as caught:
        calyx.load(TEXT).values(params)
    assert words in str(caught.value), str(caught.value)
    assert isinstance(caught.value, ValueError)
    # The command line has this option.
    assert "--set" not in caught.value.help + str(caught.value)


def test_values_of_other_types_are_type_errors():
    with pytest.raises(TypeError, match="a param cannot be a"):
        calyx.load(TEXT).values(width=object())
    with pytest.raises(TypeError, match="given twice: width"):
        calyx.load(TEXT).values({"width": 3}, width=4)
