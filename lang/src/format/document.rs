//! A document with optional line breaks, and its layout within a line width.
//!
//! The algorithm follows Oppen, *Prettyprinting* (1980): a document is a flat sequence of items, so
//! building and laying it out takes linear time and no recursion. Blanks and line ends are delayed
//! until text follows, so that consecutive requests for a line end, as comments cause them, are
//! merged.

/// An item of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Item<'t> {
    Text(&'t str),
    Space,
    /// A blank, or a line end if its group breaks.
    Line,
    /// Nothing, or a line end if its group breaks.
    SoftLine,
    /// A line end in any case; the enclosing groups break.
    HardLine,
    /// A line end and an empty line, except next to a bracket and at the start of the file.
    EmptyLine,
    /// A comment at the end of a line of code, followed by a line end.
    Trailing(&'t str),
    Open(Breaks),
    Close,
    Indent,
    Dedent,
}

/// The line breaks of a group that does not fit on a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Breaks {
    /// At all optional breaks.
    All,
    /// Only where the next item would not fit.
    Filled,
}

const INDENT: usize = 4;

/// Precomputed information about an item.
#[derive(Clone, Copy, Default)]
struct Ahead {
    /// For a group, or for the text after a break in a filled group: columns up to the next
    /// possible break.
    width: usize,
    /// For a group: `true` if it contains a forced line end.
    forced: bool,
}

