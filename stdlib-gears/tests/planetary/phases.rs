//! Assembly and phasing: which spacings go together, and which harmonics of the mesh turn the sun or move it sideways.
