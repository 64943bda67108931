//! Does my highlight's factor gain energy, where, and which factor of the same form does not?
//!
//! ```sh
//! cargo run --release --example energy -- "(n + 8)/(8*pi)" blinn-phong-modified
//! ```
//! Without arguments: that one, the (n + 8)/8π that stands beside cosⁿ of the half vector in many shaders.

use bellfit::bound::{Formula, Residual};
use bellfit::fit::{FactorForm, Objective, Reals, fit_factor};
use bellfit::integral::{Case, Limit, Lobe};
use bellfit::kernel::model::Model;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let text = arguments.next().unwrap_or_else(|| "(n + 8)/(8*pi)".to_owned());
    let id = arguments.next().unwrap_or_else(|| "blinn-phong-modified".to_owned());
    let model =
        Model::from_id(&id).ok_or_else(|| format!("{id}: none of {:?}", Model::ALL.map(Model::id)))?;
    let factor: Formula = text.parse()?;
    let (from, to) = (16.0, 1024.0);

    // 2π coef(n) Int(n) - 1: what the highlight reflects of a light along the normal, less what falls in. Enclosed over
    // every real n, so the ends are proved.
    let case = Case { model, lobe: Lobe::CosN, limit: Limit::Support };
    let residual = Residual::new(case, &factor).over_reals(from, to);
    println!("cosⁿ as {}, coef(n) = {text}, n from {from} to {to}", model.title());
    println!(
        "  energy gained, at most:  {:+.4} % (n = {:.1})",
        100.0 * residual.max.value.hi(),
        residual.max.n
    );
    println!(
        "  energy gained, at least: {:+.4} % (n = {:.1})",
        100.0 * residual.min.value.lo(),
        residual.min.n
    );

    // The line of six digits that never gains and loses least.
    let range = Reals::new(from, to)?;
    let better = fit_factor(&case, range, FactorForm::Linear, Objective::OneSided, 6)?;
    println!("a line that never gains: coef(n) = {}", better.factor);
    println!("  energy gained, at least: {:+.4} %", 100.0 * better.extremes.min.value.lo());
    Ok(())
}
