//! A design: the numbers of free keys that make a quantity least or greatest while the criteria of the scene are met.
//!
//! Every point of the search is a solved film of a sweep's chain, so that the mesh of the one before stays as long as
//! it suits; its gradients come from `sensitivity.rs`. Criteria are constraints, relative to their limits; with
//! `spread` each is worse by the sum of the effects of the tolerances there, whose own gradient is left out. The search
//! is that of [`oilwedge_study::quadratic`]. The optimum is solved by itself at the end, with error bars, on a mesh of
//! its own.
//! Verified by `tests/tests/design.rs`: Rayleigh's step, and a short film.

mod record;

use oilwedge_scene::{Design, DesignSense, FreeKey, KeyTolerance, Scene, SceneError};
use oilwedge_study::column::Column;
use oilwedge_study::quadratic::{DescentEnd, Optimum, Valued, least};
use oilwedge_study::quantities::Quantity;
use oilwedge_study::result::{Criterion, Status};
use oilwedge_study::run::{Run, run_telling};
use oilwedge_study::run_options::RunOptions;
use oilwedge_study::scope::Scope;
use oilwedge_study::{CHECKS, CompileError, compile, parse};

use crate::sensitivity::{Derivatives, derivatives};
use crate::spread::with_derivatives;
use crate::sweep::{CaseOutcome, CaseStatus, Walker};
pub use record::{ChosenKey, Constraint, DesignEnd, DesignPoint, DesignRecord, ListedChoice};

/// Most films of one search, those for gradients apart.
const MOST: usize = 30;
/// Digits of the numbers of an optimum.
const DIGITS: usize = 6;
/// A constraint that costs more than this relative to its limit is active.
const ACTIVE: f64 = 1e-5;
/// A constraint or bound that is met by less than this, relative, is active; one that misses by less is met.
const CLOSE: f64 = 1e-4;

/// Why there is no design.
#[derive(Debug, thiserror::Error)]
pub enum NoDesign {
    /// A scene on the way is none.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The optimum does not become a film.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The search has no beginning.
    #[error("the search has no beginning: there is no film with the numbers of the scene, {0}; give others")]
    NoStart(String),
}

/// The optimum of a scene: its run, the text of its scene, and how it was found.
#[derive(Debug)]
pub struct Designed {
    /// The run of the optimum.
    pub run: Run,
    /// The scene of the optimum.
    pub scene: Scene,
    /// Keys, constraints and path.
    pub record: DesignRecord,
    /// What could not be found beside, in sentences.
    pub notes: Vec<String>,
}

/// The best design of a scene over all combinations of its listed values.
///
/// # Errors
/// [`NoDesign`]: no combination has a film to begin with, or the optimum is no scene.
pub fn design(scene: &Scene, asked: &Design, options: &RunOptions) -> Result<Designed, NoDesign> {
    let beside = RunOptions { bars: false, observer: None, ..*options };
    let mut best: Option<BestChoice> = None;
    let (mut choices, mut reason) = (Vec::new(), String::new());
    for (values, scene) in scene.combinations(&CHECKS)? {
        let mut search = DesignSearch::new(&scene, asked, &beside);
        let found = search.run();
        let record = found.as_ref().map(|optimum| search.record(optimum));
        choices.push(ListedChoice {
            values,
            objective: record.as_ref().map(|it| it.value),
            is_met: record.as_ref().is_some_and(|it| it.is_met),
        });
        match record {
            None => reason = search.reason,
            Some(record) => {
                let found = BestChoice { record, scene: scene.clone(), free: search.free };
                if best.as_ref().is_none_or(|best| found.is_better(best, asked.sense)) {
                    best = Some(found);
                }
            }
        }
    }
    let BestChoice { mut record, scene, free } = best.ok_or(NoDesign::NoStart(reason))?;
    let values: Vec<(&KeyTolerance, f64)> =
        free.iter().zip(&record.keys).map(|(free, key)| (&free.input, si(&free.input, key.optimum))).collect();
    let scene = parse(&scene.text_with(&values), &scene.path)?;
    let run = run_telling(&compile(&scene)?, options, None)?;
    let (result, notes) = with_derivatives(&scene, &run, scene.differentiated(false), options);
    record.solved = result.by_name(&record.objective).map(|quantity| quantity.value);
    record.error = result.by_name(&record.objective).and_then(Quantity::error);
    if !asked.choices.is_empty() {
        record.choices = choices;
        record.choice_keys = asked.choices.iter().map(|axis| axis.name.clone()).collect();
    }
    Ok(Designed { run: Run { result, ..run }, scene, record, notes })
}

