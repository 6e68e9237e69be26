//! # Loads of an engine on its crankshaft: all throws by firing order, and what is out of balance on the webs
//!
//! **Equation.** Each throw has the crank drive of [`Crank`], at an angle of its own; so its rod presses the pin, and
//! what is out of balance on a web pulls it outwards:
//! ```text
//! F_pin(theta) = F(theta - phi),        F_web(theta) = omega^2 R(theta) U
//! ```
//! in the frame of the cylinders, which are in line. R turns by theta, U is mass times radius in the axes of the shaft,
//! in which the throw lies at -phi.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | theta, phi | rad | `angle`, [`Engine::fires_at`] |
//! | U | kg m | [`Engine::unbalances`] |
//! | omega | rad/s | [`Engine::speed`] |
//!
//! A shaft cut at its main bearings bears each load as a beam on the two mains beside it ([`shares`]); beyond the last
//! main, as a lever on the last two.
//!
//! **Source.** C. F. Taylor, The Internal Combustion Engine in Theory and Practice, 1985, vol. 2, ch. 8. **Range.** One
//! row of cylinders; constant speed. **Verified by** the tests below and `tests/full/tests/shaft_cycle.rs`.

use super::cut::shares;
use super::frame::NodeForce;
use crate::duty_cycle::{Crank, DutyCycle, Throw};

/// Webs of a throw.
pub const WEBS: usize = 2;

/// The cylinders of an engine on its crankshaft.
#[derive(Debug, Clone, PartialEq)]
pub struct Engine {
    /// The crank drive of each throw.
    pub crank: Crank,
    /// Crank angle phi [rad] by which each throw follows the first one: it fires so much later.
    pub fires_at: Vec<f64>,
    /// What is out of balance on both webs of each throw [kg m], in the axes of the shaft; counterweights are.
    pub unbalances: Vec<[[f64; 2]; WEBS]>,
    /// Angular speed [rad/s], positive.
    pub speed: f64,
}

impl Engine {
    /// Angle [rad] at which a throw lies in the axes of the shaft.
    pub fn lies_at(&self, throw: usize) -> f64 {
        -self.fires_at[throw]
    }

    /// The loads at a crank angle [rad] on the nodes of all pins and, behind them, of all webs, in the frame of the
    /// cylinders.
    pub fn loads(&self, angle: f64) -> Vec<NodeForce> {
        let throws = self.fires_at.len();
        let pins = self.fires_at.iter().map(|phi| self.crank.force_on_pin(angle - phi, self.speed));
        let (sin, cos) = angle.sin_cos();
        let square = self.speed * self.speed;
        let webs = self.unbalances.iter().flatten();
        let pulls = webs.map(|[x, y]| [square * (cos * x - sin * y), square * (sin * x + cos * y)]);
        debug_assert_eq!(self.unbalances.len(), throws);
        (0..).zip(pins.chain(pulls)).map(|(place, force)| NodeForce { place, force }).collect()
    }

    /// The load of each main bearing at these axial places [m], growing, where the shaft is cut at them; `throws` are
    /// the places of the first web, the pin and the second web of each throw [m].
    pub fn on_mains(&self, mains: &[f64], throws: &[[f64; 3]]) -> Vec<DutyCycle> {
        let share = |main: usize, z: f64| shares(mains, z)[main];
        let load = |main: usize| {
            let beside = self.fires_at.iter().zip(throws).map(|(&angle, place)| Throw {
                angle,
                share: share(main, place[1]),
                web_mass: 0.0,
            });
            let mut unbalance = [0.0; 2];
            for (webs, [first, _, second]) in self.unbalances.iter().zip(throws) {
                for (web, z) in webs.iter().zip([first, second]) {
                    let part = share(main, *z);
                    unbalance = [unbalance[0] + part * web[0], unbalance[1] + part * web[1]];
                }
            }
            let throws = beside.filter(|throw| throw.share != 0.0).collect();
            DutyCycle::of_main(self.crank.clone(), throws, self.speed).with_unbalance(unbalance)
        };
        (0..mains.len()).map(load).collect()
    }

    /// Sums of what is out of balance [kg m], and of its moment about z = 0 [kg m2], on webs at these places [m].
    pub fn out_of_balance(&self, throws: &[[f64; 3]]) -> [[f64; 2]; 2] {
        let mut sums = [[0.0; 2]; 2];
        for (webs, [first, _, second]) in self.unbalances.iter().zip(throws) {
            for (web, z) in webs.iter().zip([first, second]) {
                for k in 0..2 {
                    sums[0][k] += web[k];
                    sums[1][k] += z * web[k];
                }
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::duty_cycle::{GasPressure, Linkage, PressureCurve};
    use std::f64::consts::{PI, TAU};

    fn engine(fires_at: Vec<f64>) -> Engine {
        Engine {
            crank: Crank {
                linkage: Linkage { radius: 0.0625, rod_length: 0.23 },
                reciprocating_mass: 3.43,
                rotating_mass: 2.025,
                bore: 0.125,
                gas: GasPressure::Curve(PressureCurve { peak: 8e6, angle: 0.2, sharpness: 14.0, period: 2.0 * TAU }),
            },
            unbalances: vec![[[0.0; 2]; WEBS]; fires_at.len()],
            fires_at,
            speed: 209.0,
        }
    }

    #[test]
    fn mains_bear_force_and_moment_of_all_throws() {
        let mut engine = engine(vec![0.0, 3.0 * PI, PI, 2.0 * PI]);
        engine.unbalances[1] = [[0.02, 0.01], [-0.03, 0.0]];
        let mains = [0.0, 0.1, 0.2, 0.3, 0.4];
        let throws: Vec<[f64; 3]> = [0.05, 0.15, 0.25, 0.35].map(|z| [z - 0.02, z, z + 0.02]).to_vec();
        let places = throws.iter().map(|place| place[1]).chain(throws.iter().flat_map(|place| [place[0], place[2]]));
        let places: Vec<f64> = places.collect();
        let cycles = engine.on_mains(&mains, &throws);
        for k in 0..50 {
            let angle = 0.25 * f64::from(k);
            let loads = engine.loads(angle);
            for towards in 0..2 {
                let load: f64 = loads.iter().map(|load| load.force[towards]).sum();
                let moment: f64 = loads.iter().map(|load| places[load.place] * load.force[towards]).sum();
                let borne = |arm: &dyn Fn(f64) -> f64| -> f64 {
                    let parts = cycles.iter().zip(mains);
                    parts.map(|(cycle, z)| arm(z) * cycle.at(angle).force[towards]).sum()
                };
                assert!((borne(&|_| 1.0) - load).abs() < 1e-9, "{angle}");
                assert!((borne(&|z| z) - moment).abs() < 1e-9, "{angle}");
            }
        }
    }

    #[test]
    fn a_throw_that_fires_later_has_the_load_of_the_first_one_then() {
        let engine = engine(vec![0.0, 3.0 * PI]);
        let [first, second] = [0.4, 0.4 + 3.0 * PI].map(|angle| engine.loads(angle));
        assert!((first[0].force[0] - second[1].force[0]).abs() < 1e-8);
        // It lies opposite to the first one.
        assert!((engine.lies_at(1).cos() + 1.0).abs() < 1e-12);
    }
}
