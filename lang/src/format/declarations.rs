//! Formats declarations: interfaces, functions with their parameters, types.

use super::document::Item;
use super::expressions::operator;
use super::printer::{Layout, Printer};
use crate::ast::{
    Bind, Domain, EnumDecl, Expr, ExprKind, FunctionBody, FunctionDecl, Ident, Mode, ParamDecl, Parameter,
    RecordDecl, StmtKind, UnitDecl, UnitMeaning, VarDecl,
};
use crate::lexer::Kind;

impl Printer<'_> {
    /// Formats `param name = default in low .. high;`.
    pub(super) fn param(&mut self, param: &ParamDecl) {
        self.token(Kind::Param);
        self.space();
        self.open();
        self.token(Kind::Identifier);
        self.value(Bind::Evaluate, &param.default);
        if let Some(domain) = &param.domain {
            self.item(Item::Indent);
            self.line();
            self.domain(domain);
            self.item(Item::Dedent);
        }
        self.item(Item::Close);
        self.token(Kind::Semicolon);
    }

    /// Formats `output name := value in unit;`.
    pub(super) fn output_in(&mut self, value: &Expr, unit: &Expr) {
        self.token(Kind::Output);
        self.space();
        self.open();
        self.token(Kind::Identifier);
        self.value(Bind::Symbolic, value);
        self.item(Item::Indent);
        self.line();
        self.token(Kind::In);
        self.space();
        self.unit_product(unit);
        self.item(Item::Dedent);
        self.item(Item::Close);
        self.token(Kind::Semicolon);
    }

    /// Formats a product of units, without spaces.
    fn unit_product(&mut self, e: &Expr) {
        match &e.kind {
            ExprKind::Name(name) if name.name == "%" => self.token(Kind::Percent),
            ExprKind::Binary { op, left, right, .. } => {
                self.unit_product(left);
                self.token(operator(*op));
                self.unit_product(right);
            }
            _ => self.expression(e),
        }
    }

    fn domain(&mut self, domain: &Domain) {
        self.token(Kind::In);
        self.space();
        match domain {
            Domain::Choices { values, .. } => self.list(values),
            Domain::Range { low, high, .. } => {
                if let Some(low) = low {
                    self.expression(low);
                    self.space();
                }
                self.token(Kind::DotDot);
                if let Some(high) = high {
                    self.space();
                    self.expression(high);
                }
            }
        }
    }

    /// Formats a declared name and its former name: `teeth was lugs`.
    fn renamed(&mut self, former: &Option<Ident>) {
        self.token(Kind::Identifier);
        if former.is_some() {
            self.space();
            self.token(Kind::Identifier);
            self.space();
            self.token(Kind::Identifier);
        }
    }

    /// Formats `record Name { field: Type = default; }`, one field per line.
    pub(super) fn record(&mut self, record: &RecordDecl) {
        self.token(Kind::Record);
        self.space();
        self.renamed(&record.former);
        self.space();
        self.token(Kind::OpenBrace);
        let is_empty = record.fields.is_empty() && !self.comment_ahead();
        self.item(Item::Indent);
        for field in &record.fields {
            self.begin_item();
            self.renamed(&field.former);
            if field.annotation.is_some() {
                self.token(Kind::Colon);
                self.space();
                self.type_expression();
            }
            if let Some(default) = &field.default {
                self.value(Bind::Evaluate, default);
            }
            self.token(Kind::Semicolon);
        }
        self.comments();
        self.item(Item::Dedent);
        if !is_empty {
            self.item(Item::HardLine);
        }
        self.token(Kind::CloseBrace);
    }

    /// Formats `enum Name { a, b }` on one line, or one choice per line if it does not fit or has
    /// comments.
    pub(super) fn enumeration(&mut self, decl: &EnumDecl) {
        self.token(Kind::Enum);
        self.space();
        self.token(Kind::Identifier);
        self.space();
        self.open();
        self.token(Kind::OpenBrace);
        self.item(Item::Indent);
        let documented = decl.choices.iter().any(|choice| choice.doc.is_some());
        for index in 0..decl.choices.len() {
            if index > 0 {
                self.token(Kind::Comma);
            }
            match documented {
                true => self.begin_item(),
                false => self.line(),
            }
            self.token(Kind::Identifier);
        }
        if self.kind() == Some(Kind::Comma) {
            self.token(Kind::Comma);
        }
        self.comments();
        self.item(Item::Dedent);
        if !decl.choices.is_empty() {
            self.item(if documented { Item::HardLine } else { Item::Line });
        }
        self.token(Kind::CloseBrace);
        self.item(Item::Close);
    }

    /// Formats `dimension Name = Force/Length;`.
    pub(super) fn dimension(&mut self, has_value: bool) {
        self.token(Kind::Dimension);
        self.space();
        self.token(Kind::Identifier);
        if has_value {
            self.space();
            self.token(Kind::Assign);
            self.space();
            self.type_expression();
        }
        self.token(Kind::Semicolon);
    }

    /// Formats `unit euro: Cost;` and `unit furlong = 220 yard;`.
    pub(super) fn unit(&mut self, unit: &UnitDecl) {
        self.token(Kind::Unit);
        self.space();
        self.token(Kind::Identifier);
        match &unit.meaning {
            UnitMeaning::Coherent(_) => {
                self.token(Kind::Colon);
                self.space();
                self.type_expression();
            }
            UnitMeaning::Equal(value) => self.value(Bind::Evaluate, value),
        }
        self.token(Kind::Semicolon);
    }

    /// Formats `var a = 1, b := 2, c`, without the `;`.
    pub(super) fn variables(&mut self, declared: &[VarDecl]) {
        self.token(Kind::Var);
        self.space();
        if let [only] = declared {
            self.variable(only);
            return;
        }
        self.group(|p| {
            for (index, variable) in declared.iter().enumerate() {
                if index > 0 {
                    p.token(Kind::Comma);
                    p.line();
                }
                p.variable(variable);
            }
        });
    }

    fn variable(&mut self, variable: &VarDecl) {
        self.token(Kind::Identifier);
        if let Some((bind, value)) = &variable.init {
            self.value(*bind, value);
        }
    }

    pub(super) fn function(&mut self, function: &FunctionDecl) {
        match &function.body {
            FunctionBody::Statement(body) => self.headed(body, |p| p.signature(function)),
            FunctionBody::Symbolic(Expr { kind: ExprKind::Block(body), .. }) => {
                self.headed(body, |p| {
                    p.signature(function);
                    p.space();
                    p.bind(Bind::Symbolic);
                });
            }
            FunctionBody::Symbolic(value) => {
                self.signature(function);
                self.value(Bind::Symbolic, value);
                self.token(Kind::Semicolon);
            }
            FunctionBody::Extern { .. } => {
                self.signature(function);
                self.token(Kind::Semicolon);
            }
        }
    }

    /// Formats everything before the body.
    fn signature(&mut self, function: &FunctionDecl) {
        if function.is_test {
            self.token(Kind::Test);
            self.space();
        }
        if function.is_host {
            self.token(Kind::Host);
            self.space();
        }
        if let FunctionBody::Extern { purity, .. } = &function.body {
            self.token(Kind::Extern);
            self.space();
            if purity.is_some() {
                self.token(Kind::Identifier);
                self.space();
            }
        }
        self.token(if function.is_component { Kind::Component } else { Kind::Function });
        self.space();
        self.renamed(&function.former);
        let has_block = match &function.body {
            FunctionBody::Statement(body) => matches!(body.kind, StmtKind::Block(_)),
            FunctionBody::Symbolic(e) => matches!(e.kind, ExprKind::Block(_)),
            FunctionBody::Extern { .. } => false,
        };
        let layout = if has_block { Layout::EachClosed } else { Layout::Each };
        let parameter = if function.is_component { Self::declared_parameter } else { Self::parameter };
        self.bracket((Kind::OpenParen, Kind::CloseParen), &function.parameters, layout, parameter);
        if function.result.is_some() {
            self.space();
            self.token(Kind::Arrow);
            self.space();
            self.type_expression();
        }
        if let FunctionBody::Extern { unit: Some(unit), .. } = &function.body {
            self.space();
            self.token(Kind::In);
            self.space();
            self.unit_product(unit);
        }
    }

    fn parameter(&mut self, parameter: &Parameter) {
        self.token(match parameter.mode {
            Mode::In => Kind::In,
            Mode::Out => Kind::Out,
            Mode::InOut => Kind::InOut,
        });
        self.space();
        self.declared_parameter(parameter);
    }

    /// Formats a parameter without its mode.
    fn declared_parameter(&mut self, parameter: &Parameter) {
        self.renamed(&parameter.former);
        if parameter.annotation.is_some() {
            self.token(Kind::Colon);
            self.space();
            self.type_expression();
        }
        match &parameter.default {
            Some((bind, Some(value))) => self.value(*bind, value),
            Some((bind, None)) => {
                self.space();
                self.bind(*bind);
            }
            None => {}
        }
        if let Some(former) = &parameter.former_none {
            self.space();
            self.token(Kind::Identifier);
            self.space();
            self.expression(former);
        }
        if let Some(domain) = &parameter.domain {
            self.space();
            self.domain(domain);
        }
    }

    /// Formats a type token by token, because the tree does not contain its parentheses:
    /// `Array(Number)`, `Force/Length^(1/2)`.
    pub(super) fn type_expression(&mut self) {
        let mut open = 0_usize;
        let mut operand_ahead = true;
        // `Function(Length) -> Force`: depths of the functions whose arrow is ahead, and whether
        // the token before is the word.
        let mut functions = Vec::new();
        let mut after_word = false;
        while let Some(kind) = self.kind() {
            let is_word =
                self.word() == Some("Function") && operand_ahead && self.previous() != Some(Kind::Dot);
            match kind {
                Kind::Arrow if functions.last() == Some(&open) && !operand_ahead => {
                    functions.pop();
                    operand_ahead = true;
                    self.space();
                    self.token(kind);
                    self.space();
                    continue;
                }
                Kind::Identifier | Kind::Number if operand_ahead => operand_ahead = false,
                // The exponent of a dimension may have a sign.
                Kind::Minus if operand_ahead => {}
                Kind::OpenParen if operand_ahead || self.previous() == Some(Kind::Identifier) => {
                    functions.extend(after_word.then_some(open));
                    open += 1;
                    operand_ahead = true;
                }
                Kind::Star | Kind::Slash | Kind::Caret if !operand_ahead => operand_ahead = true,
                Kind::Dot if self.previous() == Some(Kind::Identifier) => operand_ahead = true,
                Kind::Comma if open > 0 => operand_ahead = true,
                Kind::CloseParen if open > 0 => {
                    open -= 1;
                    operand_ahead = false;
                }
                _ => return,
            }
            after_word = is_word;
            self.token(kind);
            if kind == Kind::Comma && self.kind() != Some(Kind::CloseParen) {
                self.space();
            }
        }
    }
}
