//! Help texts for the keywords and built-in names of the language: one or two sentences and an
//! example each.

/// The help text for a word.
#[derive(Clone, Copy, Debug)]
pub struct Help {
    pub word: &'static str,
    /// One or two sentences, Markdown.
    pub text: &'static str,
    /// A program, whole or a few statements of one.
    pub example: &'static str,
}

/// Returns the help for a built-in function or constant.
pub fn builtin(name: &str) -> Option<&'static Help> {
    BUILTINS.iter().find(|help| help.word == name)
}

/// Returns the help for a keyword.
pub fn keyword(word: &str) -> Option<&'static Help> {
    KEYWORDS.iter().find(|help| help.word == word)
}

/// Returns all help texts, for tests and the reference.
pub fn all() -> impl Iterator<Item = &'static Help> {
    BUILTINS.iter().chain(KEYWORDS)
}

const fn help(word: &'static str, text: &'static str, example: &'static str) -> Help {
    Help { word, text, example }
}

const BUILTINS: &[Help] = &[
    help("sin", "Sine of an angle.", "print(sin(30 deg));"),
    help("cos", "Cosine of an angle.", "print(cos(60 deg));"),
    help("tan", "Tangent of an angle.", "print(tan(45 deg));"),
    help("asin", "The angle from -90 to 90 degrees with this sine.", "var angle = asin(0.5);\nprint(angle);"),
    help(
        "acos",
        "The angle from 0 to 180 degrees with this cosine.",
        "var angle = acos(0.5);\nprint(angle);",
    ),
    help(
        "atan",
        "The angle between -90 and 90 degrees with this tangent.",
        "var helix = atan(0.25);\nprint(helix);",
    ),
    help(
        "atan2",
        "The angle of the point `(x, y)`, from -180 to 180 degrees; both have the same dimension.",
        "print(atan2(3 mm, 4 mm));",
    ),
    help("exp", "Exponential of a pure number.", "print(exp(1));"),
    help("log", "Natural logarithm of a pure number.", "print(log(10));"),
    help("sqrt", "Square root; the exponents of the dimension are halved.", "print(sqrt(9 mm^2));"),
    help("abs", "Absolute value.", "print(abs(-3 N));"),
    help(
        "min",
        "The smallest of two or more numbers with the same dimension, or of an array of them.",
        "print(min(3 mm, 1 mm, 2 mm), min([3, 1, 2]));",
    ),
    help(
        "max",
        "The largest of two or more numbers with the same dimension, or of an array of them.",
        "print(max(3 mm, 1 mm, 2 mm), max([3, 1, 2]));",
    ),
    help("floor", "The largest integer that is not greater.", "print(floor(2.7));"),
    help("ceil", "The smallest integer that is not less.", "print(ceil(2.1));"),
    help("round", "The nearest integer; halves are rounded away from zero.", "print(round(2.5));"),
    help("dot", "Scalar product of two vectors.", "print(dot(3 N * e1, 2 mm * e1));"),
    help(
        "cross",
        "Vector product of two vectors, by the right-hand rule.",
        "print(cross(30 mm * e1, 100 N * e2));",
    ),
    help("norm", "Length of a vector.", "print(norm(3 mm * e1 + 4 mm * e2));"),
    help(
        "Translate",
        "The frame translated by a vector. In `A * B`, the frame is first moved by `B`, then by `A` relative to the resulting frame.",
        "var second := Rotate(-3 rpm * Time, e3) * Translate(2 inch * e1);\nprint(origin(second) at Time = 0 s);",
    ),
    help(
        "Rotate",
        "The frame rotated about a unit vector, by the right-hand rule.",
        "var pinion := Rotate(3 rpm * Time, e3);\nprint(direction(pinion, e1) at Time = 5 s);",
    ),
    help(
        "inverse",
        "The inverse transformation.",
        "var frame = Translate(3 mm * e1);\nprint(origin(inverse(frame)));",
    ),
    help("origin", "The origin of a frame in ground coordinates.", "print(origin(Translate(3 mm * e1)).x);"),
    help(
        "direction",
        "A vector of a frame in ground coordinates; translations of the frame do not matter.",
        "print(direction(Rotate(90 deg, e3), e1));",
    ),
    help(
        "velocity",
        "Velocity of the origin of a frame that moves with `Time`, in ground coordinates.",
        "var arm := Rotate(3 rad/s * Time, e3) * Translate(2 m * e1);\nprint(velocity(arm) at Time = 0 s);",
    ),
    help(
        "acceleration",
        "Acceleration of the origin of a frame that moves with `Time`, in ground coordinates.",
        "var fall := Translate(-9.81 m/s^2 * Time^2 / 2 * e2);\nprint(acceleration(fall) at Time = 1 s);",
    ),
    help(
        "angular_velocity",
        "Angular velocity of a frame that rotates with `Time`, in ground coordinates.",
        "var shaft := Rotate(3000 rpm * Time, e3);\nprint(angular_velocity(shaft).z at Time = 0 s);",
    ),
    help(
        "angular_acceleration",
        "Angular acceleration of a frame that rotates with `Time`, in ground coordinates.",
        "var start := Rotate(2 rad/s^2 * Time^2 / 2, e3);\nprint(angular_acceleration(start).z at Time = 0 s);",
    ),
    help(
        "derivative",
        "The exact derivative of an expression with respect to `Time`, a number param or an argument of the enclosing symbolic function.",
        "param rate = 2 rad/s;\nvar x := 3 mm * sin(rate * Time);\nprint(derivative(x, Time) at Time = 0 s);",
    ),
    help(
        "gradient",
        "The derivatives of an expression with respect to several symbols: an array, or a tuple if their dimensions differ.",
        "param width = 2 mm;\nparam depth = 3 mm;\nprint(gradient(width * depth^2, [width, depth]));",
    ),
    help(
        "solve",
        "The first argument for which a symbolic function is zero, found from a guess by Newton's method. The arguments after the guess are those of the function's other parameters. The solution has exact derivatives.",
        "function equation(in x, in area) := x^2 - area;\nvar side := solve(equation, 1 mm, 2 mm^2);\nprint(side);",
    ),
    help(
        "minimize",
        "The first argument for which a symbolic function has a local minimum, found from a guess by Newton's method on the gradient; the second derivatives verify it. The arguments after the guess are those of the function's other parameters. The result has exact derivatives.",
        "function energy(in x, in load) := (2 N/mm) * x^2 / 2 - load * x;\nvar deflection := minimize(energy, 0 mm, 3 N);\nprint(deflection);",
    ),
    help(
        "spline",
        "The natural cubic spline through points, with exact derivatives: twice continuously differentiable, with a straight line beyond both ends. Arrays are captured when the expression is bound.",
        "const positions = [0 s, 1 s, 2 s];\nvar lift := spline(positions, [0 mm, 3 mm, 1 mm], Time);\nprint(lift at Time = 1 s, derivative(lift, Time) at Time = 1 s);",
    ),
    help("len", "The number of elements of an array.", "print(len([1 mm, 2 mm]));"),
    help(
        "push",
        "Appends an element to an array. It is a statement without a value.",
        "var widths = [10 mm, 20 mm];\npush(widths, 30 mm);\nprint(widths);",
    ),
    help(
        "sum",
        "The sum of the elements of an array: numbers, vectors, or arrays of equal length.",
        "print(sum([10 mm, 20 mm]));",
    ),
    help(
        "sort",
        "The numbers of an array in ascending order; NaN follows all others.",
        "print(sort([3 mm, 1 mm, 2 mm]));",
    ),
    help(
        "print",
        "Prints its values on a line, in the units of the file's system, separated by blanks.",
        "print(\"width\", 20 mm);",
    ),
    help(
        "assert",
        "Ends the run with an error if the condition is false. The message is optional.",
        "var teeth = 20;\nassert(teeth > 11, \"{teeth} teeth are too few\");",
    ),
    help(
        "Time",
        "The time. It has no value while the model is built, so it is allowed only in `:=` expressions.",
        "var angle := 3 rpm * Time;\nprint(angle at Time = 5 s);",
    ),
    help("e1", "The unit vector along x.", "var arm = 30 mm * e1;\nprint(arm);"),
    help("e2", "The unit vector along y.", "var load = -100 N * e2;\nprint(load);"),
    help(
        "e3",
        "The unit vector along z: the axis of gears in a two-dimensional model.",
        "var moment = 5 N*m * e3;\nprint(moment);",
    ),
    help("pi", "The ratio of a circle's circumference to its diameter.", "print(pi / 4 * (10 mm)^2);"),
    help(
        "inf",
        "Infinity, with any dimension.",
        "var least = inf;\nleast = min(least, 2 mm);\nprint(least);",
    ),
    help("nan", "Not a number (NaN), with any dimension.", "var missing = nan;\nprint(missing == 2 mm);"),
    help("TRUE", "The truth value `true`.", "param crowned = TRUE;\nif (crowned) print(\"crowned\");"),
    help("FALSE", "The truth value `false`.", "param crowned = FALSE;\nif (!crowned) print(\"straight\");"),
];

