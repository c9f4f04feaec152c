//! Tests on streams as data: each malformed message is reported, and the messages after it are
//! read.

use super::*;
use std::fmt::Write;

/// Reads a stream in pieces of `piece` bytes. Messages are shown by their method or id, errors by
/// their code and id.
fn read(stream: &[u8], piece: usize) -> String {
    let mut framing = Framing::default();
    let mut shown = String::new();
    for bytes in stream.chunks(piece) {
        framing.push(bytes);
        while let Some(next) = framing.next() {
            match next {
                Ok(message) => {
                    let message: serde_json::Value = serde_json::from_str(&message).unwrap();
                    let name = message["method"].as_str().unwrap_or("response");
                    write!(shown, "{name} ").unwrap();
                }
                Err(error) => write!(shown, "{}:{} ", error.code, error.id).unwrap(),
            }
        }
    }
    shown.push_str(&framing.missing().unwrap_or_default());
    shown.trim_end().to_owned()
}

fn framed(body: &str) -> String {
    format!("Content-Length: {}\r\n\r\n{body}", body.len())
}

fn request(method: &str) -> String {
    framed(&format!(r#"{{"jsonrpc":"2.0","id":1,"method":"{method}"}}"#))
}

/// The well-formed messages before and after each stream are always read.
#[test]
fn malformed_messages_are_reported_and_skipped() {
    let body = r#"{"jsonrpc":"2.0","id":1,"method":"m"}"#;
    let length = body.len();
    let cases: &[(&str, Vec<u8>, &str)] = &[
        ("nothing", b"".to_vec(), ""),
        ("a message", request("m").into(), "m"),
        ("a response", framed(r#"{"jsonrpc":"2.0","id":"x","result":null}"#).into(), "response"),
        ("line feeds alone", format!("Content-Length: {length}\n\n{body}").into(), "m"),
        ("empty lines between", format!("\r\n\n{}", request("m")).into(), "m"),
        ("any case", format!("content-LENGTH:{length}\r\nX-Other: y\r\n\r\n{body}").into(), "m"),
        (
            "UTF-8",
            format!("Content-Type: a/b; charset=\"UTF-8\"\r\nContent-Length: {length}\r\n\r\n{body}").into(),
            "m",
        ),
        ("no encoding", format!("Content-Type: a/b\r\nContent-Length: {length}\r\n\r\n{body}").into(), "m"),
        (
            "another encoding",
            format!("Content-Type: a; charset=utf-16\r\nContent-Length: {length}\r\n\r\n{body}").into(),
            "-32700:null",
        ),
        ("one length twice", format!("Content-Length: {length}\r\n{}", request("m")).into(), "m"),
        ("two lengths", format!("Content-Length: 3\r\n{}", request("m")).into(), "-32700:null m"),
        ("no JSON", framed("{\"jsonrpc\":").into(), "-32700:null"),
        ("no body", framed("").into(), "-32700:null"),
        ("deeply nested", framed(&"[".repeat(100_000)).into(), "-32700:null"),
        ("a number without end", framed("1e999").into(), "-32700:null"),
        ("no UTF-8", b"Content-Length: 3\r\n\r\n\"\xff\"".to_vec(), "-32700:null"),
        ("a batch", framed(&format!("[{body},{body}]")).into(), "-32600:null"),
        ("no object", framed("7").into(), "-32600:null"),
        ("no version", framed(r#"{"id":5,"method":"m"}"#).into(), "-32600:5"),
        ("another version", framed(r#"{"jsonrpc":2,"id":"a","method":"m"}"#).into(), "-32600:\"a\""),
        ("no method", framed(r#"{"jsonrpc":"2.0","id":5}"#).into(), "-32600:null"),
        ("a method that is none", framed(r#"{"jsonrpc":"2.0","id":5,"method":{}}"#).into(), "-32600:5"),
        ("a fraction as id", framed(r#"{"jsonrpc":"2.0","id":0.5,"method":"m"}"#).into(), "-32600:null"),
        (
            "a large id",
            framed(r#"{"jsonrpc":"2.0","id":9223372036854775808,"method":"m"}"#).into(),
            "-32600:null",
        ),
        ("a list as id", framed(r#"{"jsonrpc":"2.0","id":[1],"method":"m"}"#).into(), "-32600:null"),
        ("an error that is none", framed(r#"{"jsonrpc":"2.0","id":5,"error":3}"#).into(), "-32600:null"),
        ("a name twice", framed(r#"{"jsonrpc":"2.0","id":5,"method":"m","method":"n"}"#).into(), "n"),
        ("too short", format!("Content-Length: 9\r\n\r\n{body}").into(), "-32700:null"),
        ("too long", format!("Content-Length: 60\r\n\r\n{body}").into(), "-32700:null"),
        ("one too long", format!("Content-Length: {}\r\n\r\n{body}", length + 1).into(), "-32700:null"),
        ("far too long", format!("Content-Length: 1000\r\n\r\n{body}").into(), "-32700:null"),
        ("enormous", format!("Content-Length: 99999999999\r\n\r\n{body}").into(), "-32700:null"),
        ("beyond 64 bits", format!("Content-Length: {}\r\n\r\n{body}", "9".repeat(99)).into(), "-32700:null"),
        ("negative", format!("Content-Length: -5\r\n\r\n{body}").into(), "-32700:null"),
        ("no number", format!("Content-Length: x\r\n\r\n{body}").into(), "-32700:null"),
        ("no length", format!("X: y\r\n\r\n{body}").into(), "-32700:null"),
        ("no header", body.into(), "-32700:null"),
        ("bytes", vec![0xff; 100], "-32700:null"),
        ("typed by hand", b"hello\n".to_vec(), "-32700:null"),
        ("bytes before a header", format!("foobar{}", request("m")).into(), "-32700:null m"),
        ("a long header", vec![b'x'; 100_000], "-32700:null"),
        ("many empty lines", vec![b'\n'; 100_000], "-32700:null"),
        ("a long value", format!("X: {}\r\n{}", "y".repeat(100_000), request("m")).into(), "-32700:null m"),
        (
            "a header in a text",
            framed(r#"{"jsonrpc":"2.0","method":"m","params":["Content-Length: 7\r\n\r\n"]}"#).into(),
            "m",
        ),
        ("a header in a broken text", framed("{\"a\":\"Content-Length: 7\\r\\n\\r\\n").into(), "-32700:null"),
    ];
    for (name, stream, expected) in cases {
        let mut whole = request("before").into_bytes();
        whole.extend(stream);
        whole.extend(request("after").into_bytes());
        let expected = format!("before {expected} after").replace("  ", " ");
        for piece in [1, 2, 7, 61, whole.len()] {
            assert_eq!(read(&whole, piece), expected, "{name}, {piece} bytes at a time");
        }
    }
}

#[test]
fn a_stream_that_ends_within_a_message_says_so() {
    for (stream, expected) in [
        ("", ""),
        ("Content-Len", "the input ended in the header of a message"),
        ("Content-Length: 10\r\n\r\n{}", "the input ended after 2 of the 10 bytes of a message"),
        ("hello\n", "-32700:null the input ended in bytes that are no message"),
    ] {
        assert_eq!(read(stream.as_bytes(), 4096), expected);
    }
}

/// Bytes that belong to no message are not stored.
#[test]
fn memory_is_bounded() {
    let mut framing = Framing::default();
    for _ in 0..1000 {
        framing.push(&[b'c'; 4096]);
        while framing.next().is_some() {}
        assert!(framing.buffer.len() <= LONGEST_HEADER + 4096);
    }
    assert!(framing.buffer.capacity() < 4 * LONGEST_HEADER);
}

/// Random streams of damaged messages: the same messages are read whatever the size of the pieces,
/// and the second undamaged message is read. `CALYX_FUZZ` sets the number of streams.
#[test]
fn damaged_streams_are_read_on() {
    let count = std::env::var("CALYX_FUZZ").ok().and_then(|count| count.parse().ok());
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut random = move |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 33) as usize % below
    };
    let pieces = [
        "Content-Length: ",
        "\r\n",
        "\r\n\r\n",
        "5",
        "c",
        ":",
        "{",
        "\"",
        "\u{e9}",
        "\0",
        "Content-Length: 7\r\n",
    ];
    for round in 0..count.unwrap_or(3000) {
        let mut stream: Vec<u8> = Vec::new();
        for _ in 0..=random(4) {
            stream.extend(request(["m", "textDocument/hover"][random(2)]).as_bytes());
        }
        for _ in 0..=random(6) {
            let at = random(stream.len());
            match random(4) {
                0 => stream[at] = random(256) as u8,
                1 => drop(stream.drain(at..(at + 1 + random(20)).min(stream.len()))),
                2 => drop(stream.splice(at..at, pieces[random(pieces.len())].bytes())),
                _ => stream.truncate(at + 1),
            }
            if stream.is_empty() {
                stream.push(b'x');
            }
        }
        // The end of the damaged messages may become the beginning of the first header.
        stream.extend(request("first").as_bytes());
        stream.extend(request("next").as_bytes());
        // The number of errors may depend on how many bytes have arrived.
        let messages = |piece: usize| {
            let read = read(&stream, piece);
            read.split(' ').filter(|shown| !shown.starts_with('-')).collect::<Vec<_>>().join(" ")
        };
        let whole = messages(stream.len());
        let text = String::from_utf8_lossy(&stream);
        assert!(whole.ends_with("next"), "round {round}: {whole}\n{text}");
        for piece in [1, 1 + random(30)] {
            assert_eq!(messages(piece), whole, "round {round}, {piece} bytes at a time\n{text}");
        }
    }
}
