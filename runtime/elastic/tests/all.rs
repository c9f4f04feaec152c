//! Tests of elastic bodies of any shape.
