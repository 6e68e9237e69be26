//! Laws of viscosity that have a meaning at the film's temperature and at the pressures that are given.

use oilwedge_reynolds::Form;
use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::LawKind;
use oilwedge_reynolds::lubricant::grades::GRADES;
use oilwedge_reynolds::lubricant::walther::LEAST_ON_CHART;
use oilwedge_reynolds::lubricant::{Grade, TemperatureLaw as Law};
use oilwedge_scene::spelling::nearest;
use oilwedge_scene::wording::celsius;
use oilwedge_scene::{Complaints, HighShear, PressureLawTable, Scene, TemperatureLawTable, Viscosity};

use crate::compile::oil::{HIGH_SHEAR_AT, points};
use crate::effects::Sockets;
use crate::oil::Oil;

/// Parts of a viscosity that high shear leaves; a law through other points may be off by some percent at 150 degrees C.
const LEAST_SHEARED: f64 = 0.3;
const MOST_SHEARED: f64 = 1.1;
/// A given pressure must be known from its reduced one to this part.
const LOST: f64 = 1e-6;

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let oil = Oil::of(scene);
    if let Viscosity::ByTemperature(law) = &scene.oil.viscosity {
        has_meaning(law, &oil, complaints);
    }
    if !complaints.concern_temperature() {
        high_shear(scene, &oil, complaints);
    }
    if complaints.concern_temperature() {
        return;
    }
    at_given_temperature(scene, &oil, complaints);
    let source = match (&oil.thermal, scene.given_temperature()) {
        (Some(_), Some((key, _))) => key,
        _ => "oil.viscosity",
    };
    complaints.refuse_if(
        matches!(scene.oil.pressure_law, PressureLawTable::Roelands(_)) && oil.viscosity.ln() + 9.67 <= 0.0,
        source,
        "is below the range of Roelands' law, which needs ln(viscosity in Pa.s) + 9.67 > 0",
        "give more than 0.0632 mPa.s (is it in mPa.s?), or take another law of pressure",
    );
    if !complaints.concern_temperature() {
        pressures(scene, oil.viscosity, complaints);
    }
}

/// What shear leaves of a viscosity is less than all of it, and not next to nothing.
fn high_shear(scene: &Scene, oil: &Oil, complaints: &mut Complaints) {
    let (Some(HighShear::Viscosity(given)), Some(thermal)) = (scene.oil.high_shear, &oil.thermal) else {
        return;
    };
    let milli = |viscosity: f64| readable(1e3 * viscosity);
    complaints.refuse_if(
        !(LEAST_SHEARED..=MOST_SHEARED).contains(&thermal.sheared),
        "oil.high_shear",
        format!(
            "is {} mPa.s, but at low shear the oil has {} mPa.s at 150 C, of which shear leaves {LEAST_SHEARED} to 1 times",
            milli(given),
            milli(thermal.unsheared(HIGH_SHEAR_AT))
        ),
        "give the viscosity at 150 C and 1e6 1/s (HTHS) of the data sheet of this oil, or a factor as 0.8",
    );
}

/// A grade is known, and points make a law.
fn has_meaning(law: &TemperatureLawTable, oil: &Oil, complaints: &mut Complaints) {
    let (key, help) = match law {
        TemperatureLawTable::Vogel { .. } | TemperatureLawTable::Exponential { .. } => return,
        TemperatureLawTable::Grade(name) => {
            let near = nearest(name, GRADES.iter().map(|grade| grade.name));
            let near = near.map_or(String::new(), |near| format!("did you mean \"{near}\"? "));
            return complaints.refuse_if(
                Grade::named(name).is_none() && !complaints.concern("oil.grade"),
                "oil.grade",
                format!("\"{name}\" is no grade that is known"),
                format!("{near}oilwedge oil lists all; or give walther = {{ nu40, nu100 }} of its data sheet"),
            );
        }
        TemperatureLawTable::Walther(_) => (
            "oil.walther",
            "write walther = { nu40 = \"95 mm2/s\", nu100 = \"14.3 mm2/s\" }, or t1, nu1, t2 and nu2 for other temperatures",
        ),
        TemperatureLawTable::Table(_) => (
            "oil.table",
            "write table = [{ t = \"40 C\", nu = \"95 mm2/s\" }, { t = \"100 C\", nu = \"14.3 mm2/s\" }], or mu = \"80 mPa.s\" in place of nu",
        ),
    };
    let points = points(law, oil.density.unwrap_or_default());
    let message = match points.iter().find(|(_, viscosity)| *viscosity <= LEAST_ON_CHART) {
        Some((_, viscosity)) => {
            format!("has a viscosity of {} mm2/s, but the chart begins above 0.3 mm2/s", readable(1e6 * viscosity))
        }
        None => "needs two points or more, each hotter one with a lower viscosity".to_owned(),
    };
    complaints.refuse_if(oil.thermal.is_none() && !complaints.concern(key), key, message, help);
}

/// The law of temperature has a meaning at the temperature of the film or, where that is found, of the oil that is fed.
fn at_given_temperature(scene: &Scene, oil: &Oil, complaints: &mut Complaints) {
    let (Some(thermal), Some((key, temperature))) = (&oil.thermal, scene.given_temperature()) else {
        return;
    };
    let viscosity = thermal.viscosity(temperature);
    let (message, help) = match &thermal.law {
        Law::Vogel(law) if temperature <= law.singular => (
            format!("is not above {}, below which Vogel's law has no meaning", celsius(law.singular)),
            "give a higher temperature, or a greater oil.vogel.c",
        ),
        Law::Table(table) if temperature < table.range()[0] || temperature > table.range()[1] => {
            let [from, to] = table.range().map(celsius);
            (
                format!("lies outside oil.table, which reaches from {from} to {to}"),
                "give a temperature within, or a point of the table beyond",
            )
        }
        _ if viscosity <= 0.0 || viscosity.is_infinite() => (
            format!("leaves the oil a viscosity of {viscosity} Pa.s"),
            "give a temperature at which the oil is a liquid, and check the numbers of its law",
        ),
        _ => return,
    };
    complaints.add(key, message, help);
}

/// The equation is one of reduced pressures, all of which lie below the limit of the law; a pressure that round-off
/// puts there is lost.
fn pressures(scene: &Scene, viscosity: f64, complaints: &mut Complaints) {
    let Sockets { form: Form::Conservative, pressure_rule, .. } = Sockets::of(scene) else {
        return;
    };
    let law = pressure_rule.at(viscosity);
    let feeds = scene.feeds.iter().enumerate();
    let feeds = feeds.filter_map(|(index, feed)| Some((format!("feed[{index}].pressure"), feed.pressure?)));
    for (key, pressure) in feeds.chain([("ends.pressure".to_owned(), scene.ends.pressure)]) {
        let back = law.pressure(law.reduced_pressure(pressure));
        let ratio = law.viscosity_ratio(pressure);
        complaints.refuse_if(
            pressure > 0.0 && (back / pressure - 1.0).abs() > LOST && !ratio.is_nan(),
            &key,
            format!("makes the oil {ratio:.1e} times as viscous, so near to solid that round-off hides the pressure"),
            match law.kind() == LawKind::Roelands {
                true => "give a lower pressure, or a smaller exponent (oil.roelands.z or alpha)",
                false => "give a lower pressure, or a law that grows slower (oil.roelands)",
            },
        );
    }
}
