//! Skins of solid meshes: cavities, lids over openings, velocities, and coarsening.

use crate::shapes::{cuboid, sphere, sphere_and_half};
use crate::spheres::frequency;
use calyx_acoustics::coarsening::coarsened;
use calyx_acoustics::projection::Projection;
use calyx_acoustics::rayleigh;
use calyx_acoustics::skin::{Skin, Solid};
use calyx_acoustics::{AcousticError, Fluid, RadiationModel, Settings, SurfaceMesh};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::Vector;
use faer::c64;

/// Grid of 4 x 4 x 4 cells of unit size; those that a function selects are hexahedra.
fn grid(is_solid: impl Fn([usize; 3]) -> bool) -> (Vec<Vector>, Vec<Solid>) {
    let node = |[i, j, k]: [usize; 3]| 25 * k + 5 * j + i;
    let nodes = (0..125).map(|n| [n % 5, n / 5 % 5, n / 25].map(|x| x as f64)).collect();
    let mut solids = Vec::new();
    for at in (0..64).map(|cell| [cell % 4, cell / 4 % 4, cell / 16]).filter(|at| is_solid(*at)) {
        let corner = |n: usize| {
            let [di, dj] = [[0, 0], [1, 0], [1, 1], [0, 1]][n % 4];
            node([at[0] + di, at[1] + dj, at[2] + n / 4])
        };
        solids.push(Solid::Hexahedron([0, 1, 2, 3, 4, 5, 6, 7].map(corner)));
    }
    (nodes, solids)
}

fn is_inside(at: [usize; 3]) -> bool {
    at.iter().all(|x| (1..3).contains(x))
}

#[test]
fn cavities_are_omitted() {
    let (nodes, solids) = grid(|at| !is_inside(at));
    let skin = Skin::new(&nodes, &solids, &[], None).expect("closed");
    assert!((skin.mesh.area() - 96.0).abs() < 1e-9 && (skin.mesh.volume() - 64.0).abs() < 1e-9);
    assert_eq!((skin.mesh.vertices().len(), skin.mesh.triangles().len()), (98, 192));
}

/// A shaft of cells above the cavity opens it to the top.
#[test]
fn lids_close_openings() {
    let opening = |at: [usize; 3]| at[2] == 3 && (1..3).contains(&at[0]) && (1..3).contains(&at[1]);
    let (nodes, solids) = grid(|at| !is_inside(at) && !opening(at));
    let open = Skin::new(&nodes, &solids, &[], None).expect("closed through the opening");
    assert!((open.mesh.volume() - 52.0).abs() < 1e-9);

    let rim: Vec<usize> = [[1, 1], [2, 1], [3, 1], [3, 2], [3, 3], [2, 3], [1, 3], [1, 2]]
        .map(|[i, j]| 100 + 5 * j + i)
        .to_vec();
    let reversed: Vec<usize> = rim.iter().rev().copied().collect();
    for lid in [rim.clone(), reversed] {
        let skin = Skin::new(&nodes, &solids, &[lid], None).expect("closed");
        assert!((skin.mesh.area() - 96.0).abs() < 1e-9 && (skin.mesh.volume() - 64.0).abs() < 1e-9);
        assert_eq!(skin.nodes.iter().filter(|nodes| nodes.len() > 1).count(), 1);

        // A rigid motion, also of the lid.
        let velocity = [0.3, -0.2, 0.7].map(|x| c64::new(x, 0.0));
        let found = skin.normal_velocities(&vec![velocity; nodes.len()]).expect("one each");
        for (normal, found) in skin.mesh.normals().iter().zip(&found) {
            let expected = 0.3 * normal[0] - 0.2 * normal[1] + 0.7 * normal[2];
            assert!((found.re - expected).abs() < 1e-12);
        }
        assert!(skin.normal_velocities(&vec![velocity; 20]).is_err());
    }

    let rejected = |lid: Vec<usize>| {
        let error = Skin::new(&nodes, &solids, &[lid], None).expect_err("no rim");
        assert!(matches!(&error, AcousticError::Input { .. }) && !error.help().is_empty(), "{error}");
    };
    rejected(rim[..2].to_vec());
    rejected(vec![rim[0], rim[3], rim[5]]);
}

#[test]
fn tetrahedra_and_wedges_have_outward_faces() {
    let corners: Vec<Vector> = [0, 1]
        .iter()
        .flat_map(|z| [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| [x, y, f64::from(*z)]))
        .collect();
    for (solids, volume) in [
        (vec![Solid::Wedge([0, 1, 2, 3, 4, 5])], 0.5),
        (vec![Solid::Wedge([3, 4, 5, 0, 1, 2])], 0.5),
        (vec![Solid::Tetrahedron([0, 1, 2, 3])], 1.0 / 6.0),
        (vec![Solid::Tetrahedron([0, 2, 1, 3])], 1.0 / 6.0),
        (
            vec![
                Solid::Tetrahedron([0, 1, 2, 3]),
                Solid::Tetrahedron([1, 2, 3, 4]),
                Solid::Tetrahedron([2, 3, 4, 5]),
            ],
            0.5,
        ),
    ] {
        let skin = Skin::new(&corners, &solids, &[], None).expect("closed");
        assert!((skin.mesh.volume() - volume).abs() < 1e-12, "{solids:?}");
    }
    let error = Skin::new(&corners, &[Solid::Tetrahedron([0, 1, 2, 6])], &[], None).expect_err("no node");
    assert_eq!(error.to_string(), "solid element 0: node 6 does not exist; the mesh has 6 nodes");
    assert!(Skin::new(&corners, &[], &[], None).is_err());
}

