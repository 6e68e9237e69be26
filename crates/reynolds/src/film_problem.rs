//! One film, compiled: what is simulated, chosen once; and its solution.

use std::sync::Arc;

use oilwedge_fem::newton::{self, Failure, HistoryStep, Seconds};
use oilwedge_fem::{Analysis, Assembler, Constraints, Field, Linearisation, Space, transfer};
use oilwedge_mesh::Mesh;
use oilwedge_mesh::refine::Child;

use crate::film_law::FilmLaw;
use crate::film_thickness::FilmContribution;
use crate::lubricant::{Barus, Lubricant};
use crate::supply::{Supply, SupplyError, SupplyRegion};
use crate::terms::Term;
use crate::{Bearing, Cavitation, FilmPoint, JournalState};

/// Speeds of an as-printed film are bisected to this fraction of the speed asked for.
const FOLD_RESOLUTION: f64 = 1e-4;

/// How viscosity that depends on pressure enters the equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Form {
    /// Under the divergence, as mass balance has it; the unknown is the reduced pressure q.
    Conservative,
    /// On the right-hand side, `div(h^3/(12 mu0) grad p) = exp(alpha p) div(U h/2)`, as the FlexPDE
    /// study prints it; the unknown is p. No mass balance; it has a fold and no solution past it.
    AsPrinted(Barus),
}

/// A film for a given journal state: one entry a socket, lists where contributions add up.
pub struct FilmProblem {
    /// Dimensions and end pressure.
    pub bearing: Bearing,
    /// Position and rotation of the journal.
    pub journal: JournalState,
    /// Film thickness: a sum.
    pub film_thickness: Vec<Box<dyn FilmContribution>>,
    /// The oil.
    pub lubricant: Lubricant,
    /// How its viscosity enters.
    pub form: Form,
    /// Fluxes: a sum.
    pub terms: Vec<Box<dyn Term>>,
    /// What closes the law where the film breaks.
    pub cavitation: Cavitation,
}

/// Everything that depends on mesh and supply only: numbered, analysed once, used for every solve.
#[derive(Debug)]
pub struct FilmSystem {
    /// Assembles on the space of quadratic elements.
    pub assembler: Assembler,
    /// The analysed pattern of the Cholesky factor.
    pub analysis: Arc<Analysis>,
    /// Where pressure is given.
    pub supply: Supply,
}

/// Why a mesh and its supply make no system.
#[derive(Debug, thiserror::Error)]
pub enum SystemError {
    /// Given pressures and mesh do not fit.
    #[error("the given pressures do not fit the mesh")]
    Supply(Vec<SupplyError>),
    /// The system is too large.
    #[error(transparent)]
    Fem(#[from] oilwedge_fem::Error),
}

impl FilmSystem {
    /// Elements of degree `degree` on `mesh`, with pressures given on `regions`.
    ///
    /// # Errors
    /// Every misfit of mesh and regions, or a system that does not fit in memory.
    pub fn new(mesh: Arc<Mesh>, degree: usize, regions: Vec<SupplyRegion>) -> Result<Self, SystemError> {
        let space = Space::new(mesh, degree);
        let supply = Supply::new(&space, regions).map_err(SystemError::Supply)?;
        let assembler = Assembler::new(space);
        let analysis = Arc::new(Analysis::new(assembler.space(), assembler.sparsity().clone())?);
        Ok(Self {
            assembler,
            analysis,
            supply,
        })
    }

    /// The space of the unknown.
    pub fn space(&self) -> &Space {
        self.assembler.space()
    }
}

/// Why there is no film to report.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoFilm {
    /// The viscosity law has no pressure for the reduced pressure found.
    #[error(
        "no steady film: the reduced pressure q reaches {reached:.4e} Pa, {} of the {limit:.4e} Pa at which the viscosity law makes the pressure infinite{}; lower speed, eccentricity or viscosity, or use a law that grows slower (Roelands)",
        readable(*ratio), greatest_speed.map_or(String::new(), |speed| format!(", which it reaches at {} rad/s", readable(speed)))
    )]
    AboveLimit {
        /// Greatest reduced pressure [Pa].
        reached: f64,
        /// Limit of the law [Pa].
        limit: f64,
        /// Their ratio.
        ratio: f64,
        /// Speed [rad/s] up to which there is a film, where it can be told.
        greatest_speed: Option<f64>,
    },
    /// The pressure falls below what the viscosity law covers.
    #[error(
        "no steady film: the pressure falls to where Roelands' law ends (q = {reached:.4e} Pa below {floor:.4e} Pa); add [cavitation]"
    )]
    BelowFloor {
        /// Least reduced pressure [Pa].
        reached: f64,
        /// Floor of the law [Pa].
        floor: f64,
    },
    /// The as-printed equation has no solution at this speed.
    #[error(
        "the as-printed equation has no solution above {} rad/s (its fold; asked for {} rad/s); lower speed or eccentricity, or use form = \"conservative\"",
        readable(*last), readable(*asked)
    )]
    Fold {
        /// Last speed with a solution [rad/s].
        last: f64,
        /// Speed asked for [rad/s].
        asked: f64,
    },
    /// The iteration failed.
    #[error("not converged: {0}")]
    NotConverged(#[from] Failure),
}

