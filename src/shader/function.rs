//! The text that all languages share: functions whose expressions are spelt as in WGSL.

use super::ShaderError;

/// A type.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Type {
    /// The format's number.
    Real,
    /// The number in which what depends on n alone is computed: f32 beside f16, else the format's.
    Wide,
    /// A whole number of 32 bits.
    Count,
    /// A structure by its name.
    Record(String),
}

/// A line of a function.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    /// A name for a value of the function's arithmetic.
    Let(&'static str, String),
    /// A variable.
    Var(&'static str, Type, String),
    /// A variable with an assigning operator, and its argument.
    Assign(&'static str, String),
    /// A branch.
    If(String, Vec<Statement>),
    /// A loop.
    While(String, Vec<Statement>),
    /// The result.
    Return(String),
    /// The result, a structure field by field.
    ReturnRecord(String, Vec<(&'static str, String)>),
    /// A parameter that is there for the signature's sake.
    Unused(&'static str),
}

/// A structure of numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Record {
    pub name: String,
    pub about: Vec<String>,
    /// Names and what they are.
    pub fields: Vec<(&'static str, String)>,
}

/// A function.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Function {
    pub name: String,
    /// Paragraphs of its comment.
    pub about: Vec<String>,
    pub parameters: Vec<(&'static str, Type)>,
    pub result: Type,
    /// What its named values are: [`Type::Real`] or [`Type::Wide`].
    pub arithmetic: Type,
    pub body: Vec<Statement>,
}

/// A structure or a function.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Item {
    Record(Record),
    Function(Function),
}

impl Item {
    pub fn name(&self) -> &str {
        match self {
            Item::Record(record) => &record.name,
            Item::Function(function) => &function.name,
        }
    }

    pub fn about(&self) -> &[String] {
        match self {
            Item::Record(record) => &record.about,
            Item::Function(function) => &function.about,
        }
    }
}

/// Items in the order of their definition.
#[derive(Clone, Debug, Default)]
pub(super) struct Program {
    items: Vec<Item>,
}

impl Program {
    /// Adds an item, unless the same is there.
    pub fn add(&mut self, item: Item) -> Result<(), ShaderError> {
        match self.items.iter().find(|known| known.name() == item.name()) {
            Some(known) if *known == item => {}
            Some(_) => return Err(ShaderError::Name(item.name().to_owned())),
            None => self.items.push(item),
        }
        Ok(())
    }

    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Whether some expression calls the function of this name.
    pub fn calls(&self, name: &str) -> bool {
        self.expressions().iter().any(|text| calls(text, name))
    }

    /// Whether some parameter or variable is a whole number.
    pub fn counts(&self) -> bool {
        self.items.iter().any(
            |item| matches!(item, Item::Function(f) if f.parameters.iter().any(|(_, ty)| *ty == Type::Count)),
        )
    }

    fn expressions(&self) -> Vec<&str> {
        let mut found = Vec::new();
        for item in &self.items {
            if let Item::Function(function) = item {
                collect(&function.body, &mut found);
            }
        }
        found
    }
}

fn collect<'a>(body: &'a [Statement], found: &mut Vec<&'a str>) {
    for statement in body {
        match statement {
            Statement::Let(_, value)
            | Statement::Var(_, _, value)
            | Statement::Assign(_, value)
            | Statement::Return(value) => found.push(value),
            Statement::If(condition, inner) | Statement::While(condition, inner) => {
                found.push(condition);
                collect(inner, found);
            }
            Statement::ReturnRecord(_, values) => found.extend(values.iter().map(|(_, v)| v.as_str())),
            Statement::Unused(_) => {}
        }
    }
}

/// Whether the name stands before a parenthesis, as a whole word.
fn calls(text: &str, name: &str) -> bool {
    text.match_indices(name).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let is_start = !before.is_some_and(|c| c.is_alphanumeric() || c == '_');
        is_start && text[at + name.len()..].starts_with('(')
    })
}

/// p^K by squarings of `p`, the last as the result.
pub(super) fn squarings(power: u32) -> Vec<Statement> {
    const NAMES: [&str; 6] = ["p", "squared", "fourth", "eighth", "sixteenth", "thirty_second"];
    let steps = power.trailing_zeros() as usize;
    let mut body: Vec<Statement> =
        (1..steps).map(|i| Statement::Let(NAMES[i], format!("{0} * {0}", NAMES[i - 1]))).collect();
    body.push(Statement::Return(format!("{0} * {0}", NAMES[steps - 1])));
    body
}
