//! Geometry of surface meshes; damaged meshes are rejected with place, reason and remedy.

use crate::shapes::{cuboid, faces, icosphere, sphere_and_half};
use calyx_acoustics::{AcousticError, Face, RigidPlane, SurfaceMesh};
use calyx_numerics::vec3::Vector;
use faer::c64;

#[test]
fn boxes_of_quadrilaterals_have_their_area_and_volume() {
    let (vertices, faces) = cuboid([0.2, 0.3, 0.5], [2, 3, 4]);
    let mesh = SurfaceMesh::new(vertices, &faces, None).expect("closed");
    assert!((mesh.area() - 0.62).abs() < 1e-12 && (mesh.volume() - 0.03).abs() < 1e-12);
    assert_eq!(mesh.triangles().len(), 2 * faces.len());
    assert!(mesh.faces().windows(2).all(|pair| pair[0] <= pair[1]));
    for (at, enclosure) in [([0.1, 0.1, 0.1], 1.0), ([0.1, 0.1, 0.6], 0.0), ([-0.5, 2.0, 0.1], 0.0)] {
        assert!((mesh.enclosure(at) - enclosure).abs() < 1e-9, "{at:?}");
    }
    let longest = (0.01f64 + 0.125 * 0.125).sqrt();
    assert!((mesh.longest_edge() - longest).abs() < 1e-12);
    assert!((mesh.highest_frequency(343.2) - 343.2 / 6.0 / longest).abs() < 1e-9);
}

#[test]
fn half_spheres_on_a_plane_have_half_the_volume() {
    let [whole, half] = sphere_and_half(2, 0.1);
    assert!((half.volume() / whole.volume() - 0.5).abs() < 1e-12);
    assert!((half.enclosure([0.0, 0.0, 0.05]) - 1.0).abs() < 1e-9);
    assert!(half.enclosure([0.0, 0.0, 0.15]).abs() < 1e-9);
}

#[test]
fn normal_velocities_are_projections() {
    let (vertices, faces) = cuboid([1.0; 3], [1; 3]);
    let mesh = SurfaceMesh::new(vertices, &faces, None).expect("closed");
    let velocity = [1.0, 2.0, 3.0].map(|x| c64::new(x, -x));
    let found = mesh.normal_velocities(&vec![velocity; mesh.vertices().len()]).expect("one each");
    for (normal, found) in mesh.normals().iter().zip(found) {
        let expected: c64 = (0..3).map(|axis| velocity[axis] * normal[axis]).sum();
        assert!((found - expected).norm() < 1e-12);
    }
    assert!(mesh.normal_velocities(&[velocity]).is_err());
}

/// Passes a damaged mesh, and compares place, message and remedy.
fn rejected(vertices: Vec<Vector>, faces: &[Face], plane: Option<RigidPlane>, expected: [&str; 3]) {
    match SurfaceMesh::new(vertices, faces, plane).expect_err("damaged") {
        AcousticError::Mesh { place, message, help } => {
            assert_eq!([place.as_str(), message.as_str(), help.as_str()], expected);
        }
        other => panic!("{other}"),
    }
}

#[test]
fn damaged_meshes_are_rejected() {
    let (vertices, triangles) = icosphere(1);
    let all = faces(&triangles);
    let with = |change: &dyn Fn(&mut Vec<Vector>, &mut Vec<Face>)| {
        let (mut vertices, mut faces) = (vertices.clone(), all.clone());
        change(&mut vertices, &mut faces);
        (vertices, faces)
    };
    let case = |change: &dyn Fn(&mut Vec<Vector>, &mut Vec<Face>), expected: [&str; 3]| {
        let (vertices, faces) = with(change);
        rejected(vertices, &faces, None, expected);
    };
    case(&|_, faces| faces.clear(), ["mesh", "it has no elements", "pass at least four triangles"]);
    case(
        &|_, faces| faces[3] = Face::Triangle([0, 1, 99]),
        [
            "element 3",
            "vertex 99 does not exist; the mesh has 42 vertices",
            "correct the vertices of the element",
        ],
    );
    case(
        &|vertices, _| vertices[7][1] = f64::NAN,
        [
            "vertex 7",
            &format!("the position {:?} is not finite", [vertices[7][0], f64::NAN, vertices[7][2]]),
            "correct the coordinates",
        ],
    );
    case(
        &|vertices, _| vertices.push([3.0; 3]),
        ["vertex 42", "it belongs to no element", "remove vertices without elements"],
    );
    let [a, b, c] = triangles[5];
    case(
        &|vertices, faces| {
            vertices.push(vertices[a]);
            faces[5] = Face::Triangle([42, b, c]);
        },
        [&format!("vertices {a} and 42"), "both are at the same position", "merge coincident vertices"],
    );
    case(
        &|_, faces| faces.push(Face::Triangle([a, b, a])),
        ["element 80", "it has no area", "remove the element, or correct its vertices"],
    );
    case(
        &|_, faces| faces[5] = Face::Triangle([a, c, b]),
        // The first element in the order of the mesh that has an edge in the same direction.
        [
            "element 7",
            "its normal is opposite to that of element 5",
            "reverse the order of the vertices of one of them",
        ],
    );
    case(
        &|_, faces| {
            for face in faces {
                if let Face::Triangle([_, b, c]) = face {
                    std::mem::swap(b, c);
                }
            }
        },
        [
            "element 0",
            "the normals of its connected surface point into the body",
            "reverse the order of the vertices of all its elements, or remove a surface inside of the body",
        ],
    );
}

