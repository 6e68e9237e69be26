//! The errors of a pressure film, estimated by the film in cubic elements.

use std::cell::OnceCell;

use oilwedge_bearing::{Coefficients, Dynamics};
use oilwedge_fem::Field;
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::error_bar::{Bar, FilmError, FlowGoal, Value};
use oilwedge_reynolds::quantities::cavity::hidden_share;
use oilwedge_reynolds::quantities::inlet::inlet_flows;
use oilwedge_reynolds::quantities::load::rim_error;
use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};

use super::places::{self, PlacedPair};
use super::{CoefficientErrors, Estimate, ExtentEnd, Scaled};
use crate::film::Film;
use crate::measure::{Measured, drag};

/// Share of the differences of the flow through triangles, without their signs, that the cubic film is off by.
const OF_FLOWS: f64 = 0.5;

/// A film in quadratic elements beside that in cubic ones.
pub(super) struct CubicPair<'a> {
    pub(super) film: &'a Film,
    pub(super) quadratic: &'a SolvedFilm,
    pub(super) cubic: &'a SolvedFilm,
    pub(super) error: &'a FilmError,
    /// Numbers measured on the quadratic and on the cubic film.
    pub(super) measured: [&'a Measured; 2],
    /// The film that is judged.
    pub(super) value: Value,
    /// What the edge of the cavity of the cubic film leaves open of stiffness and damping, triangle by triangle; none
    /// where they are not asked for, or could not be computed.
    pub(super) edge: Option<Vec<Coefficients>>,
    /// What bars of the load are made of: sums over all triangles, made once for all quantities.
    pub(super) of_load: LoadErrors,
    /// What is made once when it is first asked for.
    pub(super) shared: SharedBars,
}

/// Bars that several quantities ask for.
#[derive(Default)]
pub(super) struct SharedBars {
    summit: OnceCell<[f64; 2]>,
    inlet_flow: OnceCell<f64>,
}

/// What the errors of two films say of the load.
#[derive(Clone, Copy)]
pub(super) struct LoadErrors {
    /// Bars of the load along and across its direction [N].
    pub(super) bars: [Bar; 2],
    /// False where the mesh does not resolve the film.
    pub(super) is_resolved: bool,
}

impl LoadErrors {
    /// Sums the errors of a film for this value.
    pub(super) fn of(error: &FilmError, value: Value) -> Self {
        Self { bars: [error.load(value), error.across(value)], is_resolved: error.is_resolved() }
    }
}

/// Parts of the difference of the tangents of both films that each of them is off by: of the quadratic one, of the
/// cubic one where the edge of a cavity is found, and elsewhere; measured.
const OF_QUADRATIC_TANGENTS: f64 = 2.0;
const OF_CUBIC_TANGENTS: f64 = 1.0;
const OF_TANGENTS_WITHOUT_EDGE: f64 = 0.8;
/// Where the film is smooth the cubic tangent is off by this times the 3/2 power of the difference, over the sizes of
/// entries, if that is less; measured: up to 1.05.
const OF_SMOOTH_TANGENTS: f64 = 1.5;
/// Part of the products of response and dual in a triangle through which the edge of the cavity runs by which a tangent
/// is off, where those of all triangles are added without regard to their signs; measured.
const PER_EDGE: f64 = 0.4;
/// Where the mesh shows no edge: part of the share of the triangles in which one may hide.
const PER_HIDDEN: f64 = 0.08;

/// Weight in the law of extremes of a smooth pressure; measured: up to 2.5.
const PER_EXTREME: f64 = 3.0;

