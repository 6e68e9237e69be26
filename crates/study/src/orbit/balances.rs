//! What must vanish over a cycle: oil and energy.
//!
//! ```text
//! mean of T omega + work of the load on the path, over the time = mean heat - what feeds put in
//! ```
//!
//! The work of the load is an integral along the path between the steps, all else is measured on films: so the balance
//! shows the error of the steps in time. A support and a mass give back over a closed cycle what they take.

use oilwedge_bearing::duty_cycle::PeriodicSpline;
use oilwedge_bearing::orbit::{Motion, Span};
use oilwedge_bearing::{ThermalFlows, mean_network};
use oilwedge_reynolds::quantities::heat_network::NodeNetwork;

use super::sample::Sampled;

/// Places of a span at which the power of the load is taken, in spans, and their weights (Gauss).
const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];
/// Places at which a spline is asked for its mean.
const PLACES: u32 = 4096;

/// What is left over a cycle.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct CycleBalances {
    /// Greatest imbalance of the oil of a film [1].
    pub(crate) mass: f64,
    /// What turns the journal and the work of the load, less the heat, over that [1]; none where the films cannot be
    /// joined to a curve.
    pub(crate) energy: Option<f64>,
}

/// The balances of a cycle.
pub(super) fn balances(motion: &Motion, path: &[Span], sampled: &[Sampled]) -> CycleBalances {
    CycleBalances {
        mass: sampled.iter().map(|sampled| sampled.imbalance).fold(0.0, f64::max),
        energy: energy(motion, path, sampled),
    }
}

/// Mean of what heats and what cools the films; none without a balance of heat.
pub(super) fn mean_flows(sampled: &[Sampled]) -> Option<ThermalFlows> {
    let (last, films) = sampled.split_last()?;
    let times = films.iter().map(|sampled| sampled.sample.time).collect();
    let values = films.iter().map(|sampled| {
        let flows = sampled.flows?;
        Some([flows.power, flows.flow, flows.carried_over * flows.flow])
    });
    let values: Option<Vec<[f64; 3]>> = values.collect();
    let [power, flow, round] = mean(times, values?, last.sample.time)?;
    Some(ThermalFlows { power, flow, carried_over: if flow > 0.0 { round / flow } else { 0.0 } })
}

/// The mean of the films as networks of heat, by the trapezoidal rule over the cycle; none without temperatures across
/// the films.
pub(super) fn mean_heat(sampled: &[Sampled]) -> Option<NodeNetwork> {
    let last = sampled.len().checked_sub(1)?;
    let time = |k: usize| sampled[k].sample.time;
    let weighed = (0..=last).map(|k| {
        let weight = 0.5 * (time((k + 1).min(last)) - time(k.saturating_sub(1)));
        Some((weight, sampled[k].network.as_ref()?))
    });
    let weighed: Option<Vec<(f64, &NodeNetwork)>> = weighed.collect();
    mean_network(&weighed?)
}

/// Mean of values at these times, on a periodic spline.
fn mean<const N: usize>(times: Vec<f64>, values: Vec<[f64; N]>, period: f64) -> Option<[f64; N]> {
    let spline = PeriodicSpline::new(times, values, period).ok()?;
    let places = (0..PLACES).map(|k| spline.at(period * f64::from(k) / f64::from(PLACES)));
    let add = |sum: [f64; N], at: [f64; N]| std::array::from_fn(|k| sum[k] + at[k] / f64::from(PLACES));
    Some(places.fold([0.0; N], add))
}

fn energy(motion: &Motion, path: &[Span], sampled: &[Sampled]) -> Option<f64> {
    let (last, films) = sampled.split_last()?;
    let period = last.sample.time;
    let times = films.iter().map(|sampled| sampled.sample.time).collect();
    let values = films.iter().map(|sampled| {
        let power = &sampled.power;
        let dissipated = power.shear + power.driven + power.contact;
        [dissipated, power.friction() + power.supplied + power.cavity]
    });
    let [dissipated, put_in] = mean(times, values.collect(), period)?;
    let by_load = path.iter().map(|span| work(motion, span)).sum::<f64>() / period;
    (dissipated > 0.0).then_some((put_in + by_load - dissipated).abs() / dissipated)
}

/// Work of the load along a part of the path [J].
fn work(motion: &Motion, span: &Span) -> f64 {
    let [from, to] = span.times;
    let power = |part: f64| {
        let time = from + part * (to - from);
        let (load, rate) = (motion.asked(time), span.rate(time));
        (0..4).map(|k| load[k] * rate[k]).sum::<f64>()
    };
    GAUSS.iter().map(|(part, weight)| weight * power(*part)).sum::<f64>() * (to - from)
}
