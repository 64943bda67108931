//! Claims files: every mistake is told with its place, no text makes the reader panic, and the judge
//! refutes what is planted false and proves what is true.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/draw.rs"]
mod draw;

use bellfit::integral::albedo::{Profile, Reflectance, directional_albedo_plain};
use bellfit::integral::{AGREEMENT, Case, GaussTable, Limit, Lobe, gauss_legendre};
use bellfit::kernel::lobe::cos_n_versine;
use bellfit::kernel::model::Model;
use bellfit::paper::{ClaimsError, ClaimsFile, LOBE_PAPER, PIXEL_PAPER};
use bellfit::verdict::{Evidence, Judge, Judgement, Verdict};
use core::f64::consts::PI;
use draw::Draw;

/// A sound file with one claim of this id and reading (without its `id`).
fn file(claim: &str, reading: &str) -> String {
    format!(
        "version = 1\n\n[[claim]]\nid = \"{claim}\"\npaper = \"π\"\nlocator = \"line 12\"\ntext = \"as printed\"\n\
         [[claim.reading]]\nid = \"one\"\n{reading}\n"
    )
}

const RESIDUAL: &str = r#"kind = "factor-residual"
model = "phong"
factor = "1.063*n/(2*pi)"
limit = ["support", "paper"]
n = "16..1024"
over = "reals"
statistic = "max"
printed = "4.7e-4""#;

/// Reads a text in which ¦ stands where the mistake is, and demands one clear line about it there.
fn assert_mistake(marked: &str, words: &[&str]) {
    let before: Vec<&str> = marked.split('¦').collect();
    assert_eq!(before.len(), 2, "one mark: {marked}");
    let line = before[0].matches('\n').count() + 1;
    let column = before[0].rsplit('\n').next().unwrap().chars().count() + 1;
    let error = ClaimsFile::parse(&before.concat()).unwrap_err();
    assert_eq!((error.line, error.column), (line, column), "{error}\n{marked}");
    check(&error);
    for word in words {
        assert!(error.message.contains(word), "{error}: no {word:?}");
    }
    assert_eq!(error.to_string(), format!("line {line}, column {column}: {}", error.message));
}

fn check(error: &ClaimsError) {
    assert!(error.line >= 1 && error.column >= 1, "{error:?}");
    assert!(!error.message.trim().is_empty() && !error.message.chars().any(char::is_control), "{error:?}");
}

/// The file with the residual's reading, one text of it exchanged.
fn assert_exchange(from: &str, to: &str, words: &[&str]) {
    let sound = file("mine", RESIDUAL);
    assert!(ClaimsFile::parse(&sound).is_ok());
    assert_eq!(sound.matches(from).count(), 1, "{from}");
    assert_mistake(&sound.replace(from, to), words);
}

#[test]
fn what_is_not_known_is_told() {
    assert_exchange("over = ", "¦colour = \"red\"\nover = ", &["colour"]);
    assert_exchange("paper = ", "¦page = 7\npaper = ", &["page"]);
    assert_exchange("[[claim]]\n", "¦title = \"mine\"\n[[claim]]\n", &["title"]);
    assert_exchange("\"factor-residual\"", "¦\"factor-residue\"", &["unknown kind", "factor-residue"]);
    assert_exchange("\"phong\"", "¦\"pong\"", &["model", "pong", "blinn-phong-ndf"]);
    assert_exchange("\"phong\"", "¦[\"phong\", \"pong\"]", &["model", "pong"]);
    assert_exchange("[\"support\", \"paper\"]", "¦\"edge\"", &["limit", "edge", "exact-zero"]);
    assert_exchange("\"reals\"", "¦\"rationals\"", &["over", "rationals", "integers, reals"]);
    assert_exchange("\"max\"", "¦\"mean\"", &["statistic", "mean", "max-abs"]);
    assert_exchange("over = ", "relation = ¦\"<\"\nover = ", &["relation", "<="]);
    assert_exchange("over = ", "lobe = ¦\"cos\"\nover = ", &["lobe", "cos-n, cs16"]);
}

