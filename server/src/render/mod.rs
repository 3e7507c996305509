//! Pictures.

pub mod view;
