//! The binary; everything is in the library.

fn main() -> std::process::ExitCode {
    sonarium::cli::main()
}
