//! The report's first page: what it is about, and how its verdicts read.

/// The title, what the kernels are and what was claimed.
pub(super) const INTRODUCTION: &str = "\
# The lobe and the pixel paper, verified

A highlight on a shiny surface is a bump of light, and the oldest formula for it is Phong's cosⁿθ: 1 in the middle, falling to \
0, the narrower the larger the *specular exponent* n. A texture filter weighs texels with another bump, the Gauss curve. Both \
are *bell-shaped kernels*, and both cost a `pow` or an `exp`.

Two papers (in Ukrainian) put cheap compact bells in their place: a \
polynomial that is squared four times and cut off where it reaches 0. The *lobe paper* writes cs_16 = (n/16 (cos θ - 1) + 1)^16 for cosⁿθ \
and gives, for six reflection models, the *factor* by which the lobe is to be multiplied so that a surface sends back no more light \
than it gets. The *pixel paper* projects a round Gaussian pixel into the texture, where it is an ellipse, and weighs the texels \
inside with such a bell. Both state numbers. This report says which of them are right, which are not, and what to use instead.

Everything below is computed by `bellfit`, which integrates, fits and proves; each number stands with all its digits in the \
file that is linked below it, beside the command that remakes it.
";

/// What each verdict means, and the words that recur.
pub(super) const READING: &str = "
## How to read the verdicts

Signs are lost in print and few digits are printed, so a claim may have several *readings*: each is judged by itself. \"= 1.7e-2\" \
means whatever rounds to these digits, 1.65e-2 to 1.75e-2; \"≤ 1.7e-2\" is another statement, and 1.7013e-2 is the one and not the other.

- **proved**: an interval that is guaranteed to hold the true value (an *enclosure*) lies inside what is stated, or exact \
arithmetic shows it; over everything that the row says, such as every real n from 16 to 1024 and every angle.
- **reproduced**: the same, on the weaker evidence of numerical integration with a stated error.
- **refuted**: the enclosure lies outside of what is stated; the *witness* says where.
- **definition**: a convention or a figure; nothing to judge, so it is only computed again.

Of a claim as a whole it is said that it **holds**, that it **does not hold**, or that it **holds under 2 of 6 readings**: two \
ways to read the print make it true, four do not. What holds *vacuously* says nothing, as a negative number is less than any bound, \
and is counted apart; readings that are definitions are not counted.

What follows \"at most\" is rounded up, other numbers to the nearest digit, so the same bound may end in one more. A proved bound stands \
a little above the value itself, by what its search was told to leave; a largest error is one thing up to n = 1024, another for \
every n and a third in the limit n → ∞, and each place says which.

Words that recur: *residual*, how much light is gained (above 0) or lost by a factor, 2π coef(n) Int(n) - 1; *support*, \
where a bell is not 0; *RDF*, *NDF* and *heightfield*, whether the lobe is the reflection itself or the distribution of a rough surface's normals, and how it \
is normalised; *modified*, that the factor times the lobe is the reflectance f itself (else it is f cos θ); *one-sided*, a fit that never gains energy; \
*minimax*, the fit with the least largest error. Where an integral ends is its *limit*: `paper` is 6/√n, `card` √(6/n), `exact-zero` the \
lobe's own zero in θ, `support` its zero in its own angle.
";
