//! Evaluates a tape in complex numbers. For tiny `h`, the imaginary part of `f(x + ih)/h` is the
//! derivative to full precision, because nothing is subtracted (Squire and Trapp 1998). Steps and
//! conditional expressions use real parts.

use calyx_symbolic::{Graph, Instruction, NodeId};

#[derive(Clone, Copy)]
struct Complex {
    re: f64,
    im: f64,
}

fn real(re: f64) -> Complex {
    Complex { re, im: 0.0 }
}

fn add(a: Complex, b: Complex) -> Complex {
    Complex { re: a.re + b.re, im: a.im + b.im }
}

fn scale(c: f64, a: Complex) -> Complex {
    Complex { re: c * a.re, im: c * a.im }
}

fn multiply(a: Complex, b: Complex) -> Complex {
    Complex { re: a.re * b.re - a.im * b.im, im: a.re * b.im + a.im * b.re }
}

fn divide(a: Complex, b: Complex) -> Complex {
    let size = b.re * b.re + b.im * b.im;
    Complex { re: (a.re * b.re + a.im * b.im) / size, im: (a.im * b.re - a.re * b.im) / size }
}

/// Returns the square root of a number in the right half-plane.
fn sqrt(a: Complex) -> Complex {
    let re = ((a.re.hypot(a.im) + a.re) / 2.0).sqrt();
    Complex { re, im: a.im / (2.0 * re) }
}

fn sin(a: Complex) -> Complex {
    Complex { re: a.re.sin() * a.im.cosh(), im: a.re.cos() * a.im.sinh() }
}

fn cos(a: Complex) -> Complex {
    Complex { re: a.re.cos() * a.im.cosh(), im: -a.re.sin() * a.im.sinh() }
}

fn atan(a: Complex) -> Complex {
    let below = a.re * a.re + (1.0 - a.im) * (1.0 - a.im);
    Complex {
        re: 0.5 * (2.0 * a.re).atan2(1.0 - a.re * a.re - a.im * a.im),
        im: 0.25 * (4.0 * a.im / below).ln_1p(),
    }
}

fn asin(a: Complex) -> Complex {
    let root = sqrt(add(real(1.0), scale(-1.0, multiply(a, a))));
    atan(divide(a, root))
}

fn exp(a: Complex) -> Complex {
    Complex { re: a.re.exp() * a.im.cos(), im: a.re.exp() * a.im.sin() }
}

fn log(a: Complex) -> Complex {
    Complex { re: a.re.hypot(a.im).ln(), im: a.im.atan2(a.re) }
}

/// Returns the derivative of a node with respect to one of its inputs.
pub fn complex_step(graph: &Graph, node: NodeId, inputs: &[f64], by: usize) -> f64 {
    const STEP: f64 = 1e-60;
    let tape = graph.schedule(inputs.len(), &[node]);
    let mut values: Vec<Complex> = Vec::new();
    for &instruction in &tape.instructions {
        let v = |id: u32| values[id as usize];
        let of_reals = || real(instruction.evaluate(inputs, |id| values[id as usize].re));
        use Instruction as I;
        values.push(match instruction {
            I::Input(index) if index as usize == by => Complex { re: inputs[by], im: STEP },
            I::Negate(a) => scale(-1.0, v(a)),
            I::Abs(a) => scale(if v(a).re < 0.0 { -1.0 } else { 1.0 }, v(a)),
            I::Sqrt(a) => sqrt(v(a)),
            I::Sin(a) => sin(v(a)),
            I::Cos(a) => cos(v(a)),
            I::Tan(a) => divide(sin(v(a)), cos(v(a))),
            I::Asin(a) => asin(v(a)),
            I::Acos(a) => add(real(std::f64::consts::FRAC_PI_2), scale(-1.0, asin(v(a)))),
            I::Atan(a) => atan(v(a)),
            I::Exp(a) => exp(v(a)),
            I::Log(a) => log(v(a)),
            I::Add(a, b) => add(v(a), v(b)),
            I::Subtract(a, b) => add(v(a), scale(-1.0, v(b))),
            I::Multiply(a, b) => multiply(v(a), v(b)),
            I::Divide(a, b) => divide(v(a), v(b)),
            I::Power(a, b) => exp(multiply(v(b), log(v(a)))),
            I::Atan2(a, b) => {
                let half = of_reals();
                Complex { re: half.re, im: atan(divide(v(a), v(b))).im }
            }
            I::Min(a, b) => {
                if v(b).re < v(a).re {
                    v(b)
                } else {
                    v(a)
                }
            }
            I::Max(a, b) => {
                if v(b).re > v(a).re {
                    v(b)
                } else {
                    v(a)
                }
            }
            I::Select(c, a, b) => {
                if v(c).re != 0.0 {
                    v(a)
                } else {
                    v(b)
                }
            }
            I::Constant(_)
            | I::Input(_)
            | I::Floor(_)
            | I::Ceil(_)
            | I::Round(_)
            | I::Not(_)
            | I::Less(..)
            | I::LessEqual(..)
            | I::Equal(..)
            | I::And(..)
            | I::Or(..)
            | I::Piecewise(..)
            | I::Lookup(..)
            | I::Solution(..) => of_reals(),
        });
    }
    values[tape.outputs[0] as usize].im / STEP
}
