//! The schema, the example and the JSON of claims files: each names all there is.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/own_claims.rs"]
mod own_claims;

use bellfit::paper::schema::SCHEMA;
use bellfit::paper::{ClaimedLobe, ClaimsFile, EXAMPLE, Kind, LOBE_PAPER, PIXEL_PAPER};
use bellfit::report::judgements_json;
use own_claims::{file, judge};
use std::collections::BTreeSet;

/// Every kind that the reader knows is in the schema with a heading or a row of its own, and no other is read.
#[test]
fn the_schema_names_every_kind_and_every_lobe() {
    let named =
        |id: &str| SCHEMA.contains(&format!("## `{id}`")) || SCHEMA.contains(&format!("\n| `{id}` |"));
    for id in Kind::IDS {
        assert!(named(id), "{id} is not in the schema");
        let bare = file(&[]) + &format!("[[claim.reading]]\nid = \"a\"\nkind = \"{id}\"\n");
        let read = ClaimsFile::parse(&bare);
        assert!(!read.is_err_and(|error| error.message.contains("unknown kind")), "{id} is not read");
    }
    let unknown = file(&[]) + "[[claim.reading]]\nid = \"a\"\nkind = \"nonsense\"\n";
    let error = ClaimsFile::parse(&unknown).unwrap_err();
    assert!(Kind::IDS.iter().all(|id| error.message.contains(id)), "{error}");
    let mut seen = BTreeSet::new();
    for text in [LOBE_PAPER, PIXEL_PAPER, EXAMPLE] {
        for reading in ClaimsFile::parse(text).unwrap().claims.iter().flat_map(|claim| &claim.readings) {
            assert!(Kind::IDS.contains(&reading.kind.id()));
            seen.insert(reading.kind.id());
        }
    }
    assert_eq!(
        seen.len(),
        Kind::IDS.len(),
        "{:?}",
        Kind::IDS.iter().filter(|id| !seen.contains(*id)).collect::<Vec<_>>()
    );
    for id in ClaimedLobe::IDS {
        assert!(SCHEMA.contains(&format!("`{id}`")), "{id}");
    }
}

/// Every field of the JSON is in the schema, and its version; the fields of a refuted reading are as they were.
#[test]
fn the_json_is_the_one_described() {
    let found = judge(&[
        "model = \"phong\"\nlobe = \"cs16\"\nfactor = \"1.0725*n/(2*pi)\"\nn = \"16..inf\"\nbound = \"1e-3\""
            .to_owned(),
        "model = \"blinn-phong\"\nlobe = \"cs16\"\nfactor = \"n/(8*pi)\"\nn = \"16..64\"\nbound = \"1e-12\""
            .to_owned(),
    ]);
    let json: serde_json::Value = serde_json::from_str(&judgements_json(&found).unwrap()).unwrap();
    fn fields(value: &serde_json::Value, found: &mut BTreeSet<String>) {
        match value {
            serde_json::Value::Object(object) => object.iter().for_each(|(key, value)| {
                found.insert(key.clone());
                fields(value, found);
            }),
            serde_json::Value::Array(list) => list.iter().for_each(|value| fields(value, found)),
            _ => {}
        }
    }
    let mut all = BTreeSet::new();
    fields(&json, &mut all);
    let (_, described) = SCHEMA.split_once("# The verdicts as JSON").unwrap();
    assert!(all.iter().all(|key| described.contains(key.as_str())), "{all:?}");
    let first = &json["judgements"][0];
    assert_eq!(json["version"], 1);
    assert_eq!(
        (&first["verdict"], &first["kind"], &first["stated"]),
        (&"refuted".into(), &"normalisation".into(), &"|residual| ≤ 1e-3".into())
    );
    // 1.0725 · 16/17 - 1, and 1.0625 · 16/17 = 1.
    let exact = 1.0725 * 16.0 / 17.0 - 1.0;
    for end in ["lo", "hi"] {
        assert!((first["computed"][end].as_f64().unwrap() - exact).abs() < 1e-12);
        assert!((first["residual"]["max"][end].as_f64().unwrap() - exact).abs() < 1e-12);
        assert!(first["nearest"]["max"][end].as_f64().unwrap().abs() < 1e-12);
    }
    assert_eq!(
        (&first["nearest"]["factor"], &first["nearest"]["digits_changed"]),
        (&"1.0625*n/(2*pi)".into(), &1.into())
    );
    assert!(first["residual"]["n_to"].is_null() && first["residual"]["n_from"] == 16.0);
    assert_eq!(first["demands"][0]["demand"], "bound");
    assert_eq!(json["judgements"][1]["ruled_out"][0]["form"], "proportional");
}

/// Every key of the example is explained: beside it, or in a comment.
#[test]
fn the_example_explains_its_keys() {
    let comments: String =
        EXAMPLE.lines().filter_map(|line| line.split_once('#')).map(|(_, c)| c.to_owned() + "\n").collect();
    let mut keys = BTreeSet::new();
    for line in EXAMPLE.lines().filter(|line| !line.starts_with('#')) {
        let Some((key, rest)) = line.split_once(" = ") else { continue };
        if rest.contains('#') || comments.contains(key) {
            keys.insert(key.trim().to_owned());
        }
    }
    for line in EXAMPLE.lines().filter(|line| !line.starts_with([' ', '#'])) {
        if let Some((key, _)) = line.split_once(" = ") {
            assert!(keys.contains(key), "{key} is not explained");
        }
    }
    let first = EXAMPLE.find("kind = ").map(|at| &EXAMPLE[at..]).unwrap();
    assert!(first.starts_with("kind = \"normalisation\""), "the new kind comes first");
}
