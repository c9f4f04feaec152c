// Tests words and indentation of `language-configuration.json` on lines as they are typed.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";

const configuration = JSON.parse(readFileSync(new URL("../language-configuration.json", import.meta.url), "utf8"));
const regex = ({ pattern, flags }) => new RegExp(pattern, flags);

test("words are names of all scripts and whole numbers", () => {
  const word = new RegExp(regex(configuration.wordPattern).source, "gu");
  const words = (text) => text.match(word);
  assert.deepEqual(words("gears.external(größe_1=3.5e-7 µm)"), ["gears", "external", "größe_1", "3.5e-7", "µm"]);
  assert.deepEqual(words("0 mm..5 mm"), ["0", "mm", "5", "mm"]);
});

test("open brackets indent, closing ones do not", () => {
  const { increaseIndentPattern, decreaseIndentPattern } = configuration.indentationRules;
  const increases = (line) => regex(increaseIndentPattern).test(line);
  for (const line of ["function f(in x) {", "var rack = gears.rack(", "    modifications = [", "} else {", 'print("(", f(']) {
    assert.ok(increases(line), line);
  }
  for (const line of ["var a = f(x);", "// as in f(", "/// see `f(`", 'print("{x} (");', "record R { a = 1; }"]) {
    assert.ok(!increases(line), line);
  }
  assert.ok(regex(decreaseIndentPattern).test("    }"));
  assert.ok(!regex(decreaseIndentPattern).test("    a = b;"));
});

/** Returns the effect of the first matching rule at the end of a line. */
function onEnter(line, previous = "") {
  const fits = ({ beforeText, afterText, previousLineText }) =>
    regex(beforeText).test(line) &&
    (afterText === undefined || regex(afterText).test("")) &&
    (previousLineText === undefined || regex(previousLineText).test(previous));
  return configuration.onEnterRules.find(fits)?.action;
}

test("documentation goes on in the next line until a line of it stays empty", () => {
  assert.deepEqual(onEnter("/// Torque on the pinion."), { indent: "none", appendText: "/// " });
  assert.deepEqual(onEnter("    /// A whole number."), { indent: "none", appendText: "/// " });
  assert.equal(onEnter("/// ").appendText, undefined);
  assert.equal(onEnter("// plain"), undefined);
  assert.equal(onEnter("//// ruler"), undefined);
});

test("behind the last argument the call is left", () => {
  assert.deepEqual(onEnter("    rim = gears.simple_rim(diameter = 1 inch));"), { indent: "outdent" });
  assert.deepEqual(onEnter('        gears.tip_relief(relief, shape = "linear")]);'), { indent: "outdent" });
  assert.deepEqual(onEnter("    tip_radius = tip_radius);"), { indent: "outdent" });
  assert.equal(onEnter("    var a = f(g(x));"), undefined);
  assert.equal(onEnter("    print(a);"), undefined);
});

test("what follows a case is indented", () => {
  assert.deepEqual(onEnter("    case 2:"), { indent: "indent" });
  assert.deepEqual(onEnter("    default:"), { indent: "indent" });
});
