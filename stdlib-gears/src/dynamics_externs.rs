//! Time ranges and impulses of dynamic analyses for programs.

use crate::analyses::Arguments;
use crate::externs::{before_analysis, body, entry, host, refusal};
use crate::host::{ModelHost, keep};
use calyx_abi::RuntimeError;
use calyx_abi::externs::Handle;
use calyx_runtime::dynamics::{DynamicOptions, Scheme, Start, TimeRange, kept_positions};
use calyx_runtime::error::EngineError;
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::{Impulse, Wrench};

calyx_abi::externs! {
    Pure fn calyx_gears_time_range(
        context, duration: f64, step: f64, load_from: f64, load_to: f64, output_every: f64,
    ) -> Handle {
        if !(step.is_finite() && step > 0.0) {
            return Err(refusal("E0763", "step", &format!("a step cannot take {step} s"),
                "give a positive time, a twentieth of the shortest period that matters or less"));
        }
        if !(output_every.fract() == 0.0 && output_every >= 1.0) {
            return Err(refusal("E0763", "output_every", &format!("every {output_every} steps is not possible"),
                "give a whole number of at least 1"));
        }
        let steps = (duration / step).round();
        if steps > MOST_STEPS {
            return Err(refusal("E0763", "step", &format!("{steps} steps are too many"),
                "take longer steps, or shorter ranges"));
        }
        let range = TimeRange {
            duration,
            steps: steps.max(1.0) as usize,
            load: [load_from, load_to],
            keep: output_every as usize,
        };
        range.check().map_err(refused)?;
        Ok(keep(&mut host(context)?.time_ranges, range))
    }

    Pure fn calyx_gears_time_ranges(context, ranges: Vec<Handle>, from: f64) -> Handle {
        let host = host(context)?;
        let ranges: Vec<TimeRange> = ranges
            .into_iter()
            .map(|range| entry(&host.time_ranges, range).copied())
            .collect::<Result<_, _>>()?;
        if ranges.is_empty() {
            return Err(refusal("E0763", "ranges", "there is no range", "give at least one `gears.time_range(...)`"));
        }
        let positions = keep(&mut host.positions, kept_positions(from, &ranges));
        host.histories.insert(positions.0, (from, ranges));
        Ok(positions)
    }

    Scene fn calyx_gears_impulse(
        context, body: Handle, at: f64, duration: f64, momentum: [f64; 3], angular_momentum: [f64; 3],
    ) -> () {
        before_analysis(context, "the impulse")?;
        if !(duration.is_finite() && duration > 0.0) {
            return Err(refusal("E0766", "duration", &format!("an impulse cannot have a duration of {duration} s"),
                "give a positive time, a few steps long and much shorter than the periods that are looked at"));
        }
        let id = self::body(context, "body", body)?;
        let host = host(context)?;
        let momentum = Wrench { force: momentum, moment: angular_momentum };
        if let Some(body) = host.scene.bodies.get_mut(id.0) {
            body.impulses.push(Impulse { at, duration, momentum });
        }
        Ok(())
    }
}

/// Dynamic analysis as requested by `analyze`.
pub(crate) fn motion_in_time(
    host: &ModelHost,
    arguments: &Arguments<'_>,
) -> Result<DynamicOptions, RuntimeError> {
    let Arguments { over, newmark, rayleigh, start, .. } = *arguments;
    let Some((from, ranges)) = host.histories.get(&over.0).cloned() else {
        return Err(refusal(
            "E0765",
            "over",
            "a dynamic analysis goes through ranges of time, and these are positions",
            "give it ranges: `over = gears.time_ranges([gears.time_range(10 ms, step = 5 us)])`",
        ));
    };
    let Some(scheme) = Scheme::named(newmark) else {
        let known: Vec<String> = Scheme::ALL.iter().map(|(name, _)| format!("\"{name}\"")).collect();
        let message = format!("there is no integrator called \"{newmark}\"");
        return Err(refusal("E0764", "newmark", &message, &format!("choose one of {}", known.join(", "))));
    };
    let start = match start {
        "equilibrium" => Start::Equilibrium,
        "frames" => Start::Frames,
        _ => {
            let message = format!("a dynamic analysis cannot start from \"{start}\"");
            return Err(refusal("E0764", "start", &message, "choose \"equilibrium\" or \"frames\""));
        }
    };
    Ok(DynamicOptions { from, ranges, scheme, rayleigh, start })
}

/// Lumped inertia on a body's frame: mass in kg, moment of inertia about its axis in kg m².
pub(crate) fn lumped(mass: f64, inertia: f64) -> Result<Inertia, RuntimeError> {
    for (argument, given) in [("mass", mass), ("inertia", inertia)] {
        if !(given.is_finite() && given >= 0.0) {
            return Err(refusal(
                "E0760",
                argument,
                &format!("the {argument} added to a body cannot be {given}"),
                "give a positive number, or 0 for none",
            ));
        }
    }
    Ok(Inertia::axial(mass, inertia, 0.0))
}

/// Maximum number of steps of a range.
const MOST_STEPS: f64 = 1e9;

fn refused(error: EngineError) -> RuntimeError {
    crate::externs::engine(error)
}
