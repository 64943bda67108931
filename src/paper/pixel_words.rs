//! The words that readings of statements about pixels choose from.

use crate::bound::{ClippedPixel, Interval};

/// Words of a claims file, each with its meaning.
macro_rules! words {
    ($(#[$about:meta])* $name:ident { $($(#[$doc:meta])* $word:ident = $id:literal,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name { $($(#[$doc])* $word,)+ }

        impl $name {
            /// All of them.
            pub const ALL: &'static [$name] = &[$($name::$word,)+];

            /// The word in claims files.
            pub const fn id(self) -> &'static str {
                match self { $($name::$word => $id,)+ }
            }
        }
    };
}

words! {
    /// A sign lost in print.
    Sign {
        /// Plus.
        Plus = "+",
        /// Minus.
        Minus = "-",
    }
}

words! {
    /// The signs of U sin α and V cos α in v₁.
    SignPair {
        /// -U sin α + V cos α.
        MinusPlus = "-+",
        /// U sin α + V cos α.
        PlusPlus = "++",
        /// U sin α - V cos α.
        PlusMinus = "+-",
        /// -U sin α - V cos α.
        MinusMinus = "--",
    }
}

words! {
    /// The polygon's denominator D x + E y + F.
    Denominator {
        /// D = E = 0.
        Constant = "constant",
        /// Any.
        Any = "any",
    }
}

words! {
    /// The circle on the screen whose image the conic is said to be.
    Base {
        /// Of radius 1.
        Radius = "radius-1",
        /// Of diameter 1.
        Diameter = "diameter-1",
    }
}

words! {
    /// Where a weight is looked at.
    Region {
        /// On and within the ellipse, Q ≤ 1.
        Ellipse = "ellipse",
        /// Everywhere.
        Plane = "plane",
    }
}

words! {
    /// How the two derivative vectors lie to the ellipse's axes.
    Vectors {
        /// ∂(u,v)/∂x along the major axis, ∂(u,v)/∂y along the minor one.
        MajorX = "major-x",
        /// The other way round.
        MajorY = "major-y",
        /// Neither along an axis.
        Skew = "skew",
    }
}

words! {
    /// The direction of the major axis, between the coordinate axes and the diagonals.
    Octant {
        /// 0° to 45°.
        First = "0..45",
        /// 45° to 90°.
        Second = "45..90",
        /// 90° to 135°.
        Third = "90..135",
        /// 135° to 180°.
        Fourth = "135..180",
        /// 180° to 225°.
        Fifth = "180..225",
        /// 225° to 270°.
        Sixth = "225..270",
        /// 270° to 315°.
        Seventh = "270..315",
        /// 315° to 360°.
        Eighth = "315..360",
    }
}

words! {
    /// What twice the derivative vectors' lengths, L and d, are said to be.
    AxesProperty {
        /// The lengths of the ellipse's axes.
        Lengths = "lengths",
        /// L is not the shorter one.
        Longer = "longer",
        /// π L d/4 is the ellipse's area.
        Area = "area",
        /// L² + d² is the sum of the squares of the axes.
        SumOfSquares = "sum-of-squares",
    }
}

words! {
    /// A number about the bell (8) for which the paper prints none.
    BellFigure {
        /// sup over all x of the distance from e^(-n x²/2), which does not depend on n.
        Sup = "sup",
        /// Volume of the surface of revolution by the Gaussian's.
        Volume = "volume",
        /// Area under the curve by the Gaussian's.
        Area = "area",
        /// The least that sup can be when the n in the bell, and not the Gaussian's, is chosen freely.
        BestSup = "best-sup",
        /// That n.
        BestN = "best-n",
    }
}

words! {
    /// A number about a weight (9).
    WeightFigure {
        /// sup of the distance from the Gaussian.
        Sup = "sup",
        /// Its volume by the whole Gaussian's.
        Volume = "volume",
    }
}

words! {
    /// How (8) is applied to both coordinates.
    Shape {
        /// (1 - c (a² + b²))^8.
        Sum = "sum",
        /// (1 - c a²)^8 (1 - c b²)^8.
        Product = "product",
    }
}

words! {
    /// What a weight (9) is said to have.
    WeightProperty {
        /// The Gaussian's curvature in the middle, so its σ.
        Sigma = "sigma",
        /// 0 on the ellipse, and more within.
        ZeroOnRim = "zero-on-rim",
        /// Both.
        Both = "both",
        /// The Gaussian's volume over the plane.
        Volume = "volume",
    }
}

words! {
    /// What the formula of the clipped volume is said to have.
    ClipProperty {
        /// It is the volume of a part that holds no centre: ½ at 0 and in [0, ½] up to d = ½.
        Volume = "volume",
        /// It falls as d grows to ½.
        Falls = "falls",
        /// Nothing is left at the base, d = ½.
        ZeroAtBase = "zero-at-base",
    }
}

words! {
    /// What a texel on the rim counts.
    RimShare {
        /// The area of its square within the ellipse.
        Area = "area",
        /// The area of its square on one side of a straight edge at the rim's distance.
        HalfPlane = "half-plane",
    }
}

words! {
    /// How the constant term of a fitted formula is found.
    ConstantTerm {
        /// Fitted with the others.
        Free = "free",
        /// Held at its printed value.
        Fixed = "fixed",
    }
}

/// The word of a pixel in claims files, and the pixel.
pub(super) fn pixels() -> [(&'static str, ClippedPixel); 7] {
    let whole = |m: f64| ClippedPixel::Gaussian(Interval::from(m));
    [
        ("gaussian-6", whole(6.0)),
        ("gaussian-6-base", ClippedPixel::GaussianOnBase(6)),
        ("gaussian-5", whole(5.0)),
        ("gaussian-4", whole(4.0)),
        ("disk", ClippedPixel::Bell(0)),
        ("cone", ClippedPixel::Cone),
        ("bell-8", ClippedPixel::Bell(8)),
    ]
}