/// The optimum of one combination of listed values.
struct BestChoice {
    record: DesignRecord,
    scene: Scene,
    free: Vec<FreeKey>,
}

impl BestChoice {
    fn is_better(&self, other: &Self, sense: DesignSense) -> bool {
        let [own, before] = [self, other].map(|found| signed(sense, found.record.value));
        (self.record.is_met, -own) > (other.record.is_met, -before)
    }
}

/// The objective as it is made least.
fn signed(sense: DesignSense, value: f64) -> f64 {
    match sense {
        DesignSense::Minimise => value,
        DesignSense::Maximise => -value,
    }
}

/// A number in the unit of a key in SI.
fn si(input: &KeyTolerance, value: f64) -> f64 {
    input.nominal + (value - input.in_unit(input.nominal)) * input.unit_size()
}

/// The search for one combination of listed values.
struct DesignSearch<'a> {
    scene: &'a Scene,
    asked: &'a Design,
    options: &'a RunOptions,
    free: Vec<FreeKey>,
    /// Name of the objective.
    objective: String,
    walker: Walker<'a>,
    /// Size of the objective; that of the first film.
    scale: Option<f64>,
    path: Vec<DesignPoint>,
    gradient_films: usize,
    /// Why the last point has no film.
    reason: String,
}

/// A solved point: its quantities, criteria, and how they change.
struct SolvedPoint {
    found: CaseOutcome,
    inputs: Vec<KeyTolerance>,
    slopes: Vec<Derivatives>,
}

impl SolvedPoint {
    /// The derivative of a quantity by each of the first `count` inputs over their `widths`; `None` where one has none.
    fn gradient(&self, quantity: &Quantity, widths: &[f64]) -> Option<Vec<f64>> {
        let slopes = self.slopes.iter().zip(&self.inputs).zip(widths);
        slopes.map(|((slopes, input), width)| Some(slopes.of(quantity, input)? * width)).collect()
    }

    /// Sum of the effects of those inputs that are tolerances, behind the first `count`: the worst case. `None` where
    /// the quantity has no derivative by one of them.
    fn spread(&self, quantity: &Quantity, count: usize) -> Option<f64> {
        let tolerances = self.slopes.iter().zip(&self.inputs).skip(count);
        tolerances.map(|(slopes, input)| Some((slopes.of(quantity, input)? * input.half_width).abs())).sum()
    }
}

/// Least value of a constraint, relative to its limit, and that limit's size.
fn met_by(criterion: &Criterion) -> (f64, f64, f64) {
    let (limit, sign) = match (criterion.least, criterion.most) {
        (Some(least), _) => (least, 1.0),
        (None, most) => (most.unwrap_or(criterion.value), -1.0),
    };
    let scale = if limit == 0.0 { 1.0 } else { limit.abs() };
    (sign * (criterion.value - limit) / scale, limit, sign / scale)
}

impl<'a> DesignSearch<'a> {
    fn new(scene: &'a Scene, asked: &'a Design, options: &'a RunOptions) -> Self {
        let column = Column::wanted(&asked.objective, &Scope::of(scene));
        Self {
            scene,
            asked,
            options,
            free: scene.free_keys(),
            objective: column.map_or_else(|_| asked.objective.name.clone(), |column| column.quantity.into_owned()),
            walker: Walker::new(options),
            scale: None,
            path: Vec::new(),
            gradient_films: 0,
            reason: String::new(),
        }
    }

    /// Widths of the bounds, in SI.
    fn widths(&self) -> Vec<f64> {
        self.free.iter().map(|free| free.bounds[1] - free.bounds[0]).collect()
    }