#[test]
fn what_is_missing_is_told() {
    // The kind is known, so what it needs is said at the kind.
    for (key, line) in [
        ("model", "model = \"phong\"\n"),
        ("factor", "factor = \"1.063*n/(2*pi)\"\n"),
        ("limit", "limit = [\"support\", \"paper\"]\n"),
        ("n", "n = \"16..1024\"\n"),
        ("over", "over = \"reals\"\n"),
        ("statistic", "statistic = \"max\"\n"),
    ] {
        let without = file("mine", RESIDUAL).replace(line, "");
        let marked = without.replace("kind = ", "kind = ¦");
        assert_mistake(&marked, &["factor-residual", &format!("`{key}`")]);
    }
    // Fields that every claim or reading has: said at the table that lacks them.
    assert_mistake(
        &file("mine", RESIDUAL).replace("[[claim]]", "¦[[claim]]").replace("paper = \"π\"\n", ""),
        &["paper"],
    );
    let kind = "kind = \"factor-residual\"\n";
    let without = file("mine", RESIDUAL).replace("[[claim.reading]]", "¦[[claim.reading]]").replace(kind, "");
    assert_mistake(&without, &["kind"]);
    assert_mistake("¦", &["version"]);
    assert_mistake("¦[[claim]]\n", &["id"]);
    let bare = "version = 1\n[[claim]]\nid = ¦\"a\"\npaper = \"\"\nlocator = \"\"\ntext = \"\"\n";
    assert_mistake(bare, &["\"a\"", "no reading"]);
}

#[test]
fn what_stands_twice_is_told() {
    let first = file("mine", RESIDUAL);
    let again = file("mine", RESIDUAL).replace("version = 1\n", "").replace("\"mine\"", "¦\"mine\"");
    assert_mistake(&format!("{first}{again}"), &["\"mine\"", "already"]);
    let reading = format!("[[claim.reading]]\nid = ¦\"one\"\n{RESIDUAL}\n");
    assert_mistake(&format!("{first}{reading}"), &["\"one/support\"", "already"]);
    // A list of words can spell another reading's id.
    let reading = format!("[[claim.reading]]\nid = ¦\"one/support\"\n{RESIDUAL}\n");
    let single = reading.replace("[\"support\", \"paper\"]", "\"support\"");
    assert_mistake(&format!("{first}{single}"), &["\"one/support\"", "already"]);
    let twice = file("mine", RESIDUAL).replace("\"paper\"]", "\"support\"]").replace("\"one\"", "¦\"one\"");
    assert_mistake(&twice, &["\"one/support\"", "already"]);
}

#[test]
fn what_does_not_parse_is_told() {
    assert_exchange("version = 1", "version = ¦2", &["version 2", "reads version 1"]);
    assert_exchange("version = 1", "version = ¦\"1\"", &["expected u32"]);
    for bad in ["4.7e", "about 4.7e-4", "", "4,7e-4", "0x10", "4.7·10^-4", "NaN"] {
        assert_exchange("\"4.7e-4\"", &format!("¦\"{bad}\""), &["printed", bad, "not a decimal"]);
    }
    assert_exchange("\"4.7e-4\"", "¦4.7e-4", &["expected a string"]);
    for bad in [
        "1024..16",
        "0..1024",
        "16",
        "16..",
        "..16",
        "16...1024",
        "16..1e3",
        "-1..16",
        "16..9999999",
        "16-1024",
    ] {
        assert_exchange("\"16..1024\"", &format!("¦\"{bad}\""), &[bad, "A..B"]);
    }
    for (bad, why) in [
        ("1.063*m/(2*pi)", "character 7"),
        ("1.063*n/(2*pi", "character 14"),
        ("1.063*n/0", "character "),
        ("n^(n)", "character "),
        ("2^(n*n)", "character "),
        ("n^99", "character "),
        ("", "character 1"),
        ("1.063 n", "character 7"),
    ] {
        assert_exchange("\"1.063*n/(2*pi)\"", &format!("¦\"{bad}\""), &["formula", bad, why]);
    }
    assert_exchange("[\"support\", \"paper\"]", "¦[]", &["limit", "empty"]);
    assert_exchange("[\"support\", \"paper\"]", "¦true", &["a word or a list of words"]);
    // A number is a word, as a power of a bell is.
    assert_exchange("[\"support\", \"paper\"]", "¦7", &["limit", "\"7\"", "known are"]);
    assert_exchange("over = ", "over ¦", &[]);
}

