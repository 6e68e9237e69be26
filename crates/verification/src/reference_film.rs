//! A second method for every answer: the same film on a finer mesh, another scene that must agree, or known values.

use oilwedge_campaign::QuantityPair;
use oilwedge_reynolds::analytical::ocvirk::ShortFilm;
use oilwedge_reynolds::analytical::sommerfeld;
use oilwedge_study::Run;
use oilwedge_study::quantities::{Bar, ECCENTRICITY, LOAD, Quantity};
use toml::{Table, Value};

use crate::answer::{CaseAnswer, sockets, solve, solve_within};
use crate::cases::{finer, other};
use crate::family::{CaseSeries, ClosedForm, KnownValue, Other, SecondMethod};

/// A finer mesh has error bars of this part of those of the case.
const FINER: f64 = 0.25;
/// Part of its own bars that a finer mesh of a mass-conserving film has: these meshes grow faster.
const HALF: f64 = 0.5;
/// Bars of mass-conserving films hold in some 95 of 100 cases (docs/theory/error_estimation_jfo.md); this many bars
/// must in all.
const CONSERVING: f64 = 2.0;
/// Unknowns of the finer mesh at most.
const MOST_UNKNOWNS: usize = 20_000;
/// Finest and coarsest tolerance of the reference.
const TOLERANCES: [f64; 2] = [1e-7, 0.1];

/// What stood against an answer.
#[derive(Debug, Default)]
pub(crate) struct Second {
    /// The methods in words.
    pub(crate) methods: String,
    /// Known values, and the numbers beside them.
    pub(crate) known: Vec<QuantityPair>,
}

/// Holds another method against an answer; what does not agree goes to `faults`.
pub(crate) fn against(series: &CaseSeries, scene: &Table, run: &Run, faults: &mut Vec<String>) -> Second {
    let (mut methods, mut compared) = (Vec::new(), Vec::new());
    if run.result.head.status == oilwedge_study::result::Status::Converged {
        match &series.against {
            SecondMethod::Finer => methods.push(on_finer_mesh(scene, run, faults)),
            SecondMethod::Other(wanted) => methods.push(elsewhere(wanted, scene, run, faults)),
            SecondMethod::Known => {}
        }
        for (name, known) in &series.known {
            let (method, comparison) = beside_known(name, known, scene, run, faults);
            methods.push(method);
            compared.extend(comparison);
        }
        if methods.is_empty() {
            faults.push("no second method stands against it".to_owned());
        }
    }
    Second { methods: methods.join("; "), known: compared }
}

fn on_finer_mesh(scene: &Table, run: &Run, faults: &mut Vec<String>) -> String {
    let relative = |name: &str| {
        let quantity = run.result.by_name(name)?;
        let value = if quantity.value == 0.0 { 1.0 } else { quantity.value.abs() };
        quantity.error().map(|error| error / value)
    };
    let name = match scene.contains_key("load") {
        true => ECCENTRICITY.name,
        false => LOAD.name,
    };
    let conserving = sockets(scene).is_some_and(|sockets| sockets.cavitation.conserves_oil());
    let (finer_by, widened) = if conserving { (HALF, CONSERVING) } else { (FINER, 1.0) };
    let tolerance = (finer_by * relative(name).unwrap_or(TOLERANCES[1])).clamp(TOLERANCES[0], TOLERANCES[1]);
    let answer = solve_within(&finer(scene, tolerance), MOST_UNKNOWNS);
    let CaseAnswer::Run(second) = &answer else {
        faults.push(format!("refused on a finer mesh: {:?}", answer.reason()));
        return String::new();
    };
    if second.result.quantities.is_empty() {
        faults.push(format!("no answer on a finer mesh: {:?}", answer.reason()));
    }
    for quantity in &run.result.quantities {
        let Some(fine) = second.result.by_name(&quantity.name) else {
            continue;
        };
        let (Some(error), Some(fine_error)) = (quantity.error(), fine.error()) else {
            continue;
        };
        let distance = quantity.row.difference(quantity.value, fine.value).abs();
        let bars = widened * (error + fine_error);
        let rounding = 1e-12 * quantity.value.abs().max(natural(run, quantity.unit()));
        if distance > bars + rounding {
            faults.push(format!(
                "{} is {:.8e} with a bar of {error:.1e}, but {:.8e} with a bar of {fine_error:.1e} on {} triangles",
                quantity.name, quantity.value, fine.value, second.result.mesh.cells
            ));
        }
    }
    format!("finer mesh, {} triangles", second.result.mesh.cells)
}

