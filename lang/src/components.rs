//! Strongly connected components of a graph, by Tarjan's algorithm (1972). It is iterative, because
//! a chain of calls may be as long as a program.

use crate::hashed::{HashMap, HashSet};
use std::hash::Hash;

/// Returns the strongly connected components in reverse topological order: each follows the
/// components that it links to.
pub fn components<N, L>(nodes: impl IntoIterator<Item = N>, links: impl Fn(N) -> L) -> Vec<Vec<N>>
where
    N: Copy + Eq + Hash,
    L: IntoIterator<Item = N>,
{
    let mut search = Search {
        index: HashMap::default(),
        low: HashMap::default(),
        stack: Vec::new(),
        on_stack: HashSet::default(),
        found: Vec::new(),
    };
    for node in nodes {
        search.visit(node, &|node| links(node).into_iter().collect());
    }
    search.found
}

struct Search<N> {
    index: HashMap<N, usize>,
    low: HashMap<N, usize>,
    stack: Vec<N>,
    on_stack: HashSet<N>,
    found: Vec<Vec<N>>,
}

impl<N: Copy + Eq + Hash> Search<N> {
    fn visit(&mut self, first: N, links: &dyn Fn(N) -> Vec<N>) {
        if self.index.contains_key(&first) {
            return;
        }
        let mut open: Vec<(N, Vec<N>)> = Vec::new();
        self.enter(first, &mut open, links);
        while let Some((node, left)) = open.last_mut() {
            let node = *node;
            match left.pop() {
                Some(to) if !self.index.contains_key(&to) => self.enter(to, &mut open, links),
                Some(to) => {
                    if self.on_stack.contains(&to) {
                        let low = self.low[&node].min(self.index[&to]);
                        self.low.insert(node, low);
                    }
                }
                None => {
                    open.pop();
                    let low = self.low[&node];
                    if let Some((around, _)) = open.last() {
                        let least = self.low[around].min(low);
                        self.low.insert(*around, least);
                    }
                    if low == self.index[&node] {
                        let at = self.stack.iter().rposition(|other| *other == node).unwrap_or(0);
                        let component = self.stack.split_off(at);
                        component.iter().for_each(|member| {
                            self.on_stack.remove(member);
                        });
                        self.found.push(component);
                    }
                }
            }
        }
    }

    fn enter(&mut self, node: N, open: &mut Vec<(N, Vec<N>)>, links: &dyn Fn(N) -> Vec<N>) {
        let next = self.index.len();
        self.index.insert(node, next);
        self.low.insert(node, next);
        self.stack.push(node);
        self.on_stack.insert(node);
        open.push((node, links(node)));
    }
}

#[cfg(test)]
mod tests {
    use super::components;

    #[test]
    fn components_come_after_what_they_link_to() {
        // Edges 0 -> 1 <-> 2 -> 3; node 4 is isolated.
        let links = |node: usize| [vec![1], vec![2], vec![1, 3], vec![], vec![]][node].clone();
        let mut found = components(0..5, links);
        found.iter_mut().for_each(|component| component.sort());
        assert_eq!(found, [vec![3], vec![1, 2], vec![0], vec![4]]);
    }

    #[test]
    fn a_long_chain_needs_no_stack() {
        let found = components(0..1_000_000_usize, |node| (node + 1 < 1_000_000).then_some(node + 1));
        assert_eq!((found.len(), found[0][0]), (1_000_000, 999_999));
    }
}