#[test]
fn what_a_kind_has_no_use_for_is_told() {
    assert_exchange("over = ", "a = ¦\"1.063\"\nover = ", &["factor-residual", "no `a`"]);
    assert_exchange("over = ", "cut = ¦\"paper\"\nover = ", &["factor-residual", "no `cut`"]);
    assert_exchange("over = ", "powers = ¦[4, 8]\nover = ", &["factor-residual", "no `powers`"]);
    let off_support = RESIDUAL.replace("kind = ", "lobe = \"cos-n\"\nkind = ¦");
    assert_mistake(&file("mine", &off_support), &["cos-n", "support only"]);
    for (reading, words) in [
        ("kind = ¦\"energy\"", vec!["energy", "`model`"]),
        (
            "kind = \"energy-at-every-angle\"\nmodel = \"phong\"\nuse = ¦\"microfacet\"\nfactor = \"n\"\nn = \"16..64\"",
            vec!["phong", "no use", "microfacet"],
        ),
        (
            "kind = \"energy-at-every-angle\"\nmodel = \"phong\"\nuse = ¦\"normals\"\nfactor = \"n\"\nn = \"16..64\"",
            vec!["use", "normals", "printed, microfacet"],
        ),
        (
            "kind = \"energy-at-every-angle\"\nmodel = \"phong\"\nlimit = ¦\"support\"\nfactor = \"n\"\nn = \"16..64\"",
            vec!["energy-at-every-angle", "no `limit`"],
        ),
        ("kind = ¦\"energy-at-every-angle\"\nmodel = \"phong\"\nn = \"16..64\"", vec!["`factor`"]),
        ("kind = \"bell-falls\"\npowers = ¦[8, 4]", vec!["powers", "ascending"]),
        ("kind = \"bell-falls\"\npowers = ¦[8]", vec!["powers"]),
        ("kind = \"bell-falls\"\npowers = ¦[8, 128]", vec!["powers", "64"]),
        (
            "kind = \"gaussian-falls\"\ngaussian = \"gaussian-angle\"\nn = ¦\"15..64\"",
            vec!["15..64", "n ≥ 16"],
        ),
        (
            "kind = \"cut\"\nform = ¦\"6/n\"\nn = \"16..64\"\nprinted = \"6\"",
            vec!["form", "6/n", "c/sqrt(n)"],
        ),
        (
            "kind = \"cut-effect\"\ncut = \"paper\"\nn = \"16..64\"\ncompared = ¦\"more\"",
            vec!["compared", "more"],
        ),
        (
            "kind = \"fit\"\nmodel = \"phong\"\nlimit = \"paper\"\nobjective = ¦\"minimax\"\nform = \"proportional\"\nn = \"16..64\"\na = \"1\"",
            vec!["objective", "minimax"],
        ),
        (
            "kind = \"fit\"\nmodel = \"phong\"\nlimit = \"paper\"\nobjective = \"ls-relative\"\nform = \"proportional\"\nn = \"16..64\"\na = \"1\"\nb = ¦\"1\"",
            vec!["fit", "no `b`"],
        ),
        (
            "kind = ¦\"fit\"\nmodel = \"phong\"\nlimit = \"paper\"\nobjective = \"ls-relative\"\nform = \"linear\"\nn = \"16..64\"\na = \"1\"",
            vec!["fit", "`b`"],
        ),
    ] {
        assert_mistake(&file("mine", reading), &words);
    }
}

/// A message is one line whatever the file quotes.
#[test]
fn quoted_line_breaks_do_not_break_the_message() {
    for broken in ["\"ener\\ngy\"", "\"\"\"ener\ngy\"\"\"", "\"ener\\u001b[31mgy\"", "\"a\\rb\""] {
        let error = ClaimsFile::parse(&file("mine", &format!("kind = {broken}"))).unwrap_err();
        check(&error);
    }
    let doubled = file("a\\nb", RESIDUAL) + &file("a\\nb", RESIDUAL).replace("version = 1\n", "");
    check(&ClaimsFile::parse(&doubled).unwrap_err());
}

