//! How far the tolerances of a scene spread its quantities, to first order, and films beside that check it.
//!
//! With the effect `d_j = t_j dQ/dx_j` of a tolerance t_j the worst case is `sum |d_j|`, and `rss^2 = sum d_j^2` (ISO
//! 14253-2 calls it the combined uncertainty of independent inputs). Derivatives are those of [`crate::sensitivity`].
//! Films at the worst corners of the quantities of short tables show whether effects add up; corners of several
//! quantities are often the same, and each is solved once. Films along the tolerance that matters most make a curve.
//! Criteria are judged with the worst case. `tests/tests/cli/spread.rs` tests all of it by exponents of the short film,
//! by its corners in closed form, and by draws.

use std::borrow::Cow;
use std::collections::BTreeMap;

use oilwedge_reynolds::existence::readable;
use oilwedge_scene::{KeyTolerance, Scene, SceneError};
use oilwedge_study::CHECKS;
use oilwedge_study::limits::judged_with_spread;
use oilwedge_study::quantities::{Quantity, QuantitySpread, ToleranceCurve};
use oilwedge_study::result::{RunResult, Status, headlines};
use oilwedge_study::run::Run;
use oilwedge_study::run_options::RunOptions;

use crate::sensitivity::{Derivatives, add, derivatives};
use crate::sweep::{CaseOutcome, Walker};

/// Corners that depart from the sum of effects by more than this are reported by themselves.
const LINEAR: f64 = 0.2;
/// Places of the films of the curve on its tolerance, the nominal one in the middle.
const PLACES: [f64; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];
const NOMINAL: usize = 2;

/// The result of a run whose quantities have their derivatives by some `inputs` of its scene and, where it has
/// tolerances and these are among the inputs, their spread; and why some have none. Runs without an answer have
/// neither.
pub fn with_derivatives(
    scene: &Scene,
    run: &Run,
    inputs: &[KeyTolerance],
    options: &RunOptions,
) -> (RunResult, Vec<String>) {
    let (mut result, options) = (run.result.clone(), RunOptions { bars: false, observer: None, ..*options });
    let (mut reasons, mut of_tolerances) = (Vec::new(), Vec::new());
    if inputs.is_empty() || result.head.status != Status::Converged {
        return (result, reasons);
    }
    for (input, found) in inputs.iter().zip(derivatives(scene, run.solved.as_ref(), inputs, &options)) {
        match found {
            Ok(found) => {
                add(&mut result.quantities, input, &found);
                of_tolerances.extend((input.half_width > 0.0).then_some(found));
            }
            Err(reason) => reasons.push(format!("there is no sensitivity to {}: {reason}", input.key)),
        }
    }
    if !of_tolerances.is_empty() && of_tolerances.len() == scene.tolerances.len() {
        reasons.extend(add_spread(scene, &mut result, &of_tolerances, &options));
        result.criteria = judged_with_spread(&result.criteria, &result.quantities);
    }
    (result, reasons)
}

/// Adds the spread of each quantity, what films at corners say of those of short tables, and the curve of films along
/// the tolerance that matters most; one that a film beside lacks has no spread. Returns which films were not found.
fn add_spread(scene: &Scene, of: &mut RunResult, found: &[Derivatives], options: &RunOptions) -> Vec<String> {
    let effects = |quantity: &Quantity| -> Option<Vec<f64>> {
        let tolerances = scene.tolerances.iter().zip(found);
        tolerances.map(|(input, found)| Some(found.of(quantity, input)? * input.half_width)).collect()
    };
    let all: Vec<Option<Vec<f64>>> = of.quantities.iter().map(effects).collect();
    for (quantity, effects) in of.quantities.iter_mut().zip(&all) {
        quantity.spread = effects.as_ref().map(|effects| spread_of(effects, &scene.tolerances));
    }
    let headlines = headlines(&of.quantities, |quantity| quantity.row, &of.effects);
    let is_spread = |quantity: &Quantity| quantity.spread.as_ref().is_some_and(|own| own.worst_case > 0.0);
    let names: Vec<_> = headlines.iter().filter(|it| is_spread(it)).map(|it| it.name.clone()).collect();
    let Some(main) = names.first().and_then(|name| of.quantities.iter().position(|it| it.name == *name)) else {
        return Vec::new();
    };
    let Some(widest) = all[main].as_deref().and_then(widest) else { return Vec::new() };
    let along = PLACES.map(|place| {
        let mut places = vec![0.0; scene.tolerances.len()];
        places[widest] = place;
        places
    });
    let mut films = FilmsBeside::of(scene, &along, options);
    let nominal = films.films[NOMINAL].clone();
    let shown = of.quantities.iter_mut().zip(&all).filter(|(quantity, _)| names.contains(&quantity.name));
    for (quantity, effects) in shown {
        let (Some(own), Some(effects)) = (&mut quantity.spread, effects) else { continue };
        let signs = effects.iter().map(|effect| if *effect < 0.0 { -1.0 } else { 1.0 }).collect::<Vec<f64>>();
        let ends = [-1.0, 1.0].map(|end| films.at(&signs.iter().map(|sign| end * sign).collect::<Vec<_>>()));
        let value = |film: Option<&Vec<Quantity>>| Some(named(film?, &quantity.name)?.value);
        let [low, high, middle] = [ends[0].as_ref(), ends[1].as_ref(), nominal.as_ref()].map(value);
        if let (Some(low), Some(high), Some(middle)) = (low, high, middle) {
            let sides = [quantity.row.difference(middle, low), quantity.row.difference(high, middle)];
            let departures = sides.map(|side| (side / own.worst_case - 1.0).abs());
            let nonlinearity = departures[0].max(departures[1]);
            own.nonlinearity = Some(nonlinearity);
            own.corners = Some([low, high]).filter(|_| nonlinearity > LINEAR);
        }
    }
    of.tolerance_curve = curve(&scene.tolerances[widest], &films, &names);
    films.reasons
}

