//! The binary itself. (Having a test here also makes `cargo test` build the binary that the tests of
//! the whole drive.)

use std::process::Command;

#[test]
fn it_tells_its_version() {
    let output = Command::new(env!("CARGO_BIN_EXE_sonarium"))
        .arg("--version")
        .output()
        .expect("the binary can be started");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success());
    assert!(said.starts_with(&format!("sonarium {}", env!("CARGO_PKG_VERSION"))), "{said}");
}
