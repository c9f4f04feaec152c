//! Client capabilities.

use super::text::Encoding;
use tower_lsp_server::ls_types::{ClientCapabilities, PositionEncodingKind};

/// Capabilities that a client has announced.
#[derive(Debug, Default)]
pub struct Client {
    pub encoding: Encoding,
    /// True if diagnostics may have related locations.
    pub related_information: bool,
    pub capabilities: ClientCapabilities,
}

impl Client {
    pub fn new(capabilities: &ClientCapabilities) -> Client {
        let document = capabilities.text_document.as_ref();
        let diagnostics = document.and_then(|document| document.publish_diagnostics.as_ref());
        Client {
            encoding: encoding(capabilities),
            related_information: diagnostics.and_then(|d| d.related_information).unwrap_or(false),
            capabilities: capabilities.clone(),
        }
    }

    /// Returns the encoding in terms of the protocol.
    pub fn encoding_kind(&self) -> PositionEncodingKind {
        match self.encoding {
            Encoding::Utf8 => PositionEncodingKind::UTF8,
            Encoding::Utf16 => PositionEncodingKind::UTF16,
        }
    }
}

/// Selects UTF-8 if the client supports it, at any position in its list: texts are stored in UTF-8.
fn encoding(capabilities: &ClientCapabilities) -> Encoding {
    let offered = capabilities.general.as_ref().and_then(|general| general.position_encodings.as_deref());
    match offered {
        Some(offered) if offered.contains(&PositionEncodingKind::UTF8) => Encoding::Utf8,
        _ => Encoding::Utf16,
    }
}
