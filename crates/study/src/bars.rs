//! The error bars of all quantities: what judges a film, and by which rule each number.
//!
//! | film | judged by | value reported |
//! |---|---|---|
//! | pressure film | the film in cubic elements on the same mesh | the cubic one |
//! | mass-conserving film | its companion on the vertices alone | that of the film itself |
//!
//! Under a load what is uncertain is the position: its bar comes from that of the load through the stiffness, and the bars
//! of all other numbers from the film moved that far along its tangent. `docs/theory/error_estimation.md` has the rules and how often they hold.

use std::time::Instant;

use oilwedge_fem::Field;
use oilwedge_reynolds::error_bar::{Bar, FilmError, FlowGoal, Value, film_error};
use oilwedge_reynolds::quantities::pressure::Extremes;
use oilwedge_reynolds::quantities::similarity;
use oilwedge_reynolds::{FilmSolution, FilmSystem, ReferenceFilm};

use crate::analysis::{Balance, Solved};
use crate::compile::Study;
use crate::joint;
use crate::measure::{Measured, measure, quantities};
use crate::moved::position_bars;
use crate::result::{ErrorParts, Quantity};
use crate::thermal;

/// A film, measured and judged.
#[derive(Debug)]
pub struct Judged {
    /// What was measured on the film whose numbers are reported.
    pub measured: Measured,
    /// The quantities, with their errors where bars were asked for and can be trusted.
    pub quantities: Vec<Quantity>,
    /// Share of each triangle in the error of the load [N]; none without bars.
    pub indicator: Option<Vec<f64>>,
    /// True if triangles should be divided where the error comes from, rather than all of them.
    pub is_local: bool,
    /// Part of every bar, over its number, for oil that triangles spread across the flow; zero on rows along it.
    pub spread: f64,
    /// Seconds that measuring and judging took.
    pub seconds: f64,
}

impl Judged {
    /// A film that nothing judges.
    pub fn without_bars(quantities: Vec<Quantity>, measured: Measured) -> Self {
        Self {
            measured,
            quantities,
            indicator: None,
            is_local: false,
            spread: 0.0,
            seconds: 0.0,
        }
    }
}

/// Measures and judges a solved film.
pub fn judge(study: &Study, solved: &Solved) -> Judged {
    let clock = Instant::now();
    let mut judged = match &solved.reference {
        None => {
            let measured = measure(&study.problem, &study.system, &solved.film);
            Judged::without_bars(quantities(study, &measured), measured)
        }
        Some(ReferenceFilm::Cubic(cubic)) => judge_by_cubic(study, solved, cubic),
        Some(ReferenceFilm::Coarse(coarse)) => crate::companion_bars::judge(study, solved, coarse),
    };
    if let Some(heat) = &solved.heat {
        heat.widen(study, &judged.measured, &mut judged.quantities);
    }
    Judged {
        seconds: clock.elapsed().as_secs_f64(),
        ..judged
    }
}

fn judge_by_cubic(study: &Study, solved: &Solved, cubic: &FilmSolution) -> Judged {
    let better = &study.system.cubic().system;
    let measured = measure(&study.problem, better, cubic);
    let mut list = quantities(study, &measured);
    let Ok(error) = film_error(&study.problem, &study.system, &solved.film, cubic, &measured.load.total) else {
        return Judged::without_bars(list, measured);
    };
    let quadratic = measure(&study.problem, &study.system, &solved.film);
    let before = quantities(study, &quadratic);
    let rules = Rules {
        study,
        film: &solved.film,
        cubic,
        error: &error,
        measured: [&quadratic, &measured],
        value: Value::Cubic,
    };
    let load = of_few(study, error.load(Value::Cubic));
    let moved = solved.balance.as_ref().map(|balance| {
        let across = of_few(study, error.across(Value::Cubic));
        position_bars(study, &solved.film, balance, [load.total(), across.total()], &before)
    });
    for quantity in &mut list {
        let own = solved
            .balance
            .as_ref()
            .and_then(|balance| balanced(study, quantity, balance, &measured));
        let before = before.iter().find(|other| other.name == quantity.name);
        let bar = own.or_else(|| {
            let bar = of_few(study, rules.bar(quantity, before?)?);
            let position = match &moved {
                Some(moved) => *moved.get(&quantity.name)?,
                None => 0.0,
            };
            Some(Bar { position, ..bar })
        });
        set(quantity, bar);
    }
    Judged {
        quantities: list,
        measured,
        is_local: load.front > load.discretisation,
        spread: 0.0,
        indicator: Some(error.indicator()),
        seconds: 0.0,
    }
}