const KEYWORDS: &[Help] = &[
    help(
        "var",
        "Declares a variable. With `=` it holds a value, with `:=` it keeps the expression, in which `Time`, params and other such \
         names stay symbols.",
        "var width = 20 mm;\nvar angle := 3 rpm * Time;\nprint(width, angle at Time = 1 s);",
    ),
    help(
        "param",
        "An input that is set from outside, as by `calyx run model.cx --set torque=500`. After `in` stands a range or a list of \
         choices.",
        "/// Torque on the pinion.\nparam torque = 1000 lbf*inch in 0 lbf*inch .. 5000 lbf*inch;\nprint(torque);",
    ),
    help(
        "output",
        "What the results hold: an observable of the library, or an expression of observables, params and `Time`.",
        "param rate = 3 rpm;\noutput angle := rate * Time;",
    ),
    help(
        "const",
        "Names a value that is known before the program runs. It is visible in its whole block.",
        "const tooth_count = 2 * 10 + 1;\nprint(tooth_count);",
    ),
    help(
        "function",
        "A function of values, or with `:=` an expression with free arguments.",
        "function area(in width, in depth = 1 mm) { return width * depth; }\n\
         function wave(in t) := 2 mm * sin(3 rad/s * t);\nprint(area(2 mm), wave(0 s));",
    ),
    help(
        "record",
        "Named fields, each with a type, a default or both. A record is created like a call.",
        "record Blank {\n    width = 25 mm;\n    teeth: Number;\n}\nprint(Blank(teeth = 20));",
    ),
    help(
        "enum",
        "A type with a few values, its choices. The text of a choice stands for it.",
        "enum Hand { left, right }\nvar hand = Hand.left;\nprint(hand == \"left\");",
    ),
    help(
        "component",
        "A part of a model that may occur several times, with its own params and outputs. An instance is declared with `var`.",
        "component Shaft(diameter: Length) {\n    param torque = 10 N*m;\n    var stress = 16 * torque / (pi * diameter^3);\n}\n\
         var shaft = Shaft(20 mm);\nprint(shaft.stress);",
    ),
    help(
        "dimension",
        "Declares a name for a product of dimensions or, without a value, a new base dimension.",
        "dimension Cost;\nunit euro: Cost;\ndimension Wage = Cost/Time;\nprint(200 euro / 8 hour);",
    ),
    help(
        "unit",
        "Declares a unit by its size, or the first unit of a new base dimension.",
        "unit hand = 4 inch;\nprint(3 hand);",
    ),
    help(
        "import",
        "Makes the declarations of a module visible as `module.name`. The module is part of the library, or a file in the folder of this one.",
        "import gears;\nvar rack = gears.rack(module = 2 mm, tip_radius = 0.6 mm);",
    ),
    help(
        "units",
        "The system of the file: in which units it shows numbers, and what a number without unit means where its use says its \
         dimension.",
        "units mm_N_s;\nprint(1 inch);",
    ),
    help(
        "private",
        "Hides a declaration from files that import the module.",
        "private const ratio = 3;\nfunction scaled(in x) { return ratio * x; }",
    ),
    help("extern", "Declares a function of the engine. Only the library can do this.", ""),
    help(
        "host",
        "A function that the embedding program may provide. Its body runs if no program provides it.",
        "host function friction(in v: Velocity) -> Number { return 0.05; }\nprint(friction(2 m/s));",
    ),
    help("test", "Marks a function that `calyx test` runs.", "test function adds() { assert(1 + 1 == 2); }"),
    help(
        "if",
        "A conditional statement or a conditional expression.",
        "var torque = -3 N*m;\nif (torque < 0) print(\"coast\");\nprint(if (torque < 0) -1 else 1);",
    ),
    help(
        "else",
        "The statement or the value if the condition of the nearest `if` is false.",
        "print(if (1 < 2) 1 else 2);",
    ),
    help(
        "for",
        "A loop over the elements of an array or the numbers of a range, or with an initialization, a condition, and a step after each iteration.",
        "for (width in [1 mm, 2 mm]) print(width);\nfor (i in 0 .. 3) print(i);\nfor (var i = 0; i < 3; i += 1) print(i);",
    ),
    help(
        "while",
        "A loop that repeats while its condition is true.",
        "var n = 100;\nwhile (n > 1) n = n / 2;\nprint(n);",
    ),
    help(
        "do",
        "A loop whose body runs at least once.",
        "var n = 1;\ndo {\n    n = 2 * n;\n} while (n < 100);\nprint(n);",
    ),
    help(
        "switch",
        "Enters the first `case` that is equal to the value, or `default`. Execution goes on into the next case unless `break` \
         leaves the switch.",
        "switch (2) {\n    case 1:\n        print(\"one\");\n        break;\n    default:\n        print(\"many\");\n}",
    ),
    help(
        "case",
        "A value for which a `switch` continues here.",
        "switch (\"a\") {\n    case \"a\":\n    case \"b\":\n        print(\"a or b\");\n}",
    ),
    help(
        "default",
        "The point at which a `switch` continues if no case is equal.",
        "switch (3) {\n    case 1:\n        print(1);\n        break;\n    default:\n        print(\"other\");\n}",
    ),
    help("break", "Leaves the innermost loop or `switch`.", "while (TRUE) break;"),
    help(
        "continue",
        "Continues with the next iteration of the innermost loop.",
        "for (var i = 0; i < 3; i = i + 1) {\n    if (i == 1) continue;\n    print(i);\n}",
    ),
    help(
        "return",
        "Leaves a function and returns its value, if any.",
        "function twice(in x) { return 2 * x; }\nprint(twice(3));",
    ),
    help(
        "goto",
        "Jumps to a label of the same block or of an enclosing one.",
        "for (var i = 0; i < 3; i = i + 1) {\n    for (var j = 0; j < 3; j = j + 1) if (i * j == 2) goto found;\n}\n\
         found: print(\"left both loops\");",
    ),
    help(
        "throw",
        "Fails with an error: a text or an `Error`. In a `catch`, `throw;` throws the caught error again.",
        "try throw \"out of stock\";\ncatch (error) print(error.message);",
    ),
    help(
        "try",
        "Runs a statement; if it fails, the statement after `catch` runs.",
        "try {\n    print([1, 2][2]);\n} catch (error) {\n    print(error.code, error.message);\n}",
    ),
    help(
        "catch",
        "The statement that runs if the `try` before it fails. It receives an `Error` with `code`, `message`, `place` and `value`.",
        "try throw Error(code = \"STOCK\", message = \"out of stock\");\ncatch (error) print(error.code);",
    ),
    help(
        "in",
        "Before a parameter: its value is passed. After the default of a param or parameter: its range or choices.",
        "function hob(in teeth = 20 in 5 .. 200) { return teeth; }\nprint(hob(30));",
    ),
    help(
        "out",
        "A parameter whose value is copied back when the function returns.",
        "function half(in x, out y) { y = x / 2; }\nvar y;\nhalf(3, y);\nprint(y);",
    ),
    help(
        "inout",
        "A parameter that is passed, and copied back when the function returns.",
        "function double(inout x) { x = 2 * x; }\nvar x = 3;\ndouble(x);\nprint(x);",
    ),
    help(
        "at",
        "The value of an expression at a time, or with another value of a param.",
        "var angle := 3 rpm * Time;\nprint(angle at Time = 5 s);",
    ),
    help(
        "is",
        "`e is none` tests whether an optional parameter or field has no value, `e is not none` whether it has one.",
        "function area(in length, in width = none) {\n    if (width is none) return length^2;\n    return length * width;\n}\nprint(area(2 mm));",
    ),
    help(
        "none",
        "No value: the default of an optional parameter or field. `e is none` tests for it.",
        "function area(in length, in width = none) {\n    if (width is none) return length^2;\n    return length * width;\n}\n\
         print(area(2 mm, none));",
    ),
    help("pure", "Marks an engine function that depends only on its arguments.", ""),
    help("scene", "Marks an engine function that adds to the model.", ""),
    help("effect", "Marks an engine function that checking does not call, such as one that solves.", ""),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::builtin_names;
    use crate::lexer::keywords;

    #[test]
    fn every_word_has_help_and_only_words_have() {
        for name in builtin_names() {
            assert!(builtin(name).is_some(), "{name}");
        }
        for word in keywords().filter(|word| builtin(word).is_none()) {
            assert!(keyword(word).is_some(), "{word}");
        }
        let known: Vec<&str> = builtin_names().collect();
        for help in BUILTINS {
            assert!(known.contains(&help.word), "{}", help.word);
        }
    }
}
