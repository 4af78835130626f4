// SPDX-License-Identifier: MIT
//! Links the shared library from the folder HRBFNPR_LIB_DIR. If that is not set, the linker searches its folders.
//! Build scripts of crates that depend on this crate find the folder in DEP_HRBFNPR_LIB_DIR.
use std::{env, path::Path, process::Command};

/// The files that linkers take for the library. The last two are import libraries of libhrbfnpr.dll, for MSVC and MinGW.
const NAMES: [&str; 4] = [
    "libhrbfnpr.so",
    "libhrbfnpr.dylib",
    "hrbfnpr.lib",
    "libhrbfnpr.dll.a",
];

/// Returns the minor version of the compiler: 63 for rustc 1.63.0. A compiler that does not tell its version counts as
/// new.
fn compiler() -> u32 {
    let said = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .arg("--version")
        .output();
    let text = said.map_or(String::new(), |output| {
        String::from_utf8_lossy(&output.stdout).into_owned()
    });
    let minor = text
        .split('.')
        .nth(1)
        .and_then(|number| number.parse().ok());
    minor.unwrap_or(u32::MAX)
}

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=HRBFNPR_LIB_DIR");
    if let Some(folder) = env::var_os("HRBFNPR_LIB_DIR") {
        let folder = Path::new(&folder);
        if !NAMES.iter().any(|name| folder.join(name).is_file()) {
            panic!(
                "HRBFNPR_LIB_DIR is {}, where there is none of {}",
                folder.display(),
                NAMES.join(", ")
            );
        }
        println!("cargo:rustc-link-search=native={}", folder.display());
        println!("cargo:lib_dir={}", folder.display());
    }
    println!("cargo:rustc-link-lib=dylib=hrbfnpr");
    for (name, since) in [("hrbfnpr_no_core_c_char", 64), ("hrbfnpr_no_offset_of", 77)] {
        if compiler() < since {
            println!("cargo:rustc-cfg={name}");
        }
        if compiler() >= 80 {
            println!("cargo:rustc-check-cfg=cfg({name})");
        }
    }
}
