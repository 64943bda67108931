//! Words: each names one thing, exactly as it is spelt, and no other word does.

use crate::holds;
use bellfit::bound::Format;
use bellfit::filter::{AxesKind, Reduction, Rim, Wrap};
use bellfit::fit::{FactorForm, Form, Objective};
use bellfit::integral::albedo::Usage;
use bellfit::integral::{Limit, Lobe};
use bellfit::kernel::model::Model;
use bellfit::kernel::stand_in::StandIn;
use bellfit::scene::{Technique, weight_from_id, weight_ids};
use bellfit::shader::Language;
use bellfit::trade::{Place, Subject};
use proptest::prelude::*;

/// Whether a reader gives back a word's own name.
type Reads = Box<dyn Fn(&str) -> Option<String>>;

fn readers() -> Vec<(&'static str, Vec<String>, Reads)> {
    macro_rules! of {
        ($($name:ident: $all:expr),+ $(,)?) => {
            vec![$((
                stringify!($name),
                $all.into_iter().map(|one| one.id().to_string()).collect(),
                Box::new(|word: &str| $name::from_id(word).map(|one| one.id().to_string())) as Reads,
            )),+]
        };
    }
    let mut all = of! {
        Model: Model::ALL, StandIn: StandIn::ALL, Lobe: Lobe::ALL, Limit: Limit::ALL, Usage: Usage::ALL,
        Objective: Objective::ALL, Form: Form::ALL, FactorForm: FactorForm::ALL, Format: Format::ALL,
        Wrap: Wrap::ALL, AxesKind: AxesKind::ALL, Rim: Rim::ALL, Reduction: Reduction::ALL, Place: Place::ALL,
        Language: Language::ALL, Subject: Subject::all(),
    };
    let techniques = Technique::all().into_iter().map(|technique| technique.id).collect();
    all.push(("Technique", techniques, Box::new(|word| Technique::from_id(word).map(|found| found.id))));
    // A weight has no name of its own: that it is one is all there is to see.
    let weight = |word: &str| weight_from_id(word, 0.5).map(|_| word.to_owned());
    all.push(("weight", weight_ids(), Box::new(weight)));
    all
}

#[test]
fn every_name_reads_back_and_stands_once() {
    for (kind, names, read) in readers() {
        assert!(!names.is_empty(), "{kind}");
        for (i, name) in names.iter().enumerate() {
            assert_eq!(read(name).as_ref(), Some(name), "{kind}");
            assert!(!names[..i].contains(name), "{kind}: {name} twice");
        }
    }
}

#[test]
fn no_other_word_is_one() {
    let readers = readers();
    let all: Vec<String> = readers.iter().flat_map(|(_, names, _)| names.clone()).collect();
    let word = (proptest::sample::select(all), 0..6_u8, any::<u16>()).prop_map(|(word, change, at)| {
        let at = usize::from(at) % word.len();
        match change {
            0 => word.to_uppercase(),
            1 => format!("{word} "),
            2 => word[..at].to_owned(),
            3 => format!("{}{}", &word[..at], &word[at + 1..]),
            4 => format!("{}-{}", &word[..at], &word[at..]),
            _ => word,
        }
    });
    holds(30, 1500, word, |word| {
        for (kind, names, read) in &readers {
            let expected = names.contains(&word).then(|| word.clone());
            // One-sided objectives are words of the command line beside the others.
            if *kind != "Objective" || expected.is_some() {
                prop_assert_eq!(read(&word), expected, "{}", kind);
            }
        }
        Ok(())
    });
}