#[test]
fn no_mutation_of_a_file_makes_the_reader_panic() {
    let mut draw = Draw(300);
    let inserts: Vec<char> = "\"'[]{}=.,#\\\n\r\t\0 07-+eE^*/()nπ¦𝒳\u{feff}\u{200b}".chars().collect();
    let (mut read, mut refused) = (0, 0);
    for i in 0..300 {
        let mut text = [LOBE_PAPER, PIXEL_PAPER][i % 2].to_owned();
        for _ in 0..=draw.below(3) {
            let boundaries: Vec<usize> = text.char_indices().map(|(i, _)| i).collect();
            let from = draw.below(boundaries.len());
            let until = (from + draw.below(4)).min(boundaries.len() - 1);
            let (from, until) = (boundaries[from], boundaries[until]);
            let insert: String = (0..draw.below(3)).map(|_| inserts[draw.below(inserts.len())]).collect();
            // An empty insert deletes, an empty range inserts, neither empty replaces.
            text.replace_range(from..until, &insert);
        }
        match ClaimsFile::parse(&text) {
            Ok(file) => {
                read += 1;
                assert!(file.claims.iter().all(|claim| !claim.readings.is_empty()));
            }
            Err(error) => {
                refused += 1;
                check(&error);
                assert!(error.line <= text.matches('\n').count() + 1, "{error}");
                let line = text.split('\n').nth(error.line - 1).unwrap();
                assert!(error.column <= line.chars().count() + 1, "{error}");
            }
        }
    }
    // Both ends of the reader were reached.
    assert!(read > 20 && refused > 20, "{read} read, {refused} refused");
}

fn judge(text: &str) -> Vec<Judgement> {
    Judge::default().judge(&ClaimsFile::parse(text).unwrap_or_else(|e| panic!("{e}\n{text}"))).unwrap()
}

fn one(reading: &str) -> Judgement {
    let mut found = judge(&file("mine", reading));
    assert_eq!(found.len(), 1);
    found.remove(0)
}

/// The exponent that a witness names.
fn witness(judgement: &Judgement) -> f64 {
    let (_, after) = judgement.witness.rsplit_once("n = ").unwrap();
    after.parse().unwrap_or_else(|_| panic!("{}", judgement.witness))
}

/// 2π coef(n) Int(n) - 1 with coef = (a n + b)/(divisor π), Int by Gauss-Legendre.
fn residual(model: Model, limit: Limit, [a, b, divisor]: [f64; 3], n: f64) -> f64 {
    let case = Case { model, lobe: Lobe::Cs16, limit };
    let coefficient = (a * n + b) / (divisor * PI);
    2.0 * PI * coefficient * gauss_legendre(case, n, &mut GaussTable::default()) - 1.0
}