/// Skin whose vertices are the nodes.
fn skin(mesh: SurfaceMesh) -> Skin {
    let nodes = (0..mesh.vertices().len()).map(|vertex| vec![vertex]).collect();
    Skin { mesh, nodes }
}

#[test]
fn coarsening_keeps_boxes() {
    let (vertices, faces) = cuboid([1.0, 2.0, 3.0], [8, 16, 24]);
    let fine = skin(SurfaceMesh::new(vertices, &faces, None).expect("closed"));
    let coarse = coarsened(&fine, 0.5).expect("valid");
    assert!((coarse.mesh.area() - 22.0).abs() < 1e-9 && (coarse.mesh.volume() - 6.0).abs() < 1e-9);
    assert!(coarse.mesh.longest_edge() <= 0.5);
    assert!(8 * coarse.mesh.triangles().len() < 3 * fine.mesh.triangles().len());
    let mut nodes: Vec<usize> = coarse.nodes.concat();
    nodes.sort_unstable();
    assert!(nodes.into_iter().eq(0..fine.mesh.vertices().len()));
    assert!(coarsened(&fine, 0.0).is_err() && coarsened(&fine, f64::NAN).is_err());
}

#[test]
fn coarsening_keeps_the_power_of_spheres() {
    let interrupt = Interrupt::never();
    let [_, half] = sphere_and_half(4, 1.0);
    for mesh in [sphere(4, 1.0), half] {
        let fine = skin(mesh);
        let longest = 3.0 * fine.mesh.longest_edge();
        // The plane of an equilateral triangle with these edges is this far below the sphere.
        let depth = longest * longest / 6.0;
        let coarse = coarsened(&fine, longest).expect("valid");
        let count = coarse.mesh.triangles().len();
        assert!(4 * count < fine.mesh.triangles().len(), "{count}");
        assert!((coarse.mesh.area() / fine.mesh.area() - 1.0).abs() < 2.0 * depth);
        let velocities: Vec<[c64; 3]> =
            fine.mesh.vertices().iter().map(|at| at.map(|x| c64::new(x, 0.0))).collect();
        let normal = coarse.normal_velocities(&velocities).expect("one each");
        let model = RadiationModel { mesh: coarse.mesh, fluid: Fluid::AIR };
        let equations = model.equations(frequency(1.0), &Settings::default(), &interrupt).expect("assembled");
        let radiation = equations.solve(&[normal], &interrupt).expect("solved").remove(0);
        let efficiency = radiation.efficiency(&model.mesh);
        assert!((efficiency / 0.5 - 1.0).abs() < 2.0 * depth, "{efficiency}");
    }
}

/// Walls of a small box that bend with several waves: their sound is a small difference.
#[test]
fn projected_velocities_keep_flow_and_sound() {
    let (vertices, faces) = cuboid([0.3, 0.2, 0.15], [24, 16, 12]);
    let fine = skin(SurfaceMesh::new(vertices, &faces, None).expect("closed"));
    let wave =
        |at: Vector| (21.0 * at[0] + 0.4).sin() * (26.0 * at[1] - 0.3).cos() * (31.0 * at[2] + 0.2).cos();
    let on_fine: Vec<f64> =
        (0..fine.mesh.triangles().len()).map(|triangle| wave(fine.mesh.centroid(triangle))).collect();
    let power = |mesh: &SurfaceMesh, velocities: Vec<f64>| {
        let corners: Vec<_> = (0..mesh.triangles().len()).map(|triangle| mesh.corners(triangle)).collect();
        let all = vec![1.0; velocities.len()];
        let medium = (&Fluid::AIR, 200.0);
        let form = rayleigh::panel_impedances(&corners, &[velocities], &[all], medium, &Interrupt::never());
        form.expect("solved")[0].power(&[c64::new(1.0, 0.0)])
    };
    let flow = |mesh: &SurfaceMesh, velocities: &[f64]| -> f64 {
        velocities.iter().zip(mesh.areas()).map(|(velocity, area)| velocity * area).sum()
    };
    let expected = power(&fine.mesh, on_fine.clone());
    for longest in [0.02, 0.05, 0.1] {
        let coarse = coarsened(&fine, longest).expect("valid").mesh;
        let projected = Projection::new(&fine.mesh, &coarse).normal_velocities(&on_fine);
        let [before, after] = [flow(&fine.mesh, &on_fine), flow(&coarse, &projected)];
        assert!((after / before - 1.0).abs() < 1e-12);
        let found = power(&coarse, projected);
        // Samples of the velocities at the centroids give 1.8 times the power on the coarsest mesh.
        assert!((found / expected - 1.0).abs() < 0.02, "{longest}: {}", found / expected);
    }
    let same = Projection::new(&fine.mesh, &fine.mesh).normal_velocities(&on_fine);
    assert!(same.iter().zip(&on_fine).all(|(one, other)| (one - other).abs() < 1e-15));
}

/// Every part of a fine sphere adds its flow to the triangle of the coarse one below it: a smooth
/// velocity becomes that of the centroids. Each part at a distant triangle would show.
#[test]
fn parts_of_a_surface_are_projected_to_the_nearest_triangles() {
    let [fine, coarse] = [sphere(4, 1.0), sphere(2, 1.0)];
    let wave = |mesh: &SurfaceMesh, triangle: usize| {
        let [x, y, z] = mesh.centroid(triangle);
        x + 2.0 * y - z
    };
    let on_fine: Vec<f64> = (0..fine.triangles().len()).map(|triangle| wave(&fine, triangle)).collect();
    let found = Projection::new(&fine, &coarse).normal_velocities(&on_fine);
    for (triangle, found) in found.into_iter().enumerate() {
        let scale = fine.area() / coarse.area();
        let difference = found / scale - wave(&coarse, triangle);
        assert!(difference.abs() < 0.1, "{triangle}: {difference}");
    }
}