/// Lays out items within a line width. All lines except the first are indented by at least `indent`
/// columns; the first starts after `indent` existing columns.
pub(super) fn lay_out(items: &[Item<'_>], width: usize, indent: usize) -> String {
    let ahead = look_ahead(items);
    let mut page = Page {
        out: String::new(),
        column: indent,
        pending: Pending::Nothing,
        indent,
        pending_indent: indent,
        after_open: true,
    };
    // The enclosing groups of the item; `None` for a group on one line.
    let mut groups: Vec<Option<Breaks>> = Vec::new();
    for (item, ahead) in items.iter().zip(ahead) {
        let group = groups.last().copied().unwrap_or(Some(Breaks::All));
        match *item {
            Item::Text(text) => page.text(text),
            Item::Space => page.hold(Pending::Space),
            Item::Line | Item::SoftLine => {
                let flat = if *item == Item::Line { Pending::Space } else { Pending::Nothing };
                let fits = || page.column_after(flat) + ahead.width <= width;
                let breaks = match group {
                    None => false,
                    Some(Breaks::All) => true,
                    Some(Breaks::Filled) => !fits(),
                };
                page.hold(if breaks { Pending::Line } else { flat });
            }
            Item::HardLine => page.hold(Pending::Line),
            Item::EmptyLine => page.hold(Pending::EmptyLine),
            Item::Trailing(text) => page.trailing(text),
            Item::Open(breaks) => {
                let fits = !ahead.forced && page.column_after(Pending::Nothing) + ahead.width <= width;
                groups.push(if group.is_none() || fits { None } else { Some(breaks) });
            }
            Item::Close => drop(groups.pop()),
            Item::Indent => page.indent += INDENT,
            Item::Dedent => page.indent = page.indent.saturating_sub(INDENT),
        }
    }
    if !page.out.is_empty() {
        page.out.push('\n');
    }
    page.out
}

/// Computes the information about each item in two passes.
fn look_ahead(items: &[Item<'_>]) -> Vec<Ahead> {
    // Columns before each item, if everything were on one line.
    let mut columns = Vec::with_capacity(items.len() + 1);
    let mut total = 0;
    for item in items {
        columns.push(total);
        total += match item {
            Item::Text(text) => columns_of(text),
            Item::Space | Item::Line => 1,
            _ => 0,
        };
    }
    columns.push(total);

    let mut ahead = vec![Ahead::default(); items.len()];
    // Backwards: columns up to the next possible break, and the enclosing groups of the item.
    let mut next_break = total;
    let mut around: Vec<LineContext> = Vec::new();
    for (index, item) in items.iter().enumerate().rev() {
        match item {
            Item::Line | Item::SoftLine => {
                let end = around.last().map_or(next_break, |group| group.next_line);
                ahead[index].width = end.saturating_sub(columns[index + 1]);
                next_break = columns[index];
                if let Some(group) = around.last_mut() {
                    group.next_line = columns[index];
                }
            }
            Item::HardLine | Item::EmptyLine | Item::Trailing(_) => {
                next_break = columns[index];
                if let Some(group) = around.last_mut() {
                    group.forced = true;
                    group.next_line = columns[index];
                }
            }
            Item::Close => around.push(LineContext { end: next_break, next_line: next_break, forced: false }),
            Item::Open(_) => {
                let Some(group) = around.pop() else { continue };
                ahead[index] = Ahead { width: group.end - columns[index], forced: group.forced };
                if let Some(outer) = around.last_mut() {
                    outer.forced |= group.forced;
                }
            }
            Item::Text(_) | Item::Space | Item::Indent | Item::Dedent => {}
        }
    }
    ahead
}

/// An enclosing group, in the backward pass.
struct LineContext {
    /// Columns up to the first possible break after the group.
    end: usize,
    /// Columns up to the next possible break in the group itself or after it.
    next_line: usize,
    forced: bool,
}

/// The pending space between two texts; the largest request wins.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Pending {
    Nothing,
    Space,
    Line,
    EmptyLine,
}

struct Page {
    out: String,
    column: usize,
    pending: Pending,
    indent: usize,
    /// The indentation when a line end was last requested. After a closing bracket, the next line
    /// may start further left.
    pending_indent: usize,
    /// `true` if the last text opened a bracket, or if nothing is written yet.
    after_open: bool,
}

impl Page {
    fn hold(&mut self, pending: Pending) {
        self.pending = self.pending.max(pending);
        if pending >= Pending::Line {
            self.pending_indent = self.indent;
        }
    }

    fn line_start(&self) -> usize {
        self.indent.min(self.pending_indent)
    }

    /// Returns the column of the next text if `more` is requested before it.
    fn column_after(&self, more: Pending) -> usize {
        match self.pending.max(more) {
            Pending::Nothing => self.column,
            Pending::Space => self.column + 1,
            Pending::Line | Pending::EmptyLine => self.line_start(),
        }
    }

    fn text(&mut self, text: &str) {
        let mut pending = std::mem::replace(&mut self.pending, Pending::Nothing);
        let closes = matches!(text, ")" | "]" | "}");
        if pending == Pending::EmptyLine && (self.after_open || closes) {
            pending = Pending::Line;
        }
        if self.out.is_empty() {
            pending = Pending::Nothing;
        }
        match pending {
            Pending::Nothing => {}
            Pending::Space => self.write(" "),
            Pending::Line | Pending::EmptyLine => {
                self.out.push_str(if pending == Pending::EmptyLine { "\n\n" } else { "\n" });
                self.column = self.line_start();
                self.out.extend(std::iter::repeat_n(' ', self.column));
            }
        }
        self.write(text);
        self.after_open = matches!(text, "(" | "[" | "{");
    }

    /// Writes after the existing text, regardless of pending requests.
    fn trailing(&mut self, text: &str) {
        if !self.out.is_empty() {
            self.write(" ");
        }
        self.write(text);
        self.hold(Pending::Line);
    }

    fn write(&mut self, text: &str) {
        self.out.push_str(text);
        match text.rfind('\n') {
            Some(end) => self.column = columns_of(&text[end + 1..]),
            None => self.column += columns_of(text),
        }
    }
}

fn columns_of(text: &str) -> usize {
    text.chars().count()
}

#[cfg(test)]
mod tests {
    use super::{Breaks, Item, lay_out};

    fn list(breaks: Breaks) -> Vec<Item<'static>> {
        let mut items = vec![Item::Text("f("), Item::Open(breaks), Item::Indent, Item::SoftLine];
        for (index, word) in ["one,", "two,", "three,", "four"].into_iter().enumerate() {
            if index > 0 {
                items.push(Item::Line);
            }
            items.push(Item::Text(word));
        }
        items.extend([Item::Dedent, Item::Close, Item::Text(");")]);
        items
    }

    #[test]
    fn a_group_that_fits_stays_in_its_line() {
        assert_eq!(lay_out(&list(Breaks::All), 80, 0), "f(one, two, three, four);\n");
    }

    #[test]
    fn what_follows_a_group_must_fit_too() {
        assert_eq!(lay_out(&list(Breaks::All), 25, 0), "f(one, two, three, four);\n");
        assert_eq!(lay_out(&list(Breaks::All), 24, 0), "f(\n    one,\n    two,\n    three,\n    four);\n");
    }

    #[test]
    fn a_filled_group_breaks_where_it_must() {
        assert_eq!(lay_out(&list(Breaks::Filled), 16, 0), "f(one, two,\n    three,\n    four);\n");
    }

    #[test]
    fn requests_for_line_ends_are_one() {
        let items = [
            Item::EmptyLine,
            Item::Text("{"),
            Item::Indent,
            Item::EmptyLine,
            Item::Text("a"),
            Item::Space,
            Item::HardLine,
            Item::Trailing("// why"),
            Item::EmptyLine,
            Item::Text("b"),
            Item::EmptyLine,
            Item::Dedent,
            Item::Text("}"),
        ];
        assert_eq!(lay_out(&items, 80, 0), "{\n    a // why\n\n    b\n}\n");
    }

    #[test]
    fn a_line_end_inside_breaks_the_groups_around() {
        let items = [
            Item::Open(Breaks::All),
            Item::Text("a"),
            Item::Line,
            Item::Open(Breaks::All),
            Item::Text("b"),
            Item::HardLine,
            Item::Text("c"),
            Item::Close,
            Item::Close,
        ];
        assert_eq!(lay_out(&items, 80, 0), "a\nb\nc\n");
    }
}