/// Models, factors as text and as numbers, limits.
type Line = (Model, &'static str, [f64; 3], Limit);
const TOO_LARGE: [Line; 4] = [
    (Model::Phong, "1.07*n/(2*pi)", [1.07, 0.0, 2.0], Limit::Support),
    (Model::Phong, "1.07*n/(2*pi)", [1.07, 0.0, 2.0], Limit::Paper),
    (Model::PhongModified, "(1.07*n + 1)/(2*pi)", [1.07, 1.0, 2.0], Limit::Support),
    (Model::BlinnPhong, "(1.07*n + 1)/(8*pi)", [1.07, 1.0, 8.0], Limit::Support),
];
const SMALL: [Line; 4] = [
    (Model::Phong, "1.0624*n/(2*pi)", [1.0624, 0.0, 2.0], Limit::Support),
    (Model::Phong, "1.062*n/(2*pi)", [1.062, 0.0, 2.0], Limit::Paper),
    (Model::PhongModified, "(1.0615*n + 0.99)/(2*pi)", [1.0615, 0.99, 2.0], Limit::Support),
    (Model::BlinnPhong, "(1.0595*n + 1.03)/(8*pi)", [1.0595, 1.03, 8.0], Limit::Support),
];

fn residual_claim((model, factor, _, limit): Line, over: &str, relation: &str, printed: &str) -> String {
    format!(
        "kind = \"factor-residual\"\nmodel = \"{}\"\nfactor = \"{factor}\"\nlimit = \"{}\"\nn = \"16..1024\"\n\
         over = \"{over}\"\nstatistic = \"max-abs\"\nrelation = \"{relation}\"\nprinted = \"{printed}\"",
        model.id(),
        limit.id(),
    )
}

fn energy_claim((model, factor, _, limit): Line, over: &str) -> String {
    format!(
        "kind = \"energy\"\nmodel = \"{}\"\nfactor = \"{factor}\"\nlimit = \"{}\"\nn = \"16..1024\"\nover = \"{over}\"",
        model.id(),
        limit.id(),
    )
}

#[test]
fn false_claims_are_refuted_with_a_witness() {
    for line in TOO_LARGE {
        let (model, factor, numbers, limit) = line;
        for over in ["integers", "reals"] {
            for relation in ["<=", "="] {
                let found = one(&residual_claim(line, over, relation, "1e-3"));
                assert_eq!(found.verdict, Verdict::Refuted, "{factor}: {found:?}");
                let n = witness(&found);
                let height = residual(model, limit, numbers, n);
                assert!(height.abs() > 1.5e-3, "{factor}: {height:e} at the witness {n}");
                // The witness is where the computed value is: its digits are rounded to a hundredth.
                let computed = found.computed.unwrap();
                assert!(
                    (height.abs() - computed.mid()).abs() <= 1e-5 * computed.hi(),
                    "{factor}: {height:e}, {computed:?}"
                );
            }
            let found = one(&energy_claim(line, over));
            assert_eq!(found.verdict, Verdict::Refuted, "{factor}: {found:?}");
            let height = residual(model, limit, numbers, witness(&found));
            assert!(height > AGREEMENT, "{factor} gains {height:e} at the witness");
        }
    }
}

#[test]
fn true_claims_are_proved() {
    for line in SMALL {
        let (model, factor, numbers, limit) = line;
        // True by every integer's own value, before the judge is asked.
        let heights = (16..=1024).map(|n| residual(model, limit, numbers, f64::from(n)));
        let (most, size) = heights.fold((f64::MIN, 0.0_f64), |(m, s), h| (m.max(h), s.max(h.abs())));
        assert!(most < 0.0 && size < 3e-3, "{factor}: {most:e}, {size:e}");
        for over in ["integers", "reals"] {
            assert_eq!(one(&residual_claim(line, over, "<=", "3e-3")).verdict, Verdict::Proved, "{factor}");
            assert_eq!(one(&energy_claim(line, over)).verdict, Verdict::Proved, "{factor}");
        }
    }
    // Exactly on the law's edge: 17/16 normalises, and no rounding may call that a gain.
    let edge = (Model::Phong, "1.0625*n/(2*pi)", [1.0625, 0.0, 2.0], Limit::Support);
    assert_ne!(one(&energy_claim(edge, "reals")).verdict, Verdict::Refuted);
}

/// At every angle: too large a factor is refuted with an angle, a smaller one is reproduced and never
/// proved, and a factor that is exact leaves an estimate nothing to say.
#[test]
fn energy_at_every_angle_is_estimated() {
    let claim = |model: &str, usage: &str, lobe: &str, factor: &str| {
        one(&format!(
            "kind = \"energy-at-every-angle\"\nmodel = \"{model}\"\nuse = \"{usage}\"\nlobe = \"{lobe}\"\n\
             factor = \"{factor}\"\nn = \"16..64\""
        ))
    };
    for (model, usage, lobe, factor, verdict) in [
        ("phong", "printed", "cs16", "1.07*n/(2*pi)", Verdict::Refuted),
        ("phong", "printed", "cs16", "1.0624*n/(2*pi)", Verdict::Reproduced),
        ("phong", "printed", "cos-n", "(n + 1)/(2*pi)", Verdict::Undecided),
        ("blinn-phong-modified", "printed", "cos-n", "(n + 5)/(8*pi)", Verdict::Reproduced),
        ("blinn-phong-modified", "printed", "cos-n", "(n + 9)/(8*pi)", Verdict::Refuted),
        ("blinn-phong-heightfield", "microfacet", "cos-n", "1.001*(n + 2)/(2*pi)", Verdict::Refuted),
        ("blinn-phong-heightfield", "microfacet", "cos-n", "0.999*(n + 2)/(2*pi)", Verdict::Reproduced),
        // Along the normal the horizon hides enough of this one at n = 16, but not at n = 64.
        ("blinn-phong-ndf", "printed", "cos-n", "1.001*(n + 1)/(2*pi)", Verdict::Refuted),
    ] {
        let found = claim(model, usage, lobe, factor);
        assert_eq!(found.verdict, verdict, "{model}, {usage}, {factor}: {found:?}");
        assert_eq!(found.evidence, Some(Evidence::Estimated), "{factor}");
        assert!(found.witness.contains('θ'), "{factor}: {}", found.witness);
    }
    // What is no factor is judged to be nothing, and said so with its n.
    for (factor, place) in [("-n", "-16"), ("1/(n - 20)", "n = 16"), ("1/(n - 16)", "n = 16")] {
        let found = claim("phong", "printed", "cs16", factor);
        assert_eq!(found.verdict, Verdict::Undecided, "{factor}: {found:?}");
        assert!(found.witness.contains(place), "{factor}: {}", found.witness);
    }
    let gains = claim("blinn-phong-heightfield", "microfacet", "cos-n", "1.001*(n + 2)/(2*pi)");
    let (_, angle) = gains.witness.rsplit_once("at θ = ").unwrap();
    let angle: f64 = angle.split('°').next().unwrap().parse().unwrap();
    let lobe = |w: f64| cos_n_versine(w, witness(&gains));
    let profile = Profile::new(&lobe, 1.0, witness(&gains)).unwrap();
    let factor = 1.001 * (witness(&gains) + 2.0) / (2.0 * PI);
    let of = Reflectance::HeightfieldMicrofacet;
    let at = directional_albedo_plain(of, &profile, factor, angle.to_radians()).unwrap();
    assert!(angle < 90.0 && at.value > 1.0 + 1e-6, "{angle}°: {at:?}");
}

#[test]
fn printed_digits_decide_both_ways() {
    // 1.07 · 16/17 - 1 = 12/1700 = 7.0588…e-3 for every n.
    let line = TOO_LARGE[0];
    for (printed, relation, verdict) in [
        ("7.06e-3", "=", Verdict::Proved),
        ("7.1e-3", "=", Verdict::Proved),
        ("7e-3", "=", Verdict::Proved),
        ("7.0e-3", "=", Verdict::Refuted),
        ("7.05e-3", "=", Verdict::Refuted),
        ("7e-3", "<=", Verdict::Refuted),
        ("7.0588e-3", "<=", Verdict::Refuted),
        ("7.0589e-3", "<=", Verdict::Proved),
    ] {
        let found = one(&residual_claim(line, "reals", relation, printed));
        assert_eq!(found.verdict, verdict, "{relation} {printed}: {found:?}");
    }
}

#[test]
fn a_range_of_one_n_is_a_range() {
    let claim = residual_claim(TOO_LARGE[2], "reals", "<=", "1e-3").replace("16..1024", "100..100");
    let found = one(&claim);
    assert_eq!((found.verdict, witness(&found)), (Verdict::Refuted, 100.0));
}

#[test]
fn renaming_keeps_the_verdicts() {
    let readings = |id: &str| {
        let claims = [
            file(id, &residual_claim(TOO_LARGE[2], "reals", "<=", "1e-3")),
            file(&format!("{id} 2"), &energy_claim(SMALL[1], "integers")),
            file(
                &format!("{id} 3"),
                "kind = \"factor-identity\"\nmodel = \"phong\"\nfactor = \"(n + 1)/(2*pi)\"",
            ),
        ];
        judge(&format!("version = 1\n{}", claims.concat().replace("version = 1\n", "")))
    };
    let (plain, renamed) = (readings("L7"), readings("ninety-nine"));
    let expected = [Verdict::Refuted, Verdict::Proved, Verdict::Proved];
    assert_eq!(plain.iter().map(|j| j.verdict).collect::<Vec<_>>(), expected);
    for (mut before, after) in plain.into_iter().zip(renamed) {
        assert_ne!(before.claim, after.claim);
        before.claim.clone_from(&after.claim);
        assert_eq!(before, after);
    }
}
