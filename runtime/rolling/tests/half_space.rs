//! Elastic half-spaces with pressure cells along and across a contact line: the reference of the
//! strips.

use std::f64::consts::PI;

/// Contact between two half-spaces with a gap `relief(x) + y²/(2R)`.
pub struct Reference<'a> {
    /// Length of the contact line, m.
    pub length: f64,
    /// Effective radius, m.
    pub radius: f64,
    /// Composite modulus, Pa.
    pub modulus: f64,
    /// Share of the images of all loads in both ends.
    pub images: f64,
    /// Approach less relief at a position, m.
    pub approach: &'a dyn Fn(f64) -> f64,
    /// Number of cells along the line, and across it on each side.
    pub cells: [usize; 2],
    /// Half-width of the cells, m.
    pub half_width: f64,
}

/// Converged pressures.
pub struct Field {
    /// Positions along the line, m.
    pub positions: Vec<f64>,
    /// Largest pressure across the line, Pa.
    pub pressures: Vec<f64>,
    /// Loads per length, N/m.
    pub loads: Vec<f64>,
    /// Load, N.
    pub load: f64,
    /// Moment about the middle, N m.
    pub moment: f64,
}

/// Integral of 1/ρ over a rectangle (Love 1929; Johnson, Contact Mechanics, equation 3.25).
fn love(x: [f64; 2], y: [f64; 2]) -> f64 {
    let corner = |x: f64, y: f64| {
        let root = x.hypot(y);
        x * (y + root).ln() + y * (x + root).ln()
    };
    // The formula holds for positive coordinates; others are sums of such rectangles.
    let positive = |x: f64, y: f64| {
        if x == 0.0 || y == 0.0 {
            return 0.0;
        }
        let (a, b) = (x.abs(), y.abs());
        (corner(a, b) - a * a.ln() - b * b.ln()) * x.signum() * y.signum()
    };
    positive(x[1], y[1]) - positive(x[0], y[1]) - positive(x[1], y[0]) + positive(x[0], y[0])
}

impl Reference<'_> {
    /// Deflections of cells by others, by the distance of their columns and by their rows.
    fn table(&self) -> Vec<f64> {
        let [along, across] = self.cells;
        let (dx, dy) = (self.length / along as f64, self.half_width / across as f64);
        let y = |k: usize| (k as f64 + 0.5) * dy;
        // Deflection of cell (i, k) by cells (j, ±l), by the distances of columns.
        let kernel = |shift: f64, k: usize, l: usize| {
            let own = [shift * dx - 0.5 * dx, shift * dx + 0.5 * dx];
            let rows = [y(k) - y(l), y(k) + y(l)];
            rows.map(|row| love(own, [row - 0.5 * dy, row + 0.5 * dy])).iter().sum::<f64>()
                / (PI * self.modulus)
        };
        let mut table = vec![0.0; 2 * along * across * across];
        for shift in 0..2 * along {
            for k in 0..across {
                for l in 0..across {
                    table[(shift * across + k) * across + l] = kernel(shift as f64, k, l);
                }
            }
        }
        table
    }

    /// Solves by conjugate gradients on active sets.
    pub fn solve(&self) -> Field {
        let [along, across] = self.cells;
        let (dx, dy) = (self.length / along as f64, self.half_width / across as f64);
        let x = |i: usize| (i as f64 + 0.5) * dx - 0.5 * self.length;
        let y = |k: usize| (k as f64 + 0.5) * dy;
        let table = self.table();
        let count = along * across;
        let interaction = |i: usize, j: usize, k: usize| {
            let at = |shift: usize| &table[(shift * across + k) * across..(shift * across + k + 1) * across];
            // Images in the ends: the distance of the columns is i + j + 1 from one of them.
            (at(i.abs_diff(j)), at(i + j + 1), at(2 * along - 1 - i - j))
        };
        let apply = |pressure: &[f64]| {
            let mut result = vec![0.0; count];
            for i in 0..along {
                for j in 0..along {
                    let source = &pressure[j * across..(j + 1) * across];
                    if source.iter().all(|p| *p == 0.0) {
                        continue;
                    }
                    for k in 0..across {
                        let (direct, first, second) = interaction(i, j, k);
                        let mut sum = 0.0;
                        for l in 0..across {
                            sum += (direct[l] + self.images * (first[l] + second[l])) * source[l];
                        }
                        result[i * across + k] += sum;
                    }
                }
            }
            result
        };
        let target: Vec<f64> = (0..count)
            .map(|cell| {
                let across_line = y(cell % across);
                (self.approach)(x(cell / across)) - 0.5 * across_line * across_line / self.radius
            })
            .collect();
        let largest = target.iter().copied().fold(0.0, f64::max);
        let mut active: Vec<bool> = target.iter().map(|t| *t > 0.0).collect();
        let mut pressure = vec![0.0; count];
        for _ in 0..100 {
            let masked = |values: Vec<f64>| -> Vec<f64> {
                values
                    .into_iter()
                    .zip(&active)
                    .map(|(value, active)| if *active { value } else { 0.0 })
                    .collect()
            };
            let mut residual: Vec<f64> =
                masked(apply(&pressure).iter().zip(&target).map(|(u, t)| t - u).collect());
            let mut direction = residual.clone();
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
            let mut square = dot(&residual, &residual);
            for _ in 0..400 {
                if square.sqrt() < 1e-7 * largest {
                    break;
                }
                let image = masked(apply(&direction));
                let step = square / dot(&direction, &image);
                for cell in 0..count {
                    pressure[cell] += step * direction[cell];
                    residual[cell] -= step * image[cell];
                }
                let next = dot(&residual, &residual);
                for cell in 0..count {
                    direction[cell] = residual[cell] + next / square * direction[cell];
                }
                square = next;
            }
            let deflection = apply(&pressure);
            let mut changed = 0;
            for cell in 0..count {
                if active[cell] && pressure[cell] < 0.0 {
                    (active[cell], pressure[cell]) = (false, 0.0);
                    changed += 1;
                } else if !active[cell] && target[cell] - deflection[cell] > 1e-6 * largest {
                    active[cell] = true;
                    changed += 1;
                }
            }
            if changed == 0 {
                break;
            }
        }
        assert!((0..along).all(|i| pressure[(i + 1) * across - 1] == 0.0), "the cells are too narrow");
        let row = |i: usize| &pressure[i * across..(i + 1) * across];
        let loads: Vec<f64> = (0..along).map(|i| 2.0 * dy * row(i).iter().sum::<f64>()).collect();
        Field {
            positions: (0..along).map(x).collect(),
            // The pressure is even across the line: extrapolate to its middle.
            pressures: (0..along).map(|i| row(i)[0] + (row(i)[0] - row(i)[1]) / 8.0).collect(),
            load: dx * loads.iter().sum::<f64>(),
            moment: dx * (0..along).map(|i| loads[i] * x(i)).sum::<f64>(),
            loads,
        }
    }
}
