//! The papers' claims against their expected verdicts: what holds keeps holding, what is refuted stays
//! refuted, and nothing is left open.
#![cfg(feature = "toolkit")]

use bellfit::paper::{ClaimsFile, Kind};
use bellfit::verdict::{
    EXPECTED, EXPECTED_PIXEL, Evidence, Expectations, ExpectedError, Judge, Judgement, Verdict,
};
use std::sync::OnceLock;

fn judgements() -> &'static [Judgement] {
    static JUDGED: OnceLock<Vec<Judgement>> = OnceLock::new();
    JUDGED.get_or_init(|| {
        let claims = ClaimsFile::papers().expect("the claims are readable");
        Judge::default().judge(&claims).expect("every fit is made")
    })
}

fn of<'a>(claim: &str, reading: &str) -> &'a Judgement {
    let found = judgements().iter().find(|j| j.claim == claim && j.reading == reading);
    found.unwrap_or_else(|| panic!("{claim}, {reading}"))
}

#[test]
fn every_verdict_is_the_expected_one() {
    let expected = Expectations::papers().expect("the expectations are readable");
    assert_eq!(expected.differences(judgements()), []);
}

#[test]
fn nothing_is_undecided_and_every_printed_number_is_certified() {
    let claims = ClaimsFile::papers().expect("the claims are readable");
    let ids: Vec<&str> = claims.claims.iter().map(|c| c.id.as_str()).collect();
    let lobe = (1..=16).map(|i| format!("L{i}")).chain(["G1".into(), "G2".into()]);
    let all: Vec<String> = lobe.chain((0..=13).map(|i| format!("P{i}"))).collect();
    assert_eq!(ids, all, "the papers' claims, and no others");
    for judgement in judgements() {
        let name = format!("{}, {}", judgement.claim, judgement.reading);
        assert_ne!(judgement.verdict, Verdict::Undecided, "{name}");
        // What is proved is certified, and what rests on less is reproduced at best.
        let certified = judgement.evidence == Some(Evidence::Certified);
        assert!(judgement.verdict != Verdict::Proved || certified, "{name}");
        assert!(judgement.verdict != Verdict::Reproduced || !certified, "{name}");
        if !judgement.printed.is_empty() {
            assert_eq!(judgement.evidence, Some(Evidence::Certified), "{name}");
            assert!(judgement.computed.is_some(), "{name}");
        }
        assert!(!judgement.witness.is_empty(), "{name}");
    }
    // A definition is a convention, a figure, or a number for which none is printed.
    for claim in &claims.claims {
        for reading in &claim.readings {
            let defines = match &reading.kind {
                Kind::Definition { .. } => true,
                Kind::FactorResidual { printed, .. } => printed.is_none(),
                Kind::Pixel(kind) => kind.is_figure(),
                _ => false,
            };
            let verdict = of(&claim.id, &reading.id).verdict;
            assert_eq!(verdict == Verdict::Definition, defines, "{}, {}", claim.id, reading.id);
        }
    }
}

/// The paper's own bounds, against values worked out by hand: where they hold and where not.
#[test]
fn the_papers_bounds_against_hand_made_values() {
    // Phong: Int = 16/(17 n), so the residual is 1.063 · 16/17 - 1 = 8/17000 at every n.
    let phong = of("L7", "res/exact-zero/reals/max/=");
    assert!(phong.verdict == Verdict::Proved && phong.computed.is_some_and(|c| c.contains(8.0 / 17000.0)));
    assert_eq!(of("L7", "res/exact-zero/reals/max/<=").verdict, Verdict::Refuted);
    // Phong, modified: (16/17)(1.063 + m)(1 - 8 m/9) - 1 at m = 1/32 is 13/10200.
    let modified = of("L8", "(1.063 n + 1)/exact-zero/integers/max/<=");
    assert_eq!(modified.verdict, Verdict::Proved);
    assert!(modified.computed.is_some_and(|c| c.contains(13.0 / 10200.0)) && modified.witness == "n = 32");
    // The other grouping at n = 16: 1.063 · 17/16 · (16/17) · (17/18) - 1 = 0.071/18.
    let other = of("L8", "1.063 (n + 1)/exact-zero/integers/max/<=");
    assert_eq!(other.verdict, Verdict::Refuted);
    assert!(other.computed.is_some_and(|c| c.contains(0.071 / 18.0)));
    // At n = 16 the exact cut is a right angle, √16 · π/2 = 2π; for large n it tends to √32.
    let cut = of("L3", "6/√n");
    assert_eq!(cut.verdict, Verdict::Proved);
    let c = cut.computed.expect("an enclosure");
    assert!(c.contains(core::f64::consts::TAU) && c.lo() > libm::sqrt(32.0) && c.lo() < 5.67);
    assert_eq!(of("L3", "√(6/n)").verdict, Verdict::Refuted);
    // The brief's cut leaves cosⁿ alone where it is (1 - 3/1024 …)^1024, near e^-3 = 4.98e-2.
    let brief = of("L5", "max/card/=").computed.expect("an enclosure");
    assert!((brief.mid() - libm::exp(-3.0)).abs() < 3e-4);
    // Δ is never negative: the printed minimum is refuted under every cut.
    assert!(judgements().iter().filter(|j| j.claim == "L6").all(|j| j.verdict == Verdict::Refuted));
}

