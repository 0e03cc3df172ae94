//! Every figure of the catalogue can be computed, and everything that it claims holds.

use nyquist::figure::catalog;
use std::collections::HashSet;

#[test]
fn every_claim_of_every_figure_holds() {
    for entry in catalog::all() {
        let figure = entry.figure().unwrap_or_else(|e| panic!("{}: {e}", entry.id));
        assert!(!figure.claims.is_empty(), "{} claims nothing", entry.id);
        for claim in &figure.claims {
            let r = &claim.residual;
            assert!(r.holds(), "{}: {}: measured {:e}, allowed {:e}", entry.id, r.law, r.measured, r.bound);
        }
    }
}

#[test]
fn every_figure_has_a_unique_id_and_sentences_in_both_languages() {
    let mut ids = HashSet::new();
    for entry in catalog::all() {
        assert!(ids.insert(entry.id), "{} stands twice", entry.id);
        for text in [entry.title, entry.caption] {
            for lang in nyquist::text::Lang::ALL {
                assert!(!text.get(lang).is_empty(), "{} is silent in {}", entry.id, lang.code());
            }
        }
        let figure = entry.figure().expect("the defaults work");
        let mut names = HashSet::new();
        assert!(figure.panels.iter().all(|p| names.insert(p.name)), "{}: two panels of one name", entry.id);
    }
}
