//! The planet gear of the report (section 3.1.2): frame and derivatives with respect to time and
//! design parameters, against reference values. The reference values come from numerical
//! differentiation with 110 digits (workload W1 of the kinematic reference data), rounded to the
//! nearest double.

use crate::support::evaluate;
use calyx_symbolic::{Frame, Graph, NodeId};

/// Inputs: time, centre distance, runout (x, y), pin position error (x, y), phase, speed of the
/// planet, speed of the carrier.
const PARAMETERS: [f64; 8] = [10.0, 2e-6, 1e-6, 1e-6, 2e-6, 0.3, 3300.0, 1100.0];
const TIMES: [f64; 4] =
    [0.011331231503445617, 0.014915635145254022, 0.019420055071735925, 0.008887184341115443];

/// Entries 11 12 14 21 22 24 of the matrix; their first and second time derivatives; entries 14 24
/// differentiated by centre distance and by both pin position errors; the six entries
/// differentiated by phase.
#[rustfmt::skip]
const REFERENCE: [[f64; 30]; 4] = [
    [
        0.9999817116191736, 0.0060478448382817905, -0.9582055734997917, -0.0060478448382817905, 0.9999817116191736, 9.953989057361364,
        19.95788796632991, -3299.939648343273, -21898.773726195, 3299.939648343273, 19.95788796632991, -2108.056661699542,
        -10889800.8395328, -65861.0302888887, 4637724.655738992, 65861.0302888887, -10889800.8395328, -48177302.197629,
        -0.09582083772567133, 0.9953985970743331, 0.9953985970743331, 0.09582083772567133, -0.09582083772567133, 0.9953985970743331,
        0.0060478448382817905, -0.9999817116191736, -9.953988057361363, 0.9999817116191736, 0.0060478448382817905, -0.9582075734997918,
    ],
    [
        0.7358423829558262, 0.6771528538268824, -9.918606930813285, -0.6771528538268824, 0.7358423829558262, -1.2732770048347448,
        2234.604417628712, -2428.2798637542264, 2801.2116106364388, 2428.2798637542264, 2234.604417628712, -21820.939647789226,
        -8013323.550388947, -7374194.578174749, 48006067.225136295, 7374194.578174749, -8013323.550388947, 6162665.543400166,
        -0.9918606819764046, -0.12732787420396785, -0.12732787420396785, 0.9918606819764046, -0.9918606819764046, -0.12732787420396785,
        0.6771528538268824, -0.7358423829558262, 1.273278004834745, 0.7358423829558262, 0.6771528538268824, -9.918608930813285,
    ],
    [
        0.0164669175782087, -0.9998644111205641, 8.181445224934299, 0.9998644111205641, 0.0164669175782087, 5.750133759961431,
        -3299.5525566978617, -54.340828008088714, -12650.292071915146, 54.340828008088714, -3299.5525566978617, 17999.175094855458,
        -179324.73242669276, 10888523.437102944, -39598185.20868201, -10888523.437102944, -179324.73242669276, -27830642.558213323,
        0.8181441013632854, 0.5750132428079046, 0.5750132428079046, -0.8181441013632854, 0.8181441013632854, 0.5750132428079046,
        -0.9998644111205641, -0.0164669175782087, -5.7501327599614305, 0.0164669175782087, -0.9998644111205641, 8.181443224934299,
    ],
    [
        -0.2157129232241572, 0.9764568268766873, -8.426842488989726, -0.9764568268766873, -0.2157129232241572, 5.384082347675616,
        3222.307528693068, 711.8526466397187, -11844.978964886355, -711.8526466397187, 3222.307528693068, -18539.0578757774,
        2349113.733911072, -10633614.844687125, 40785927.32671028, 10633614.844687125, 2349113.733911072, -26058953.722749982,
        -0.8426843342029001, 0.5384079428175397, 0.5384079428175397, 0.8426843342029001, -0.8426843342029001, 0.5384079428175397,
        0.9764568268766873, 0.2157129232241572, -5.384081347675616, -0.2157129232241572, 0.9764568268766873, -8.426844488989726,
    ],
];

/// The workload multiplies active matrices; as coordinate transformations they describe the inverse
/// motion.
fn outputs(g: &mut Graph) -> Vec<NodeId> {
    let [time, cd, rx, ry, px, py, phase, planet, carrier] = [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|i| g.symbol(i));
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    let axis = [zero, zero, one];
    let relative = g.subtract(planet, carrier);
    let turn = g.multiply(relative, time);
    let turn = g.add(turn, phase);
    let carried = g.multiply(carrier, time);
    let across = g.add(cd, py);
    let [turn, carried] = [turn, carried].map(|angle| g.negate(angle));
    let runout = g.negate_vector([rx, ry, zero]);
    let pin = g.negate_vector([px, across, zero]);
    let frame = Frame::translate(runout)
        .after(&Frame::rotate(turn, axis))
        .after(&Frame::translate(pin))
        .after(&Frame::rotate(carried, axis));
    let poses = frame.pose_with_derivatives(g, 0, 2);
    let mut outputs: Vec<NodeId> = poses.iter().flat_map(|p| [p[0], p[1], p[9], p[3], p[4], p[10]]).collect();
    for parameter in [1, 4, 5] {
        outputs.extend([poses[0][9], poses[0][10]].map(|entry| g.derivative(entry, parameter)));
    }
    let entries: Vec<NodeId> = outputs[..6].to_vec();
    outputs.extend(entries.into_iter().map(|entry| g.derivative(entry, 6)));
    outputs
}

#[test]
fn the_planet_frame_and_its_derivatives_meet_the_reference_to_1e_13() {
    let mut g = Graph::new();
    let outputs = outputs(&mut g);
    assert_eq!(outputs.len(), 30);
    let values: Vec<Vec<f64>> =
        TIMES.iter().map(|&time| evaluate(&g, &outputs, &[&[time][..], &PARAMETERS].concat())).collect();
    for column in 0..30 {
        let scale = REFERENCE.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        for (row, reference) in values.iter().zip(&REFERENCE) {
            let error = (row[column] - reference[column]).abs() / scale;
            assert!(error <= 1e-13, "column {column}: error {error:e}");
        }
    }
}
