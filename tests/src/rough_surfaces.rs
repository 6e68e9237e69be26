//! Rough surfaces that touch where the films of the tests are thin.

use oilwedge_reynolds::contact::{BearingCurve, Contact, ContactLaw, Fineness, GreenwoodTripp};

/// Contact of elastic asperities of a roughness of 2 um, and by a bearing curve of 4 um: they touch where films of the tests are thin.
pub fn contacts() -> [Contact; 2] {
    let laws = [
        ContactLaw::GreenwoodTripp(GreenwoodTripp::new(2e-6, 0.05, 0.01, 115e9, 2e9)),
        ContactLaw::BearingCurve(BearingCurve {
            depth: 4e-6,
            hardness: 1e8,
        }),
    ];
    laws.map(|law| Contact {
        law,
        friction: 0.1,
        fineness: Fineness::Reported,
    })
}
