//! A whole scene's answer.

use super::{Answer, Candidate, Costs, NeedError, Price, SceneNeeds, SurfaceAnswer, Verdict, choose};
use crate::kernel::stand_in::StandIn;

/// A material's answer.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialAnswer {
    /// Its name.
    pub name: String,
    /// Its kernels.
    pub answer: Answer,
    /// Whether the best is within the budget's cost, if there is one.
    pub within_cost: bool,
}

impl MaterialAnswer {
    /// The squarings, where no kernel is cheaper: then no stand-in is needed, and its bound is rounding's.
    pub fn by_squarings(&self) -> Option<&Candidate> {
        let squarings = |c: &&Candidate| c.stand_in == StandIn::Squarings;
        let found = self.answer.qualifying().find(squarings)?;
        let best = self.answer.best()?;
        found.price.order(best.price).is_le().then_some(found)
    }

    /// Whether a kernel qualifies within the cost.
    pub fn is_met(&self) -> bool {
        self.answer.best().is_some() && self.within_cost
    }
}

/// A scene's answer.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneAnswer {
    /// A lobe each, in the file's order.
    pub materials: Vec<MaterialAnswer>,
    /// The one kernel that does for all materials at the least sum of their costs, if there is one.
    pub common: Option<StandIn>,
    /// A texture each, in the file's order.
    pub surfaces: Vec<SurfaceAnswer>,
}

impl SceneAnswer {
    /// Whether every material has its kernel.
    pub fn is_met(&self) -> bool {
        self.materials.iter().all(MaterialAnswer::is_met)
    }
}

impl SceneNeeds {
    /// Asks for every material, and looks at every surface.
    ///
    /// # Errors
    /// [`NeedError`] of the first material that cannot be asked for.
    ///
    /// ```
    /// use bellfit::choose::{Costs, EXAMPLE_NEEDS, SceneNeeds};
    /// let answer = SceneNeeds::parse(EXAMPLE_NEEDS)?.answer(&Costs::default())?;
    /// let chalk = answer.materials.iter().find(|m| m.name == "chalk").expect("a material");
    /// assert!(chalk.by_squarings().is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn answer(&self, costs: &Costs<'_>) -> Result<SceneAnswer, NeedError> {
        let mut materials = Vec::new();
        for material in &self.materials {
            let answer = choose(&material.need, costs)?;
            let within_cost = match (self.most_cost, answer.best().map(|best| best.price)) {
                (Some(most), Some(Price::Operations(cost) | Price::Measured(cost))) => cost <= most,
                _ => true,
            };
            materials.push(MaterialAnswer { name: material.name.clone(), answer, within_cost });
        }
        let surfaces = self.surfaces.iter().map(super::Surface::answer).collect();
        Ok(SceneAnswer { common: common(&materials), materials, surfaces })
    }
}

/// The kernel that qualifies everywhere for the least sum; sums of operations and of nanoseconds are not
/// compared.
fn common(materials: &[MaterialAnswer]) -> Option<StandIn> {
    let sum = |stand_in: StandIn| {
        let mut total: Option<Price> = None;
        for material in materials {
            let here = material.answer.candidates.iter().find(|c| c.stand_in == stand_in)?;
            if here.verdict != Verdict::Qualifies {
                return None;
            }
            total = Some(match (total, here.price) {
                (None, price) => price,
                (Some(Price::Measured(a)), Price::Measured(b)) => Price::Measured(a + b),
                (Some(Price::Operations(a)), Price::Operations(b)) => Price::Operations(a + b),
                _ => return None,
            });
        }
        Some((stand_in, total?))
    };
    StandIn::ALL.into_iter().filter_map(sum).min_by(|a, b| a.1.order(b.1)).map(|(stand_in, _)| stand_in)
}