impl Estimate for CubicPair<'_> {
    fn is_resolved(&self) -> bool {
        self.of_load.is_resolved
    }

    fn force(&self) -> f64 {
        let [x, y] = self.error.force;
        x.hypot(y)
    }

    fn load(&self) -> Bar {
        let [along, across] = self.bars();
        if self.vanishes() { along + across } else { along }
    }

    fn across(&self) -> Option<Bar> {
        (!self.vanishes()).then(|| self.bars()[1])
    }

    fn product(&self, [u, v]: [f64; 2]) -> Bar {
        let ([along, across], [x, y], force) = (self.bars(), self.error.force, self.force());
        match self.vanishes() {
            true => (along + across).scaled(u.hypot(v)),
            false => along.scaled((u * x + v * y) / force) + across.scaled((u * y - v * x) / force),
        }
    }

    fn moment(&self) -> Option<[Bar; 2]> {
        self.error.moment(self.value)
    }

    fn pressure_integral(&self) -> Bar {
        self.error.pressure_integral(self.value) + self.unseen()
    }

    fn greatest_pressure(&self) -> f64 {
        let extremes = self.measured.map(|measured| measured.extremes);
        let [quadratic, cubic] = extremes.map(|extremes| extremes.greatest);
        self.apart((cubic - quadratic).abs(), extremes.map(|extremes| extremes.summit.triangle))
    }

    fn least_pressure(&self) -> Bar {
        let extremes = self.measured.map(|measured| measured.extremes);
        let [quadratic, cubic] = extremes.map(|extremes| extremes.least);
        let triangles = extremes.into_iter().filter_map(|extremes| extremes.least_in);
        match self.quadratic.solution.cavity.contains(&true) {
            true => Bar::default(),
            false => Bar::of(self.apart((cubic - quadratic).abs(), triangles)),
        }
    }

    fn flow(&self, goal: &FlowGoal, Scaled { unit, change }: Scaled) -> Option<Bar> {
        let (_, error) = self.error.flows.iter().find(|(other, _)| other == goal)?;
        let (size, unsure) = self.booked(goal);
        let size = self.has_smooth_flows().then_some(size);
        let bar = self.error.flow(error, size, unsure, self.value);
        // What a cavity makes beside an end is booked apart from the residuals, so that the two may change by another
        // amount.
        let discretisation = match size {
            Some(_) => bar.discretisation,
            None => bar.discretisation.max(change.abs() * unit),
        };
        Some(Bar { discretisation, ..bar }.scaled(1.0 / unit))
    }

    /// Differences of the gradients along the line cancel in that of the flow: they are summed without their signs too.
    fn inlet_flow(&self, number: Scaled) -> f64 {
        let apart = || match [self.quadratic, self.cubic].map(inlet_flows) {
            [Some(quadratic), Some(cubic)] => quadratic.iter().zip(&cubic).map(|(a, b)| (a - b).abs()).sum(),
            _ => 0.0,
        };
        number.change.abs().max(OF_FLOWS * self.shared.inlet_flow.get_or_init(apart) / number.unit.abs())
    }

    /// What the cavity makes is what all others bring and take.
    fn cavity_flow(&self, change: f64) -> Option<Bar> {
        let regions = self.film.system.supply.regions().iter();
        let others = regions.filter(|region| matches!(region.kind, BoundaryKind::Line | BoundaryKind::Feed));
        let goals = others.map(|region| FlowGoal::Region(region.name.clone()));
        let unchanged = Scaled { unit: 1.0, change: 0.0 };
        [FlowGoal::Ends]
            .into_iter()
            .chain(goals)
            .try_fold(Bar::of(change.abs()), |sum, goal| Some(sum + self.flow(&goal, unchanged)?))
    }

    fn power(&self, [shear, pressure]: [f64; 2]) -> Bar {
        let [quadratic, cubic] = self.measured.map(|measured| {
            let power = measured.power;
            shear * power.shear + pressure * power.pressure
        });
        self.error.drag([shear, pressure], cubic - quadratic, self.value)
    }

    fn cavity_power(&self, change: f64) -> Option<Bar> {
        let share = self.front_share() + self.hidden_share();
        Some(Bar::of(change.abs() + share * self.judged().power.shear))
    }

    fn cavity_share(&self, change: f64) -> f64 {
        change.abs() + 0.4 * self.front_share() + self.hidden_share()
    }

    fn least_fraction(&self) -> Option<f64> {
        None
    }

    fn summit(&self) -> [f64; 2] {
        *self.shared.summit.get_or_init(|| places::summit(&self.placed(), self.greatest_pressure()))
    }

    fn film_end(&self, end: ExtentEnd) -> Option<Bar> {
        places::film_end(&self.placed(), end)
    }

    fn coefficients(&self) -> Option<CoefficientErrors> {
        self.errors_of_coefficients(|dynamics| Some(&dynamics.at.first()?.coefficients))
    }

    fn judged_coefficients(&self) -> Option<CoefficientErrors> {
        self.errors_of_coefficients(|dynamics| Some(&dynamics.judged.coefficients))
    }
}