/// The numbers of the quadratic film of a solved study with their bars: what would be reported without the cubic film.
/// `None` where there is no cubic film, and under a load, where the position is that of the cubic film.
pub fn judge_quadratic(study: &Study, solved: &Solved) -> Option<Vec<Quantity>> {
    let (Some(ReferenceFilm::Cubic(cubic)), None) = (&solved.reference, &solved.balance) else {
        return None;
    };
    let better = measure(&study.problem, &study.system.cubic().system, cubic);
    let error = film_error(&study.problem, &study.system, &solved.film, cubic, &better.load.total).ok()?;
    let measured = measure(&study.problem, &study.system, &solved.film);
    let after = quantities(study, &better);
    let mut list = quantities(study, &measured);
    let rules = Rules {
        study,
        film: &solved.film,
        cubic,
        error: &error,
        measured: [&measured, &better],
        value: Value::Quadratic,
    };
    for quantity in &mut list {
        let after = after.iter().find(|other| other.name == quantity.name);
        let bar = after.and_then(|after| rules.bar(quantity, after));
        let bar = bar.map(|bar| of_few(study, bar));
        set(quantity, bar);
    }
    Some(list)
}

/// Triangles of a mesh whose bars are twice those of the rules, which were found on meshes of hundreds and more.
const FEW: f64 = 100.0;

/// A bar on the mesh of a study: wider where triangles are few, and two degrees know little of the shape of a cavity.
pub fn of_few(study: &Study, bar: Bar) -> Bar {
    let triangles = study.system.space().mesh().triangles().len() as f64;
    let wider = 1.0 + FEW / triangles;
    Bar {
        discretisation: wider * bar.discretisation,
        front: wider * bar.front,
        transport: wider * bar.transport,
        ..bar
    }
}

/// Gives a quantity its bar, or says that there is none.
pub fn set(quantity: &mut Quantity, bar: Option<Bar>) {
    let bar = bar.filter(|bar| bar.total().is_finite());
    quantity.error = bar.map(|bar| bar.total());
    quantity.error_parts = bar.map(|bar| ErrorParts {
        discretisation: bar.discretisation,
        front: bar.front,
        transport: bar.transport,
        geometry: bar.geometry,
        nonlinear: bar.nonlinear,
        algebra: bar.algebra,
        position: bar.position,
        temperature: 0.0,
    });
}

/// The bar of what a load fixes: how far it is from balanced. None for what it does not fix.
pub fn balanced(study: &Study, quantity: &Quantity, balance: &Balance, measured: &Measured) -> Option<Bar> {
    let unbalanced = match quantity.name.as_str() {
        "load" | "load_x" | "load_y" => balance.unbalanced,
        "load_coefficient" | "sommerfeld_number" => {
            let force = measured.load.magnitude().max(f64::MIN_POSITIVE);
            balance.unbalanced / force * quantity.value.abs()
        }
        // The force is within a circle around the load.
        "load_angle" if balance.residual < 1.0 => balance.residual.asin().to_degrees(),
        "load_angle" => 180.0,
        joint::FILM_SHARE => balance.unbalanced * study.film_share().map(|[x, y]| x.hypot(y))?,
        _ => return None,
    };
    Some(Bar {
        algebra: unbalanced,
        ..Bar::default()
    })
}

/// A bar without a name for its origin.
fn plain(discretisation: f64) -> Bar {
    Bar {
        discretisation,
        ..Bar::default()
    }
}

/// What the rules look at.
struct Rules<'a> {
    study: &'a Study,
    film: &'a FilmSolution,
    cubic: &'a FilmSolution,
    error: &'a FilmError,
    /// On either film.
    measured: [&'a Measured; 2],
    /// Which film that is.
    value: Value,
}

