//! The shared text as WGSL, C or Rust.

use super::Language;
use super::function::{Function, Item, Program, Record, Statement, Type};
use super::language::Target;
use crate::bound::Format;
use core::fmt::Write;

/// Width of a comment line.
const WIDTH: usize = 100;

/// The whole program. For GLSL, HLSL and MSL the WGSL that naga reads, without comments.
pub(super) fn text(program: &Program, target: Target) -> String {
    let speller = Speller { target };
    let mut text = speller.header(program);
    for (i, item) in program.items().iter().enumerate() {
        if i > 0 {
            text.push('\n');
        }
        if !matches!(target.language, Language::Glsl | Language::Hlsl | Language::Msl) {
            text.push_str(&comment(item, target.language));
        }
        match item {
            Item::Record(record) => speller.record(record, &mut text),
            Item::Function(function) => speller.function(function, &mut text),
        }
    }
    text
}

/// An item's comment, in ASCII: not every compiler of a shading language reads more.
pub(super) fn comment(item: &Item, language: Language) -> String {
    let mark = if language == Language::Rust { "///" } else { "//" };
    let mut text = String::new();
    let mut about = item.about().to_vec();
    if let (Item::Record(record), Language::Glsl | Language::Hlsl | Language::Msl) = (item, language) {
        // naga drops what stands beside the fields.
        let fields = record.fields.iter().map(|(field, meaning)| format!("{field}: {meaning}"));
        about.push(format!("Fields: {}.", fields.collect::<Vec<_>>().join("; ")));
    }
    let generator = format!("Generator: {} {}.", env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION"));
    for paragraph in about.iter().chain([&generator]) {
        let mut line = mark.to_owned();
        for word in ascii(paragraph).split_whitespace() {
            if line.len() > mark.len() && line.len() + 1 + word.len() > WIDTH {
                let _ = writeln!(text, "{line}");
                line = format!("{mark}  ");
            }
            line.push(' ');
            line.push_str(word);
        }
        let _ = writeln!(text, "{line}");
    }
    text
}

/// ASCII for what comments hold; anything else becomes `?`. No line may end in a backslash, which would join
/// the next to the comment.
fn ascii(text: &str) -> String {
    let mut plain = String::new();
    for c in text.chars() {
        match c {
            'θ' => plain.push_str("theta"),
            'π' => plain.push_str("pi"),
            'σ' => plain.push_str("sigma"),
            'ε' => plain.push_str("epsilon"),
            'α' => plain.push_str("alpha"),
            'β' => plain.push_str("beta"),
            'ⁿ' => plain.push_str("^n"),
            '²' => plain.push_str("^2"),
            '³' => plain.push_str("^3"),
            '≤' => plain.push_str("<="),
            '≥' => plain.push_str(">="),
            '→' => plain.push_str("->"),
            '∞' => plain.push_str("infinity"),
            '√' => plain.push_str("sqrt "),
            '½' => plain.push_str("1/2"),
            '·' => plain.push('*'),
            '−' | '–' => plain.push('-'),
            '\\' => plain.push('/'),
            c if c.is_ascii_graphic() => plain.push(c),
            c if c.is_whitespace() => plain.push(' '),
            _ => plain.push('?'),
        }
    }
    plain
}

struct Speller {
    target: Target,
}

impl Speller {
    fn header(&self, program: &Program) -> String {
        let mut header = String::new();
        match self.target.language {
            Language::C => {
                header.push_str("#include <math.h>\n");
                if program.counts() {
                    header.push_str("#include <stdint.h>\n");
                }
                header.push('\n');
            }
            Language::Rust => {}
            _ if self.target.format == Format::Half => header.push_str("enable f16;\n\n"),
            _ => {}
        }
        header
    }

    fn number(&self, format: Format) -> &'static str {
        match (self.target.language, format) {
            (Language::C, Format::Double) => "double",
            (Language::C, _) => "float",
            (_, Format::Half) => "f16",
            (_, Format::Double) => "f64",
            _ => "f32",
        }
    }

    fn name(&self, ty: &Type) -> String {
        match ty {
            Type::Real => self.number(self.target.format).to_owned(),
            Type::Wide => self.number(self.target.wide()).to_owned(),
            Type::Count if self.target.language == Language::C => "uint32_t".to_owned(),
            Type::Count => "u32".to_owned(),
            Type::Record(name) => name.clone(),
        }
    }

    fn record(&self, record: &Record, text: &mut String) {
        let real = self.name(&Type::Real);
        let is_c = self.target.language == Language::C;
        let _ = match self.target.language {
            Language::C => writeln!(text, "typedef struct {{"),
            Language::Rust => writeln!(text, "#[derive(Clone, Copy, Debug)]\npub struct {} {{", record.name),
            _ => writeln!(text, "struct {} {{", record.name),
        };
        for (field, meaning) in &record.fields {
            let meaning = ascii(meaning);
            let _ = match self.target.language {
                Language::C => writeln!(text, "    {real} {field}; // {meaning}"),
                Language::Rust => writeln!(text, "    /// {meaning}\n    pub {field}: {real},"),
                _ => writeln!(text, "    {field}: {real}, // {meaning}"),
            };
        }
        let _ = if is_c { writeln!(text, "}} {};", record.name) } else { writeln!(text, "}}") };
    }

    fn function(&self, function: &Function, text: &mut String) {
        let is_c = self.target.language == Language::C;
        let parameters: Vec<String> = function
            .parameters
            .iter()
            .map(|(name, ty)| {
                let ty = self.name(ty);
                if is_c { format!("{ty} {name}") } else { format!("{name}: {ty}") }
            })
            .collect();
        let (parameters, result) = (parameters.join(", "), self.name(&function.result));
        let _ = match self.target.language {
            Language::C => writeln!(text, "static inline {result} {}({parameters}) {{", function.name),
            Language::Rust => {
                writeln!(text, "#[inline]\npub fn {}({parameters}) -> {result} {{", function.name)
            }
            _ => writeln!(text, "fn {}({parameters}) -> {result} {{", function.name),
        };
        self.block(&function.body, function, 1, text);
        text.push_str("}\n");
    }

    fn block(&self, body: &[Statement], function: &Function, depth: usize, text: &mut String) {
        let indent = "    ".repeat(depth);
        let is_c = self.target.language == Language::C;
        let is_rust = self.target.language == Language::Rust;
        let spell = |value: &str| self.expression(value, &function.arithmetic);
        for (i, statement) in body.iter().enumerate() {
            // The last value of a Rust function is its result.
            let is_tail = is_rust && depth == 1 && i + 1 == body.len();
            let _ = match statement {
                Statement::Let(name, value) if is_c => {
                    let ty = self.name(&function.arithmetic);
                    writeln!(text, "{indent}const {ty} {name} = {};", spell(value))
                }
                // A number alone would be an f32 whatever it is used for.
                Statement::Let(name, value) if !is_rust && value.parse::<f64>().is_ok() => {
                    let ty = self.name(&function.arithmetic);
                    writeln!(text, "{indent}let {name}: {ty} = {value};")
                }
                Statement::Let(name, value) => writeln!(text, "{indent}let {name} = {};", spell(value)),
                Statement::Var(name, ty, value) => {
                    let (ty, value) = (self.name(ty), spell(value));
                    match self.target.language {
                        Language::C => writeln!(text, "{indent}{ty} {name} = {value};"),
                        Language::Rust => writeln!(text, "{indent}let mut {name}: {ty} = {value};"),
                        _ => writeln!(text, "{indent}var {name}: {ty} = {value};"),
                    }
                }
                Statement::Assign(to, value) => writeln!(text, "{indent}{to} {};", spell(value)),
                Statement::If(condition, inner) | Statement::While(condition, inner) => {
                    let word = if matches!(statement, Statement::If(..)) { "if" } else { "while" };
                    let condition = spell(condition);
                    let _ = if is_rust {
                        writeln!(text, "{indent}{word} {condition} {{")
                    } else {
                        writeln!(text, "{indent}{word} ({condition}) {{")
                    };
                    self.block(inner, function, depth + 1, text);
                    writeln!(text, "{indent}}}")
                }
                Statement::Return(value) if is_tail => writeln!(text, "{indent}{}", spell(value)),
                Statement::Return(value) => writeln!(text, "{indent}return {};", spell(value)),
                Statement::ReturnRecord(name, fields) => {
                    let record = self.construct(name, fields, function);
                    if is_tail {
                        writeln!(text, "{indent}{record}")
                    } else {
                        writeln!(text, "{indent}return {record};")
                    }
                }
                Statement::Unused(name) => match self.target.language {
                    Language::C => writeln!(text, "{indent}(void){name};"),
                    Language::Rust => writeln!(text, "{indent}let _ = {name};"),
                    _ => writeln!(text, "{indent}_ = {name};"),
                },
            };
        }
    }

    fn construct(&self, name: &str, fields: &[(&'static str, String)], function: &Function) -> String {
        let narrows = self.target.format == Format::Half && function.arithmetic == Type::Wide;
        let values: Vec<String> = fields
            .iter()
            .map(|(field, value)| {
                let value = self.expression(value, &function.arithmetic);
                match self.target.language {
                    Language::Rust if value == *field => value,
                    Language::Rust => format!("{field}: {value}"),
                    _ if narrows => format!("f16({value})"),
                    _ => value,
                }
            })
            .collect();
        let values = values.join(", ");
        match self.target.language {
            Language::C => format!("({name}){{{values}}}"),
            Language::Rust => format!("{name} {{ {values} }}"),
            _ => format!("{name}({values})"),
        }
    }

    /// Numbers with the language's suffix, functions by the language's names; the rest is the same in all.
    fn expression(&self, text: &str, arithmetic: &Type) -> String {
        let ty = self.name(arithmetic);
        let (mut spelt, mut rest) = (String::new(), text);
        while let Some(first) = rest.chars().next() {
            let length = if first.is_ascii_digit() {
                number_length(rest)
            } else if first.is_alphabetic() || first == '_' {
                rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len())
            } else {
                first.len_utf8()
            };
            let (token, after) = rest.split_at(length);
            if first.is_ascii_digit() {
                spelt.push_str(&self.literal(token, &ty));
            } else if after.starts_with('(') {
                spelt.push_str(&self.callee(token, &ty));
            } else {
                spelt.push_str(token);
            }
            rest = after;
        }
        spelt
    }

    fn literal(&self, token: &str, ty: &str) -> String {
        match self.target.language {
            Language::C if ty == "float" && token.contains(['.', 'e']) => format!("{token}f"),
            Language::Rust => token.trim_end_matches('u').to_owned(),
            _ => token.to_owned(),
        }
    }

    fn callee(&self, name: &str, ty: &str) -> String {
        match (self.target.language, name) {
            (Language::Rust, "pow") => format!("{ty}::powf"),
            (Language::Rust, "log1p") => format!("{ty}::ln_1p"),
            (Language::Rust, "max" | "exp" | "exp2" | "log2" | "cbrt") => format!("{ty}::{name}"),
            (Language::C, "max") => if ty == "float" { "fmaxf" } else { "fmax" }.to_owned(),
            (Language::C, "exp" | "exp2" | "log2" | "log1p" | "pow" | "cbrt") if ty == "float" => {
                format!("{name}f")
            }
            (Language::Rust | Language::C, _) => name.to_owned(),
            _ => name.to_owned(),
        }
    }
}

/// Digits, point, exponent with its sign, and the suffix of a whole number.
fn number_length(text: &str) -> usize {
    let mut before = ' ';
    text.find(|c: char| {
        let goes_on = c.is_ascii_digit() || ".eu".contains(c) || (c == '-' && before == 'e');
        before = c;
        !goes_on
    })
    .unwrap_or(text.len())
}