/// Energy at every angle: the values along the normal are the integrals' own, and nothing is certified.
#[test]
fn every_angle_is_judged_on_estimates() {
    let of = |reading: &str| of("L13", reading);
    // 1.063 · 16/17 for Phong and the whole of the NDF; 1 + 13/10200 for the modified and the heightfield.
    for (reading, value) in [
        ("phong, every angle", 1.0 + 8.0 / 17000.0),
        ("blinn-phong-ndf, every angle/printed", 1.0 + 8.0 / 17000.0),
        ("phong-modified, every angle", 1.0 + 13.0 / 10200.0),
        ("blinn-phong-heightfield, every angle/microfacet", 1.0 + 13.0 / 10200.0),
    ] {
        let found = of(reading);
        assert_eq!(found.verdict, Verdict::Refuted, "{reading}");
        let computed = found.computed.expect("a value");
        assert!((computed.mid() - value).abs() < 1e-12 && computed.lo() > 1.0, "{reading}: {computed:?}");
    }
    assert!(of("blinn-phong-heightfield, every angle/microfacet").witness.contains("at θ = 89."));
    // (1.063/(2π)) · 2π ∫ cs_16 cos α dw = 1.063 · (16/17) (1 - 8 m/9), nearest to 1 at n = 1024.
    let normals = of("blinn-phong-ndf, every angle/microfacet");
    let value = 1.063 * 16.0 / 17.0 * (1.0 - 8.0 / 9.0 / 1024.0);
    assert_eq!(normals.verdict, Verdict::Reproduced);
    assert!((normals.computed.expect("a value").mid() - value).abs() < 1e-12);
    for judgement in judgements().iter().filter(|j| j.reading.contains("every angle")) {
        assert_eq!(judgement.evidence, Some(Evidence::Estimated), "{}", judgement.reading);
    }
}

#[test]
fn a_changed_expectation_is_seen() {
    let lobe: Vec<Judgement> = judgements().iter().filter(|j| j.paper != "pixel").cloned().collect();
    let differs = |text: &str| Expectations::parse(text).expect("readable").differences(&lobe);
    assert!(differs(EXPECTED).is_empty() && differs(EXPECTED_PIXEL).len() > lobe.len());
    // A verdict turned round.
    let at = EXPECTED.find("verdict = \"refuted\"").expect("something is refuted");
    let turned = format!("{}verdict = \"proved\"{}", &EXPECTED[..at], &EXPECTED[at + 19..]);
    assert!(matches!(differs(&turned).as_slice(), [ExpectedError::Differs { .. }, ..]));
    // A reading that does not exist, in place of one that does.
    let renamed = EXPECTED.replacen("\"res/paper/integers/max/=\"", "\"res/paper/integers/max/≠\"", 1);
    let found = differs(&renamed);
    assert!(found.iter().any(|e| matches!(e, ExpectedError::Absent { .. })), "{found:?}");
    assert!(found.iter().any(|e| matches!(e, ExpectedError::Unexpected { .. })), "{found:?}");
    // A reading twice.
    let twice = EXPECTED.replacen("\"res/paper/integers/max/=\",", "\"zero\", \"zero\",", 1);
    assert!(matches!(Expectations::parse(&twice), Err(ExpectedError::Doubled(..))));
}