/// The greatest value in this unit: what rounding errors are measured by.
fn natural(run: &Run, unit: &str) -> f64 {
    let alike = run.result.quantities.iter().filter(|quantity| quantity.unit() == unit);
    alike.map(|quantity| quantity.value.abs()).fold(0.0, f64::max)
}

fn elsewhere(wanted: &Other, scene: &Table, run: &Run, faults: &mut Vec<String>) -> String {
    let answer = solve(&other(scene, wanted));
    let CaseAnswer::Run(second) = &answer else {
        faults.push(format!("{} is refused: {:?}", wanted.name, answer.reason()));
        return String::new();
    };
    for (name, allowed) in &wanted.quantities {
        let (Some(first), Some(second)) = (run.result.by_name(name), second.result.by_name(name)) else {
            faults.push(format!("{name} is not in both: {:?}", answer.reason()));
            continue;
        };
        // A number that has no bar claims nothing; the run has warned of it.
        let Some(error) = first.error() else { continue };
        let bars = error + second.error().unwrap_or(0.0);
        if first.row.difference(first.value, second.value).abs() > bars + allowed * first.value.abs() {
            faults.push(format!(
                "{name} is {:.8e}, but {:.8e} by {}, bars together {bars:.1e}",
                first.value, second.value, wanted.name
            ));
        }
    }
    wanted.name.clone()
}

fn beside_known(
    name: &str,
    known: &KnownValue,
    scene: &Table,
    run: &Run,
    faults: &mut Vec<String>,
) -> (String, Option<QuantityPair>) {
    let Some(quantity) = run.result.by_name(name) else {
        faults.push(format!("{name} is not there"));
        return (String::new(), None);
    };
    let form = known.form.and_then(|form| sommerfeld_number(form, scene, run));
    let Some(value) = known.value.or(form) else {
        faults.push(format!("no known value of {name}"));
        return (String::new(), None);
    };
    let bar = quantity.error().unwrap_or(0.0);
    if quantity.row.difference(quantity.value, value).abs() > bar + known.to * value.abs() {
        faults.push(format!(
            "{name} is {:.8e} with a bar of {bar:.1e}, known is {value:.8e} to {:.0e}",
            quantity.value, known.to
        ));
    }
    let bar = Some(Bar::of(known.to * value.abs()));
    let pair = QuantityPair::between(Some(&Quantity { value, bar, ..quantity.clone() }), Some(quantity));
    let method = match known.form {
        Some(form) => format!("closed form ({form:?})"),
        None => format!("known {name}"),
    };
    (method, pair)
}

/// The Sommerfeld number of a closed form at the eccentricity and slenderness of a scene.
fn sommerfeld_number(form: ClosedForm, scene: &Table, run: &Run) -> Option<f64> {
    let length = |key: &str| {
        let text = scene.get("bearing")?.get(key)?.as_str()?;
        text.strip_suffix(" mm")?.parse::<f64>().ok()
    };
    let slenderness = length("length")? / length("diameter")?;
    let eccentricity = match scene.get("journal")?.get("eccentricity") {
        Some(Value::Float(number)) => *number,
        Some(Value::Integer(number)) => *number as f64,
        _ => run.result.quantity(&ECCENTRICITY)?.value,
    };
    Some(match form {
        ClosedForm::Sommerfeld => sommerfeld::sommerfeld_number(eccentricity),
        ClosedForm::Ocvirk => ShortFilm::steady(eccentricity).full_film().magnitude() * slenderness * slenderness,
        ClosedForm::OcvirkHalf => ShortFilm::steady(eccentricity).half_film().magnitude() * slenderness * slenderness,
    })
}
