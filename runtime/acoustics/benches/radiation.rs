//! Time and memory of boundary elements at one frequency, and time of 500 speeds with eight mesh
//! harmonics from transfer vectors that are interpolated over the frequency. Ratios are to a plain
//! fill of a dense complex matrix with exp(-ikr)/r between all centroids, in the same run.
//!
//! `cargo bench -p calyx-acoustics` solves a sphere of 5,120 elements with dense matrices;
//! `-- LEVEL` one of 20 · 4^LEVEL elements, `-- hierarchical` with hierarchical matrices.

#[path = "../tests/shapes.rs"]
#[allow(dead_code)]
mod shapes;

use calyx_acoustics::sweep::TransferSweep;
use calyx_acoustics::{Fluid, Method, RadiationModel, Settings};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{length, minus};
use faer::{Mat, c64};
use rayon::prelude::*;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

/// Largest times of the equations with a solution, and of all speeds, as ratios; memory, bytes.
const LIMITS: (f64, f64, u64) = (20.0, 10.0, 2 << 30);
/// Points, speeds, and mesh harmonics per speed.
const COUNTS: [usize; 3] = [10, 500, 8];

fn main() {
    let mut method = Method::Dense;
    let mut level = 4;
    for argument in std::env::args().skip(1) {
        match argument.parse() {
            Ok(value) => level = value,
            Err(_) if argument == "hierarchical" => method = Method::Hierarchical,
            Err(_) => {}
        }
    }
    let model = RadiationModel { mesh: shapes::sphere(level, 0.2), fluid: Fluid::AIR };
    let mesh = &model.mesh;
    let triangles = mesh.triangles().len();
    let frequency = mesh.highest_frequency(Fluid::AIR.speed_of_sound);
    let wavenumber = TAU * frequency / Fluid::AIR.speed_of_sound;
    println!("{triangles} elements, {} vertices, {frequency:.0} Hz, {method:?}", mesh.vertices().len());
    let timed = |call: &mut dyn FnMut()| {
        let start = Instant::now();
        call();
        start.elapsed().as_secs_f64()
    };

    let centroids: Vec<_> = (0..triangles).map(|triangle| mesh.centroid(triangle)).collect();
    let fill = timed(&mut || {
        let matrix = Mat::from_fn(triangles, triangles, |i, j| {
            let r = length(minus(centroids[i], centroids[j])).max(1e-9);
            let (sine, cosine) = (wavenumber * r).sin_cos();
            c64::new(cosine / r, -sine / r)
        });
        black_box(&matrix);
    });
    println!("fill of a dense matrix  {fill:8.2} s");

    let interrupt = Interrupt::never();
    let settings = Settings { method, ..Settings::default() };
    let velocities: Vec<c64> =
        centroids.iter().map(|at| c64::new((20.0 * at[0]).sin(), 5.0 * at[1])).collect();
    let (mut equations, mut power) = (None, 0.0);
    let assembly = timed(&mut || {
        equations = Some(model.equations(frequency, &settings, &interrupt).expect("assembled"));
    });
    let equations = equations.expect("assembled");
    let solution = timed(&mut || {
        let radiation =
            equations.solve(std::slice::from_ref(&velocities), &interrupt).expect("solved").remove(0);
        power = radiation.power(mesh);
    });
    let total = assembly + solution;
    println!("equations               {assembly:8.2} s, ratio {:.1}", assembly / fill);
    println!("solution                {solution:8.2} s, ratio {:.1}, {power:.3e} W", solution / fill);
    println!("memory                  {:8.2} GB", interrupt.largest_request() as f64 / 1e9);

    let points: Vec<_> = (0..COUNTS[0]).map(|k| [1.0, 0.1 * k as f64, 0.5]).collect();
    let mut sweep = vec![];
    let vectors = timed(&mut || {
        sweep.push(equations.transfer_vectors(&points, &interrupt).expect("in the fluid"));
    });
    println!("{} transfer vectors     {vectors:8.2} s", COUNTS[0]);
    let memory = interrupt.largest_request();
    drop(equations);
    for share in [0.98, 0.96, 0.94] {
        let equations = model.equations(share * frequency, &settings, &interrupt).expect("assembled");
        sweep.insert(0, equations.transfer_vectors(&points, &interrupt).expect("in the fluid"));
    }
    let sweep = TransferSweep::new(sweep, mesh, &model.fluid, &interrupt).expect("ascending");
    let speeds = timed(&mut || {
        let sums = (0..COUNTS[1]).into_par_iter().map(|speed| {
            let scale = 0.94 + 0.06 * speed as f64 / COUNTS[1] as f64;
            let harmonics = (0..COUNTS[2]).map(|harmonic| {
                let own: Vec<c64> = velocities.iter().map(|v| v * (harmonic as f64 + scale)).collect();
                sweep.pressures(scale * frequency, &own).expect("in the range")[0]
            });
            harmonics.sum::<c64>()
        });
        black_box(sums.collect::<Vec<c64>>());
    });
    println!("{} speeds              {speeds:8.2} s, ratio {:.2}", COUNTS[1], speeds / fill);
    if level == 4 && method == Method::Dense {
        let (longest, slowest, most) = LIMITS;
        assert!(total < longest * fill && speeds < slowest * fill && memory < most, "over the limits");
    }
}
