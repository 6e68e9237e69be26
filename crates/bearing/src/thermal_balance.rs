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
//! root lies between t and g(t): that brackets it from any start. Within, false position (Illinois), bisected where
//! that is slow, so it always converges.
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
pub enum NoBalance<E> {
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
        /// That temperature [K].
        temperature: f64,
        /// What heats and cools the film there.
        film: ThermalFlows,
    },
}

/// A film at a temperature.
#[derive(Debug, Clone, Copy)]
struct Point {
    temperature: f64,
    film: ThermalFlows,
    surplus: f64,
}

impl Point {
    /// Whether the surplus is at most this part of the power.
    fn is_balanced(&self, accuracy: f64) -> bool {
        self.surplus.abs() <= accuracy * self.film.power.abs()
    }
}

/// A search for the root.
struct Search<'a, F> {
    balance: &'a ThermalBalance,
    evaluate: F,
    films: usize,
}

impl<E, F: FnMut(f64) -> Result<ThermalFlows, E>> Search<'_, F> {
    fn at(&mut self, temperature: f64) -> Result<Point, E> {
        self.films += 1;
        let film = (self.evaluate)(temperature)?;
        Ok(Point { temperature, film, surplus: self.balance.surplus(temperature, &film) })
    }

    /// The first film: at the start or, where there is none, elsewhere.
    fn first(&mut self, start: f64) -> Result<Point, NoBalance<E>> {
        let reason = match self.at(start) {
            Ok(point) => return Ok(point),
            Err(reason) => reason,
        };
        let [coldest, _] = self.balance.range();
        let found = STARTS.into_iter().find_map(|above| self.at(coldest + above).ok());
        found.ok_or(NoBalance::NoFilm(reason))
    }

    /// The film nearest to the root that secants lead to while they are quick, from a `slope` of the surplus; with the
    /// last slope [W/K].
    fn by_slope(&mut self, first: Point, slope: Option<f64>, accuracy: f64) -> (Point, f64) {
        let [coldest, hottest] = self.balance.range();
        let (mut near, mut last_slope) = (first, slope.unwrap_or(f64::NAN));
        while !near.is_balanced(accuracy) && last_slope < 0.0 {
            let next = near.temperature - near.surplus / last_slope;
            let Some(Ok(point)) = (next > coldest && next < hottest).then(|| self.at(next)) else {
                break;
            };
            if point.surplus.abs() > QUICK * near.surplus.abs() {
                break;
            }
            if (point.temperature - near.temperature).abs() > APART {
                last_slope = (point.surplus - near.surplus) / (point.temperature - near.temperature);
            }
            near = point;
        }
        (near, last_slope)
    }

    /// A film on the other side of the root than `near`.
    fn other_side(&mut self, mut near: Point) -> Result<[Point; 2], NoBalance<E>> {
        let [coldest, hottest] = self.balance.range();
        let mut none_beyond: Option<(f64, E)> = None;
        loop {
            let told = self.balance.balanced_by(&near.film).clamp(coldest, hottest);
            // A little beyond, so that the root does not lie at the end of the bracket.
            let beyond = told + 1e-3 * (told - near.temperature);
            let mut next = if beyond.is_nan() { hottest } else { beyond.clamp(coldest, hottest) };
            if let Some((edge, _)) = &none_beyond {
                next = 0.5 * (near.temperature + edge);
            }
            match self.at(next) {
                Ok(point) if (point.surplus > 0.0) != (near.surplus > 0.0) || point.surplus == 0.0 => {
                    return Ok([near, point]);
                }
                Ok(point) => near = point,
                Err(reason) => none_beyond = Some((next, reason)),
            }
            match none_beyond {
                Some((edge, reason)) if (edge - near.temperature).abs() < EDGE || self.films > MOST_FILMS => {
                    return Err(NoBalance::Ends { temperature: near.temperature, film: near.film, reason });
                }
                other => none_beyond = other,
            }
            let is_last = near.temperature == hottest || near.temperature == coldest || self.films > MOST_FILMS;
            if is_last && none_beyond.is_none() {
                return Err(NoBalance::TooHot { temperature: near.temperature, film: near.film });
            }
        }
    }

    /// Narrows a bracket until the surplus is below `accuracy` of the power; with the slope of the surplus there [W/K].
    fn narrowed(&mut self, [mut a, mut b]: [Point; 2], accuracy: f64) -> Result<(Point, f64), NoBalance<E>> {
        let slope = |a: &Point, b: &Point| (b.surplus - a.surplus) / (b.temperature - a.temperature);
        // What false position takes the surplus at `a` for; `b` is the last film.
        let mut held = a.surplus;
        let (mut last_slope, mut width, mut turns) = (slope(&a, &b), f64::INFINITY, 0);
        loop {
            let best = if a.surplus.abs() < b.surplus.abs() { a } else { b };
            let [low, high] = [a.temperature.min(b.temperature), a.temperature.max(b.temperature)];
            let is_narrow = high - low < NARROW || self.films > MOST_FILMS;
            if best.is_balanced(accuracy) || is_narrow {
                return Ok((best, last_slope));
            }
            let mut next = b.temperature - b.surplus * (b.temperature - a.temperature) / (b.surplus - held);
            turns += 1;
            let is_slow = turns % 3 == 0 && high - low > 0.5 * width;
            if turns % 3 == 0 {
                width = high - low;
            }
            if is_slow || !(next > low && next < high) {
                next = 0.5 * (low + high);
            }
            let point = self.at(next).map_err(|reason| NoBalance::Ends {
                temperature: best.temperature,
                film: best.film,
                reason,
            })?;
            if (point.temperature - best.temperature).abs() > APART {
                last_slope = slope(&best, &point);
            }
            match (point.surplus > 0.0) == (b.surplus > 0.0) {
                true => held *= 0.5,
                false => (a, held) = (b, b.surplus),
            }
            b = point;
        }
    }
}

/// Where the search for a temperature begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// A temperature [K].
    pub temperature: f64,
    /// How the surplus changes with temperature there [W/K], where that is known.
    pub slope: Option<f64>,
}

impl Start {
    /// At a temperature [K] where the slope is not known.
    pub fn at(temperature: f64) -> Self {
        Self { temperature, slope: None }
    }
}

/// Finds the temperature at which the heat is balanced to the part `accuracy` of the power. `evaluate` gives what heats
/// and cools the film at a temperature [K].
///
/// # Errors
/// [`NoBalance`]: the reason why there is none.
pub fn find<E>(
    balance: &ThermalBalance,
    start: Start,
    accuracy: f64,
    evaluate: impl FnMut(f64) -> Result<ThermalFlows, E>,
) -> Result<Balanced, NoBalance<E>> {
    let mut search = Search { balance, evaluate, films: 0 };
    let [coldest, hottest] = balance.range();
    let first = search.first(start.temperature.clamp(coldest, hottest))?;
    let (nearest, slope) = search.by_slope(first, start.slope, accuracy);
    let (found, slope) = match nearest.is_balanced(accuracy) {
        true => (nearest, slope),
        false => {
            let bracket = search.other_side(nearest)?;
            search.narrowed(bracket, accuracy)?
        }
    };
    Ok(Balanced {
        temperature: found.temperature,
        film: found.film,
        surplus: found.surplus,
        slope,
        films: search.films,
    })
}

#[cfg(test)]
mod tests;
