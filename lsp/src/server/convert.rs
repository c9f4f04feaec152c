//! Conversion between positions of [`ide`] and of the protocol.

use super::view::View;
use crate::ide;
use std::collections::BTreeMap;
use std::ops::Range as Bytes;
use tower_lsp_server::ls_types::{
    DocumentChanges, Location, OneOf, OptionalVersionedTextDocumentIdentifier, Position, Range,
    TextDocumentEdit, TextDocumentPositionParams, TextEdit, Uri, WorkspaceEdit,
};

impl View {
    /// Converts the position of a cursor; `None` if its file is not part of the project.
    pub fn position(&self, params: &TextDocumentPositionParams) -> Option<ide::Position> {
        let file = self.name(&params.text_document.uri)?;
        let offset = self.offset(&file, params.position)?;
        Some(ide::Position { file, offset })
    }

    pub fn offset(&self, file: &str, position: Position) -> Option<u32> {
        Some(self.file(file)?.text.offset(position, self.client.encoding))
    }

    /// Converts the range of a selection to bytes.
    pub fn bytes(&self, file: &str, range: Range) -> Option<Bytes<u32>> {
        Some(self.file(file)?.text.bytes(range, self.client.encoding))
    }

    /// Converts a byte range of a file to a range of the protocol.
    pub fn range(&self, file: &str, bytes: Bytes<u32>) -> Option<Range> {
        Some(self.file(file)?.text.range(bytes, self.client.encoding))
    }

    pub fn location(&self, file: &str, bytes: Bytes<u32>) -> Option<Location> {
        Some(Location { uri: self.uri(file)?, range: self.range(file, bytes)? })
    }

    pub fn text_edit(&self, edit: &ide::Edit) -> Option<TextEdit> {
        let range = self.range(&edit.file, edit.start..edit.end)?;
        Some(TextEdit { range, new_text: edit.replacement.clone() })
    }

    /// Converts the edits of one file; omits those of other files.
    pub fn text_edits(&self, file: &str, edits: &[ide::Edit]) -> Vec<TextEdit> {
        edits.iter().filter(|edit| *edit.file == *file).filter_map(|edit| self.text_edit(edit)).collect()
    }

    /// Converts edits of any files, for the document versions they were computed for. Omits edits
    /// of the library, which is read-only.
    pub fn workspace_edit(&self, edits: &[ide::Edit]) -> WorkspaceEdit {
        let mut by_file: BTreeMap<Uri, Vec<TextEdit>> = BTreeMap::new();
        for edit in edits {
            if self.file(&edit.file).is_none_or(|file| file.of_library) {
                continue;
            }
            if let (Some(uri), Some(text_edit)) = (self.uri(&edit.file), self.text_edit(edit)) {
                by_file.entry(uri).or_default().push(text_edit);
            }
        }
        let capabilities = self.client.capabilities.workspace.as_ref();
        let edit = capabilities.and_then(|workspace| workspace.workspace_edit.as_ref());
        if !edit.and_then(|edit| edit.document_changes).unwrap_or(false) {
            return WorkspaceEdit {
                changes: Some(by_file.into_iter().collect()),
                ..WorkspaceEdit::default()
            };
        }
        let documents = by_file.into_iter().map(|(uri, edits)| {
            let version = self.version(&uri);
            TextDocumentEdit {
                text_document: OptionalVersionedTextDocumentIdentifier { uri, version },
                edits: edits.into_iter().map(OneOf::Left).collect(),
            }
        });
        let documents = Some(DocumentChanges::Edits(documents.collect()));
        WorkspaceEdit { document_changes: documents, ..WorkspaceEdit::default() }
    }
}
