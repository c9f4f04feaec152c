//! Splits the byte stream of a client into messages.
//!
//! The crate `tower_lsp_server` ends its input at the first message that it cannot decode.
//! Therefore it reads the output of [`Reader`]: every well-formed message, and for every malformed
//! one a request [`MALFORMED`], which the server answers with the error of the protocol.
//!
//! After an error [`Framing`] searches for the next header. A JSON text cannot contain
//! `Content-Length: 12` with a raw line break, because strings escape control characters. So this
//! line begins a message wherever it is found, also within the body of a message whose length is
//! wrong.

mod message;
mod reader;

pub use message::{MALFORMED, Malformed};
pub use reader::Reader;

use message::decode;

/// Longest header section, bytes. Those of known clients have less than a hundred.
const LONGEST_HEADER: usize = 8 << 10;
/// Longest message, bytes. A model of 300,000 lines has 5 MB.
const LONGEST_MESSAGE: usize = 64 << 20;
/// Most digits, and most blanks, of a length that the search for a header accepts.
const LONGEST_NUMBER: usize = 20;

const LENGTH: &str = "content-length";

/// Splitter of a byte stream into messages.
#[derive(Debug, Default)]
pub struct Framing {
    /// Received bytes that belong to no message yet.
    buffer: Vec<u8>,
    state: State,
    /// Number of bytes of the body that contain no header.
    searched: usize,
    /// True if the bytes before the next header belong to an error that has been reported.
    reported: bool,
}

#[derive(Debug, Default)]
enum State {
    #[default]
    Header,
    /// Body of this length. A body in an unsupported encoding is skipped.
    Body { length: usize, unsupported: Option<String> },
    /// Skips everything before the next header.
    Searching,
}

/// A header section.
enum Header {
    /// The end of the header has not arrived.
    Incomplete,
    Complete {
        size: usize,
        length: usize,
        unsupported: Option<String>,
    },
    /// `garbage`: the bytes contain no length at all.
    Malformed {
        problem: String,
        garbage: bool,
    },
}

impl Framing {
    pub fn push(&mut self, bytes: &[u8]) {
        self.buffer.extend_from_slice(bytes);
    }

    /// Returns the next message as JSON, or the error to answer; `None` until more bytes arrive.
    pub fn next(&mut self) -> Option<Result<String, Malformed>> {
        loop {
            match &mut self.state {
                State::Header => match header(&self.buffer) {
                    Header::Incomplete => return None,
                    Header::Complete { size, length, unsupported } => {
                        self.consume(size);
                        self.state = State::Body { length, unsupported };
                    }
                    Header::Malformed { problem, garbage } => {
                        // The search must not find the same line again.
                        self.consume(1);
                        self.state = State::Searching;
                        let known = garbage && self.reported;
                        self.reported = true;
                        if !known {
                            return Some(Err(Malformed::unparsable(problem)));
                        }
                    }
                },
                State::Searching => {
                    let found = find_header(&self.buffer, 0);
                    let (Found::At(start) | Found::Perhaps(start) | Found::NoneBefore(start)) = found;
                    self.consume(start);
                    match found {
                        Found::At(_) => self.state = State::Header,
                        _ => return None,
                    }
                }
                State::Body { length, unsupported } => {
                    let (length, unsupported) = (*length, unsupported.take());
                    if self.buffer.len() >= length {
                        return Some(self.body(length, unsupported));
                    }
                    if let Found::At(start) = find_header(&self.buffer, self.searched) {
                        return Some(Err(self.cut_short(length, start)));
                    }
                    self.searched = self.buffer.len().saturating_sub(LENGTH.len() + 3 * LONGEST_NUMBER);
                    self.state = State::Body { length, unsupported };
                    return None;
                }
            }
        }
    }

    /// Describes the incomplete message if the stream ends here; `None` between two messages.
    pub fn missing(&self) -> Option<String> {
        match &self.state {
            State::Header if self.buffer.is_empty() => None,
            State::Header => Some("the input ended in the header of a message".to_owned()),
            State::Body { length, .. } => {
                let arrived = self.buffer.len();
                Some(format!("the input ended after {arrived} of the {length} bytes of a message"))
            }
            State::Searching => Some("the input ended in bytes that are no message".to_owned()),
        }
    }

    /// Takes the body of a message, which has arrived completely.
    fn body(&mut self, length: usize, unsupported: Option<String>) -> Result<String, Malformed> {
        let decoded = match unsupported {
            Some(problem) => Err(Malformed::unparsable(problem)),
            None => decode(&self.buffer[..length]),
        };
        if decoded.is_err() {
            // A length that is too great includes at least the beginning of the next header.
            match find_header(&self.buffer, 0) {
                Found::At(start) | Found::Perhaps(start) if start < length => {
                    return Err(self.cut_short(length, start));
                }
                _ => {}
            }
        }
        self.consume(length);
        self.state = State::Header;
        self.reported = decoded.is_err();
        decoded
    }

    /// Reports a message that is interrupted by the next header.
    fn cut_short(&mut self, length: usize, start: usize) -> Malformed {
        self.consume(start);
        self.state = State::Searching;
        self.reported = true;
        Malformed::unparsable(format!(
            "`Content-Length` is {length} bytes, but the next message begins after {start}"
        ))
    }

    fn consume(&mut self, count: usize) {
        self.buffer.drain(..count.min(self.buffer.len()));
        self.searched = 0;
    }
}

