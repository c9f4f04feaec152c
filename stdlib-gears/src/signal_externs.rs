//! Outputs in the frequency domain for programs: spectra, spectrograms, order maps, transfer
//! functions.

use crate::bearing_externs::GROUND;
use crate::error::Severity;
use crate::externs::{before_analysis, body, host, refusal};
use crate::host::{Finding, ModelHost, RequestedSignal};
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::motion::{Orientation, spatial_pose};
use calyx_runtime::results::StepRow;
use calyx_runtime::signal::{Scaling, Signal, SignalKind, SignalRequest, Span, Window, evaluate};

calyx_abi::externs! {
    Scene fn calyx_gears_spectrum(
        context, output: String, from: f64, to: f64, window: String, segment: Option<f64>, scaling: String, highest: f64,
    ) -> () {
        let segment = segment.map(|segment| more_than_none("segment", segment)).transpose()?;
        let scaling = if scaling == "density" { Scaling::Density } else { Scaling::Amplitude };
        ask(context, output, [from, to], highest, SignalKind::Spectrum { window: named(&window)?, segment, scaling })
    }

    Scene fn calyx_gears_spectrogram(
        context, output: String, segment: f64, from: f64, to: f64, window: String, highest: f64,
    ) -> () {
        let segment = more_than_none("segment", segment)?;
        ask(context, output, [from, to], highest, SignalKind::Spectrogram { window: named(&window)?, segment })
    }

    Scene fn calyx_gears_order_map(
        context, output: String, shaft: Handle, angle: Option<String>, from: f64, to: f64, revolutions: f64, highest: f64, window: String,
    ) -> () {
        let shaft = if shaft == GROUND { None } else { Some(body(context, "shaft", shaft)?) };
        let ahead = angle.map(|angle| context.name_in_instance(angle));
        if shaft.is_none() && ahead.is_none() {
            return Err(refusal("E0778", "shaft", "the shaft whose revolutions are counted is missing",
                "give the `shaft`, or the name of an output that is its `angle`"));
        }
        let (revolutions, highest) = (more_than_none("revolutions", revolutions)?, more_than_none("highest", highest)?);
        let window = named(&window)?;
        ask(context, output, [from, to], highest, SignalKind::OrderMap { shaft, ahead, revolutions, highest, window })
    }

    Scene fn calyx_gears_transfer_function(
        context, output: String, from: f64, momentum: f64, to: f64, highest: f64,
    ) -> () {
        if momentum == 0.0 || !momentum.is_finite() {
            return Err(refusal("E0778", "momentum", "an impulse of zero gives no transfer function",
                "give what `gears.impulse` passes on"));
        }
        ask(context, output, [from, to], highest, SignalKind::TransferFunction { momentum })
    }
}

fn named(window: &str) -> Result<Window, RuntimeError> {
    Window::named(window).ok_or_else(|| {
        let known: Vec<String> = Window::ALL.iter().map(|(name, _)| format!("\"{name}\"")).collect();
        let message = format!("there is no window called \"{window}\"");
        refusal("E0778", "window", &message, &format!("choose one of {}", known.join(", ")))
    })
}

fn positive(argument: &str, number: f64) -> Result<f64, RuntimeError> {
    match number >= 0.0 {
        true => Ok(number),
        false => Err(refusal(
            "E0778",
            argument,
            &format!("`{argument}` cannot be {number}"),
            "give a positive number",
        )),
    }
}

fn more_than_none(argument: &str, number: f64) -> Result<f64, RuntimeError> {
    positive(argument, if number.is_finite() && number > 0.0 { number } else { f64::NAN })
}

fn ask(
    context: &mut Context,
    of: String,
    [from, to]: [f64; 2],
    highest: f64,
    kind: SignalKind,
) -> Result<(), RuntimeError> {
    before_analysis(context, format_args!("the signal of `{of}`"))?;
    if to.is_nan() || from.is_nan() || to <= from {
        return Err(refusal(
            "E0778",
            "to",
            "the range of time ends before it begins",
            "let `to` be later than `from`",
        ));
    }
    let highest = more_than_none("highest", highest.min(f64::MAX))?;
    let place = context.place;
    let of = context.name_in_instance(of);
    let request = SignalRequest { of, span: Span { from, to }, highest, kind };
    host(context)?.asked_signals.push(RequestedSignal { request, place });
    Ok(())
}

/// Checks that all requested signals refer to existing outputs.
///
/// # Errors
/// E0775: one does not.
pub fn check(host: &ModelHost) -> Result<(), RuntimeError> {
    for RequestedSignal { request, place } in &host.asked_signals {
        let ahead = match &request.kind {
            SignalKind::OrderMap { ahead: Some(ahead), .. } => Some(("angle", ahead)),
            _ => None,
        };
        for (argument, name) in [("output", &request.of)].into_iter().chain(ahead) {
            check_output(host, (argument, name), *place)?;
        }
    }
    Ok(())
}

/// Checks that the output whose name is an argument exists.
///
/// # Errors
/// E0775: it does not.
pub(crate) fn check_output(
    host: &ModelHost,
    (argument, name): (&str, &str),
    place: (u32, u32, u32),
) -> Result<(), RuntimeError> {
    if output(host, name).is_some() {
        return Ok(());
    }
    let known: Vec<&str> = host.outputs.iter().map(|output| output.name.as_str()).collect();
    let message = format!("the model has no output called \"{name}\"");
    let help = match known.is_empty() {
        true => "declare one, such as `output te := gears.transmission_error(mesh);`".to_owned(),
        false => format!("its outputs are {}", known.join(", ")),
    };
    Err(RuntimeError { place: Some(place), ..refusal("E0775", argument, &message, &help) })
}

fn output(host: &ModelHost, name: &str) -> Option<usize> {
    host.outputs.iter().position(|output| output.name == name)
}

/// Computes all requested signals from the rows of a completed analysis. Requests that the rows
/// cannot answer are reported (E0776, E0777); the other results remain valid.
pub(crate) fn answer(host: &mut ModelHost) {
    let Some(result) = &host.result else { return };
    let mut signals: Vec<Signal> = Vec::with_capacity(host.asked_signals.len());
    let mut findings = Vec::new();
    for RequestedSignal { request, place } in &host.asked_signals {
        let Some(of) = output(host, &request.of) else { continue };
        let angle = |row: &StepRow| {
            let SignalKind::OrderMap { shaft, ahead, .. } = &request.kind else { return 0.0 };
            let framed = shaft.map_or(0.0, |shaft| {
                let body = host.scene.bodies.get(shaft.0);
                let pose = body.and_then(|body| spatial_pose(body.motion.as_ref(), row.position.time).ok());
                pose.map_or(f64::NAN, |pose| Orientation::of(&pose).angle)
            });
            let ahead =
                ahead.as_ref().map_or(Some(0.0), |ahead| Some(row.outputs.get(output(host, ahead)?)?.value));
            framed + ahead.unwrap_or(f64::NAN)
        };
        let interrupt = &host.analysis.resources.interrupt;
        match evaluate(request, &result.rows, of, angle, interrupt) {
            Ok(answer) => signals.push(answer),
            Err(error) => findings.push(Finding {
                severity: Severity::Warning,
                error: RuntimeError { place: Some(*place), ..crate::externs::engine(error) },
            }),
        }
    }
    host.signals = signals;
    host.findings.extend(findings);
}
