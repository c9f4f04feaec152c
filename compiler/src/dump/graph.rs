//! Expression graphs of symbolic sites: every distinct operation once, operands before their uses.

use calyx_abi::newton::Search;
use calyx_abi::text::number;
use calyx_lang::ir::{Program, SiteId};
use calyx_lower::kernels::{KernelError, SiteGraph, site_graph};
use calyx_symbolic::{Node, NodeId};

/// Output format of graphs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Format {
    #[default]
    Text,
    /// Graphviz format.
    Dot,
}

pub fn print(program: &Program, only: Option<&str>, format: Format) -> Result<String, KernelError> {
    let mut out = String::new();
    for (index, site) in program.sites.iter().enumerate() {
        if only.is_some_and(|only| site.name != only) {
            continue;
        }
        let graph = site_graph(program, SiteId(index as u32))?;
        let title = match site.name.as_str() {
            "" => format!("site {index}"),
            name => name.to_owned(),
        };
        out += &match format {
            Format::Text => text(&title, &graph),
            Format::Dot => dot(&title, &graph),
        };
    }
    Ok(out)
}

fn text(title: &str, site: &SiteGraph) -> String {
    let mut out = format!("{title}: {} operations\n", operations(site));
    for id in &site.nodes {
        out += &format!("  {} = {}\n", name(site, *id), node(site, *id));
    }
    let outputs: Vec<String> = site.outputs.iter().map(|id| name(site, *id)).collect();
    out + &format!("  outputs {}\n\n", outputs.join(" "))
}

fn dot(title: &str, site: &SiteGraph) -> String {
    let mut out = format!("digraph {title:?} {{\n  rankdir = BT;\n");
    for id in &site.nodes {
        let label = match site.graph.node(*id) {
            Node::Constant(_) | Node::Symbol(_) => node(site, *id),
            Node::Unary(operation, _) => format!("{operation:?}").to_lowercase(),
            Node::Binary(operation, ..) => format!("{operation:?}").to_lowercase(),
            Node::Select(..) => "select".into(),
            Node::Piecewise(table, _) => format!("table {table}"),
            Node::Lookup(order, ..) => format!("spline {order}"),
            Node::Solution(_, unknown) => format!("{} {unknown}", search(site, *id)),
        };
        let shape = if site.outputs.contains(id) { ", shape = box" } else { "" };
        out += &format!("  {} [label = {label:?}{shape}];\n", name(site, *id));
        for operand in site.graph.operands(*id) {
            out += &format!("  {} -> {};\n", name(site, operand), name(site, *id));
        }
    }
    out + "}\n"
}

fn operations(site: &SiteGraph) -> usize {
    let leaf = |id: &&NodeId| !matches!(site.graph.node(**id), Node::Constant(_) | Node::Symbol(_));
    site.nodes.iter().filter(leaf).count()
}

/// Nodes are numbered in output order, so that the text is independent of nodes that were
/// simplified away.
fn name(site: &SiteGraph, id: NodeId) -> String {
    format!("n{}", site.nodes.binary_search(&id).unwrap_or(usize::MAX))
}

fn node(site: &SiteGraph, id: NodeId) -> String {
    let operand = |id| name(site, id);
    match site.graph.node(id) {
        Node::Constant(bits) => number(f64::from_bits(bits)),
        Node::Symbol(index) => site.inputs.get(index as usize).cloned().unwrap_or_default(),
        Node::Unary(operation, a) => format!("{} {}", format!("{operation:?}").to_lowercase(), operand(a)),
        Node::Binary(operation, a, b) => {
            format!("{} {} {}", format!("{operation:?}").to_lowercase(), operand(a), operand(b))
        }
        Node::Select(c, a, b) => format!("select {} {} {}", operand(c), operand(a), operand(b)),
        Node::Piecewise(table, a) => format!("table {table} {}", operand(a)),
        Node::Lookup(order, table, a) => format!("spline {order} {} {}", operand(table), operand(a)),
        Node::Solution(_, unknown) => {
            let operands: Vec<String> = site.graph.operands(id).map(operand).collect();
            format!("{} {unknown} {}", search(site, id), operands.join(" "))
        }
    }
}

/// Returns the name of the function that a solution is a value of.
fn search(site: &SiteGraph, id: NodeId) -> &'static str {
    match site.graph.system(id).map(|system| system.search) {
        Some(Search::Minimum) => "minimize",
        _ => "solve",
    }
}
