//! # The sharp hill: pressure in quadratic and cubic elements over the cavity of a mass-conserving film
//!
//! **Equation.** With `k = h^3/(12 mu)`, `F = U h/2` and the reduced pressure v above that of the cavity
//! ```text
//! Int k grad v . grad w dA = Int T/h F . grad w dA        for all w
//! T = h                     on the side of rupture, where v >= 0 is an obstacle
//! T = g + (h - g) chi       on the side of reformation while g < h,    chi = clip(v/e0, 0, 1)
//! ```
//! The finite volumes of the film tell where cavities are and the oil `g(z) = h theta` that they carry. Rays along the
//! flow carry it on (`rays`); rupture and reformation are found anew (`balance`, `hill`). The front is smeared over a
//! triangle: where coefficients are constant its full side is exact, and `chi v` has the area of the sharp one, so that
//! loads are integrals of it (`numbers`).
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | v | Pa | `v` |
//! | g | m | `oil` |
//! | e0 | Pa | `width` |
//!
//! **Source.** The free boundary and its condition: Jakobsson and Floberg, Chalmers Report 190 (1957); the contact of
//! quadratic elements: Brezzi, Hager, Raviart, Numer. Math. 28 (1977) 431. **Range.** Steady films without pockets,
//! starved edges or axial sliding. Flows, film fraction and cavity are those of the finite volumes. **Verified by**
//! `cavitation/sharp`: Swift-Stieber films, finer meshes.

mod balance;
mod hill;
mod numbers;
mod rays;

use oilwedge_fem::Error;
use oilwedge_fem::newton::{NewtonFailure, NewtonStep};

use self::balance::HillBalance;
use self::hill::{Hill, Kept, NodeKinds};
pub use self::numbers::HillNumbers;
use self::rays::{RaySide, Rays};
use crate::cavitation::oil_carried;
use crate::{Cavitation, FilmProblem, FilmSystem, Form, SolvedFilm, Theory};

/// Residual over the greatest share of a node at which a reported hill is found.
const SOLVED: f64 = 1e-8;
/// Residual at which a hill is found whose force is to balance a load.
const BALANCED: f64 = 1e-12;
/// Residual at which a hill is found that others are compared with.
const COMPARED: f64 = 1e-6;

/// The hill over the cavity of one film.
#[derive(Debug)]
pub struct SharpFilm {
    /// Numbers of the hill in cubic elements.
    pub cubic: HillNumbers,
    /// Numbers in cubic elements less those in quadratic elements.
    pub by_degree: HillNumbers,
    /// What they change by, to first order, with as much more oil as keeps cavities from making or losing any.
    pub by_oil: HillNumbers,
    /// What they change by where cavities are found anew at this position; zero where they are those of this position.
    pub by_cavities: HillNumbers,
    /// How much oil that is, as a part of that which arrives.
    pub lost: f64,
    /// Steps of both degrees.
    pub history: Vec<NewtonStep>,
    kept: Kept,
    frame: HillFrame,
}

/// What a hill starts from.
#[derive(Debug)]
pub enum HillStart {
    /// The film: in quadratic elements, then in cubic ones.
    Film,
    /// The hill of a position nearby on the same system: in cubic elements alone. What degree and oil change is that
    /// which they change there.
    Near(SharpFilm),
    /// The hill of a position nearby, in cubic elements alone, over the cavities found there and with the oil that
    /// arrives at them here. The force is then a smooth function of the position.
    SameCavities(SharpFilm),
}

/// What of a hill is found once and does not follow the position smoothly.
#[derive(Debug)]
struct HillFrame {
    rays: Rays,
    /// Nodes of cubic elements.
    nodes: NodeKinds,
    /// Dofs of the film that are in a cavity.
    cavity: Vec<bool>,
}

impl FilmProblem {
    /// True if a hill is a film of this problem.
    fn has_sharp_film(&self, system: &FilmSystem) -> bool {
        let starved = |region: &crate::supply::SupplyRegion| region.film_fraction.is_some();
        matches!(self.cavitation, Cavitation::Jfo { .. })
            && self.form == Form::Conservative
            && self.storage.is_none()
            && self.theory == Theory::Full
            && self.journal.velocity == [0.0; 2]
            && self.journal.axial_velocity == 0.0
            && self.journal.speed != 0.0
            && self.film_thickness.len() == 1
            && !self.is_rough()
            && self.viscosity_across.is_none()
            && system.space().degree() == 2
            && !system.supply.regions().iter().any(starved)
    }

