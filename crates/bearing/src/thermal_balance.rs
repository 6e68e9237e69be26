//! # Heat balance: the temperature at which friction heats the oil as much as it carries off
//!
//! **Equation.** For the mean temperature t of the film, at which it has its viscosity,
//! ```text
//! P(t) = rho c Q(t) (t_out - t_0) + G (t - t_a),      t = (t_in + t_out)/2,      t_in = t_0 + (t_out - t_in) r
//! ```
//! Q is the oil that leaves the film, and is fed with the temperature t_0; r = q_0/q_1 is what goes round hot with the
//! journal and mixes with it, over that. So `t_out - t_0 = 2 (t - t_0) (1 + r)/(1 + 2 r)`. P falls with t and the right
//! side rises: there is one root.
//!
//! The flows at a temperature t lead to another one, g(t), at which they would be balanced; as P falls and Q rises, the
//! root lies between t and g(t): that brackets it from any start. Within, secants, bisected where they are slow, so it
//! always converges. A steady film has t as an unknown beside its position instead ([`crate::Heated`]).
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | P, Q, r | W, m3/s, - | `power`, `flow`, `carried_over` |
//! | t_0, rho c | K, J/(m3 K) | `inlet`, `heat_capacity` |
//! | G, t_a | W/K, K | `conductance`, `ambient` |
//! | P - right side | W | `surplus` |
//!
//! **Source.** Heat balance of engine bearings in textbooks on engine design (eqs. 19.9 to 19.11 and eight steps), with
//! hot oil carried over as in the design of a tractor engine (in Ukrainian); ISO 7902-1. **Range.** One temperature for
//! all of the film; what the feeds' pressure puts in is left out. **Verified by**
//! `tests/tests/literature/thermal_balance.rs`, and the tests below.

/// What heats and what cools one film at a temperature.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ThermalFlows {
    /// Power of friction P [W].
    pub power: f64,
    /// Oil that leaves the film Q [m3/s].
    pub flow: f64,
    /// Oil that goes round hot and mixes with the fresh one, over that which leaves [1].
    pub carried_over: f64,
}

/// What the heat goes into.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThermalBalance {
    /// Temperature t_0 of the oil that is fed [K].
    pub inlet: f64,
    /// Heat capacity per volume rho c [J/(m3 K)].
    pub heat_capacity: f64,
    /// What the housing gives off, if it does.
    pub housing: Option<Housing>,
}

/// A housing at the temperature of the film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Housing {
    /// Heat conductance G from the film to what is around [W/K].
    pub conductance: f64,
    /// Temperature t_a around [K].
    pub ambient: f64,
}

/// The film's temperature is sought up to so much above the inlet [K].
pub const HOTTEST: f64 = 250.0;
/// Longest step of the logarithm of the viscosity in a search for the temperature: a factor of two. A prototype failed
/// with longer ones (`docs/theory/balance.md`).
pub const LONGEST_THINNING: f64 = 0.7;
/// Friction under a load falls with temperature like this power of the viscosity: between that of a thick film, 1, and
/// that of a thin one, whose journal comes nearer.
const FRICTION_EXPONENT: f64 = 0.6;
/// A slope of the surplus further from the usual one than this factor, in either sense, is that of a film that jumps.
const UNUSUAL: f64 = 4.0;
/// Starts [K] above the inlet where there is no film at the first one.
const STARTS: [f64; 4] = [0.0, 10.0, 40.0, 120.0];
/// Steps by the slope go on while each leaves at most this part of the surplus.
const QUICK: f64 = 0.2;
/// A bracket is not narrowed further than this [K].
const NARROW: f64 = 1e-10;
/// Films nearer to one another than this [K] do not show how the surplus changes, where a cavity may jump.
const APART: f64 = 0.01;
/// A film that is sought between a temperature that has one and one that has none is sought to this [K].
const EDGE: f64 = 0.05;
/// Most films.
const MOST_FILMS: usize = 200;

impl ThermalBalance {
    /// Temperatures [K] with which oil enters and leaves a film of the mean temperature `mean` [K].
    pub fn ends(&self, mean: f64, carried_over: f64) -> [f64; 2] {
        let outlet = self.inlet + self.per_mean(carried_over) * (mean - self.inlet);
        [2.0 * mean - outlet, outlet]
    }

