//! A chain of fifty factors and its first two time derivatives against reference values, and its
//! cost. The reference values come from numerical differentiation with 110 digits (workload W4 of
//! the kinematic reference data), rounded to the nearest double.

use crate::support::{Random, evaluate};
use calyx_symbolic::{Frame, Graph, Instruction, NodeId};

const TIMES: [f64; 4] = [0.773536091967868, 1.5046140316764478, 0.4654183313549236, 0.19867882265320502];

/// The upper three rows of the matrix (rotation and translation, row by row), followed by their
/// first and second time derivatives.
#[rustfmt::skip]
const REFERENCE: [[f64; 36]; 4] = [
    [
        -0.3462290260784592, -0.8953186746710329, 0.2802319258865179, 5.041405535448551,
        0.0422864520640946, -0.3132968842736317, -0.9487132961418142, 3.810548508393571,
        0.9371965201987216, -0.316622066650036, 0.14633232533404059, -8.433260892408798,
        0.005708052917550468, 1.396689306276477, 4.469363396989607, -5.791836650188005,
        -2.123158337582802, -4.017674034842222, 1.2321361244016193, 30.199219018499985,
        0.09790596197441034, 0.02603336718659485, -0.5707172913298829, 3.3035333554509925,
        -8.919000616952815, 30.258313674813824, 7.411124263797567, -66.6012913126709,
        1.3823331776191639, -11.170446747206379, 27.116501516174562, -41.679859213039386,
        -8.177463513130974, -17.364689039908004, 12.504858879336494, 113.48991948968404,
    ],
    [
        0.20871724606363992, -0.16737929651353708, -0.9635462014321075, 1.4126286428628474,
        -0.5432728062592549, 0.7993992413979882, -0.2565453387444702, 20.124704159972364,
        0.8131984807996164, 0.5770138854056758, 0.07591578804334179, 6.297839390717916,
        5.93288202792954, -12.483487013569809, 3.4536715183050677, -56.49287138576287,
        -11.144769898638298, -12.352485707773408, -14.889833137960263, -120.6771135803573,
        -8.96822287329617, 13.492033080508925, -6.482778173738663, 307.8473671288176,
        101.75493008248306, 59.56618624746621, 222.33728516946567, 240.12124643861566,
        222.25450687530167, -430.24165173935626, 131.81783237212798, -6367.610875922154,
        -172.56203644693844, -236.65169055663475, -363.71740811745485, -2034.5190602697603,
    ],
    [
        -0.5305345168748022, -0.707297481168744, -0.46718668595837615, 4.058136263411466,
        0.7263202152109177, -0.09516004353687628, -0.6807374758965646, -3.720154576204528,
        0.4370263966631608, -0.7004818621823194, 0.5642101464642441, -4.438462079656496,
        0.9016488644662453, -1.0721387833556157, 0.5992576942900696, 7.537011273322755,
        -1.3508888659911706, 2.708835047969349, -1.820012555265832, 9.00476067291961,
        3.339692402374478, 0.7145769603117686, -1.699695659057167, -23.887143569844625,
        -2.6259560163901936, 0.24322432311712902, 7.583029421862309, 4.657490992636616,
        -15.090081378572712, -16.436722860430915, 4.523067943634274, 134.4164902851006,
        -9.666111543465364, 14.8326130809779, 0.10845501779355515, 15.613337651303786,
    ],
    [
        -0.8196352544259886, -0.25321059210704244, -0.513889526792331, 2.268070919621282,
        0.3243398430734831, -0.9445148879181623, -0.051916208413265115, -2.089593442241707,
        -0.47223057492830056, -0.20922720316857035, 0.856283984176479, 0.6654417898696608,
        0.6794627487175966, -2.8362625317964585, 0.31380303298969325, 7.288832432910342,
        4.5218824379832725, 1.6865226305266328, -2.433134022529984, -15.954133010516411,
        1.9264212562946152, -4.180976493727336, 0.04080538672179306, -9.416531209391483,
        10.339819449761746, 9.405703925033706, -4.38222062987239, -21.206187622133555,
        -16.805750516573134, 25.469991907622262, -5.694570316373118, 21.192439495350875,
        22.6468483906664, 9.228712769964758, -10.005905211558515, -90.23847700461629,
    ],
];

/// Returns a polynomial in time with the next random coefficients: multiples of 0.001 from -1 to 1.
fn polynomial(g: &mut Graph, random: &mut Random, degree: usize) -> NodeId {
    let time = g.symbol(0);
    let coefficients: Vec<f64> =
        (0..=degree).map(|_| ((random.uniform(0.0, 1.0) * 2001.0).floor() - 1000.0) / 1000.0).collect();
    let mut sum = g.constant(0.0);
    for &coefficient in coefficients.iter().rev() {
        let (product, coefficient) = (g.multiply(sum, time), g.constant(coefficient));
        sum = g.add(product, coefficient);
    }
    sum
}

/// The workload multiplies active matrices left to right; as coordinate transformations they
/// describe the inverse motion.
fn outputs(g: &mut Graph) -> Vec<NodeId> {
    let mut random = Random(4);
    let mut frame = Frame::ground();
    for pair in 0..25 {
        let v = [0; 3].map(|_| polynomial(g, &mut random, 2));
        let angle = polynomial(g, &mut random, 3);
        let axis = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.36, 0.48, 0.8]][pair % 4];
        let axis = axis.map(|component| g.constant(component));
        let (v, angle) = (g.negate_vector(v), g.negate(angle));
        frame = frame.after(&Frame::translate(v).after(&Frame::rotate(angle, axis)));
    }
    let rows = |p: [NodeId; 12]| [0, 1, 2].map(|i| [p[3 * i], p[3 * i + 1], p[3 * i + 2], p[9 + i]]).concat();
    frame.pose_with_derivatives(g, 0, 2).into_iter().flat_map(rows).collect()
}

#[test]
fn fifty_factors_meet_the_reference_to_1e_13() {
    let mut g = Graph::new();
    let outputs = outputs(&mut g);
    let values = TIMES.map(|time| evaluate(&g, &outputs, &[time]));
    for column in 0..36 {
        let scale = REFERENCE.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        for (row, reference) in values.iter().zip(&REFERENCE) {
            let error = (row[column] - reference[column]).abs() / scale;
            assert!(error <= 1e-13, "column {column}: error {error:e}");
        }
    }
}

/// Hand-written rigid-body kinematics takes 3,700 operations; entry-by-entry differentiation takes
/// 8,900.
#[test]
fn fifty_factors_cost_no_more_than_rigid_body_algebra_by_hand() {
    let mut g = Graph::new();
    let outputs = outputs(&mut g);
    let tape = g.schedule(1, &outputs);
    let constants_and_inputs =
        |i: &&Instruction| matches!(i, Instruction::Constant(_) | Instruction::Input(_));
    let operations = tape.instructions.len() - tape.instructions.iter().filter(constants_and_inputs).count();
    assert!(operations <= 3700, "{operations}");
}