/// Six significant digits, without an exponent where that is short.
fn readable(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    if (1e-4..1e7).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// The solved film.
#[derive(Debug)]
pub struct FilmSolution {
    /// The unknown at each dof [Pa]: reduced pressure q, or p of an as-printed film.
    pub unknown: Vec<f64>,
    /// Volume flow [m3/s] into the film near each dof where pressure is given; rounding elsewhere.
    pub inflow: Vec<f64>,
    /// The factorised tangent.
    pub linearisation: Linearisation,
    /// One entry a linear solve on the way.
    pub history: Vec<HistoryStep>,
    /// Where the time went.
    pub seconds: Seconds,
    /// Films solved on coarser levels to start from.
    pub levels: usize,
}

impl FilmProblem {
    /// Solves the film.
    ///
    /// # Errors
    /// [`NoFilm`]: the reason why there is none.
    pub fn solve(&self, system: &FilmSystem) -> Result<FilmSolution, NoFilm> {
        let constraints = system.supply.constraints(|p| self.unknown_at(p));
        let start = vec![0.0; system.space().dofs()];
        match self.form {
            Form::Conservative => {
                let film = self.solve_scaled(system, &constraints, 1.0, start)?;
                self.check_existence(system, &film)?;
                Ok(film)
            }
            Form::AsPrinted(_) => {
                let coarse = self.solve_coarse(system);
                let levels = usize::from(coarse.is_some());
                let film = self.solve_scaled(system, &constraints, 1.0, coarse.unwrap_or(start));
                let film = film.or_else(|_| self.continue_in_speed(system, &constraints))?;
                Ok(FilmSolution { levels, ..film })
            }
        }
    }

    /// Nested iteration: the film with linear elements on the same mesh, carried to the quadratic ones. It
    /// takes a quarter of the unknowns and leaves Newton's method little to do. None if it fails.
    fn solve_coarse(&self, system: &FilmSystem) -> Option<Vec<f64>> {
        let mesh = system.space().mesh();
        let coarse = FilmSystem::new(mesh.clone(), 1, system.supply.regions().to_vec()).ok()?;
        let constraints = coarse.supply.constraints(|p| self.unknown_at(p));
        let start = vec![0.0; coarse.space().dofs()];
        let film = self.solve_scaled(&coarse, &constraints, 1.0, start).ok()?;
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let lineage: Vec<Child> = (0..mesh.triangles().len() as u32)
            .map(|parent| Child { parent, corners })
            .collect();
        let field = Field {
            space: coarse.space(),
            values: &film.unknown,
        };
        Some(transfer(&field, system.space(), &lineage))
    }

    /// Pressure [Pa] that drag through the clearance makes, `mu0 U R/c^2`, or the greatest given one.
    fn pressure_scale(&self, constraints: &Constraints) -> f64 {
        let slenderness = self.bearing.radius / self.bearing.clearance;
        let drag = self.lubricant.viscosity * self.journal.speed.abs() * slenderness.powi(2);
        constraints
            .values
            .iter()
            .fold(drag, |scale, given| scale.max(given.abs()))
    }

    fn solve_scaled(
        &self,
        system: &FilmSystem,
        constraints: &Constraints,
        speed_factor: f64,
        start: Vec<f64>,
    ) -> Result<FilmSolution, Failure> {
        let law = FilmLaw::new(self, speed_factor);
        let solution = newton::solve(
            &system.assembler,
            &system.analysis,
            &law,
            constraints,
            self.pressure_scale(constraints),
            start,
        )?;
        Ok(FilmSolution {
            unknown: solution.u,
            inflow: solution.reactions,
            linearisation: solution.linearisation,
            history: solution.history,
            seconds: solution.seconds,
            levels: 0,
        })
    }

    /// Raises the speed from rest in steps, each started from the last solution. The least steps
    /// close in on the fold, the speed past which the stable branch has no solution.
    fn continue_in_speed(&self, system: &FilmSystem, constraints: &Constraints) -> Result<FilmSolution, NoFilm> {
        let start = vec![0.0; system.space().dofs()];
        let mut film = self.solve_scaled(system, constraints, 0.0, start)?;
        let (mut reached, mut step) = (0.0, 0.25);
        loop {
            let next: f64 = f64::min(reached + step, 1.0);
            match self.solve_scaled(system, constraints, next, film.unknown.clone()) {
                Ok(mut solution) => {
                    let mut history = film.history;
                    history.append(&mut solution.history);
                    film = FilmSolution { history, ..solution };
                    reached = next;
                    if reached == 1.0 {
                        return Ok(film);
                    }
                }
                Err(_) if step > FOLD_RESOLUTION => step *= 0.5,
                // A stable branch left behind is a fold; a branch that never began is something else.
                Err(_) if reached > 0.0 => {
                    let asked = self.journal.speed.abs();
                    return Err(NoFilm::Fold {
                        last: reached * asked,
                        asked,
                    });
                }
                Err(failure) => return Err(failure.into()),
            }
        }
    }

    /// A reduced pressure at or above the limit of the viscosity law has no pressure.
    fn check_existence(&self, system: &FilmSystem, film: &FilmSolution) -> Result<(), NoFilm> {
        let law = &self.lubricant.pressure_law;
        let field = Field {
            space: system.space(),
            values: &film.unknown,
        };
        let (limit, floor) = (law.limit(), law.floor());
        let reached = field.maximum().value;
        if reached >= limit {
            return Err(NoFilm::AboveLimit {
                reached,
                limit,
                ratio: reached / limit,
                greatest_speed: self.greatest_speed(system, film, limit),
            });
        }
        let least = field.minimum().value;
        // Pressures that Guembel's film drops need no viscosity.
        let dropped = self.cavitation.kink().is_some_and(|p| self.unknown_at(p) > floor);
        if least <= floor && !dropped {
            return Err(NoFilm::BelowFloor { reached: least, floor });
        }
        Ok(())
    }

    /// The film is linear in the speed, q = q0 + (speed factor) q1, and its maximum a convex function of
    /// it: Newton's method on `max q = limit` finds the greatest speed [rad/s] from above.
    fn greatest_speed(&self, system: &FilmSystem, film: &FilmSolution, limit: f64) -> Option<f64> {
        const STEPS: usize = 20;
        let space = system.space();
        let at_rest = system.assembler.residual(&FilmLaw::new(self, 0.0), &film.unknown);
        let by_speed = film.linearisation.solve(&at_rest).ok()?;
        let mut factor = 1.0;
        for _ in 0..STEPS {
            let shifted = film.unknown.iter().zip(&by_speed);
            let q: Vec<f64> = shifted.map(|(q, q1)| q + (factor - 1.0) * q1).collect();
            let top = Field { space, values: &q }.maximum();
            let slope = Field {
                space,
                values: &by_speed,
            }
            .value(top.triangle, top.point);
            let change = (limit - top.value) / slope;
            factor += change;
            if !(slope > 0.0 && factor > 0.0) {
                return None;
            }
            if change.abs() < 1e-12 {
                return Some(factor * self.journal.speed.abs());
            }
        }
        None
    }

    /// Velocity `(U_x, U_z)` [m/s] of the journal's surface.
    pub fn surface_velocity(&self) -> [f64; 2] {
        [self.journal.speed * self.bearing.radius, self.journal.axial_velocity]
    }

    /// The unknown at a point where the pressure is `p` [Pa].
    pub fn unknown_at(&self, p: f64) -> f64 {
        match self.form {
            Form::Conservative => self.lubricant.pressure_law.reduced_pressure(p),
            Form::AsPrinted(_) => p,
        }
    }

    /// The pressure [Pa] that the film exerts where the unknown is `u`.
    pub fn pressure_at(&self, u: f64) -> f64 {
        self.cavitation.effective_pressure(self.equation_pressure(u))
    }

    /// The pressure [Pa] that the equation gives where the unknown is `u`.
    pub fn equation_pressure(&self, u: f64) -> f64 {
        match self.form {
            Form::Conservative => self.lubricant.pressure_law.pressure(u),
            Form::AsPrinted(_) => u,
        }
    }

    /// Viscosity [Pa s] at the pressure `p` [Pa].
    pub fn viscosity_at(&self, p: f64) -> f64 {
        self.lubricant.viscosity * self.lubricant.pressure_law.viscosity_ratio(p)
    }

    /// Film thickness [m] at positions [m] in triangle `cell`.
    pub fn thickness_at(&self, cell: usize, positions: &[[f64; 2]]) -> Vec<f64> {
        let mut film = vec![FilmPoint::default(); positions.len()];
        for contribution in &self.film_thickness {
            contribution.add(&self.journal, cell, positions, &mut film);
        }
        film.into_iter().map(|point| point.thickness).collect()
    }
}
