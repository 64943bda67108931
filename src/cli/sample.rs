//! `bellfit sample`.

use super::{Outcome, known, print};
use crate::filter::{AxesKind, EllipseFilter, Level, Lookup, Method, Pyramid, Reduction, Rim, Sampler, Wrap};
use crate::kernel::pixel::{Jacobian, Padding};
use crate::report::{SampleRow, sample_json, sample_lines};
use crate::scene::{Image, Transfer, ellipse_axes, near, weight_from_id, weight_ids, weight_sigma};
use anyhow::{Result, anyhow, bail};
use clap::Args;
use std::path::PathBuf;

/// Look a texture up once: the colour under a pixel, by one filter.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  bellfit sample texture.png --at 10.5,20 --jacobian 3,1,-1,2
  bellfit sample texture.png --at 10.5,20 --jacobian 3,1,-1,2 --weight paper-r1 --level 0
  bellfit sample texture.png --at -3,7.25 --jacobian 6,0,0,2 --method trilinear --wrap mirror --json

Positions and derivatives are in texels of level 0, texel centres at +1/2; so are the axes, those of the conic
in level 0. A conic that holds no texel centre, as without area, is read bilinearly and says so (fallback). Printed values are linear light, a
channel each: colours as the file has them, not multiplied by alpha.")]
pub struct Arguments {
    /// The texture: a PNG file.
    #[arg(value_name = "IMAGE")]
    image: PathBuf,
    /// The position under the pixel's middle.
    #[arg(long, value_name = "S,T", allow_hyphen_values = true, value_parser = numbers::<2>)]
    at: [f64; 2],
    /// The derivatives along the screen: (UX, VX) = ∂(u,v)/∂x, (UY, VY) = ∂(u,v)/∂y.
    #[arg(long, value_name = "UX,VX,UY,VY", allow_hyphen_values = true, value_parser = numbers::<4>)]
    jacobian: [f64; 4],
    /// nearest, bilinear, trilinear or ellipse: the weighted mean of the texels under the pixel.
    #[arg(long, value_name = "METHOD", default_value = "ellipse", value_parser = method)]
    method: Kind,
    /// The ellipse's weight: gaussian, box, paper-r1 to paper-r4 (readings of the pixel paper's), the same
    /// with -product, bell-2 to bell-64, cubic-2, cubic-4 or cubic-8; gaussian if not given.
    #[arg(long, value_name = "WEIGHT", value_parser = weight)]
    weight: Option<String>,
    /// The weight's standard deviation as a fraction of the semi-axis; 1/3 if not given, the paper's L/6.
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    sigma: Option<f32>,
    /// What stands beyond the edges: repeat, clamp or mirror.
    #[arg(long, value_name = "WRAP", default_value = "repeat", value_parser = wrap)]
    wrap: Wrap,
    /// plain or padded by one texel of the level that is read; plain if not given.
    #[arg(long, value_name = "CONIC", value_parser = conic)]
    conic: Option<Padding>,
    /// The ellipse's axes: conic, or the paper's with either tilt, paper-vector or paper-conic; conic if not
    /// given.
    #[arg(long, value_name = "AXES", value_parser = axes)]
    axes: Option<AxesKind>,
    /// Longest ratio of the axes, 1 or more: a longer ellipse is widened; without it there is no limit.
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    anisotropy: Option<f32>,
    /// How texels on the ellipse's rim count: none (whole where Q ≤ 1 at the centre), area, half-plane or
    /// volume; none if not given.
    #[arg(long, value_name = "RIM", value_parser = rim)]
    rim: Option<Rim>,
    /// Diameter of the pixel's base: 2 pixels, the conic as the paper prints it, or 1, as its words say; 2 if
    /// not given.
    #[arg(long, value_name = "D", allow_hyphen_values = true, value_parser = diameter)]
    diameter: Option<u8>,
    /// The mip level that is read, 0 the image itself; without it the method's own rule.
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = level)]
    level: Option<usize>,
    /// How the coarser levels are made: box or kaiser; box if not given.
    #[arg(long, value_name = "FILTER", value_parser = reduction)]
    filter: Option<Reduction>,
    /// Take the file's values as they are, not as sRGB.
    #[arg(long)]
    linear: bool,
    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

/// A method without its parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Nearest,
    Bilinear,
    Trilinear,
    Ellipse,
}

impl Kind {
    const ALL: [Kind; 4] = [Kind::Nearest, Kind::Bilinear, Kind::Trilinear, Kind::Ellipse];

