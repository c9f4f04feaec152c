//! Derivatives of outputs with respect to params for programs.

use crate::externs::{before_analysis, host, refusal};
use crate::host::{ModelHost, RequestedSensitivity};
use crate::signal_externs::check_output;
use calyx_abi::RuntimeError;
use calyx_runtime::sensitivity::SensitivityRequest;
use std::collections::BTreeSet;

calyx_abi::externs! {
    Scene fn calyx_gears_sensitivity(context, output: String, param: String) -> () {
        before_analysis(context, format_args!("the derivative of `{output}`"))?;
        let place = context.place;
        let output = context.name_in_instance(output);
        host(context)?.requested_sensitivities.push(RequestedSensitivity { output, param, place });
        Ok(())
    }
}

/// Checks that all requested derivatives refer to existing outputs, and to params that take decimal
/// numbers.
///
/// # Errors
/// E0775: there is no such output. E0792: the output or the param has no derivative.
pub fn check(host: &ModelHost) -> Result<(), RuntimeError> {
    for RequestedSensitivity { output, param, place } in &host.requested_sensitivities {
        check_output(host, ("output", output), *place)?;
        if observes_response(host, output) {
            let message = format!("`{output}` is a value of the forced response, which has no derivatives");
            let error = refusal("E0792", "output", &message, "compare runs with `calyx sweep`");
            return Err(RuntimeError { place: Some(*place), ..error });
        }
        let Some(message) = without_derivative(host, param) else { continue };
        let continuous = host.params.iter().filter(|param| param.is_continuous());
        let names: Vec<&str> = continuous.map(|param| param.name.as_str()).collect();
        let help = match names.is_empty() {
            true => "declare one, such as `param torque = 100 N*m;`".to_owned(),
            false => format!("choose among {}", names.join(", ")),
        };
        return Err(RuntimeError { place: Some(*place), ..refusal("E0792", "param", &message, &help) });
    }
    Ok(())
}

fn observes_response(host: &ModelHost, name: &str) -> bool {
    let of_response = |index: usize| {
        host.scene.observables.get(index).is_some_and(|observable| observable.is_of_forced_response())
    };
    host.outputs.iter().filter(|output| output.name == name).any(|output| output.observes(of_response))
}

/// Returns why there is no derivative with respect to a param of a name; `None` if there is one.
fn without_derivative(host: &ModelHost, name: &str) -> Option<String> {
    match host.params.iter().find(|param| param.name == name) {
        None => Some(format!("the model has no param called \"{name}\"")),
        Some(param) if !param.is_continuous() => {
            Some(format!("`{name}` takes no decimal numbers, so no derivatives exist"))
        }
        Some(_) => None,
    }
}

/// Returns the derivatives to compute: those that the host program requests, otherwise those of the
/// model; `None` without any.
pub fn requested(host: &ModelHost) -> Option<SensitivityRequest> {
    if host.analysis.sensitivities.is_some() {
        return host.analysis.sensitivities.clone();
    }
    let SensitivityRequest { neighbours, params, store, .. } = host.differentiable.as_ref()?;
    let is_requested = |name: &str| host.requested_sensitivities.iter().any(|own| own.param == name);
    let params: Vec<_> = params.iter().filter(|param| is_requested(&param.name)).cloned().collect();
    let outputs = host.requested_sensitivities.iter().map(|own| own.output.clone()).collect();
    let (neighbours, store) = (neighbours.clone(), store.clone());
    (!params.is_empty()).then(|| SensitivityRequest { neighbours, params, outputs, store })
}

/// Returns the number of params with respect to which the model requests derivatives.
pub fn params_of_derivatives(host: &ModelHost) -> usize {
    let params: BTreeSet<&str> = host.requested_sensitivities.iter().map(|own| own.param.as_str()).collect();
    params.len()
}

/// Returns the indices of the outputs that are differentiated, in order.
pub fn differentiated(host: &ModelHost) -> Vec<usize> {
    let Some(request) = requested(host) else { return Vec::new() };
    let all = request.differentiated(&host.outputs);
    (0..all.len()).filter(|&index| all[index]).collect()
}
