//! What the client can do.

use super::text::Encoding;
use tower_lsp_server::ls_types::{ClientCapabilities, PositionEncodingKind};

/// What a client has said of itself.
#[derive(Debug, Default)]
pub struct Client {
    pub encoding: Encoding,
    /// Whether diagnostics may refer to other places.
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

    /// How the encoding is called in the protocol.
    pub fn encoding_kind(&self) -> PositionEncodingKind {
        match self.encoding {
            Encoding::Utf8 => PositionEncodingKind::UTF8,
            Encoding::Utf16 => PositionEncodingKind::UTF16,
        }
    }
}

/// UTF-8 where the client can count it, wherever it stands in its list: texts are kept in it.
fn encoding(capabilities: &ClientCapabilities) -> Encoding {
    let offered = capabilities.general.as_ref().and_then(|general| general.position_encodings.as_deref());
    match offered {
        Some(offered) if offered.contains(&PositionEncodingKind::UTF8) => Encoding::Utf8,
        _ => Encoding::Utf16,
    }
}
