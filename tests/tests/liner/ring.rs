//! The closed form of elastic rings against the elements in r of a second code.

use oilwedge_reynolds::analytical::elastic_ring::{ElasticRing, RingSupport};
use oilwedge_tests::elastic_liner::block;

/// The reference has six digits.
const PRINTED: f64 = 6e-6;

#[test]
fn compliances_are_those_of_elements_in_r() {
    let reference = block("elastic_ring");
    let mut compared = 0;
    for (key, outer) in [("clamped", RingSupport::Clamped), ("free", RingSupport::Free)] {
        for wall in reference[key].as_array().expect("walls") {
            let number = |key: &str| wall[key].as_f64().expect("a number");
            let ring = ElasticRing {
                radius: number("a"),
                thickness: number("b") - number("a"),
                modulus: number("E"),
                poisson: number("nu"),
                outer,
            };
            for (n, wanted) in wall["C"].as_object().expect("compliances") {
                let (n, wanted) = (n.parse().expect("a wave"), wanted.as_f64().expect("a number"));
                let ratio = ring.compliance(n) / wanted;
                assert!((ratio - 1.0).abs() < PRINTED, "{} n = {n}: {ratio}", wall["name"]);
                compared += 1;
            }
            if outer == RingSupport::Clamped {
                let ratio = ring.thin_layer() / number("winkler");
                assert!((ratio - 1.0).abs() < PRINTED, "{}: {ratio}", wall["name"]);
            }
        }
    }
    assert!(compared > 70, "{compared}");
}