impl CubicPair<'_> {
    /// Errors of coefficients that both films have.
    fn errors_of_coefficients(&self, of: impl Fn(&Dynamics) -> Option<&Coefficients>) -> Option<CoefficientErrors> {
        let [quadratic, cubic] = self.measured.map(|measured| of(measured.dynamics()?));
        let (quadratic, cubic) = (quadratic?, cubic?);
        let edge = self.edge.as_ref()?;
        let (judged, other, of_edge, without_edge) = match self.value {
            Value::Quadratic => (quadratic, cubic, OF_QUADRATIC_TANGENTS, OF_QUADRATIC_TANGENTS),
            Value::Cubic => (cubic, quadratic, OF_CUBIC_TANGENTS, OF_TANGENTS_WITHOUT_EDGE),
        };
        if !edge.is_empty() {
            let parts = edge.iter().map(|part| (PER_EDGE, *part));
            let difference = (of_edge, judged.plus(&other.scaled(-1.0)));
            return Some(CoefficientErrors::of_parts(parts.chain([difference])));
        }
        let is_smooth = self.value == Value::Cubic && self.has_smooth_flows();
        let part = |difference: f64| match is_smooth {
            true => (OF_SMOOTH_TANGENTS * difference.powf(1.5)).min(without_edge * difference),
            false => without_edge * difference,
        };
        let errors = CoefficientErrors::entry_by_entry(judged, other, part);
        let hidden = match self.film.problem.cavitation.has_free_boundary() {
            true => self.hidden_share(),
            false => 0.0,
        };
        Some(errors.and_share(judged, PER_HIDDEN * hidden))
    }

    /// What bars of places are made of.
    fn placed(&self) -> PlacedPair<'_> {
        PlacedPair { film: self.film, solutions: [self.quadratic, self.cubic], measured: self.measured }
    }

    /// Bars of the load along and across its direction [N].
    fn bars(&self) -> [Bar; 2] {
        self.of_load.bars.map(|bar| bar + self.unseen())
    }

    /// What neither film sees of a load [N]: rounding of the film thickness, as much as for the drag through the whole
    /// clearance; and rims that are no single circle, whose arcs are parabolas of the mesh.
    fn unseen(&self) -> Bar {
        let Film { problem, system, .. } = self.film;
        let load = drag(problem) * 2.0 * problem.bearing.radius * problem.bearing.length;
        let regions = system.supply.regions().iter();
        let cut_out = regions.filter(|region| region.kind == BoundaryKind::Feed);
        Bar {
            algebra: f64::EPSILON * load,
            geometry: cut_out.map(|region| rim_error(problem, system.space().mesh(), region)).sum(),
            ..Bar::default()
        }
    }

    /// A load smaller than its own bar has no direction along which or across which it may be off.
    fn vanishes(&self) -> bool {
        let [along, across] = self.bars();
        along.total() + across.total() >= self.force()
    }

    /// Bar [Pa] of an extreme pressure: how far the two films are apart in the triangles that hold their extremes.
    fn apart(&self, change: f64, triangles: impl IntoIterator<Item = usize>) -> f64 {
        let problem = &self.film.problem;
        let [quadratic, cubic] = [self.quadratic, self.cubic]
            .map(|film| Field { space: film.system.space(), values: &film.solution.unknown });
        const LATTICE: u32 = 6;
        let step = 1.0 / f64::from(LATTICE);
        let apart = |t: usize| {
            let points = (0..=LATTICE).flat_map(|i| (0..=LATTICE - i).map(move |j| [f64::from(i), f64::from(j)]));
            let gap = |[i, j]: [f64; 2]| {
                let point = [step * i, step * j];
                (problem.pressure_at(cubic.value(t, point)) - problem.pressure_at(quadratic.value(t, point))).abs()
            };
            points.map(gap).fold(0.0, f64::max)
        };
        let triangles: Vec<usize> = triangles.into_iter().collect();
        let furthest = triangles.iter().copied().map(apart).fold(0.0, f64::max);
        match self.value {
            Value::Quadratic => (1.25 * change).max(furthest),
            Value::Cubic => {
                let plain = (0.3 * change).max(0.5 * furthest);
                self.of_smooth_extreme(furthest, &triangles).map_or(plain, |smooth| smooth.min(plain))
            }
        }
    }

    /// Bar [Pa] of an extreme of a smooth pressure whose two films are `furthest` [Pa] apart in these triangles:
    /// locally the error of the quadratic film decreases like h^3 and that of the cubic one like h^4, and what comes
    /// from elsewhere is in the load as well. None where the pressure is not smooth there.
    fn of_smooth_extreme(&self, furthest: f64, triangles: &[usize]) -> Option<f64> {
        let is_smooth = self.error.is_smooth && !triangles.iter().any(|&t| self.error.corner[t]);
        let extremes = self.judged().extremes;
        let size = (extremes.greatest - extremes.least).max(f64::MIN_POSITIVE);
        let [along, across] = self.bars();
        let elsewhere = size * (along.total() + across.total()) / self.force();
        (is_smooth && !self.vanishes()).then(|| PER_EXTREME * furthest * (furthest / size).cbrt() + elsewhere)
    }

    /// Whether the law of smooth films holds for flows too: there is no round rim, whose shape is not known to act on
    /// them, and no sharp corner, at which the flow has no bound.
    fn has_smooth_flows(&self) -> bool {
        let is_round = |region: &SupplyRegion| region.disc.is_some();
        let is_plain = !self.error.corner.contains(&true);
        is_plain && self.error.is_smooth && !self.film.system.supply.regions().iter().any(is_round)
    }

    /// What was measured on the film whose numbers are judged.
    fn judged(&self) -> &Measured {
        match self.value {
            Value::Quadratic => self.measured[0],
            Value::Cubic => self.measured[1],
        }
    }

    /// Share of the area [1] in which a cavity may hide where the mesh shows none.
    fn hidden_share(&self) -> f64 {
        if self.front_share() > 0.0 {
            return 0.0;
        }
        hidden_share(self.quadratic, self.least_pressure().total())
    }

    /// Share of the area [1] in triangles through which the edge of the cavity runs.
    fn front_share(&self) -> f64 {
        let SolvedFilm { problem, system, solution } = self.cubic;
        let (space, mesh) = (system.space(), system.space().mesh());
        let dropped = problem.cavitation.kink().map(|p| problem.unknown_at(p));
        let in_cavity = |dof: usize| solution.cavity[dof] || dropped.is_some_and(|floor| solution.unknown[dof] < floor);
        let (mut edge, mut whole) = (0.0, 0.0);
        for t in 0..mesh.triangles().len() {
            let [a, b, c] = mesh.corners(t);
            let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
            let dofs = &space.element_dofs(t)[..space.shapes()];
            let held = dofs.iter().any(|&dof| in_cavity(dof));
            let free = |&dof: &usize| !in_cavity(dof) && system.supply.owner(dof).is_none();
            edge += if held && dofs.iter().any(free) { area } else { 0.0 };
            whole += area;
        }
        edge / whole
    }

    /// Magnitude of a flow, and what of it is booked by where the edge of a cavity runs within a triangle [m3/s].
    fn booked(&self, goal: &FlowGoal) -> (f64, f64) {
        let regions = self.film.system.supply.regions().iter();
        let counts = |kind: BoundaryKind, region: &str| match goal {
            FlowGoal::Ends => kind == BoundaryKind::End,
            FlowGoal::Region(name) => region == name,
        };
        let flows = regions.zip(&self.judged().flows.regions);
        let counted = flows.filter(|(region, _)| counts(region.kind, &region.name));
        let (flow, unsure) =
            counted.fold((0.0, 0.0), |(flow, unsure), (_, region)| (flow + region.net, unsure + region.unsure));
        (flow.abs(), unsure)
    }
}
