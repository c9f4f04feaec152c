//! Explanations of diagnostic codes: the meaning of each code and how to fix the problem.

/// A diagnostic code with its explanation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explanation {
    pub code: &'static str,
    /// The problem in a few words.
    pub title: &'static str,
    /// One paragraph: the reason for the diagnostic and how to fix the problem.
    pub text: &'static str,
}

/// Returns the explanation of a code, case-insensitively.
pub fn explain(code: &str) -> Option<&'static Explanation> {
    CODES.iter().find(|e| e.code.eq_ignore_ascii_case(code))
}

/// Returns all codes in order.
pub fn all() -> &'static [Explanation] {
    CODES
}

macro_rules! codes {
    ($($code:literal $title:literal $text:literal)*) => {
        &[$(Explanation { code: $code, title: $title, text: $text }),*]
    };
}

const CODES: &[Explanation] = codes! {
    "E0101" "an unexpected character" "The character is not part of the language outside strings and comments. Remove it, or put it into a string."
    "E0102" "a comment that is not closed" "A comment that starts with `/*` must be closed with `*/`."
    "E0103" "a string that is not closed, or in single quotes" "Strings need double quotes and end on the line on which they start. Close the string with a quotation mark; write `\\n` for a line break in it."
    "E0104" "an unknown escape in a string" "The escapes in strings are `\\n`, `\\t`, `\\\"`, `\\\\`, and `{{` and `}}` for braces."
    "E0105" "a malformed number" "A number consists of digits with an optional decimal part and an optional power of ten, such as `3`, `0.5` or `2e-3`."
    "E0106" "nesting that is too deep" "The nesting of brackets, blocks and operators is limited, so that no text can exhaust the compiler. Split the expression into several statements."
    "E0110" "a missing semicolon" "Every statement except a block ends with `;`."
    "E0111" "a bracket or block that is not closed" "Every `(`, `[` and `{` needs a matching closing bracket."
    "E0112" "a missing value" "An expression is expected: a number, a name, a call, or an expression in parentheses."
    "E0113" "an unexpected keyword or symbol" "The grammar does not allow this token here. Remove it, or complete the construct before it."
    "E0114" "a missing or reserved name" "A declaration needs a name. Keywords and `Time e1 e2 e3 pi inf nan TRUE FALSE` cannot be names."
    "E0115" "a missing token" "The grammar requires another token here; the message names it."
    "E0116" "a closing bracket without an opening one" "No bracket of this kind is open. Remove it, or open one before it."
    "E0117" "an assignment used as a condition" "`=` assigns. Compare with `==`."
    "E0118" "an operator of another language" "Combine conditions with `&` and `|`, which evaluate their right side only if needed."
    "E0119" "a keyword of another language" "The keyword has another spelling in this language; the message shows it."
    "E0120" "a parameter without a mode" "Every parameter needs a mode: `in` passes a value, `out` and `inout` copy a value back when the function returns."
    "E0121" "an exponent of a unit that is not an integer" "An exponent directly after a unit applies to the unit and must be an integer, as in `2 inch^2`. Put the quantity in parentheses to raise all of it to a power."
    "E0122" "an assignment to a value" "Only variables and elements of arrays can be assigned."
    "E0123" "a top-level declaration inside a block" "`import`, `units`, `param`, `output`, `private`, `test` and `host` apply to the whole file, so they are allowed only outside of blocks and functions."
    "E0124" "a malformed type" "A type is a dimension such as `Length` or `Force/Length^2`, or `Bool`, `String`, `Vector(...)`, `Transform`, `Array(...)`."
    "E0130" "a decimal comma" "The decimal separator is a point: `2.5 mm`. A comma separates values, arguments and names, so `2,5 mm` are the two values 2 and 5 mm."
    "E0131" "two numbers without an operator" "Write an operator or a comma between two numbers. Write a unit such as 1/min with `/` directly after the number: `100/min`."
    "W0125" "a quantity as a divisor" "A unit has a higher precedence than any operator, so `1/2 inch` is 1/(2 inch). Add parentheses to show the intended meaning."
    "E0201" "an unknown name" "The name is not declared, or not visible here. Variables are visible from their declaration to the end of the block, functions in their whole block, functions of modules as `module.name` after `import module;`."
    "W0201" "an unused variable" "The variable is never read. Remove it, or start its name with `_` to keep it. Variables that name a part of the model, such as a mesh, are not reported, nor are objects of libraries in a model without outputs."
    "E0202" "a name declared twice" "A block can declare a name only once. An inner block may declare it again. An assignment does not need `var`."
    "W0202" "unreachable statements" "No path of the program leads to this statement: on every path, a `return`, `break`, `continue` or `goto` precedes it."
    "E0203" "a reserved name" "`Time e1 e2 e3 pi inf nan TRUE FALSE` have a fixed meaning."
    "W0203" "a value that is not used" "The statement computes a value and drops it. Assign it, or remove the statement."
    "E0204" "an unknown name in a module" "The module does not declare this name, or declares it `private`."
    "E0205" "an unknown parameter" "The function has no parameter with the name of this argument."
    "E0206" "arguments that do not match" "Pass arguments in order or by name, each once. Arguments without a name come first, and parameters without a default are required."
    "E0207" "an assignment to a param" "Params are set before the model runs and do not change. Copy the param into a variable to change it."
    "E0208" "an invalid assignment target" "Only variables and elements of arrays can be assigned, or passed to an `out` parameter."
    "E0209" "an unknown module" "The module is neither in the library nor in the folder of the model's file."
    "E0210" "a statement in a module" "A module declares functions, constants, records, dimensions and units. Statements that run belong to the model."
    "E0212" "a value that is not constant" "Defaults, ranges and choices are computed before the program runs. They can use literals, earlier params and functions without effects."
    "E0213" "an unknown kind of extern function" "An extern function is `pure` (depends only on its arguments), `scene` (adds to the scene) or `effect`."
    "E0214" "a misplaced break, continue, case or default" "`break` leaves a loop or switch, `continue` starts the next iteration of a loop; `case` and `default` must be directly in the body of a `switch`."
    "E0215" "a goto without a valid target" "`goto` jumps to a label in the same block or in an enclosing one. It cannot jump into a block or out of its function."
    "E0216" "a throw without an error" "`throw;` throws the error of the enclosing `catch` again. Elsewhere, also in a function that a `catch` calls, there is no such error: throw a text or an `Error`."
    "E0217" "a variable read before it has a value" "On some path the variable is read before it is assigned. Assign it in the declaration, or on every path."
    "E0218" "an out parameter without a value" "A function must assign its `out` parameters on every path to its end."
    "W0205" "a unit that is also a variable" "A name directly after a number is a unit, even if a variable has the same name. Write `*` to multiply by the variable."
    "E0220" "an assignment to a constant" "The value of a `const` cannot change. Declare a variable with `var` instead."
    "E0221" "a constant that is too large" "Constants are substituted where they are used, so constants that use each other several times grow exponentially. Use a variable."
    "E0222" "a test with parameters or a result" "`calyx test` calls a test without arguments and ignores results. Call the function under test inside the test, and assert the expected value."
    "E0223" "a variable of the model in a test" "A test runs without the top level of the model. It can use functions, constants, records and params."
    "E0224" "a second unit system" "`units` sets the units of all numbers of the file that have none, so a file can have only one. Remove one of the two; a single number may have any unit."
    "E0225" "an invalid host function" "The embedding program may provide a host function, so its header must be complete: all parameters are `in` and have types, the result has a type, and the types are numbers and vectors of known dimensions, `Bool`, `String` or arrays of these. Its body runs if no program provides it."
    "E0230" "a module that cannot be read" "Modules and tables are regular files below the model's directory. A link may not lead out of it, and special files such as pipes are not read. Put the file itself into the model's directory."
    "E0301" "a value of another type" "Every variable and parameter has one type. The message shows the expected and the actual type."
    "E0302" "a type that contains itself" "The program would need an infinite type, such as an array that is its own element."
    "E0303" "a call without a value" "The function returns nothing. Call it as a statement."
    "E0304" "an operator with unsupported types" "Numbers and vectors can be added, numbers scale vectors, and frames multiply frames and points. Join strings by interpolation."
    "E0305" "an invalid index" "The indices of arrays are integers from 0, those of tuples are also constant."
    "E0306" "a function or module used as a value, or a value called" "Functions are not values and can only be called. Only functions can be called."
    "E0307" "an unknown field" "Records have their declared fields, vectors the components `.x`, `.y` and `.z`."
    "E0308" "a malformed type annotation" "The parameters of extern functions need types. A dimension is a product of powers of dimensions."
    "E0309" "an unknown type" "The name is neither a dimension, nor a built-in type, nor a type of the library."
    "E0310" "an invalid out argument" "`out` and `inout` arguments must be variables or elements of arrays, and two of them must not be the same."
    "E0311" "push used as a value" "`push(array, value);` is a statement that appends to the array."
    "E0312" "a param with an unsupported type" "Params are numbers, arrays of numbers, truth values and strings, because they can be set on a command line."
    "E0313" "an empty range" "The lower limit of the range is above its upper limit."
    "E0314" "a value outside its range or choices" "The declaration of the param or parameter restricts its values, and this constant is not allowed."
    "E0315" "a case that occurs twice" "Each constant case of a switch may occur once, and there is at most one default."
    "E0316" "an invalid return" "A function returns a value either on all paths or on none; the top level returns none."
    "E0317" "a missing return" "The function returns values, but some path ends without one."
    "E0401" "dimensions that do not match" "Quantities can be added, compared and assigned only if their dimensions are equal (except for angles). The message shows both sides factor by factor, and the missing factor."
    "E0402" "a dimension error inside a function" "With the arguments of this call, an operator inside the function has operands with incompatible dimensions. Compare the dimensions of the arguments with their use in the function."
    "E0403" "an unknown unit" "A name directly after a number must be a unit. Write `*` between a number and a variable."
    "E0404" "an unknown unit system" "The unit systems are `SI`, `mm_N_s` and `inch_lbf_s`."
    "E0405" "too many base dimensions" "A program can declare at most three base dimensions in addition to length, mass, time, angle and temperature. Derive others: `dimension Wage = Cost/Time;`."
    "E0406" "an invalid unit declaration" "Declare the first unit of a new base dimension as `unit euro: Cost;`, and every other unit by its size: `unit cent = 0.01 euro;`."
    "E0407" "a circular dimension or unit" "The dimension or unit depends on itself. Define it by other dimensions and units."
    "E0408" "an invalid format" "A format consists of a width, digits after a point, `e` for a power of ten, and a unit: `{x : 10.3 mm}`. Digits and units apply only to numbers."
    "E0501" "`Time` where a value is needed" "`=` evaluates immediately, and `Time` has no value while the model is built. Bind the expression with `:=`, or evaluate it with `at Time = ...`."
    "E0502" "a time-dependent name where a value is needed" "The name is bound with `:=` to an expression in `Time`. Use it inside another `:=`, or evaluate it with `at Time = ...`."
    "E0503" "`=` and `:=` exchanged" "The declaration of a variable or parameter determines whether it has a value or an expression."
    "E0504" "a symbolic name without an expression" "The `:=` of this name comes later, or is in code that has not run. Move the binding before this use."
    "E0505" "an observable used as a value" "An observable has a value at each step of an analysis, not while the model is built. The program can compute other observables with it, but cannot print it, compare it, or use it as a count. Make it an `output`, or bind it with `:=`."
    "E0506" "an expression that is not a symbol" "Expressions can be differentiated with respect to, and evaluated at, `Time`, number params and number arguments of symbolic functions."
    "E0507" "an expression that cannot be symbolic" "Only numbers, vectors, frames, and brackets and records of them can be bound with `:=`. The texts and choices of such a record are those with which it was bound; a record that is selected or computed symbolically has none."
    "E0508" "the derivative of an observable" "The analysis computes the values of an observable, so its derivative is not known when the model is compiled."
    "E0509" "a derivative that would miss a dependence" "The expression captured a value that was computed from the param, or assigned under a condition on it. The derivative, or the value for another value of the param, would silently miss this dependence. Bind the captured name with `:=`, and write a condition as a conditional expression. The default of a param may depend on another param, but it can be overridden; bind a value that always depends on the other param with `:=`."
    "E0510" "a symbolic expression that grows without bound" "With all definitions substituted, the expression has too many operations; usually each definition uses the previous one twice."
    "E0511" "a value in a symbolic function" "A symbolic function is an expression and cannot capture the value of a variable. It can use its arguments, `Time`, params, constants and other symbolic functions."
    "E0512" "an invalid argument of a symbolic function" "The arguments of a symbolic function are numbers, truth values, vectors, frames, and records and brackets of them, with the mode `in`. The number of elements of an array is known only when the program runs; write its elements in brackets."
    "E0513" "a recursive symbolic function" "A symbolic function is a single expression, which recursion would make infinite. Build the expression in a loop that binds a `:=` name repeatedly."
    "E0514" "a function that cannot be symbolic" "A function that is called with symbolic arguments in a `:=` is inlined into the expression, so its body may contain only `var` declarations and a `return`. Write it as a symbolic function, or call it with values."
    "E0515" "an axis that is not a unit vector" "`Rotate` needs a vector of length 1; another length would scale the frame. A computed axis is checked when the rotation is computed or bound. Divide the axis by its length: `a/norm(a)`."
    "E0516" "a host function in a symbolic expression" "A function of the embedding program has no formula, so it cannot be differentiated or inlined into an expression. Call it with values, or interpolate its values."
    "E0518" "a name that is both a unit and a variable" "In a product or quotient after a number with a unit, such as `3 N/m`, names are read as units. If such a name is also a visible variable, parameter, param or constant, the meaning is ambiguous. Rename the variable, use another name of the unit (`3 N/meter`), or add parentheses to use the variable: `(3 N)/m`."
    "W0518" "cycles where angles are expected" "Hz, kHz and the dimension `Frequency` count cycles; rad, deg, rev and rpm are angles. One cycle is 2 pi radians, so a factor of 2 pi is missing if the two are combined in a sum, a comparison, an assignment or an argument. Multiply cycles by `1 rev`, or divide angles by it."
    "E0519" "a unit of angles for cycles" "A value in Hz cannot be shown in rpm, nor one in rad/s in Hz: one cycle is 2 pi radians. Multiply cycles by `1 rev`, or divide angles by it."
    "W0519" "the reciprocal of an angular velocity" "`1/(60 rpm)` is the time for a rotation by one radian, 0.159 s; a revolution takes 1 s. Write `1 rev / speed` for the time of a revolution, `1 rad / speed` for that of a radian."
    "E0860" "an invalid block of a symbolic function" "The block of a symbolic function gives names to expressions and returns one: `:= { var a = ...; return ...; }`. Everything in it stays symbolic, so its variables are declared with `=` and never assigned again. Write a choice as a conditional expression `if (c) a else b`."
    "E0861" "an invalid function for `solve` or `minimize`" "The first argument of `solve` is the name of a function whose first parameter is the unknown and whose result is zero at the solution. The arguments after the guess are those of its other parameters: `solve(f, guess, a, b)` finds `x` with `f(x, a, b) = 0`, and `minimize(f, guess, a, b)` the `x` for which `f(x, a, b)` has a minimum."
    "E0862" "equations and unknowns that do not match" "`solve` and `minimize` find a number, a vector or an array of up to four numbers. The function of `solve` returns one residual for each of them; the dimensions of the residuals may differ from those of the unknowns. The function of `minimize` returns one number."
    "E0864" "invalid points of a spline" "`spline(xs, ys, x)` takes as many ordinates as abscissas, at least two, in the order of ascending abscissas, and all of them finite. The points are numbers in brackets, a `const`, or arrays that the program computes or reads from a table before."
    "E0865" "an invalid call of a parameter" "A parameter that is called is a function: `function slope(in f, in u) := derivative(f(u), u);`. All its calls have the same number of arguments, in order and without names, because the parameters of the passed function may have any names. The parameter is never assigned, and nested functions receive it as an argument."
    "E0866" "an argument that is not a suitable function" "The argument of a parameter that is called is the name of a function of the program, or such a parameter of the enclosing function. Its parameters are plain `in` parameters without a range, and it uses no variables of a function around it. An ordinary function computes values, so it takes no function of `Time`."
    "E0867" "a function that does not fit its calls" "The function that is passed has as many parameters as the calls of the parameter have arguments, and the types of parameters and result must fit. The message names the first difference. Pass another function, or declare one that calls it with the right arguments."
    "E0868" "an unknown number of instances" "The params of all instances are listed before the model runs, so the compiler must know how many there are. A comprehension of instances goes through brackets, a constant, a variable that is declared with brackets and never assigned, or a range with constant limits, and has no condition."
    "W0520" "a number without a unit as an angle or an angular velocity" "A number without a unit is an angle in radians, or an angular velocity in radians per second. The first is rarely intended next to an angle in degrees, or above one revolution, the second for speeds of shafts. Write `2 deg` or `2 rad`, and `1500 rpm` or `157 rad/s`."
    "W0840" "a former name" "The function, argument, record or field has a new name. The former name means the same, but a later version will not accept it. `calyx check --fix` writes the new name."
    "E0850" "a malformed loop over values or brackets" "A loop over values is written `for (x in values) ...` and a comprehension `[element for x in values if condition]`. A unit after brackets applies to plain numbers: `[1, 2] mm`."
    "E0851" "a limit of a range or slice that is not an integer" "A range counts by 1 from its start to below its end, and a slice counts elements, so their limits are integers. Compute other steps from the count: `0.5 * i`."
    "E0855" "an optional value without a test" "A parameter or field with the default `none` may have no value. Test it: in `if (width is none) a else b`, `width` is `none` in `a` and a value in `b`. After `if (width is none) return 0;` it is a value, too."
    "E0856" "a test of a value that is never `none`" "Only parameters and fields with the default `none` can be `none`. Remove the test, or give the parameter the default `none`."
    "E0857" "a text that is not one of the choices" "An enumeration has the choices of its declaration, and a param or parameter those after `in`. A comparison with another text is never true. Correct the spelling; the message lists the choices."
    "W0845" "a value that no longer stands for \"not given\"" "In earlier versions this value of the argument, such as 0, meant that the argument is not given. The parameter is optional now, and the next version takes the value as it is. Write `none`, or leave the argument out. `calyx check --fix` writes `none`."
    "E0878" "a value that cannot mean `none`" "`= none was 0 mm` states that the argument `0 mm` meant `none` in earlier versions. The parameter has the default `none`, and the value after `was` is a constant number or text."
    "E0879" "a comparison of choices that are never equal" "Both sides have known choices, and no choice is common, so the comparison is never true. Compare values of the same choices, or use one spelling for both."
    "E0880" "a `switch` that does not handle every choice" "A `switch` over an enumeration has a case for every choice, or a `default`. When a choice is added to the enumeration, the compiler reports where it is not handled."
    "E0881" "a former name where none is allowed" "Functions, parameters, records and fields keep a former name for callers after `was`. Components and enumerations have none: their names are parts of the names of params, results and choices. Rename the uses."
    "E0882" "an anonymous function outside of an argument" "`(x) => e` is a symbolic function without a name. It is the argument of a parameter that is a function: the first one of `solve` and `minimize`, or a parameter that its function calls. Functions are not values, so it is neither stored nor returned; declare `function f(in x) := e;` for several uses."
    "E0883" "the type of a function outside of a parameter" "`Function(Length) -> Force` is the type of an `in` parameter that is a function, without a default. Functions are not values, so variables, fields, results, arguments of components and of host functions cannot be functions. Pass the function to each function that calls it."
    "W0850" "a result type that gives a parameter a fractional dimension" "The type of a result determines the types of parameters without an annotation. In `function area(in d) -> Length { return d^2; }`, `d` would be a Length^(1/2). Correct the result type, here to `Area`, or state the type of the parameter."
    "E0870" "a mode of a component's parameter" "A component receives values and has members, so its parameters have no mode: `component Stage(ratio: Number) { ... }`."
    "E0871" "a name of the model in a component" "A component may have several instances and may be imported by other models, so its body sees constants, functions, records and other components, but no variables, params and outputs of the model. Pass their values as arguments."
    "E0872" "a component that contains itself" "Every instance would contain another one without end. Put the repeated part into a component of its own, and declare an array of its instances."
    "E0873" "a member of unknown type" "All instances of a component have one type, so the types of its parameters and members follow from the component alone. Write the type of the parameter: `component Stage(ratio: Number)`."
    "E0874" "an instance without a name" "The names of params and outputs contain the name of the instance, and must be known before the model runs. Declare instances at the top level of a model or component: `var low = Stage(3);`, or `var stages = [Stage(3), Stage(4)];`. A function cannot create them."
    "E0875" "an argument that is not known before the run" "The default or the range of a param of the component uses this parameter. Params are set before the model runs, so the argument may contain literals, params and functions of them, but no variables."
    "E0876" "a return in a component" "A component does not return a value: its members are its parameters, params, variables and outputs, which all need values. Use `if`, or move the statements into a function."
    "E0920" "a derivative that would miss what an anonymous function captures" "An anonymous function captures the values of variables around it. Within it they are independent of `Time`, of params and of each other, so `derivative(e, p)`, `gradient` and `e at p = value` by anything but its own parameters would ignore that a captured value depends on `p`. Differentiate around the call, or declare a symbolic function of all these quantities."
    "E0921" "an element by a computed index in a symbolic expression" "Which element an index selects is a choice that has no derivative, and a symbolic expression is one formula. Declare the elements with `const` and interpolate them, `spline(positions, list, x)`, or pass the function to an ordinary function, which computes values: there, `(i) => list[i]` selects elements."
    "E0922" "an anonymous function without parentheses" "The parameters of an anonymous function are written in parentheses, also if there is only one: `(x) => x^2`."
    "E0923" "a conversion of units" "Values are stored in SI units, and a unit belongs to the text that shows a value. Write it in the format, `\"{x : deg}\"`, or at an output, `output angle := x in deg;`. The number of units in a value is a quotient: `x/(1 deg)`."
    "E0924" "choices of an enumeration in another form" "An enumeration lists its choices as names in braces: `enum Hand { left, right }`. A choice is used as `Hand.left`; where a library function takes a text, `\"left\"` is the same choice."
    "E0925" "an output without a unit after `in`" "`output loss := value in W;` states the unit in which results show the output: a product of units, such as `N*m`, or `%`. A range belongs to a param: outputs have none."
    "E0926" "a unit that does not fit an output" "The unit after `in` must have the dimension of the output. A rate in `1/s` or `Hz` and one in `rad/s` or `rpm` differ by 2 pi per cycle: multiply or divide the output by it."
};

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::Path;

    fn codes_in(directory: &Path, codes: &mut BTreeSet<String>) {
        for entry in fs::read_dir(directory).expect("sources") {
            let path = entry.expect("a file").path();
            if path.is_dir() {
                codes_in(&path, codes);
            } else if !path.ends_with("codes.rs") {
                let text = fs::read_to_string(&path).expect("readable");
                let is_code = |piece: &&str| {
                    piece.len() == 5
                        && piece.starts_with(['E', 'W'])
                        && piece[1..].bytes().all(|b| b.is_ascii_digit())
                };
                codes.extend(text.split('"').filter(is_code).map(str::to_string));
            }
        }
    }

    #[test]
    fn every_code_of_the_crate_is_explained_and_no_other() {
        let mut used = BTreeSet::new();
        codes_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut used);
        let explained: BTreeSet<String> = CODES.iter().map(|e| e.code.to_string()).collect();
        assert_eq!(explained.len(), CODES.len(), "a code stands twice");
        assert_eq!(used, explained);
    }

    #[test]
    fn codes_are_found_in_any_case() {
        assert_eq!(explain("e0401").map(|e| e.code), Some("E0401"));
        assert_eq!(explain("E9999"), None);
    }
}
