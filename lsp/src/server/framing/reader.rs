//! Stream that contains well-formed messages only.

use super::Framing;
use std::io;
use std::pin::Pin;
use std::task::{Context, Poll};
use tokio::io::{AsyncRead, ReadBuf};

/// Largest number of bytes read from the client at a time.
const CHUNK: usize = 16 << 10;

/// Reader of the messages of a client.
pub struct Reader<R, F> {
    inner: R,
    framing: Framing,
    /// Message in transfer.
    message: Vec<u8>,
    /// Number of bytes of the message already passed on.
    passed: usize,
    ended: bool,
    /// Callback that receives the reason if the stream ends within a message, or with an error.
    report: F,
}

impl<R: AsyncRead + Unpin, F: FnMut(&str) + Unpin> Reader<R, F> {
    pub fn new(inner: R, report: F) -> Reader<R, F> {
        Reader { inner, framing: Framing::default(), message: Vec::new(), passed: 0, ended: false, report }
    }

    fn end(&mut self, reason: Option<String>) {
        self.ended = true;
        if let Some(reason) = reason {
            (self.report)(&reason);
        }
    }
}

impl<R: AsyncRead + Unpin, F: FnMut(&str) + Unpin> AsyncRead for Reader<R, F> {
    fn poll_read(
        self: Pin<&mut Self>,
        context: &mut Context<'_>,
        into: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        let this = self.get_mut();
        loop {
            if this.passed < this.message.len() {
                let rest = &this.message[this.passed..];
                let count = rest.len().min(into.remaining());
                into.put_slice(&rest[..count]);
                this.passed += count;
                return Poll::Ready(Ok(()));
            }
            if let Some(next) = this.framing.next() {
                let body = next.unwrap_or_else(|malformed| malformed.request());
                this.message = format!("Content-Length: {}\r\n\r\n{body}", body.len()).into_bytes();
                this.passed = 0;
                continue;
            }
            if this.ended {
                return Poll::Ready(Ok(()));
            }
            let mut bytes = [0; CHUNK];
            let mut chunk = ReadBuf::new(&mut bytes);
            match Pin::new(&mut this.inner).poll_read(context, &mut chunk) {
                Poll::Pending => return Poll::Pending,
                Poll::Ready(Ok(())) if chunk.filled().is_empty() => {
                    let missing = this.framing.missing();
                    this.end(missing);
                }
                Poll::Ready(Ok(())) => this.framing.push(chunk.filled()),
                Poll::Ready(Err(error)) => this.end(Some(format!("the input cannot be read: {error}"))),
            }
        }
    }
}
