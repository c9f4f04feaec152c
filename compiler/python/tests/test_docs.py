"""Python programs on pages of the book and in the README of the package."""

import re
import shutil

import pytest

from support import EXAMPLES, ROOT, optional


@pytest.mark.parametrize("page", ["docs/howto/python.md", "compiler/python/README.md"])
def test_programs_on_pages_run(page, tmp_path, monkeypatch):
    optional("pandas")
    shutil.copy(EXAMPLES / "spur_pair.cx", tmp_path / "pair.cx")
    monkeypatch.chdir(tmp_path)
    text = (ROOT / page).read_text(encoding="utf-8")
    # The README shows the default run, which takes long.
    text = text.replace('run(torque="120 N*m")', 'run(torque="120 N*m", steps=2, fidelity="plane")')
    names = {}
    for program in re.finditer(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        line = text.count("\n", 0, program.start()) + 1
        exec(compile("\n" * line + program.group(1), str(ROOT / page), "exec"), names)