    fn id(self) -> &'static str {
        match self {
            Kind::Nearest => "nearest",
            Kind::Bilinear => "bilinear",
            Kind::Trilinear => "trilinear",
            Kind::Ellipse => "ellipse",
        }
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Outcome> {
    refuse_useless(arguments)?;
    let method = arguments.method()?;
    let transfer = if arguments.linear { Transfer::Linear } else { Transfer::Srgb };
    let image = Image::read(&arguments.image, transfer)?;
    let named = |error: &dyn std::fmt::Display| anyhow!("{}: {error}", arguments.image.display());
    let reduction = arguments.filter.unwrap_or(Reduction::Box);
    let pyramid = Pyramid::new(image.texture().map_err(|e| named(&e))?, reduction, arguments.wrap);
    let level = match arguments.level {
        Some(level) if level >= pyramid.levels() => {
            bail!("--level {level}: the image has levels 0 to {}", pyramid.levels() - 1)
        }
        Some(level) => Level::Fixed(level),
        None => Level::Auto,
    };
    let [ux, vx, uy, vy] = arguments.jacobian;
    let j = Jacobian { ux, vx, uy, vy }.scaled(0.5 * f64::from(arguments.diameter.unwrap_or(2)));
    let single = |x: f64| x as f32;
    let narrow = Jacobian { ux: single(j.ux), vx: single(j.vx), uy: single(j.uy), vy: single(j.vy) };
    let [s, t] = arguments.at;
    let (s, t) =
        (near(arguments.wrap, s, image.width() as f64), near(arguments.wrap, t, image.height() as f64));
    let sampler = Sampler::new(&pyramid, arguments.wrap, method)?;
    let lookup = sampler.lookup_at(single(s), single(t), narrow, level);
    if let Lookup { refused: true, level, .. } = lookup {
        bail!("--level {level}: the ellipse has more than 2^28 texels there; a coarser level has fewer");
    }
    let filter = match method {
        Method::Ellipse(filter) => Some(filter),
        _ => None,
    };
    let row = SampleRow {
        lookup,
        channels: image.channels(),
        axes: ellipse_axes(j, filter.as_ref()),
        method: arguments.method.id(),
        weight: arguments.weight_id(),
        filter,
    };
    print(&if arguments.json { sample_json(&row)? } else { sample_lines(&row) })?;
    Ok(Outcome::AsExpected)
}

/// An option that changes nothing is an error of its giver.
fn refuse_useless(arguments: &Arguments) -> Result<()> {
    if arguments.method != Kind::Ellipse {
        let given = [
            ("--weight", arguments.weight.is_some()),
            ("--sigma", arguments.sigma.is_some()),
            ("--conic", arguments.conic.is_some()),
            ("--axes", arguments.axes.is_some()),
            ("--anisotropy", arguments.anisotropy.is_some()),
            ("--rim", arguments.rim.is_some()),
            ("--diameter", arguments.diameter.is_some()),
        ];
        if let Some((option, _)) = given.iter().find(|(_, given)| *given) {
            bail!("{option}: of no use with --method {}, only with ellipse", arguments.method.id());
        }
    }
    let reads_one_level = matches!(arguments.method, Kind::Nearest | Kind::Bilinear);
    if arguments.filter.is_some()
        && (arguments.level == Some(0) || reads_one_level && arguments.level.is_none())
    {
        bail!("--filter: of no use where level 0 alone is read");
    }
    Ok(())
}

impl Arguments {
    fn weight_id(&self) -> Option<&str> {
        (self.method == Kind::Ellipse).then_some(self.weight.as_deref().unwrap_or("gaussian"))
    }

    fn method(&self) -> Result<Method> {
        Ok(match self.method {
            Kind::Nearest => Method::Nearest,
            Kind::Bilinear => Method::Bilinear,
            Kind::Trilinear => Method::Trilinear,
            Kind::Ellipse => {
                let id = self.weight_id().unwrap_or_default();
                let weight = weight_from_id(id, self.sigma.unwrap_or(1.0 / 3.0))
                    .ok_or_else(|| anyhow!("--weight {id}: unknown"))?;
                if self.sigma.is_some() && weight_sigma(weight).is_none() {
                    bail!("--sigma: the weight {id} has no standard deviation to choose");
                }
                let filter = EllipseFilter {
                    weight,
                    padding: self.conic.unwrap_or(Padding::Plain),
                    axes: self.axes.unwrap_or(AxesKind::True),
                    anisotropy: self.anisotropy.unwrap_or(f32::INFINITY),
                    rim: self.rim.unwrap_or(Rim::None),
                    ..EllipseFilter::default()
                };
                filter.check()?;
                Method::Ellipse(filter)
            }
        })
    }
}

/// Farthest position and longest derivative.
const FAR: f64 = 1e9;

/// So many numbers, separated by commas.
fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let problem = || format!("{N} numbers of -1e9 to 1e9, separated by commas, are needed");
    let read = |word: &str| word.trim().parse::<f64>().ok().filter(|x| x.abs() <= FAR).ok_or_else(problem);
    let numbers = text.split(',').map(read).collect::<Result<Vec<f64>, String>>()?;
    numbers.try_into().map_err(|_| problem())
}

fn level(word: &str) -> Result<usize, String> {
    word.parse().map_err(|_| "a level is a whole number, 0 for the image itself".to_owned())
}

fn diameter(word: &str) -> Result<u8, String> {
    known(word.parse().ok().filter(|d| (1..=2).contains(d)), ["1", "2"])
}

fn method(word: &str) -> Result<Kind, String> {
    known(Kind::ALL.into_iter().find(|kind| kind.id() == word), Kind::ALL.map(Kind::id))
}

fn weight(word: &str) -> Result<String, String> {
    let all = weight_ids();
    known(all.iter().find(|id| *id == word).cloned(), all.iter().map(String::as_str))
}

fn wrap(word: &str) -> Result<Wrap, String> {
    known(Wrap::from_id(word), Wrap::ALL.map(Wrap::id))
}

fn conic(word: &str) -> Result<Padding, String> {
    let found = match word {
        "plain" => Some(Padding::Plain),
        "padded" => Some(Padding::Padded),
        _ => None,
    };
    known(found, ["plain", "padded"])
}

fn axes(word: &str) -> Result<AxesKind, String> {
    known(AxesKind::from_id(word), AxesKind::ALL.map(AxesKind::id))
}

fn rim(word: &str) -> Result<Rim, String> {
    known(Rim::from_id(word), Rim::ALL.map(Rim::id))
}

fn reduction(word: &str) -> Result<Reduction, String> {
    known(Reduction::from_id(word), Reduction::ALL.map(Reduction::id))
}