impl Rules<'_> {
    /// The bar of a number at the position of the film; `other` is that of the other film. None if it cannot be trusted.
    fn bar(&self, quantity: &Quantity, other: &Quantity) -> Option<Bar> {
        let error = self.error;
        let name = quantity.name.as_str();
        let of_position = matches!(name, "eccentricity" | "min_film_angle" | "film_thickness_min");
        if is_given(name) || (of_position && self.study.load.is_none()) {
            return Some(Bar::default());
        }
        if !error.is_resolved() {
            return None;
        }
        if of_position {
            return Some(Bar::default());
        }
        let signed = quantity.value - other.value;
        let change = signed.abs();
        let (along, across) = (error.load(self.value), error.across(self.value));
        let [x, y] = error.force;
        let force = x.hypot(y);
        // A load that cannot be told from none has no direction along which or across which it may be off.
        let vanishes = along.total() + across.total() >= force;
        let bar = match name {
            "load" if vanishes => along + across,
            "load_angle" | "attitude_angle" if vanishes => plain(180.0),
            "load_coefficient" | "sommerfeld_number" if force == 0.0 => Bar::default(),
            "load_coefficient" | "sommerfeld_number" if vanishes => (along + across).scaled(quantity.value / force),
            "load" => along,
            "load_x" => self.product([1.0, 0.0]),
            "load_y" => self.product([0.0, 1.0]),
            joint::FILM_SHARE => self.product(self.study.film_share()?),
            "load_angle" | "attitude_angle" => across.scaled(1f64.to_degrees() / force),
            "load_coefficient" | "sommerfeld_number" => along.scaled(quantity.value / force),
            "pressure_integral" => error.pressure_integral(self.value),
            "pressure_max" => plain(self.greatest_pressure(change)),
            "pressure_min" if self.film.cavity.contains(&true) => Bar::default(),
            "pressure_min" => plain(self.apart(
                change,
                self.extremes().into_iter().filter_map(|extremes| extremes.least_in),
            )),
            "viscosity_max" => plain(self.viscosity(quantity.value)),
            "cavity_share" => plain(change + 0.4 * self.front_share()),
            "side_flow" => self.flow(&FlowGoal::Ends, change)?,
            "side_flow_number" => {
                let unit = self.flow_unit()?;
                self.flow(&FlowGoal::Ends, change * unit)?.scaled(1.0 / unit)
            }
            "inlet_flow" | "inlet_flow_number" => plain(change),
            "friction_cavity_power" => plain(change + self.front_share() * self.judged().power.shear),
            _ if name.starts_with("friction_") => self.friction(name, quantity.value, signed, vanishes)?,
            "squeeze_power" => self.product(self.study.problem.journal.velocity),
            "cavity_flow" => self.cavity_flow(change)?,
            _ => self.flow(&flow_goal(name)?, change)?,
        };
        Some(bar)
    }

    /// Bar of the product of the load with a vector.
    fn product(&self, [u, v]: [f64; 2]) -> Bar {
        let (along, across) = (self.error.load(self.value), self.error.across(self.value));
        let [x, y] = self.error.force;
        let force = x.hypot(y);
        match along.total() + across.total() >= force {
            true => (along + across).scaled(u.hypot(v)),
            false => along.scaled((u * x + v * y) / force) + across.scaled((u * y - v * x) / force),
        }
    }

    fn flow_unit(&self) -> Option<f64> {
        similarity::flow_unit(&self.study.problem.bearing, &self.study.problem.journal)
    }

    /// Bar of a number of friction, which changes by `change` between the two films. None of the coefficient where the load may be none.
    fn friction(&self, name: &str, value: f64, change: f64, vanishes: bool) -> Option<Bar> {
        let speed = self.study.problem.journal.speed.abs();
        let (parts, unit) = match name {
            "friction_torque" => ([1.0, 1.0], 1.0 / speed),
            "friction_torque_bearing" => ([1.0, -1.0], 1.0 / speed),
            "friction_power" => ([1.0, 1.0], 1.0),
            "friction_shear_power" => ([1.0, 0.0], 1.0),
            "friction_pressure_power" => ([0.0, 1.0], 1.0),
            _ => return self.friction_coefficient(value, vanishes),
        };
        Some(self.error.drag(parts, change / unit, self.value).scaled(unit))
    }

    /// Torque and load may both be off.
    fn friction_coefficient(&self, value: f64, vanishes: bool) -> Option<Bar> {
        let [quadratic, cubic] = self.measured.map(|measured| measured.power.friction());
        let torque = self.error.drag([1.0, 1.0], cubic - quadratic, self.value);
        let (power, force) = (self.judged().power.friction(), self.judged().load.magnitude());
        let load = self.error.load(self.value).scaled(value / force);
        (!vanishes).then(|| torque.scaled(value / power) + load)
    }

    /// Extremes of pressure of the quadratic and of the cubic film.
    fn extremes(&self) -> [Extremes; 2] {
        self.measured.map(|measured| measured.extremes)
    }

    /// Bar [Pa] of the greatest pressure, which changes by `change` between the two films.
    fn greatest_pressure(&self, change: f64) -> f64 {
        self.apart(change, self.extremes().map(|extremes| extremes.greatest_in))
    }

    /// Bar [Pa] of an extreme pressure: how far the two films are apart in the triangles that hold their extremes.
    fn apart(&self, change: f64, triangles: impl IntoIterator<Item = usize>) -> f64 {
        let Study { problem, system, .. } = self.study;
        let quadratic = Field {
            space: system.space(),
            values: &self.film.unknown,
        };
        let cubic = Field {
            space: system.cubic().system.space(),
            values: &self.cubic.unknown,
        };
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
        let furthest = triangles.into_iter().map(apart).fold(0.0, f64::max);
        match self.value {
            Value::Quadratic => (1.25 * change).max(furthest),
            Value::Cubic => (0.3 * change).max(0.5 * furthest),
        }
    }

    /// Bar [Pa s] of the greatest viscosity, by that of the greatest pressure.
    fn viscosity(&self, value: f64) -> f64 {
        let problem = &self.study.problem;
        let [quadratic, cubic] = self.extremes().map(|extremes| extremes.greatest);
        let greatest = self.judged().extremes.greatest;
        let bar = self.greatest_pressure((cubic - quadratic).abs());
        let above = (problem.viscosity_at(greatest + bar) - value).abs();
        above.max((problem.viscosity_at(greatest - bar) - value).abs())
    }

    /// What was measured on the film whose numbers are judged.
    fn judged(&self) -> &Measured {
        match self.value {
            Value::Quadratic => self.measured[0],
            Value::Cubic => self.measured[1],
        }
    }

    /// Share of the area [1] in triangles through which the edge of the cavity runs.
    fn front_share(&self) -> f64 {
        let system: &FilmSystem = &self.study.system.cubic().system;
        let (space, mesh) = (system.space(), system.space().mesh());
        let problem = &self.study.problem;
        let dropped = problem.cavitation.kink().map(|p| problem.unknown_at(p));
        let in_cavity =
            |dof: usize| self.cubic.cavity[dof] || dropped.is_some_and(|floor| self.cubic.unknown[dof] < floor);
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

    fn unsure(&self, goal: &FlowGoal) -> f64 {
        let regions = self
            .study
            .system
            .supply
            .regions()
            .iter()
            .zip(&self.judged().flows.regions);
        let counts = |region: &oilwedge_reynolds::supply::SupplyRegion| match goal {
            FlowGoal::Ends => region.place == oilwedge_reynolds::supply::Place::End,
            FlowGoal::End(name) | FlowGoal::Feed(name) => region.name == *name,
        };
        regions
            .filter(|(region, _)| counts(region))
            .map(|(_, flow)| flow.unsure)
            .sum()
    }

    /// Bar of a flow that differs by `change` between the two films.
    fn flow(&self, goal: &FlowGoal, change: f64) -> Option<Bar> {
        let (_, error) = self.error.flows.iter().find(|(other, _)| other == goal)?;
        let bar = self.error.flow(error, self.unsure(goal), self.value);
        // What a cavity makes beside an end is booked apart from the residuals, so that the two may change by another amount.
        Some(Bar {
            discretisation: bar.discretisation.max(change),
            ..bar
        })
    }

    /// What the cavity makes is what all others bring and take.
    fn cavity_flow(&self, change: f64) -> Option<Bar> {
        let goals = self.error.flows.iter().map(|(goal, _)| goal);
        let once = goals.filter(|goal| !matches!(goal, FlowGoal::End(_)));
        let all: Option<Vec<Bar>> = once.map(|goal| self.flow(goal, 0.0)).collect();
        Some(all?.into_iter().fold(plain(change), |sum, bar| sum + bar))
    }
}

/// The flow of this name.
fn flow_goal(name: &str) -> Option<FlowGoal> {
    let end = name
        .strip_prefix("side_flow_")
        .map(|end| FlowGoal::End(format!("end_{end}")));
    end.or_else(|| Some(FlowGoal::Feed(name.strip_prefix("feed_flow.")?.to_owned())))
}

/// Numbers without an error: parts of the load over regions cut out, whose pressure and shape are given, what bolts must hold,
/// and the temperature of the film, which is given or has a bar of its own.
pub fn is_given(name: &str) -> bool {
    matches!(name, "temperature_effective" | "viscosity_effective")
        || thermal::is_of_heat(name)
        || name.starts_with("load_x.")
        || name.starts_with("load_y.")
        || joint::is_given(name)
}
