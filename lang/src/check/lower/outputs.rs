//! Lowers outputs: each is a symbolic value that is passed to the engine with its name.

use super::body::Body;
use crate::check::tree::{DefId, Expr};
use crate::ir::{self, Capture, ExprKind, FormatPart, Op, Place, Site, SiteId, Statement, SymExpr, SymKind};
use crate::span::Span;
use calyx_abi::display::Display;
use calyx_abi::{Purity, Repr};

impl Body<'_, '_> {
    /// Lowers `output name := e;`.
    pub(super) fn output(&mut self, index: u32, def: DefId, span: Span) {
        self.bind(def);
        let mut value = self.make_symbolic(def, span);
        let name = match &value.kind {
            ExprKind::MakeSymbolic { site, .. } => self.output_name(index, *site),
            _ => String::new(),
        };
        let checker = self.lowering.checker;
        if let Some(member) = checker.outputs.get(index as usize).and_then(|output| output.member) {
            let local = self.local(member);
            let place = Place::whole(local, self.local_repr(local));
            value = self.assigned_once(place, value, span);
        }
        let name = ir::Expr { kind: ExprKind::String(name), repr: Repr::String, span };
        self.pass_output(name, value, span);
    }

    /// Lowers `output name := array;`: a loop that passes every element.
    pub(super) fn array_output(&mut self, index: u32, value: &Expr, span: Span) {
        let checker = self.lowering.checker;
        let Some(member) = checker.outputs.get(index as usize).and_then(|output| output.member) else {
            return;
        };
        // Adds the sites of the array's elements.
        let value = self.owned(value);
        let site = SiteId(self.lowering.program.sites.len() as u32);
        let name = self.output_name(index, site);
        let mut element = &value.repr;
        while let Repr::Array(inner) = element {
            element = inner;
        }
        // The value of the element at every step.
        let (repr, observable) = (element.clone(), matches!(element, Repr::Symbolic(_)));
        let kind = SymKind::Capture(0);
        self.lowering.program.sites.push(Site {
            name: name.clone(),
            shared: Vec::new(),
            expr: SymExpr { kind, repr: Repr::Number, span },
            captures: vec![Capture { name: name.clone(), repr, observable }],
            repr: Repr::Number,
            order: 0,
            part: false,
            span,
        });
        let local = self.local(member);
        let place = Place::whole(local, self.local_repr(local));
        let array = self.assigned_once(place, value, span);
        self.pass_elements(array, vec![FormatPart::Text(format!("{name}["))], site, span);
    }

    /// Passes the elements of an array as outputs. `name` is the beginning of their names, with an
    /// opening bracket.
    fn pass_elements(&mut self, array: ir::Expr, name: Vec<FormatPart>, site: SiteId, span: Span) {
        let number = |kind| ir::Expr { kind, repr: Repr::Number, span };
        let element_repr = match &array.repr {
            Repr::Array(element) => (**element).clone(),
            _ => Repr::Number,
        };
        let counter = self.temporary(number(ExprKind::Number(0.0)));
        let count = || number(ExprKind::Local(counter));
        let (test, inside, after) = (self.new_block(), self.new_block(), self.new_block());
        self.jump(test);
        self.start(test);
        let length = number(ExprKind::Len(Box::new(array.clone())));
        let kind = ExprKind::Op(Op::Less, vec![count(), length]);
        self.branch_on(ir::Expr { kind, repr: Repr::Bool, span }, inside, after);
        self.start(inside);
        let kind = ExprKind::Index(Box::new(array), Box::new(count()));
        let element = ir::Expr { kind, repr: element_repr.clone(), span };
        let mut name = name;
        name.push(FormatPart::Value(count(), Display::Plain));
        match &element_repr {
            Repr::Array(_) => {
                name.push(FormatPart::Text("][".into()));
                let local = self.temporary(element);
                let inner = ir::Expr { kind: ExprKind::Local(local), repr: element_repr, span };
                self.pass_elements(inner, name, site, span);
            }
            _ => {
                name.push(FormatPart::Text("]".into()));
                let kind = ExprKind::MakeSymbolic { site, captures: vec![element] };
                let value = ir::Expr { kind, repr: Repr::Symbolic(Box::new(Repr::Number)), span };
                let name = ir::Expr { kind: ExprKind::Format(name), repr: Repr::String, span };
                self.pass_output(name, value, span);
            }
        }
        let next = number(ExprKind::Op(Op::Add, vec![count(), number(ExprKind::Number(1.0))]));
        let place = Place::whole(counter, Repr::Number);
        self.push(Statement::Assign { place, value: next, span });
        self.jump(test);
        self.start(after);
    }

    /// Sets the kernel of an output, and returns its name.
    fn output_name(&mut self, index: u32, site: SiteId) -> String {
        let number = self.lowering.output_number(index);
        let output = number.and_then(|number| self.lowering.program.outputs.get_mut(number as usize));
        output.map_or_else(String::new, |output| {
            output.site = site;
            output.name.clone()
        })
    }

    /// Stores a value in a local, and returns the expression that reads it.
    fn assigned_once(&mut self, place: Place, value: ir::Expr, span: Span) -> ir::Expr {
        let read = ir::Expr { kind: ExprKind::Local(place.local), repr: place.repr.clone(), span };
        self.push(Statement::Assign { place, value, span });
        read
    }

    fn pass_output(&mut self, name: ir::Expr, value: ir::Expr, span: Span) {
        let parameters = [("name", Repr::String), ("value", Repr::Symbolic(Box::new(Repr::Number)))];
        let id = self.lowering.standard("output", Purity::Scene, &parameters, Repr::Unit);
        let call = ExprKind::CallExtern(id, vec![name, value]);
        self.push(Statement::Eval(ir::Expr { kind: call, repr: Repr::Unit, span }));
    }
}
