//! Checks of elastic bodies before they are condensed.

use crate::bars::bar;
use calyx_contact::solid::Pose;
use calyx_elastic::attachment::{Attachment, Connection, Region};
use calyx_elastic::import::{CondensedMatrices, CondensedNode};
use calyx_elastic::{ElasticModel, FixedComponents, NodalLoad, Node};
use calyx_model::bearing::{Bearing, axisymmetric};
use calyx_model::body::Body;
use calyx_model::connection::ElasticConnection;
use calyx_model::elastic_body::{ElasticBody, FiniteElementBody, MatrixBody};
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::{RelocatedMotion, SteadyRotation};
use calyx_model::rigid::RigidBody;
use calyx_structure::cache::Key;
use nalgebra::DMatrix;
use std::sync::Arc;

#[test]
fn loads_of_a_file_are_counted() {
    let ignored = |count: usize| {
        let mut model = bar([1, 1, 1], 1.0);
        model.loads = vec![NodalLoad { node: 0, load: [1.0; 6] }; count];
        FiniteElementBody::new(Arc::new(model), Key::of("loaded").finish()).ignored()
    };
    let about = "of the file: loads act on bodies and attachments of the model";
    assert_eq!(ignored(1), [format!("the load {about}")]);
    assert_eq!(ignored(3), [format!("the 3 loads {about}")]);
}

/// Two bars that do not touch: a part that no attachment and no support holds is rejected before
/// anything is condensed.
#[test]
fn parts_that_nothing_holds_are_rejected() {
    let mut model = bar([2, 1, 1], 1.0);
    let (nodes, elements) = (model.nodes.len(), model.elements.len());
    let other = bar([1, 1, 1], 1.0);
    for node in other.nodes {
        let [x, y, z] = node.position;
        model.nodes.push(Node { label: 1000 + node.label, position: [x, y + 1.0, z], ..node });
    }
    for mut element in other.elements {
        element.label += elements as u64;
        element.nodes.iter_mut().for_each(|node| *node += nodes);
        model.elements.push(element);
    }
    let checked = |model: &ElasticModel, both: bool| {
        let mut body = FiniteElementBody::new(Arc::new(model.clone()), Key::of("bars").finish());
        let lowest = [[-1.0, -0.1, -1.0], [-1.0, 0.9, -1.0]];
        for (name, lowest) in ["first", "second"].into_iter().zip(lowest).take(1 + usize::from(both)) {
            let region = Region::Box { lowest, highest: [1e-6, lowest[1] + 0.2, 1.0] };
            let name = name.into();
            let attachment = Attachment { name, position: None, region, connection: Connection::Rigid };
            body.attach(&attachment).expect("an attachment");
        }
        body.check()
    };
    assert_eq!(checked(&model, true), Ok(()));
    let error = checked(&model, false).expect_err("a loose part");
    assert_eq!(error.code, "E0992");
    assert!(error.message.contains("8 nodes, with node 1001,"), "{}", error.message);
    model.fixed.push(FixedComponents { node: nodes, components: [true; 6], value: 0.0 });
    assert_eq!(checked(&model, false), Ok(()));
}

/// Attachments of condensed matrices are points, and have a quarter of the size of their body.
#[test]
fn bearings_are_compared_with_nodes_of_condensed_matrices() {
    let node = |(label, x): (&str, f64)| CondensedNode { label: label.into(), position: Some([x, 0.0, 0.0]) };
    let matrices = CondensedMatrices {
        nodes: [("left", 0.0), ("right", 0.2)].map(node).to_vec(),
        components: (0..12).map(|row| (row / 6, row % 6)).collect(),
        stiffness: DMatrix::identity(12, 12) * 1e8,
        mass: None,
    };
    let mut body = MatrixBody::new(Arc::new(matrices), Key::of("two nodes").finish());
    for label in ["left", "right"] {
        body.attach(label, label, None).expect("a node");
    }
    let mut scene = Mechanism::default();
    let at_rest = || SteadyRotation::at_rest([0.0; 2]);
    let placed = |name: &str, x: f64| {
        let pose = Pose { origin: [x, 0.0, 0.0], ..Pose::IDENTITY };
        Body::new(name, Arc::new(RigidBody), RelocatedMotion { motion: Arc::new(at_rest()), pose })
    };
    let attached = [("left", 0.0), ("right", 0.2)].map(|(name, x)| scene.add_body(placed(name, x)));
    let connection = ElasticConnection::of_body("body".into(), Arc::new(body), &attached, [0.0; 3]);
    scene.add_connection(connection).expect("a connection");
    for (x, misplaced) in [(0.0, None), (0.004, None), (0.03, Some(false)), (0.2, Some(true))] {
        let shaft = scene.add_body(placed("shaft", x));
        let stiffness = axisymmetric(1e8, 0.0, 0.0, 0.0);
        let bearing = Bearing::new(format!("at {x}"), shaft, 0.0, stiffness).between(attached[0]);
        let found = scene.misplaced(&bearing).expect("frames");
        assert_eq!(found.as_ref().map(|found| found.impossible), misplaced, "{x}: {found:?}");
        assert_eq!(scene.add_bearing(bearing).is_err(), misplaced == Some(true), "{x}");
    }
}
