//! The oil that a scene describes.

use oilwedge_reynolds::lubricant::density::{EXPANSION, ZERO_CELSIUS};
use oilwedge_reynolds::lubricant::{
    self as law, Density, ExponentialLaw, Grade, ThermalOil, ViscosityTable, Vogel, Walther,
};
use oilwedge_scene::{HighShear, OilTable as Described, PointViscosity, Scene, TemperatureLawTable, Viscosity};

use crate::oil::{Oil, first_temperature};

/// Temperature [K] at which the viscosity of engine oils at high shear is measured (SAE J300; ASTM D4683).
pub(crate) const HIGH_SHEAR_AT: f64 = ZERO_CELSIUS + 150.0;

impl Oil {
    /// The oil of a scene at the temperature that the scene gives or, with a heat balance, at which the search for it
    /// begins.
    pub fn of(scene: &Scene) -> Self {
        let first = || scene.inlet_temperature().map(first_temperature);
        let oil = Self {
            viscosity: match scene.oil.viscosity {
                Viscosity::Constant(viscosity) => viscosity,
                Viscosity::ByTemperature(_) => f64::NAN,
            },
            temperature: scene.oil.temperature.or_else(first),
            thermal: thermal(&scene.oil),
            density: density(&scene.oil),
            unsheared: unsheared_grade(&scene.oil),
        };
        oil.temperature.map_or(oil.clone(), |temperature| oil.at(temperature))
    }
}

/// The density that a scene gives, else that of its grade.
fn density(oil: &Described) -> Option<Density> {
    let given = oil.density.map(|density| {
        let expansion = density.expansion.unwrap_or(EXPANSION);
        Density::of(density.value, density.at, expansion)
    });
    given.or_else(|| Some(grade(oil)?.oil()?.density))
}

/// The grade by which a scene describes its oil.
fn grade(oil: &Described) -> Option<Grade> {
    match &oil.viscosity {
        Viscosity::ByTemperature(TemperatureLawTable::Grade(name)) => Grade::named(name),
        _ => None,
    }
}

/// The multigrade oil whose viscosity at high shear is not given.
fn unsheared_grade(oil: &Described) -> Option<&'static str> {
    let multigrade = grade(oil).filter(|grade| grade.is_multigrade() && oil.high_shear.is_none());
    multigrade.map(|grade| grade.name)
}

/// Viscosity and density by temperature; none of one viscosity, and of a law that has no meaning.
fn thermal(oil: &Described) -> Option<ThermalOil> {
    let Viscosity::ByTemperature(described) = &oil.viscosity else {
        return None;
    };
    let density = density(oil).unwrap_or_default();
    let law = match described {
        TemperatureLawTable::Grade(name) => Grade::named(name)?.oil()?.law,
        TemperatureLawTable::Walther([one, other]) => law::TemperatureLaw::Walther(Walther::through(*one, *other)?),
        TemperatureLawTable::Vogel { a, b, c } => {
            law::TemperatureLaw::Vogel(Vogel { factor: *a, exponent: *b, singular: ZERO_CELSIUS - c })
        }
        TemperatureLawTable::Exponential { viscosity, at, beta } => {
            law::TemperatureLaw::Exponential(ExponentialLaw { reference: *viscosity, at: *at, rate: *beta })
        }
        TemperatureLawTable::Table(_) => {
            law::TemperatureLaw::Table(ViscosityTable::through(&points(described, density))?)
        }
    };
    let unsheared = ThermalOil { law, density, sheared: 1.0 };
    Some(ThermalOil { sheared: sheared(oil, &unsheared), ..unsheared })
}

/// What the shear rate of the film leaves of the viscosity [1]. A viscosity at 150 degrees C and 1e6 1/s is one part of
/// that at low shear, which is taken for any temperature.
fn sheared(oil: &Described, unsheared: &ThermalOil) -> f64 {
    match oil.high_shear {
        None => 1.0,
        Some(HighShear::Factor(factor)) => factor,
        Some(HighShear::Viscosity(viscosity)) => viscosity / unsheared.viscosity(HIGH_SHEAR_AT),
    }
}

/// The points `(T [K], nu [m2/s])` of a law that is given by points; the density makes dynamic viscosities kinematic.
pub(crate) fn points(law: &TemperatureLawTable, density: Density) -> Vec<(f64, f64)> {
    match law {
        TemperatureLawTable::Grade(_) | TemperatureLawTable::Vogel { .. } | TemperatureLawTable::Exponential { .. } => {
            Vec::new()
        }
        TemperatureLawTable::Walther(points) => points.to_vec(),
        TemperatureLawTable::Table(points) => (points.iter())
            .map(|point| match point.viscosity {
                PointViscosity::Kinematic(nu) => (point.temperature, nu),
                PointViscosity::Dynamic(mu) => (point.temperature, mu / density.at(point.temperature)),
            })
            .collect(),
    }
}