    fn run(&mut self) -> Option<Optimum> {
        self.walker.begin();
        let place = |free: &FreeKey| (free.input.nominal - free.bounds[0]) / (free.bounds[1] - free.bounds[0]);
        let start: Vec<f64> = self.free.iter().map(|free| place(free).clamp(0.0, 1.0)).collect();
        least(&start, MOST, &mut |at| self.sample(at))
    }

    /// Numbers of the free keys at a place in the unit box, in SI.
    fn numbers(&self, at: &[f64]) -> Vec<f64> {
        let number = |(free, part): (&FreeKey, &f64)| free.bounds[0] + part * (free.bounds[1] - free.bounds[0]);
        self.free.iter().zip(at).map(number).collect()
    }

    fn sample(&mut self, at: &[f64]) -> Option<Valued> {
        let numbers = self.numbers(at);
        let own = self.free.iter().zip(&numbers).map(|(free, number)| free.input.in_unit(*number)).collect();
        let mut point = DesignPoint { keys: own, ..DesignPoint::default() };
        let sample = self.solved(&numbers).and_then(|solved| self.sample_of(&solved, &mut point));
        point.reason = sample.as_ref().err().cloned();
        self.path.push(point);
        match sample {
            Ok(sample) => Some(sample),
            Err(reason) => {
                self.reason = reason;
                None
            }
        }
    }

    /// The film with these numbers, and how it changes with them.
    fn solved(&mut self, numbers: &[f64]) -> Result<SolvedPoint, String> {
        let values: Vec<_> = self.free.iter().map(|free| &free.input).zip(numbers.iter().copied()).collect();
        let scene = parse(&self.scene.text_with(&values), &self.scene.path).map_err(|error| error.to_string())?;
        let is_free = |input: &&KeyTolerance| self.free.iter().any(|free| free.input.key == input.key);
        let of_free = |free: &FreeKey| scene.inputs.iter().find(|input| input.key == free.input.key).cloned();
        let mut inputs: Vec<KeyTolerance> = self.free.iter().filter_map(of_free).collect();
        // Of a free key with a tolerance both count.
        inputs.iter_mut().for_each(|input| input.half_width = 0.0);
        let tolerances = scene.tolerances.iter().filter(|_| self.asked.spread);
        inputs.extend(tolerances.clone().filter(is_free).cloned());
        inputs.extend(tolerances.filter(|input| !is_free(input)).cloned());
        let mut slopes = None;
        let found = self.walker.case_asked(&scene, 0.0, &mut |solved| {
            slopes = Some(derivatives(&scene, Some(solved), &inputs, self.options));
        });
        if found.status != CaseStatus::Run(Status::Converged) {
            return Err(found.reason.unwrap_or_else(|| "it was not reached".to_owned()));
        }
        let slopes = slopes.unwrap_or_else(|| derivatives(&scene, None, &inputs, self.options));
        let slopes = slopes.into_iter().collect::<Result<Vec<_>, _>>().map_err(|error| error.to_string())?;
        self.gradient_films += slopes.iter().map(Derivatives::films).sum::<usize>();
        Ok(SolvedPoint { found, inputs, slopes })
    }