    /// `(t_out - t_0)/(t - t_0)`.
    fn per_mean(&self, carried_over: f64) -> f64 {
        2.0 * (1.0 + carried_over) / (1.0 + 2.0 * carried_over)
    }

    /// How much warmer [K] the oil enters, and colder it leaves, for each unit of what is carried over.
    pub fn ends_per_carried_over(&self, mean: f64, carried_over: f64) -> f64 {
        2.0 * (mean - self.inlet) / (1.0 + 2.0 * carried_over).powi(2)
    }

    /// Heat [W] that the oil carries off.
    pub fn carried(&self, mean: f64, film: &ThermalFlows) -> f64 {
        self.heat_capacity * film.flow * self.per_mean(film.carried_over) * (mean - self.inlet)
    }

    /// Heat [W] that the housing gives off.
    pub fn given_off(&self, mean: f64) -> f64 {
        self.housing.map_or(0.0, |housing| housing.conductance * (mean - housing.ambient))
    }

    /// Heat [W] that neither takes.
    pub fn surplus(&self, mean: f64, film: &ThermalFlows) -> f64 {
        film.power - self.carried(mean, film) - self.given_off(mean)
    }

    /// How the surplus changes with temperature [W/K] at a given place, where friction is proportional to the viscosity
    /// and the logarithm of that changes by `thinning` [1/K].
    pub fn slope_at_place(&self, mean: f64, film: &ThermalFlows, thinning: f64) -> f64 {
        film.power * thinning + self.surplus(mean + 1.0, film) - self.surplus(mean, film)
    }

    /// How the surplus usually changes with temperature under a load [W/K].
    pub fn slope_under_load(&self, mean: f64, film: &ThermalFlows, thinning: f64) -> f64 {
        self.slope_at_place(mean, film, thinning) + (FRICTION_EXPONENT - 1.0) * film.power * thinning
    }

    /// The temperature [K] at which these flows would be balanced, infinite where nothing carries heat off.
    fn balanced_by(&self, film: &ThermalFlows) -> f64 {
        let by_oil = (self.heat_capacity * film.flow * self.per_mean(film.carried_over)).max(0.0);
        let (by_housing, ambient) = self.housing.map_or((0.0, 0.0), |housing| (housing.conductance, housing.ambient));
        let supplied = film.power + by_oil * self.inlet + by_housing * ambient;
        supplied / (by_oil + by_housing)
    }

    /// Temperatures [K] between which the film's is sought.
    pub fn range(&self) -> [f64; 2] {
        let ambient = self.housing.map_or(self.inlet, |housing| housing.ambient);
        [self.inlet.min(ambient), self.inlet.max(ambient) + HOTTEST]
    }
}

/// Whether a slope of the surplus that was seen is near enough to the usual one to be followed.
pub fn is_usual(slope: f64, usual: f64) -> bool {
    (1.0 / UNUSUAL..UNUSUAL).contains(&(slope / usual))
}

/// A balanced film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balanced {
    /// Mean temperature of the film [K].
    pub temperature: f64,
    /// What heats and cools it there.
    pub film: ThermalFlows,
    /// Heat that is left over [W].
    pub surplus: f64,
    /// How the surplus falls with temperature [W/K], negative; not a number where one film was enough.
    pub slope: f64,
    /// Films asked for.
    pub films: usize,
}

/// Why there is no balance.
#[derive(Debug, Clone, PartialEq)]
pub enum NoThermalBalance<E> {
    /// There is no film at any temperature.
    NoFilm(E),
    /// Films end before the heat is carried off.
    Ends {
        /// Temperature [K] of the last film.
        temperature: f64,
        /// What heats and cools it.
        film: ThermalFlows,
        /// Why there is none beyond.
        reason: E,
    },
    /// The heat is not carried off at the greatest temperature.
    TooHot {
        /// Greatest temperature [K].
        temperature: f64,
        /// What heats and cools the film there.
        film: ThermalFlows,
    },
}

/// A film at a temperature.
#[derive(Debug, Clone, Copy)]
struct ThermalPoint {
    temperature: f64,
    film: ThermalFlows,
    surplus: f64,
}