    /// Reduced pressure [Pa] of the cavity.
    pub(super) fn cavity_unknown(&self) -> f64 {
        self.cavitation.pressure().map_or(0.0, |p| self.unknown_at(p))
    }

    /// The numbers of a hill at v.
    fn measured(&self, system: &FilmSystem, hill: &Hill, v: &[f64]) -> Result<HillNumbers, NewtonFailure> {
        let numbers = numbers::measure(self, system, v, &hill.balance.filled(v));
        match numbers.greatest.is_finite() && numbers.load.possible.is_finite() {
            true => Ok(numbers),
            false => Err(Error::NotFinite { what: "pressure of the sharp hill" }.into()),
        }
    }

    /// A hill on `system` that is to start from another one.
    fn hill<'a>(
        &self,
        system: &'a FilmSystem,
        rays: &Rays,
        nodes: NodeKinds,
        start: Kept,
    ) -> Result<Hill<'a>, NewtonFailure> {
        let may_be = |(&held, &may): (&bool, &bool)| held && may;
        let mut balance = HillBalance::new(self, system, rays);
        if !start.along.is_empty() {
            balance.along = start.along;
        }
        Ok(Hill {
            balance,
            analysis: system.unsymmetric()?,
            v: start.v,
            held: start.held.iter().zip(&nodes.may_touch).map(may_be).collect(),
            nodes,
            linearisation: start.linearisation,
            is_stale: false,
            history: Vec::new(),
        })
    }
}

impl SolvedFilm {
    /// The hill over the cavity of this film; none where it is not of the kind that has one.
    ///
    /// # Errors
    /// [`NewtonFailure`]: rupture and reformation were not found, or the viscosity law has no pressure for the film.
    pub fn sharp_film(&self, start: HillStart) -> Result<Option<SharpFilm>, NewtonFailure> {
        let Self { problem, system, solution } = self;
        let Some(fraction) = solution.film_fraction.as_ref().filter(|_| problem.has_sharp_film(system)) else {
            return Ok(None);
        };
        let oil = oil_carried(problem, system, fraction)?;
        let hill = match start {
            HillStart::Film => self.first_hill(Rays::new(self, &oil)),
            HillStart::Near(near) => {
                let frame = self.frame(&oil);
                self.hill_near(SharpFilm { frame, ..near }, SOLVED)
            }
            HillStart::SameCavities(mut near) => {
                near.frame.rays.refill(system.space(), &oil);
                self.hill_near(near, BALANCED)
            }
        };
        hill.map(Some)
    }

    /// This `hill` of this film, with what it would change by if its cavities were those of this position.
    ///
    /// # Errors
    /// [`NewtonFailure`]: rupture and reformation were not found.
    pub fn cavities_checked(&self, hill: SharpFilm) -> Result<SharpFilm, NewtonFailure> {
        let Some(fraction) = &self.solution.film_fraction else {
            return Ok(hill);
        };
        if hill.frame.cavity == self.solution.cavity && hill.frame.rays.are_those_of(self) {
            return Ok(hill);
        }
        let cubic = hill.cubic;
        let oil = oil_carried(&self.problem, &self.system, fraction)?;
        let frame = self.frame(&oil);
        let anew = self.hill_near(SharpFilm { frame, ..hill }, SOLVED)?;
        Ok(SharpFilm { by_cavities: anew.cubic.less(&cubic), cubic, ..anew })
    }

