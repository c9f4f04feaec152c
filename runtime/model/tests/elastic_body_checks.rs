//! Checks of elastic bodies before they are condensed.

use crate::bars::bar;
use calyx_elastic::attachment::{Attachment, Connection, Region};
use calyx_elastic::{ElasticModel, FixedComponents, NodalLoad, Node};
use calyx_model::elastic_body::{ElasticBody, FiniteElementBody};
use calyx_structure::cache::Key;
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