/// Parses a header section. Lines may end with a line feed alone, and empty lines may precede it.
fn header(bytes: &[u8]) -> Header {
    let malformed = |problem: String, garbage: bool| Header::Malformed { problem, garbage };
    let (mut at, mut lines) = (0, 0);
    let (mut length, mut unsupported) = (None, None);
    while let Some(end) = bytes[at..].iter().position(|&byte| byte == b'\n') {
        let line = bytes[at..at + end].strip_suffix(b"\r").unwrap_or(&bytes[at..at + end]);
        at += end + 1;
        if at > LONGEST_HEADER {
            break;
        }
        if line.is_empty() {
            match length {
                Some(length) => return Header::Complete { size: at, length, unsupported },
                None if lines == 0 => continue,
                None => return malformed("the header has no `Content-Length`".to_owned(), true),
            }
        }
        let Some((name, value)) = field(line) else {
            return malformed(format!("expected a header, found `{}`", shown(line)), length.is_none());
        };
        lines += 1;
        if name.eq_ignore_ascii_case(LENGTH) {
            match length_of(value) {
                Ok(found) if length.is_some_and(|length| length != found) => {
                    return malformed("the header has two different lengths".to_owned(), false);
                }
                Ok(found) => length = Some(found),
                Err(problem) => return malformed(problem, false),
            }
        } else if name.eq_ignore_ascii_case("content-type") && !is_utf8(value) {
            unsupported = Some(format!("the encoding must be UTF-8, not `{}`", shown(value.as_bytes())));
        }
    }
    let rest = &bytes[at.min(bytes.len())..];
    let name = rest.iter().take_while(|&&byte| is_of_name(byte)).count();
    if bytes.len() > LONGEST_HEADER {
        return malformed(format!("the header is longer than {LONGEST_HEADER} bytes"), length.is_none());
    }
    match rest.get(name) {
        None | Some(b':' | b'\r') => Header::Incomplete,
        Some(_) => malformed(format!("expected a header, found `{}`", shown(rest)), length.is_none()),
    }
}

/// Returns name and value of a header line.
fn field(line: &[u8]) -> Option<(&str, &str)> {
    let (name, value) = std::str::from_utf8(line).ok()?.split_once(':')?;
    let proper = !name.is_empty() && name.bytes().all(is_of_name);
    proper.then(|| (name, value.trim()))
}

fn is_of_name(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || b"-_!#$%&'*+.^`|~".contains(&byte)
}

fn length_of(value: &str) -> Result<usize, String> {
    let refused = |problem: &str| Err(format!("`Content-Length` {problem}: `{}`", shown(value.as_bytes())));
    if value.is_empty() || !value.bytes().all(|byte| byte.is_ascii_digit()) {
        return refused("must be a number of bytes");
    }
    match value.parse() {
        Ok(length) if length <= LONGEST_MESSAGE => Ok(length),
        _ => refused(&format!("must be at most {LONGEST_MESSAGE} bytes")),
    }
}

/// Returns true if the value of `Content-Type` names UTF-8, which is also the default.
fn is_utf8(value: &str) -> bool {
    let parameters = value.split(';').skip(1).filter_map(|parameter| parameter.split_once('='));
    let mut encodings = parameters.filter(|(name, _)| name.trim().eq_ignore_ascii_case("charset"));
    encodings.all(|(_, encoding)| {
        let encoding = encoding.trim().trim_matches('"');
        ["utf-8", "utf8"].iter().any(|utf8| encoding.eq_ignore_ascii_case(utf8))
    })
}

/// Returns the beginning of some bytes, for a message to the user.
fn shown(bytes: &[u8]) -> String {
    const MOST: usize = 40;
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4 * MOST)]);
    let line = text.lines().next().unwrap_or_default();
    let mut shown: String = line.chars().take(MOST).flat_map(char::escape_debug).collect();
    if line.chars().nth(MOST).is_some() {
        shown.push('…');
    }
    shown
}

/// Result of the search for a header that states a length.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Found {
    At(usize),
    /// The bytes end within a possible header, which starts here.
    Perhaps(usize),
    /// There is no header, and none starts before this byte.
    NoneBefore(usize),
}

/// Searches for `Content-Length: `, digits and the end of the line.
fn find_header(bytes: &[u8], from: usize) -> Found {
    let mut at = from.min(bytes.len());
    while let Some(start) = bytes[at..].iter().position(|byte| byte.eq_ignore_ascii_case(&b'c')) {
        at += start;
        match is_header(&bytes[at..]) {
            Some(true) => return Found::At(at),
            None => return Found::Perhaps(at),
            Some(false) => at += 1,
        }
    }
    Found::NoneBefore(bytes.len())
}

/// Returns true if the bytes start with a line that states a length; `None` if they end too early.
fn is_header(bytes: &[u8]) -> Option<bool> {
    let name = bytes.iter().zip(LENGTH.bytes()).take_while(|(a, b)| a.eq_ignore_ascii_case(b)).count();
    if name < LENGTH.len() {
        return (name < bytes.len()).then_some(false);
    }
    let blank = |byte: u8| byte == b' ' || byte == b'\t';
    let mut rest = &bytes[name..];
    if *rest.first()? != b':' {
        return Some(false);
    }
    rest = &rest[1..];
    rest = skip(rest, blank)?.1;
    let (digits, rest) = skip(rest, |byte| byte.is_ascii_digit())?;
    let (_, rest) = skip(rest, blank)?;
    if digits == 0 {
        return Some(false);
    }
    match rest.first()? {
        b'\n' => Some(true),
        b'\r' => Some(*rest.get(1)? == b'\n'),
        _ => Some(false),
    }
}

/// Skips at most [`LONGEST_NUMBER`] bytes of a kind; `None` if nothing follows them.
fn skip(bytes: &[u8], of_kind: impl Fn(u8) -> bool) -> Option<(usize, &[u8])> {
    let count = bytes.iter().take(LONGEST_NUMBER).take_while(|&&byte| of_kind(byte)).count();
    (count < bytes.len()).then(|| (count, &bytes[count..]))
}

#[cfg(test)]
mod tests;
