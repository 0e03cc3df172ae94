//! Every law of the catalogue holds where it must, and fails on the object that breaks it.

use nyquist::laws::catalog;
use std::collections::HashSet;

#[test]
fn every_law_holds_on_the_objects_it_is_about() {
    for law in catalog::all() {
        let residuals = (law.holds)();
        assert!(!residuals.is_empty(), "{} checks nothing", law.name);
        for r in residuals {
            assert!(r.holds(), "{}: {}: measured {:e}, allowed {:e}", law.name, r.law, r.measured, r.bound);
        }
    }
}

#[test]
fn every_law_fails_on_an_object_that_breaks_it() {
    for law in catalog::all() {
        let residuals = (law.breaks)();
        assert!(!residuals.is_empty(), "{} is not run on anything that breaks it", law.name);
        for r in residuals {
            assert!(!r.holds(), "{}: {}: measured {:e}, allowed {:e}", law.name, r.law, r.measured, r.bound);
            assert!(r.measured.is_finite(), "{}: {} fails only because it is not a number", law.name, r.law);
        }
    }
}

#[test]
fn no_two_laws_share_a_name_and_each_can_be_found() {
    let mut names = HashSet::new();
    for law in catalog::all() {
        assert!(names.insert(law.name), "{} stands twice", law.name);
        assert_eq!(catalog::matching(law.name).expect("a listed law is found")[0].name, law.name);
    }
    let error = catalog::matching("alias-enrgy").expect_err("no such law");
    assert!(error.to_string().contains("known: alias-energy"), "{error}");
}
