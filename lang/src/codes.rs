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
    "E0101" "a character that means nothing" "The text holds a character that is no part of the language outside strings and comments. Remove it, or put it into a string."
    "E0102" "a comment without end" "A comment that starts with `/*` must be closed with `*/`."
    "E0103" "a string without end or in single quotes" "Strings stand in double quotes. A string ends on the line it begins on. Close it with a quotation mark; write `\\n` for a line break inside it."
    "E0104" "an unknown escape in a string" "The escapes of strings are `\\n`, `\\t`, `\\\"`, `\\\\`, and `{{` and `}}` for braces."
    "E0105" "a malformed number" "A number is digits with an optional decimal part and an optional power of ten, such as `3`, `0.5` or `2e-3`."
    "E0106" "nesting that is too deep" "Brackets, blocks and operators inside one another are limited, so that no text can exhaust the compiler. Split the expression into several statements."
    "E0110" "a missing semicolon" "Every statement but a block ends with `;`."
    "E0111" "a bracket or block without end" "Every `(`, `[` and `{` must be closed by its counterpart."
    "E0112" "a missing value" "An expression is expected here: a number, a name, a call, or something in parentheses."
    "E0113" "a word or sign that does not belong here" "What stands here begins nothing the language knows at this place."
    "E0114" "a missing or reserved name" "A declaration needs a name that is no word of the language and none of `Time e1 e2 e3 pi inf nan TRUE FALSE`."
    "E0115" "something else was expected" "The grammar requires another word or sign at this place; the message says which."
    "E0116" "a bracket that closes nothing" "No bracket of this kind is open here. Remove it, or open one before it."
    "E0117" "an assignment used as a condition" "`=` assigns. Compare with `==`."
    "E0118" "an operator of another language" "Conditions are joined with `&` and `|`, which evaluate their right side only where it matters."
    "E0119" "a word of another language" "The word has another spelling in this language; the message says which."
    "E0120" "a parameter without its mode" "Parameters say how they are passed: `in` by value, `out` and `inout` copy a value back when the function returns."
    "E0121" "a unit's exponent that is no whole number" "The exponent right after a unit belongs to the unit and is a whole number, as in `2 inch^2`. Put the quantity in parentheses to raise all of it to a power."
    "E0122" "an assignment to something that is no place" "Only variables and elements of arrays can be assigned."
    "E0123" "a top-level declaration inside a block" "`import`, `units`, `param`, `output`, `private`, `test` and `host` concern the file as a whole, so they stand outside blocks and functions."
    "E0124" "a malformed type" "A type is a dimension such as `Length` or `Force/Length^2`, or `Bool`, `String`, `Vector(...)`, `Transform`, `Array(...)`."
    "E0130" "a decimal comma" "The decimal separator is a point: `2.5 mm`. A comma separates values, arguments and names, so `2,5 mm` is the two values 2 and 5 mm."
    "E0131" "a number that follows a number" "Between two numbers stands an operator or a comma. A unit such as 1/min is written with `/` right after the number: `100/min`."
    "W0125" "a quantity as a divisor" "A unit binds tighter than any operator, so `1/2 inch` is 1/(2 inch). Write parentheses to say which is meant."
    "E0201" "an unknown name" "Nothing of this name is visible here. Variables are visible from their declaration to the end of its block, functions in their whole block, functions of modules as `module.name` after `import module;`."
    "W0201" "an unused variable" "The variable is never read. Remove it, or start its name with `_` to keep it."
    "E0202" "a name declared twice" "A block declares a name once. An inner block may declare it anew; assignment needs no `var`."
    "W0202" "unreachable statements" "No way through the program leads here: a `return`, `break`, `continue` or `goto` stands before it on every one."
    "E0203" "a reserved name" "`Time e1 e2 e3 pi inf nan TRUE FALSE` have a fixed meaning."
    "W0203" "a value that is not used" "The statement computes a value and drops it. Assign it, or remove the statement."
    "E0204" "an unknown name in a module" "The module declares nothing of this name, or declares it `private`."
    "E0205" "an unknown parameter" "The function has no parameter of the name given with this argument."
    "E0206" "arguments that do not match" "Arguments are given in order or by name, each once, those without a name first; parameters without a default are required."
    "E0207" "an assignment to a param" "Params are set from outside before the model runs and stay as they are. Copy one into a variable to change it."
    "E0208" "something that cannot be assigned" "Only variables and elements of arrays can be assigned or handed back through `out`."
    "E0209" "an unknown module" "The module is neither in the library nor beside the model's file."
    "E0210" "a statement in a module" "A module declares functions, constants, records, dimensions and units. What runs belongs to the model."
    "E0212" "a value that is not there yet" "Defaults, ranges and choices are computed before the program runs, from literals, params declared earlier and functions without effects."
    "E0213" "an unknown kind of extern function" "An extern function is `pure` (depends on its arguments alone), `scene` (adds to the scene) or `effect`."
    "E0214" "a statement outside what it belongs to" "`break` leaves a loop or switch, `continue` a loop; `case` and `default` stand directly in the body of a `switch`."
    "E0215" "a goto that leads nowhere" "`goto` leads to a label in the same block or in one around it, never into a block, and never out of its function."
    "E0216" "a throw without an error to pass on" "`throw;` throws again what the `catch` around it caught. Elsewhere, also in a function that a `catch` calls, there is nothing to pass on: throw a text or an `Error`."
    "E0217" "a variable read before it has a value" "On some way through the program the variable is read before anything was assigned to it. Give it a value where it is declared, or on every way."
    "E0218" "an out parameter without a value" "A function assigns its `out` parameters on every way to its end."
    "W0205" "a unit that is also a variable" "Right after a number a name is a unit, whatever else it is called here. Write `*` to multiply by the variable."
    "E0220" "an assignment to a constant" "What `const` declares keeps its value. Declare a variable with `var` if it is to change."
    "E0221" "a constant that is too large" "Constants are put in wherever they are named, so those that name each other several times over grow without bound. Use a variable."
    "E0222" "a test that takes or gives something" "`calyx test` calls a test without arguments and looks at nothing it gives. Call the function to be tested inside the test, and assert what it should give."
    "E0223" "a variable of the model in a test" "A test runs on its own: what the model runs is not run before it. It sees functions, constants, records and params."
    "E0224" "a second system of units" "`units` says what the bare numbers of the whole file are in, so a file has one. Remove the other; a single number may have any unit."
    "E0225" "a host function that no program could provide" "The program that embeds the model may provide a host function, so its header says all of it: parameters are `in` and have types, the result has one, and they are numbers and vectors of known dimensions, `Bool`, `String` or arrays of these. Its body is used where nobody provides it."
    "E0230" "a module that cannot be read" "Modules and tables are regular files below the model's directory: a link may not lead out of it, and what is no file, such as a pipe, is not read. Put the file itself into the model's directory."
    "E0301" "a value of another type" "Every variable and parameter has one type. The message names the one needed and the one found."
    "E0302" "a value inside itself" "The program would need a type that contains itself, such as an array that is its own element."
    "E0303" "a call without a value used as one" "The function returns nothing. Call it as a statement."
    "E0304" "an operator on types it is not made for" "Numbers and vectors add; numbers scale vectors; frames multiply frames and points; strings are joined by interpolation."
    "E0305" "an index that does not fit" "Arrays are indexed by whole numbers from 0, tuples by constant ones."
    "E0306" "a function or module used as a value, or a value called" "Functions are not values: call them. Only functions are called."
    "E0307" "an unknown field" "Records have the fields they declare, vectors the components `.x`, `.y` and `.z`."
    "E0308" "a malformed type annotation" "The parameters of extern functions have types; a dimension is written as a product of powers of dimensions."
    "E0309" "an unknown type" "Nothing of this name is a dimension, a type of the language or something the library makes."
    "E0310" "an out argument that does not fit" "`out` and `inout` arguments are variables or elements of arrays, and no two of a call are the same place."
    "E0311" "push used as a value" "`push(array, value);` is a statement that appends to the array."
    "E0312" "a param of a type params cannot have" "Params are numbers, truth values and strings: what can be given on a command line."
    "E0313" "an empty range" "The low end of a range is above its high end."
    "E0314" "a value outside its range or choices" "Params and the library's parameters may say what is allowed; this constant is not."
    "E0315" "a case that stands twice" "Each constant case of a switch stands once, and there is one default."
    "E0316" "a return that does not fit" "A function returns a value on all its ways or on none; the top level returns none."
    "E0317" "a missing return" "The function returns values, and some way through it ends without one."
    "E0401" "dimensions that do not fit" "Quantities add, compare and stand for one another only if their dimensions are equal (angles apart). The message shows both sides factor by factor and the factor that is missing."
    "E0402" "a dimension that does not fit inside a function" "The arguments of this call give an operator inside the function operands it cannot take. Compare the dimensions of the arguments with what the function does with them."
    "E0403" "an unknown unit" "The name right after a number must be a unit. Write `*` between a number and a variable."
    "E0404" "an unknown unit system" "The unit systems are `SI`, `mm_N_s` and `inch_lbf_s`."
    "E0405" "too many base dimensions" "A program may add three base dimensions to length, mass, time, angle and temperature. Derive further ones: `dimension Wage = Cost/Time;`."
    "E0406" "a unit that makes no sense" "The first unit of a new base dimension is declared by `unit euro: Cost;`, every other unit by how large it is: `unit cent = 0.01 euro;`."
    "E0407" "a dimension or unit defined by itself" "Define it by dimensions and units that are known without it."
    "E0408" "a format that does not fit" "A format is a width, digits after a point, `e` for a power of ten, and a unit: `{x : 10.3 mm}`. Digits and units are for numbers."
    "E0501" "`Time` where a value is needed" "`=` computes at once, and `Time` has no value while the model is built. Keep the expression with `:=`, or evaluate it with `at Time = ...`."
    "E0502" "a time-dependent name where a value is needed" "The name is bound with `:=` to an expression in `Time`. Use it inside another `:=`, or evaluate it with `at Time = ...`."
    "E0503" "`=` and `:=` exchanged" "Whether a name holds a value or an expression is fixed where it is declared, and likewise for parameters."
    "E0504" "a symbolic name without an expression" "The name is bound with `:=` further down, or in a part of the program that has not run yet. Move the binding before this use."
    "E0505" "an observable used as a value" "What the engine observes has a value at each step of an analysis, not while the model is built. Use it in an `output` or another `:=`."
    "E0506" "something that is no symbol" "Expressions are differentiated by, and evaluated at, `Time`, number params and the number arguments of a symbolic function."
    "E0507" "an expression that cannot stay symbolic" "Numbers, vectors, frames and brackets of them can be bound with `:=`."
    "E0508" "the derivative of an observable" "The values of an observable come from the analysis, so no derivative of it is known when the model is compiled."
    "E0509" "a derivative that would miss something" "The expression captured a value that was computed from the param it is differentiated by, or assigned under a condition on it, so the derivative, or the value at another param, would silently lack that part. Bind the captured name with `:=`, a choice inside the expression. Of a param whose default follows another param nothing says beforehand whether it will follow: bind what always follows with `:=`."
    "E0510" "a symbolic expression that grows without bound" "With every name put in, the expression has more operations than any model needs; usually definitions double at each step."
    "E0511" "a value in a symbolic function" "A symbolic function is an expression and has no moment at which it could take the value of a variable. It sees its arguments, `Time`, params, constants and other symbolic functions."
    "E0512" "an argument a symbolic function cannot have" "The arguments of a symbolic function are free symbols: numbers, truth values or vectors, passed by `in`. An ordinary function takes whole expressions with `in name :=`."
    "E0513" "a symbolic function that needs itself" "A symbolic function stands for one expression, which would never end. Build the expression in a loop that binds a `:=` name again."
    "E0514" "a function that is more than an expression" "A function called with symbols in a `:=` becomes part of the expression, so its body may only name values with `var` and return one. Write it as a symbolic function, or call it with values."
    "E0515" "an axis that is no unit vector" "`Rotate` turns about a vector of length 1; a longer or shorter one would stretch what is turned. An axis that is computed is checked when the rotation is computed or bound. Divide the axis by its length, `a/norm(a)`."
    "E0516" "a host function in a symbolic expression" "What another program may provide has no formula, so it cannot be differentiated or become part of an expression. Call it with values, or interpolate values of it."
    "E0518" "a name that is both a unit and a variable" "In a product or quotient after a number with a unit, such as `3 N/m`, the names are read as units. Where one of them is also the name of a variable, parameter, param or constant that is visible there, nothing says which is meant. Rename the variable; or write another name of the unit (`3 N/meter`), or parentheses for the variable: `(3 N)/m`."
    "W0518" "cycles where angles are expected" "Hz and kHz count cycles, and so does the dimension `Frequency`; rad, deg, rev and rpm are angles. One cycle is 2 pi radians, so where the two meet in a sum, a comparison, an assignment or an argument, a factor of 2 pi is missing. Multiply cycles by `1 rev`, or divide angles by it."
    "E0519" "a unit of angles for cycles" "A value in Hz cannot be shown in rpm, nor one in rad/s in Hz: one cycle is 2 pi radians. Multiply cycles by `1 rev`, or divide angles by it."
    "W0519" "the reciprocal of an angular velocity" "`1/(60 rpm)` is the time in which something turns by one radian, 0.159 s; a revolution takes 1 s. Write `1 rev / speed` for the time of a revolution, `1 rad / speed` for that of a radian."
    "W0520" "a number without a unit as an angle" "Without a unit a number is an angle in radians, which is seldom meant in a sum or comparison with an angle that is written in degrees, or above one revolution. Write `2 deg` or `2 rad`."
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