#[test]
fn open_and_branched_surfaces_are_rejected() {
    let (vertices, mut faces) = cuboid([1.0; 3], [2; 3]);
    let open = "close the opening with elements, or merge the vertices along it";
    let last = faces.pop().expect("faces");
    let error = SurfaceMesh::new(vertices.clone(), &faces, None).expect_err("open");
    assert!(error.to_string().contains("belongs to no other element: the surface is open"), "{error}");
    assert_eq!(error.help(), open);

    // A wall inside of the body that joins four edges of the surface.
    faces.push(last);
    let ring = [[0.0, 0.5, 0.0], [1.0, 0.5, 0.0], [1.0, 0.5, 0.5], [0.0, 0.5, 0.5]];
    let at = |position: [f64; 3]| vertices.iter().position(|vertex| *vertex == position);
    let known: Vec<usize> = ring.iter().filter_map(|position| at(*position)).collect();
    assert_eq!(known.len(), 4);
    faces.push(Face::Quadrilateral([known[0], known[1], known[2], known[3]]));
    assert!(SurfaceMesh::new(vertices, &faces, None).is_err());

    // Two boxes that touch along an edge, and two that touch in a vertex.
    for (shift, message) in
        [([1.0, 1.0, 0.0], "belongs to 4 elements"), ([1.0, 1.0, 1.0], "touch in this vertex only")]
    {
        let (mut vertices, mut faces) = cuboid([1.0; 3], [1; 3]);
        let (others, more) = cuboid([1.0; 3], [1; 3]);
        let numbers: Vec<usize> = others
            .iter()
            .map(|other| {
                let moved = [0, 1, 2].map(|axis| other[axis] + shift[axis]);
                vertices.iter().position(|vertex| *vertex == moved).unwrap_or_else(|| {
                    vertices.push(moved);
                    vertices.len() - 1
                })
            })
            .collect();
        for face in more {
            if let Face::Quadrilateral(corners) = face {
                faces.push(Face::Quadrilateral(corners.map(|corner| numbers[corner])));
            }
        }
        let error = SurfaceMesh::new(vertices, &faces, None).expect_err("not a manifold");
        assert!(error.to_string().contains(message), "{error}");
    }
}

#[test]
fn surfaces_are_in_front_of_the_rigid_plane() {
    let (vertices, faces) = cuboid([1.0; 3], [1; 3]);
    let plane = |height: f64| RigidPlane::new([0.0, 0.0, height], [0.0, 0.0, 2.0]).ok();
    let behind = SurfaceMesh::new(vertices.clone(), &faces, plane(0.5)).expect_err("behind");
    assert!(behind.to_string().contains("behind the rigid plane"), "{behind}");
    let lying = SurfaceMesh::new(vertices.clone(), &faces, plane(0.0)).expect_err("lies in the plane");
    assert!(lying.to_string().contains("it lies in the rigid plane"), "{lying}");
    assert!(SurfaceMesh::new(vertices, &faces, plane(-0.1)).is_ok());
    assert!(RigidPlane::new([0.0; 3], [0.0; 3]).is_err());
    assert!(RigidPlane::new([f64::INFINITY, 0.0, 0.0], [0.0, 0.0, 1.0]).is_err());
}
