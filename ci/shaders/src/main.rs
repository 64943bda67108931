//! Runs the emitted WGSL on the machine's adapter, Mesa's software one where there is no other, against the
//! kernels. Exits with 0 when all is within its bounds and with 77 when there is no adapter, having said so;
//! a value out of bounds is a panic.

mod adapter;
mod lobes;
mod measure;
mod pixels;

use adapter::Adapter;
use std::process::ExitCode;

fn main() -> ExitCode {
    let adapter = match Adapter::open() {
        Ok(adapter) => adapter,
        Err(reason) => {
            println!("skipped: no adapter ({reason})");
            return ExitCode::from(77);
        }
    };
    println!("adapter: {}", adapter.name);
    let count = lobes::check(&adapter)
        + pixels::factors(&adapter)
        + pixels::footprints(&adapter)
        + pixels::weights(&adapter);
    println!("{count} values of the emitted WGSL are within their bounds");
    ExitCode::SUCCESS
}
