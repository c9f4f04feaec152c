//! A text with places where it may break, and the layout that keeps its lines within a width.
//!
//! After Oppen, *Prettyprinting* (1980): a document is a flat sequence of items, so building and laying it out takes
//! no recursion and time in proportion to its length. Blanks and line ends are held back until text follows, so that
//! several requests for a line end, as comments make them, are one.

/// One piece of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Item<'t> {
    Text(&'t str),
    Space,
    /// A blank, or a line end where its group breaks.
    Line,
    /// Nothing, or a line end where its group breaks.
    SoftLine,
    /// A line end always; the groups around it break.
    HardLine,
    /// The same with an empty line, but not beside a bracket or at the beginning of the file.
    EmptyLine,
    /// A comment at the end of a line of code; a line end follows.
    Trailing(&'t str),
    Open(Breaks),
    Close,
    Indent,
    Dedent,
}

/// How a group breaks that does not fit in a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Breaks {
    /// At all of its places.
    All,
    /// Where the next piece would not fit.
    Filled,
}

const INDENT: usize = 4;

/// What the layout must know ahead about an item.
#[derive(Clone, Copy, Default)]
struct Ahead {
    /// Of a group or of what follows a line in a filled group: columns up to the next place where a line may end.
    width: usize,
    /// Of a group: a line ends inside in any case.
    forced: bool,
}

/// The text in lines of a width, all but the first indented by so many columns at least; the first is to stand behind
/// as many.
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
    // How the groups around the item are laid out; `None` is in one line.
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

/// What the layout must know ahead of each item, in two passes.
fn look_ahead(items: &[Item<'_>]) -> Vec<Ahead> {
    // Columns of everything before an item, were it all in one line.
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
    // Backwards: columns up to the next place where a line may end, and the groups that the item lies in.
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

/// A group, seen from behind.
struct LineContext {
    /// Columns up to the first place after the group where a line may end.
    end: usize,
    /// Columns up to the next such place that is the group's own, or behind it.
    next_line: usize,
    forced: bool,
}

/// What stands between two texts; the greatest of what is asked for.
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
    /// What it was when a line end was last asked for. A line begins where it was asked for or, after a closing
    /// bracket, further out.
    pending_indent: usize,
    /// Whether the last text opened a bracket, or nothing is written yet.
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

    /// Where the next text will begin, if `more` is asked for before it.
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

    /// Behind the text that is there, whatever was asked for since.
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