    fn sample_of(&mut self, solved: &SolvedPoint, point: &mut DesignPoint) -> Result<Valued, String> {
        let widths = self.widths();
        let quantities = &solved.found.quantities;
        let lacking = |name: &str| {
            format!("{name} has no derivative by all free keys and tolerances that count; choose another quantity")
        };
        let objective = quantities.iter().find(|quantity| quantity.name == self.objective);
        let objective = objective.ok_or_else(|| format!("the film has no {}", self.objective))?;
        let gradient = solved.gradient(objective, &widths).ok_or_else(|| lacking(&self.objective))?;
        let scale = *self.scale.get_or_insert(if objective.value == 0.0 { 1.0 } else { objective.value.abs() });
        point.objective = Some(objective.value);
        let (mut constraints, mut gradients) = (Vec::new(), Vec::new());
        for criterion in solved.found.criteria.iter().filter(|criterion| criterion.decides) {
            let (mut value, limit, over) = met_by(criterion);
            let mut of = Constraint {
                what: criterion.what.clone(),
                unit: criterion.unit.clone(),
                value: criterion.value,
                limit,
                ..Constraint::default()
            };
            let gradient = match criterion.compared(quantities) {
                None => vec![0.0; widths.len()],
                Some((quantity, size)) => {
                    if self.asked.spread {
                        let own = solved.spread(quantity, widths.len()).ok_or_else(|| lacking(&quantity.name))?;
                        let spread = size * own;
                        value -= spread * over.abs();
                        of.spread = Some(spread);
                    }
                    let gradient = solved.gradient(quantity, &widths).ok_or_else(|| lacking(&quantity.name))?;
                    gradient.into_iter().map(|slope| slope * size * over).collect()
                }
            };
            of.left = value;
            point.constraints.push(of);
            constraints.push(value);
            gradients.push(gradient);
        }
        let is_same =
            |before: &DesignPoint| before.reason.is_some() || before.constraints.len() == point.constraints.len();
        if !self.path.iter().all(is_same) {
            return Err("other criteria count there than at the start".to_owned());
        }
        Ok(Valued {
            objective: signed(self.asked.sense, objective.value) / scale,
            gradient: gradient.into_iter().map(|slope| signed(self.asked.sense, slope) / scale).collect(),
            constraints,
            gradients,
        })
    }

    /// What the search has found, its numbers with a few digits.
    fn record(&self, optimum: &Optimum) -> DesignRecord {
        let numbers = self.numbers(&optimum.at);
        let own: Vec<f64> = self.free.iter().zip(&numbers).map(|(free, number)| free.input.in_unit(*number)).collect();
        let of_optimum = self.path.iter().rev().find(|point| point.keys == own);
        let start = self.path.first().cloned().unwrap_or_default();
        let point = of_optimum.cloned().unwrap_or_else(|| start.clone());
        let scale = self.scale.unwrap_or(1.0);
        // Elsewhere than at an optimum limits have no price.
        let is_optimum = optimum.end == DescentEnd::Optimum;
        let constraint = |(constraint, cost): (&Constraint, &f64)| {
            let cost = if is_optimum { *cost } else { 0.0 };
            let size = if constraint.limit == 0.0 { 1.0 } else { constraint.limit.abs() };
            let is_active = cost > ACTIVE || constraint.left.abs() < CLOSE;
            Constraint { is_active, cost: if is_active { cost * scale / size } else { 0.0 }, ..constraint.clone() }
        };
        let key = |(free, (part, value)): (&FreeKey, (&f64, &f64))| {
            let bounds = free.bounds.map(|bound| free.input.in_unit(bound));
            let rounded = format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(*value);
            ChosenKey {
                key: free.input.key.clone(),
                unit: free.input.unit.clone(),
                start: free.input.in_unit(free.input.nominal),
                optimum: f64::clamp(rounded, bounds[0], bounds[1]),
                bounds,
                is_at_bound: *part < CLOSE || *part > 1.0 - CLOSE,
            }
        };
        let is_met = point.constraints.iter().all(|constraint| constraint.left > -CLOSE);
        DesignRecord {
            objective: self.objective.clone(),
            sense: self.asked.sense.name().to_owned(),
            start: start.objective.unwrap_or(f64::NAN),
            value: point.objective.unwrap_or(f64::NAN),
            is_met,
            end: match optimum.end {
                DescentEnd::Optimum => DesignEnd::Optimum,
                DescentEnd::Infeasible => DesignEnd::Infeasible,
                DescentEnd::NoValue => DesignEnd::NoFilm,
                DescentEnd::Limit => DesignEnd::Limit,
                DescentEnd::NoStep => DesignEnd::NoStep,
            },
            reason: (optimum.end == DescentEnd::NoValue).then(|| self.reason.clone()),
            keys: self.free.iter().zip(optimum.at.iter().zip(&own)).map(key).collect(),
            constraints: point.constraints.iter().zip(&optimum.multipliers).map(constraint).collect(),
            films: self.path.len(),
            gradient_films: self.gradient_films,
            path: self.path.clone(),
            ..DesignRecord::default()
        }
    }
}
