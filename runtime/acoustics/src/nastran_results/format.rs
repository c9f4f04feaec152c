//! Recognition of files by their content.

/// Kind of a file, as its content shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// Binary results of NASTRAN (OP2).
    Op2,
    /// OP2 file as text, written with the option FORMATTED.
    FormattedOp2,
    /// Text results of NASTRAN for further processing (punch).
    Punch,
    /// Printed output of NASTRAN (F06).
    Printed,
    /// HDF5 database.
    Hdf5,
    /// NASTRAN deck.
    Deck,
    /// Universal file.
    Universal,
    /// Anything else.
    Other,
}

/// First bytes of HDF5 files.
const HDF5: &[u8] = b"\x89HDF\r\n\x1a\n";
/// Characters of the table at the beginning of formatted OP2 files.
const FORMATTED: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ$/+-()'=.*";
/// Headings of printed output.
const HEADINGS: [&str; 5] = [
    "N A S T R A N",
    "N a s t r a n",
    "V E C T O R",
    "E I G E N V E C T O R",
    "R E A L   E I G E N V A L U E",
];
/// First words of statements and cards that nearly every deck has.
const STATEMENTS: [&str; 8] = ["SOL", "CEND", "BEGIN", "GRID", "GRID*", "CQUAD4", "CTETRA", "CTRIA3"];

/// Returns the form of the output that a line of a punch file states: `REAL`, `REAL-IMAGINARY` or
/// `MAGNITUDE-PHASE`.
pub(super) fn punch_form(line: &str) -> Option<&'static str> {
    let rest = line.strip_prefix('$')?.trim_start();
    ["REAL-IMAGINARY", "MAGNITUDE-PHASE", "REAL"].into_iter().find(|form| {
        rest.get(..form.len()).is_some_and(|start| start.eq_ignore_ascii_case(form))
            && rest[form.len()..]
                .trim_start()
                .get(..6)
                .is_some_and(|word| word.eq_ignore_ascii_case("OUTPUT"))
    })
}

/// Recognizes a file by its content.
pub fn recognize(content: &[u8]) -> FileKind {
    if content.starts_with(HDF5) {
        return FileKind::Hdf5;
    }
    // The first record of an OP2 file is one word.
    if let Some(first) = content.first_chunk::<4>()
        && [i32::from_le_bytes(*first), i32::from_be_bytes(*first)].iter().any(|size| [4, 8].contains(size))
    {
        return FileKind::Op2;
    }
    if content.contains(&0) {
        return FileKind::Other;
    }
    let text = String::from_utf8_lossy(content);
    if text.lines().take(3).any(|line| line.contains(FORMATTED)) {
        return FileKind::FormattedOp2;
    }
    if text.lines().map(str::trim).find(|line| !line.is_empty()) == Some("-1") {
        return FileKind::Universal;
    }
    let mut is_deck = false;
    for line in text.lines() {
        if punch_form(line).is_some() {
            return FileKind::Punch;
        }
        if HEADINGS.iter().any(|heading| line.contains(heading)) && !line.starts_with('$') {
            return FileKind::Printed;
        }
        let word = line.split([' ', '\t', ',', '=']).next().unwrap_or_default();
        is_deck |= STATEMENTS.iter().any(|statement| word.eq_ignore_ascii_case(statement));
    }
    if is_deck { FileKind::Deck } else { FileKind::Other }
}