    /// Finds the hill in quadratic elements, then in cubic ones.
    fn first_hill(&self, rays: Rays) -> Result<SharpFilm, NewtonFailure> {
        let Self { problem, system, solution } = self;
        let floor = problem.cavity_unknown();
        let start = Kept {
            v: solution.unknown.iter().map(|u| u - floor).collect(),
            held: solution.cavity.clone(),
            ..Kept::default()
        };
        let nodes = self.nodes(system, &rays);
        let mut quadratic = problem.hill(system, &rays, nodes, start)?;
        quadratic.renew_direction();
        quadratic.solve(COMPARED)?;
        let cubic_system = system.cubic();
        let start = Kept {
            v: cubic_system.prolongation.prolong(&quadratic.v),
            held: quadratic.contact_in(cubic_system.system.space()),
            along: std::mem::take(&mut quadratic.balance.along),
            linearisation: None,
        };
        let nodes = self.nodes(&cubic_system.system, &rays);
        let mut cubic = problem.hill(&cubic_system.system, &rays, nodes, start)?;
        cubic.solve(SOLVED)?;
        quadratic.balance.along.clone_from(&cubic.balance.along);
        let (replenished, lost) = cubic.replenished()?;
        let numbers = problem.measured(&cubic_system.system, &cubic, &cubic.v)?;
        let mut history = std::mem::take(&mut quadratic.history);
        history.append(&mut cubic.history);
        let by_degree = numbers.less(&problem.measured(system, &quadratic, &quadratic.v)?);
        let by_oil = (problem.measured(&cubic_system.system, &cubic, &replenished)?).less(&numbers);
        let (kept, nodes) = cubic.kept();
        Ok(SharpFilm {
            by_degree,
            by_oil,
            by_cavities: numbers.less(&numbers),
            cubic: numbers,
            lost,
            history,
            kept,
            frame: HillFrame { rays, nodes, cavity: solution.cavity.clone() },
        })
    }

    /// The hill in cubic elements, from the hill of a position nearby, in its frame, until the residual is `enough`.
    fn hill_near(&self, near: SharpFilm, enough: f64) -> Result<SharpFilm, NewtonFailure> {
        let (problem, cubic_system) = (&self.problem, &self.system.cubic().system);
        let HillFrame { rays, nodes, cavity } = near.frame;
        let mut cubic = problem.hill(cubic_system, &rays, nodes, near.kept)?;
        cubic.solve(enough)?;
        let numbers = problem.measured(cubic_system, &cubic, &cubic.v)?;
        let history = std::mem::take(&mut cubic.history);
        let (kept, nodes) = cubic.kept();
        Ok(SharpFilm { cubic: numbers, history, kept, frame: HillFrame { rays, nodes, cavity }, ..near })
    }

    /// What is found once at the position of this film.
    fn frame(&self, oil: &[f64]) -> HillFrame {
        let rays = Rays::new(self, oil);
        HillFrame { nodes: self.nodes(&self.system.cubic().system, &rays), cavity: self.solution.cavity.clone(), rays }
    }

    /// What the nodes of `system`, that of quadratic or of cubic elements, are on both sides of the rays, over the
    /// cavity of this film.
    fn nodes(&self, system: &FilmSystem, rays: &Rays) -> NodeKinds {
        let Self { problem, system: quadratic, solution } = self;
        let (space, floor) = (system.space(), problem.cavity_unknown());
        let sides = rays.sides(space);
        let mut given = system.supply.constraints(|p| problem.unknown_at(p));
        for (dof, value) in given.values.iter_mut().enumerate() {
            if given.fixed[dof] {
                *value -= floor;
            }
        }
        let mut nodes = NodeKinds {
            pinned: vec![false; space.dofs()],
            may_touch: vec![false; space.dofs()],
            closed: vec![false; space.dofs()],
            given,
        };
        for t in 0..space.mesh().triangles().len() {
            let dofs = &space.element_dofs(t)[..space.shapes()];
            let of_film = &quadratic.space().element_dofs(t)[..quadratic.space().shapes()];
            if of_film.iter().all(|&dof| solution.cavity[dof]) {
                let any = |wanted: fn(&RaySide) -> bool| dofs.iter().any(|&dof| wanted(&sides[dof]));
                let sees_both =
                    any(|side| *side == RaySide::Rupture) && any(|side| matches!(side, RaySide::Reformation(_)));
                if sees_both || any(|side| *side == RaySide::Bare) {
                    dofs.iter().for_each(|&dof| nodes.pinned[dof] = true);
                }
                dofs.iter().for_each(|&dof| nodes.closed[dof] = nodes.given.fixed[dof]);
            }
            // Quadratic functions of vertices have no mean, so that contact there has no sign.
            let first = if space.degree() == 2 { 3 } else { 0 };
            for &dof in &dofs[first..] {
                nodes.may_touch[dof] =
                    !nodes.given.fixed[dof] && matches!(sides[dof], RaySide::Rupture | RaySide::Bare);
            }
        }
        for dof in 0..space.dofs() {
            nodes.pinned[dof] &= !nodes.given.fixed[dof];
            nodes.may_touch[dof] &= !nodes.pinned[dof];
        }
        nodes
    }
}
