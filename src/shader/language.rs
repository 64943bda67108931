//! The languages, and what each has in which format.

use super::ShaderError;
use super::function::Program;
use super::number::Digits;
use crate::bound::Format;
use core::fmt;

/// A language that pieces are emitted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Language {
    /// Rust, edition 2024, with nothing but `std`.
    Rust,
    /// WebGPU's shading language.
    Wgsl,
    /// GLSL 4.50.
    Glsl,
    /// HLSL, shader model 6.0.
    Hlsl,
    /// Metal, version 2.0.
    Msl,
    /// C99 with its mathematical library.
    C,
}

impl Language {
    /// All six.
    pub const ALL: [Language; 6] =
        [Language::Rust, Language::Wgsl, Language::Glsl, Language::Hlsl, Language::Msl, Language::C];

    /// The name on the command line.
    ///
    /// ```
    /// use bellfit::shader::Language;
    /// assert_eq!(Language::ALL.map(Language::id), ["rust", "wgsl", "glsl", "hlsl", "msl", "c"]);
    /// ```
    pub const fn id(self) -> &'static str {
        match self {
            Language::Rust => "rust",
            Language::Wgsl => "wgsl",
            Language::Glsl => "glsl",
            Language::Hlsl => "hlsl",
            Language::Msl => "msl",
            Language::C => "c",
        }
    }

    /// The language with this [`id`](Self::id), exactly spelt; `None` if there is none.
    ///
    /// ```
    /// use bellfit::shader::Language;
    /// assert_eq!(Language::from_id("wgsl"), Some(Language::Wgsl));
    /// assert_eq!(Language::from_id("WGSL"), None);
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.id() == id)
    }

    /// The formats that it is offered in.
    ///
    /// ```
    /// use bellfit::{bound::Format, shader::Language};
    /// assert_eq!(Language::Wgsl.formats(), [Format::Half, Format::Single]);
    /// ```
    pub const fn formats(self) -> &'static [Format] {
        match self {
            Language::Rust | Language::C | Language::Glsl | Language::Hlsl => {
                &[Format::Single, Format::Double]
            }
            Language::Wgsl => &[Format::Half, Format::Single],
            Language::Msl => &[Format::Single],
        }
    }

    /// Whether it is a shading language.
    pub(super) const fn is_shading(self) -> bool {
        !matches!(self, Language::Rust | Language::C)
    }
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

/// A language with a format that it has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Target {
    pub language: Language,
    pub format: Format,
}

/// Functions that GLSL and HLSL have for `float` alone.
const SINGLE_ONLY: [&str; 4] = ["exp", "exp2", "log2", "pow"];

impl Target {
    pub fn new(language: Language, format: Format) -> Result<Self, ShaderError> {
        if language.formats().contains(&format) {
            return Ok(Target { language, format });
        }
        let offered = match language {
            Language::Wgsl => "f16, f32",
            Language::Msl => "f32",
            _ => "f32, f64",
        };
        Err(ShaderError::Format { language, format: format.id(), offered })
    }

    /// The format of what depends on n alone.
    pub fn wide(self) -> Format {
        if self.format == Format::Double { Format::Double } else { Format::Single }
    }

    /// The digits of numbers in the lobe's own arithmetic.
    pub fn digits(self) -> Digits {
        Digits(self.format)
    }

    /// The digits of numbers in what depends on n alone.
    pub fn wide_digits(self) -> Digits {
        Digits(self.wide())
    }

    /// An elementary function that the program needs and the language lacks in this format.
    pub fn missing(self, program: &Program) -> Option<&'static str> {
        if !self.language.is_shading() || self.format != Format::Double {
            return None;
        }
        SINGLE_ONLY.into_iter().find(|name| program.calls(name))
    }
}
