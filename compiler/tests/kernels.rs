//! Tests of symbolic functions as kernels of an embedding program: names, units, evaluation at one
//! and many points, errors.

use calyx::{Engine, KernelError, Module};

const TEXT: &str = "
units mm_N_s;
param length = 30 mm in 1 mm .. 50 mm;
param long = FALSE;
param label = \"arm\";

/// The arm turns while it grows.
function arm(in turn) := Translate(length*e1) * Rotate(turn, e3);
function end(in push: Vector, in turn) := [origin(arm(turn)) + push, [if (long) 2*length else length, turn]];
function frame(in turn) := arm(turn);
function moved(in speed) := speed*Time + length;
function half(in x) := sqrt(x);
";

fn module(text: &str) -> Module {
    let checked = calyx::check_text("arm.cx", text);
    assert!(!checked.has_errors(), "{}", checked.render());
    Module::from_checked(&Engine::default(), checked).unwrap()
}

#[test]
fn names_units_and_places_are_told() {
    let module = module(TEXT);
    assert_eq!(module.kernel_names(), ["arm", "end", "frame", "moved", "half"]);
    let end = module.kernel("end").unwrap();
    let shown = |quantities: &[calyx::Quantity]| -> Vec<String> {
        quantities.iter().map(|q| format!("{} [{}] {}", q.name, q.unit, q.factor)).collect()
    };
    assert_eq!(
        shown(end.arguments()),
        ["push.e1 [mm] 0.001", "push.e2 [mm] 0.001", "push.e3 [mm] 0.001", "turn [rad] 1"]
    );
    assert_eq!(
        shown(end.outputs()),
        ["0.e1 [mm] 0.001", "0.e2 [mm] 0.001", "0.e3 [mm] 0.001", "1.0 [mm] 0.001", "1.1 [rad] 1"]
    );
    assert_eq!((end.name(), module.kernel("arm").unwrap().doc()), ("end", "The arm turns while it grows."));
    let frame = module.kernel("frame").unwrap();
    assert_eq!(shown(&frame.outputs()[8..10]), ["33 [] 1", "t1 [mm] 0.001"]);
    assert_eq!(shown(&module.kernel("moved").unwrap().arguments()[..1]), ["Time [s] 1"]);
    assert!(format!("{end:?}").starts_with("Kernel { name: \"end\""));
}

#[test]
fn one_point_and_many_have_the_same_bits() {
    let module = module(TEXT);
    let params = module.param_values(&[("length", "40 mm"), ("long", "TRUE")]).unwrap();
    assert_eq!(params[..2], [0.04, 1.0]);
    let end = module.kernel("end").unwrap();
    let columns: Vec<Vec<f64>> =
        (0..4).map(|column| (0..131).map(|i| f64::from(i * (column + 1)) * 0.013).collect()).collect();
    let views: Vec<&[f64]> = columns.iter().map(|column| &column[..]).collect();
    let mut outputs = vec![vec![0.0; 131]; 5];
    let mut filled: Vec<&mut [f64]> = outputs.iter_mut().map(|column| &mut column[..]).collect();
    end.batch(&params, &views, &mut filled).unwrap();
    for point in 0..131 {
        let arguments: Vec<f64> = columns.iter().map(|column| column[point]).collect();
        let found: Vec<f64> = outputs.iter().map(|column| column[point]).collect();
        assert_eq!(end.evaluate(&params, &arguments).unwrap(), found);
    }
    assert_eq!(outputs[3][0], 0.08);

    // Time is the first argument of a time-dependent function.
    let moved = module.kernel("moved").unwrap();
    assert_eq!(moved.evaluate(&params, &[2.0, 0.5]).unwrap(), [1.04]);
    let mut positions = [0.0; 2];
    moved.batch(&params, &[&[0.0, 2.0], &[0.5, 0.5]], &mut [&mut positions]).unwrap();
    assert_eq!(positions, [0.04, 1.04]);
}

#[test]
fn kernels_outlive_their_module_and_are_shared() {
    let half = module(TEXT).kernel("half").unwrap();
    let roots: Vec<f64> = std::thread::scope(|scope| {
        let threads: Vec<_> = [4.0, 9.0]
            .map(|x| {
                scope.spawn({
                    let half = &half;
                    move || half.evaluate(&[0.03, 0.0, f64::NAN], &[x]).unwrap()[0]
                })
            })
            .into();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert_eq!(roots, [2.0, 3.0]);
    // NaN is propagated.
    assert!(half.evaluate(&[0.03, 0.0, f64::NAN], &[-1.0]).unwrap()[0].is_nan());
    half.batch(&[0.03, 0.0, 0.0], &[&[]], &mut [&mut []]).unwrap();
}

#[test]
fn mistakes_are_values() {
    let module = module(TEXT);
    let message = |error: KernelError| error.to_string();
    assert_eq!(
        message(module.kernel("ned").unwrap_err()),
        "there is no symbolic function `ned`; the model has arm, end, frame, moved, half"
    );
    let half = module.kernel("half").unwrap();
    assert_eq!(message(half.evaluate(&[], &[1.0]).unwrap_err()), "0 params given, the kernel has 3");
    assert_eq!(message(half.evaluate(&[0.0; 3], &[]).unwrap_err()), "0 arguments given, the kernel has 1");
    assert_eq!(
        message(half.batch(&[0.0; 3], &[&[1.0]], &mut []).unwrap_err()),
        "0 columns of outputs given, the kernel has 1"
    );
    assert_eq!(
        message(half.batch(&[0.0; 3], &[&[1.0]], &mut [&mut []]).unwrap_err()),
        "column 0 of the outputs has 0 points, the first one has 1"
    );
    assert!(message(module.param_values(&[("length", "90 mm")]).unwrap_err()).contains("length"));
    assert!(message(module.param_values(&[("width", "90 mm")]).unwrap_err()).contains("width"));
}
