//! The glue between the page and its solver: `xtask-web WASM FOLDER` writes the script, its types and the solver into the folder.

use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [solver, folder] = &arguments[..] else {
        eprintln!("usage: xtask-web WASM FOLDER");
        return ExitCode::from(2);
    };
    let mut glue = Bindgen::new();
    glue.input_path(solver).typescript(true).omit_default_module_path(true).remove_producers_section(true);
    let written = glue.web(true).and_then(|glue| glue.generate(folder));
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask-web: {error:#}");
            ExitCode::FAILURE
        }
    }
}
