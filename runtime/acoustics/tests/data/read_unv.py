"""Reads the file of the test `pyuff_reads_what_is_written` with pyuff and compares its values."""

import sys

import numpy
import pyuff

sets = pyuff.UFF(sys.argv[1]).read_sets()
kinds = [found["type"] for found in sets]
assert kinds == [151, 164, 2411, 2412, 82, 55, 2414, 2414] + 8 * [58], kinds

_, units, nodes, elements, line, nodal = sets[:6]
assert units["units_code"] == 1 and units["length"] == 1.0
assert list(nodes["node_nums"]) == [1, 2, 99999999], nodes
assert nodes["x"][1] == 0.5 and nodes["z"][2] == 2.0, nodes
assert line["trace_num"] == 1 and len(line["nodes"]) == 10, line
assert list(nodal["node_nums"]) == [1, 2, 5] and nodal["freq"] == 1250.0, nodal
assert nodal["r1"][0] == -1.0 + 2.0j and nodal["r3"][2] == -0.75 + 1.75j, nodal

expected = numpy.arange(7) * 0.125 - 1.0
for index, found in enumerate(sets[8:]):
    values = expected + 1j * (1 - expected) if index % 2 else expected
    assert numpy.allclose(found["data"], values), found
    even = 100.0 + 2.5 * numpy.arange(7)
    assert numpy.allclose(found["x"], expected if index % 4 > 1 else even), found
    assert found["rsp_node"] == 17 and found["ref_node"] == 4 and found["ref_dir"] == -3, found
print("equal")