/// The number of the greatest effect.
fn widest(effects: &[f64]) -> Option<usize> {
    (0..effects.len()).max_by(|a, b| effects[*a].abs().total_cmp(&effects[*b].abs()))
}

fn named<'a>(film: &'a [Quantity], name: &str) -> Option<&'a Quantity> {
    film.iter().find(|quantity| quantity.name == name)
}

/// The first films, those along a tolerance, as curves of quantities; `None` where one was not found.
fn curve(input: &KeyTolerance, films: &FilmsBeside, names: &[Cow<'static, str>]) -> Option<ToleranceCurve> {
    let films: Vec<&Vec<Quantity>> = films.films[..PLACES.len()].iter().map(Option::as_ref).collect::<Option<_>>()?;
    let values = |name: &Cow<'static, str>| {
        let values = films.iter().map(|film| Some(named(film, name)?.value));
        Some((name.to_string(), values.collect::<Option<_>>()?))
    };
    let number = |place: f64| input.in_unit(input.nominal + place * input.half_width);
    Some(ToleranceCurve {
        key: input.key.clone(),
        unit: input.unit.clone(),
        numbers: PLACES.map(number).to_vec(),
        quantities: names.iter().filter_map(values).collect(),
    })
}

/// Films beside the nominal one, at places within the tolerances of its scene: -1 is the lower end of one, 1 the upper.
struct FilmsBeside<'a> {
    scene: &'a Scene,
    walker: Walker<'a>,
    places: Vec<Vec<f64>>,
    /// Quantities of each film that was found.
    films: Vec<Option<Vec<Quantity>>>,
    /// Why others were not.
    reasons: Vec<String>,
}

impl<'a> FilmsBeside<'a> {
    fn of(scene: &'a Scene, first: &[Vec<f64>], options: &'a RunOptions) -> Self {
        let mut walker = Walker::new(options);
        walker.begin();
        let mut all = Self { scene, walker, places: Vec::new(), films: Vec::new(), reasons: Vec::new() };
        first.iter().for_each(|places| drop(all.at(places)));
        all
    }

    /// The quantities of the film at some places; each film is solved once.
    fn at(&mut self, places: &[f64]) -> Option<Vec<Quantity>> {
        if let Some(before) = self.places.iter().position(|other| other == places) {
            return self.films[before].clone();
        }
        let numbers = self.scene.tolerances.iter().zip(places);
        let values: Vec<_> = numbers.map(|(input, place)| (input, input.nominal + place * input.half_width)).collect();
        let found = self.scene.with_values(&values, &CHECKS).map(|scene| self.walker.case(&scene, 0.0));
        let found = found.map_err(|error: SceneError| error.to_string()).and_then(|found: CaseOutcome| {
            match found.quantities.is_empty() {
                true => Err(found.reason.unwrap_or_default()),
                false => Ok(found.quantities),
            }
        });
        let film = found.map_err(|reason: String| self.reasons.push(missing(&values, &reason))).ok();
        self.places.push(places.to_vec());
        self.films.push(film.clone());
        film
    }
}

/// The quantity whose corners are solved: the first one of short tables.
pub fn main_of(result: &RunResult) -> Option<&Quantity> {
    headlines(&result.quantities, |quantity| quantity.row, &result.effects).first().copied()
}

fn spread_of(effects: &[f64], inputs: &[KeyTolerance]) -> QuantitySpread {
    let square: f64 = effects.iter().map(|effect| effect * effect).sum();
    let shares = inputs.iter().zip(effects).map(|(input, effect)| (input.key.clone(), effect * effect / square));
    QuantitySpread {
        worst_case: effects.iter().map(|effect| effect.abs()).sum(),
        rss: square.sqrt(),
        shares: if square > 0.0 { shares.collect() } else { BTreeMap::new() },
        ..QuantitySpread::default()
    }
}

/// A film that was not found, in a sentence.
fn missing(values: &[(&KeyTolerance, f64)], reason: &str) -> String {
    let told = |(input, value): &(&KeyTolerance, f64)| {
        let number = readable(input.in_unit(*value));
        format!("{} = {number} {}", input.key, input.unit).trim_end().to_owned()
    };
    let all: Vec<String> = values.iter().map(told).collect();
    format!("there is no film at {}, within the tolerances: {reason}", all.join(", "))
}