impl ThermalPoint {
    /// Whether the surplus is at most this part of the power.
    fn is_balanced(&self, accuracy: f64) -> bool {
        self.surplus.abs() <= accuracy * self.film.power.abs()
    }
}

/// Finds the temperature at which the heat is balanced to the part `accuracy` of the power, from a `start` [K] on.
/// `evaluate` gives what heats and cools the film at a temperature [K].
///
/// # Errors
/// [`NoThermalBalance`]: the reason why there is none.
pub fn find<E>(
    balance: &ThermalBalance,
    start: f64,
    accuracy: f64,
    mut evaluate: impl FnMut(f64) -> Result<ThermalFlows, E>,
) -> Result<Balanced, NoThermalBalance<E>> {
    let [coldest, hottest] = balance.range();
    let mut films = 0;
    let mut at = |temperature: f64| {
        films += 1;
        evaluate(temperature)
            .map(|film| (films, ThermalPoint { temperature, film, surplus: balance.surplus(temperature, &film) }))
    };
    let first = at(start.clamp(coldest, hottest));
    let first = first.or_else(|reason| STARTS.into_iter().find_map(|above| at(coldest + above).ok()).ok_or(reason));
    let (mut films, mut here) = first.map_err(NoThermalBalance::NoFilm)?;
    // A film on the other side of the root, and the nearest temperature beyond which there is none.
    let (mut other, mut edge): (Option<ThermalPoint>, Option<(f64, E)>) = (None, None);
    let mut secant = f64::NAN;
    let (mut slope, mut is_quick, mut width) = (secant, true, f64::INFINITY);
    while !here.is_balanced(accuracy) {
        let by_secant = Some(here.temperature - here.surplus / secant).filter(|_| secant < 0.0);
        let next = match (&other, &edge) {
            (Some(other), _) => {
                let between = 0.5 * (here.temperature + other.temperature);
                let span = (here.temperature - other.temperature).abs();
                if span < NARROW || films > MOST_FILMS {
                    here = if other.surplus.abs() < here.surplus.abs() { *other } else { here };
                    break;
                }
                let is_inside = |next: &f64| 2.0 * (next - between).abs() < span;
                let is_slow = films % 3 == 0 && span > 0.5 * width;
                width = if films % 3 == 0 { span } else { width };
                by_secant.filter(|next| is_inside(next) && !is_slow).unwrap_or(between)
            }
            (None, Some((edge, _))) => 0.5 * (here.temperature + edge),
            (None, None) => {
                let end = if here.surplus > 0.0 { hottest } else { coldest };
                if here.temperature == end || films > MOST_FILMS {
                    return Err(NoThermalBalance::TooHot { temperature: here.temperature, film: here.film });
                }
                let told = balance.balanced_by(&here.film).clamp(coldest, hottest);
                // A little beyond, so that the root does not lie at the end of the bracket.
                let beyond = told + 1e-3 * (told - here.temperature);
                let beyond = if beyond.is_nan() { hottest } else { beyond };
                by_secant.filter(|_| is_quick).unwrap_or(beyond).clamp(coldest, hottest)
            }
        };
        match (at(next), &other) {
            (Ok((number, point)), _) => {
                secant = (point.surplus - here.surplus) / (point.temperature - here.temperature);
                if (point.temperature - here.temperature).abs() > APART {
                    slope = secant;
                }
                is_quick = point.surplus.abs() <= QUICK * here.surplus.abs();
                other = if (point.surplus > 0.0) == (here.surplus > 0.0) { other } else { Some(here) };
                (films, here) = (number, point);
            }
            (Err(reason), Some(_)) => edge = Some((here.temperature, reason)),
            (Err(reason), None) => edge = Some((next, reason)),
        }
        let is_at_edge = |at: f64| (at - here.temperature).abs() < EDGE || films > MOST_FILMS;
        if let Some((_, reason)) = edge.take_if(|(at, _)| is_at_edge(*at)) {
            return Err(NoThermalBalance::Ends { temperature: here.temperature, film: here.film, reason });
        }
    }
    Ok(Balanced { temperature: here.temperature, film: here.film, surplus: here.surplus, slope, films })
}

#[cfg(test)]
mod tests;
