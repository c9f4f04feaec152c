//! Tests of closures as host functions, without a program.

use super::*;
use crate::description::UnitDescription;

fn value(name: &str, repr: Repr, ty: &str) -> HostValueDescription {
    HostValueDescription { name: name.into(), repr, ty: ty.into(), unit: UnitDescription::default() }
}

fn function(
    name: &str,
    parameters: Vec<HostValueDescription>,
    result: Repr,
    ty: &str,
) -> HostFunctionDescription {
    HostFunctionDescription {
        name: name.into(),
        doc: String::new(),
        parameters,
        result: value("", result, ty),
    }
}

fn friction() -> HostFunctionDescription {
    function("friction", vec![value("v", Repr::Number, "Velocity")], Repr::Number, "Number")
}

fn context(functions: &HostFunctions, described: &[HostFunctionDescription]) -> Context {
    let mut context = Context::new(Box::new(()));
    context.host_functions = functions.resolve(described).unwrap();
    context
}

#[test]
fn a_closure_takes_and_gives_values_of_every_type() {
    let mut functions = HostFunctions::default();
    functions.add("all", |n: f64, b: bool, s: String, v: [f64; 3], a: Vec<f64>, deep: Vec<Vec<bool>>| {
        assert_eq!((n, b, s.as_str(), v), (2.5, true, "é", [1.0, -2.0, 3.0]));
        assert_eq!((a, deep), (vec![4.0, 5.0], vec![vec![], vec![true, false]]));
        vec![[1.0, 2.0, 3.0], [0.0; 3]]
    });
    let array = |repr| Repr::Array(Box::new(repr));
    let parameters = vec![
        value("n", Repr::Number, "Number"),
        value("b", Repr::Bool, "Bool"),
        value("s", Repr::String, "String"),
        value("v", Repr::Vector, "Vector"),
        value("a", array(Repr::Number), "Array(Number)"),
        value("deep", array(array(Repr::Bool)), "Array(Array(Bool))"),
    ];
    let described = [friction(), function("all", parameters, array(Repr::Vector), "Array(Vector)")];
    let mut context = context(&functions, &described);
    let mut slots = vec![0; 8];
    2.5.write(&mut context, &mut slots[0..1]);
    true.write(&mut context, &mut slots[1..2]);
    String::from("é").write(&mut context, &mut slots[2..3]);
    [1.0, -2.0, 3.0].write(&mut context, &mut slots[3..6]);
    vec![4.0, 5.0].write(&mut context, &mut slots[6..7]);
    vec![vec![], vec![true, false]].write(&mut context, &mut slots[7..8]);
    let mut result = [0];
    assert_eq!(ask(&mut context, 0, &slots[..1], &mut result), Ok(false), "friction is not provided");
    assert_eq!(ask(&mut context, 1, &slots, &mut result), Ok(true));
    assert_eq!(Vec::<[f64; 3]>::read(&context, &result), Some(vec![[1.0, 2.0, 3.0], [0.0; 3]]));
    assert_eq!(ask(&mut context, 7, &[], &mut []), Ok(false));
}

#[test]
fn errors_and_panics_of_a_closure_are_errors_of_the_model() {
    let call = |functions: &HostFunctions| {
        let mut context = context(functions, &[friction()]);
        ask(&mut context, 0, &[1.0_f64.to_bits()], &mut [0]).unwrap_err()
    };
    let mut functions = HostFunctions::default();
    functions.add("friction", |v: f64| if v < 0.0 { Ok(v) } else { Err("it slips") });
    let error = call(&functions);
    assert_eq!((error.code.as_str(), error.message.as_str()), (codes::HOST, "it slips"));
    assert_eq!(error.status(), crate::Status::Failed, "it can be caught");
    functions.add("friction", |v: f64| if v < 0.0 { v } else { panic!("at {v}") });
    assert_eq!(call(&functions).message, "the function panicked: at 1");
}

#[test]
fn a_cancelled_run_calls_nothing_more() {
    let mut functions = HostFunctions::default();
    functions.add("friction", |_: f64| -> f64 { unreachable!("the run was cancelled") });
    let mut context = context(&functions, &[friction()]);
    context.cancel.cancel();
    let error = ask(&mut context, 0, &[0], &mut [0]).unwrap_err();
    assert_eq!(error.code, codes::CANCELLED);
}

#[test]
fn what_does_not_fit_is_refused_with_both_signatures() {
    let refusal = |functions: &HostFunctions, described: &[HostFunctionDescription]| {
        let HostMismatch { message, help } = functions.resolve(described).err().unwrap();
        (message, help)
    };
    let mut functions = HostFunctions::default();
    functions.add("friction", |a: f64, names: Vec<String>| a > names.len() as f64);
    assert_eq!(
        refusal(&functions, &[friction()]),
        (
            "`friction` is given as `|f64, Vec<String>| -> bool`, and the model declares `host function friction(in v: \
             Velocity) -> Number`"
                .into(),
            "give a closure `|f64| -> f64`; numbers are in SI units".into()
        )
    );
    assert_eq!(
        refusal(&functions, &[]),
        (
            "the model has no host function `friction`".into(),
            "declare it in the model: `host function friction(...) -> ... { ... }`".into()
        )
    );
    let mut functions = HostFunctions::default();
    functions.add("fiction", || 1.0);
    assert_eq!(refusal(&functions, &[friction()]).1, "its host functions are `friction`");
}
