//! bellfit.
fn main() {
    let s = std::time::Instant::now();
    let file =
        bellfit::paper::ClaimsFile::parse(bellfit::paper::LOBE_PAPER).map_err(|e| e.to_string()).unwrap();
    let j = bellfit::verdict::Judge::default().judge(&file).unwrap();
    for j in &j {
        println!(
            "{} | {} | {} | {:?} | {} | {}",
            j.claim,
            j.reading,
            j.printed,
            j.computed.map(|c| (c.lo(), c.hi())),
            j.verdict.id(),
            j.witness
        );
    }
    println!("{} {:?}", j.len(), s.elapsed());
}
