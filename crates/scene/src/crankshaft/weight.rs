//! `counterweight` of a crankshaft.

use crate::reader::TableReader;

keys! {
    "crankshaft.counterweight" = Tables; "", "none", "with throws",
        "counterweights on the webs";
    "crankshaft.counterweight.throw" = Number; "1", "required", "whole, from 1",
        "number of the throw along the axis";
    "crankshaft.counterweight.web" = Number; "1", "required", "1 or 2",
        "its first or its second web";
    "crankshaft.counterweight.mass" = Quantity(Mass); "1.2 kg", "required", ">= 0",
        "mass of the counterweight";
    "crankshaft.counterweight.radius" = Quantity(Length); "60 mm", "required", ">= 0",
        "distance of its centre of mass from the axis";
    "crankshaft.counterweight.angle" = Quantity(Angle); "180 deg", "180 deg", "",
        "angle of its centre of mass against the throw, in the sense of rotation";
}

/// A counterweight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Counterweight {
    /// Number of its throw, from 0.
    pub throw: usize,
    /// Web of the counterweight, 0 or 1.
    pub web: usize,
    /// Mass times radius [kg m].
    pub moment: f64,
    /// Angle against the throw [rad].
    pub angle: f64,
}

pub(super) fn read(mut table: TableReader<'_>) -> Counterweight {
    let throw =
        table.number("throw").within("is no whole number from 1 on", "give the number of the throw along the axis");
    let throw = throw.required();
    let web = table.number("web").which(
        |web| web == 1.0 || web == 2.0,
        "is neither 1 nor 2",
        "give the first or the second web of the throw",
    );
    let web = web.required();
    let mass = table.number("mass").within("is negative", "give a mass, and turn angle by 180 deg");
    let mass = mass.required();
    let radius = table.number("radius").within("is negative", "give a distance, and turn angle by 180 deg");
    Counterweight {
        moment: mass * radius.required(),
        throw: from_one(throw),
        web: from_one(web),
        angle: table.number("angle").or_usual(),
    }
}

/// A whole number from 1 on, counted from 0; what was refused counts as the first.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked by the caller; NaN becomes 0")]
fn from_one(number: f64) -> usize {
    (number - 1.0) as usize
}
