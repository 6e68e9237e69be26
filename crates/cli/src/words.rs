//! What the names of a result mean, in plain words. A name without an entry stands for itself.

/// Names of quantities; one of a region, `load_x.GROUP`, is looked up with its dot.
const QUANTITIES: [(&str, &str); 53] = [
    ("load", "force that the film carries"),
    ("load_x", "its part along x (angle 0)"),
    ("load_y", "its part along y (angle 90 deg)"),
    ("load_angle", "its direction, from x towards y"),
    ("load_coefficient", "W / (D B (p_feed - p_ends))"),
    ("sommerfeld_number", "W (c/R)^2 / (D B mu0 omega)"),
    ("attitude_angle", "from the load to the thinnest film"),
    ("eccentricity", "offset of the journal / clearance"),
    ("min_film_angle", "where the film is thinnest"),
    ("pressure_max", "greatest pressure, gauge"),
    ("pressure_min", "least pressure, gauge"),
    ("film_thickness_min", "thinnest film on the liner"),
    ("temperature_effective", "temperature of the film"),
    ("cooling_flow", "oil that leaves the film and carries heat off"),
    ("temperature_inlet", "of the oil that enters the film, hot oil mixed in"),
    ("temperature_outlet", "of the oil that leaves it"),
    ("heat_carried", "heat that the oil carries off"),
    ("heat_housing", "heat that the housing gives off"),
    ("viscosity_effective", "viscosity at that temperature, without pressure"),
    ("viscosity_max", "viscosity at the greatest pressure"),
    ("cavity_share", "share of the film that is cavity"),
    ("film_fraction_min", "least film fraction (1: full)"),
    ("side_flow", "oil that leaves at the ends (< 0: enters)"),
    ("side_flow_low", "the part at the end z = -B/2"),
    ("side_flow_high", "the part at the end z = +B/2"),
    ("inlet_flow", "oil carried into the loaded film"),
    ("side_flow_number", "Q_s / (D^3 (c/R) omega)"),
    ("inlet_flow_number", "Q / (D^3 (c/R) omega)"),
    ("feed_flow.", "oil that enters there (< 0: leaves)"),
    ("cavity_flow", "oil that the cavity makes, which conserves none"),
    ("friction_torque", "torque on the journal, against the rotation"),
    ("friction_torque_bearing", "torque on the bearing, with the rotation"),
    ("friction_coefficient", "T / (R W)"),
    ("friction_power", "power that turns the journal, T omega"),
    ("friction_shear_power", "its part against shear"),
    ("friction_pressure_power", "its part against pressure"),
    (
        "friction_cavity_power",
        "part of P_s in the cavity, its whole gap sheared",
    ),
    ("squeeze_power", "power of the load as the journal's centre moves"),
    ("pressure_integral", "pressure times area, summed"),
    ("load_x.", "part of W_x over that region"),
    ("load_y.", "part of W_y over that region"),
    ("cap_force", "inertia that pulls at the cap"),
    ("cap_opening_force", "pull at the cap that opens the joint"),
    ("cap_film_share", "pull of this film at the cap / P_o (< 0: none)"),
    ("shell_force", "presses one side of the shell into its seat"),
    ("bolt_force", "pull on one bolt"),
    ("bolt_preload", "preload of a bolt, its least force"),
    ("bolt_torque", "tightening torque of a bolt"),
    ("bolt_force_max", "greatest force of a bolt"),
    ("bolt_stress_max", "greatest stress of a bolt"),
    ("bolt_stress_min", "least stress of a bolt"),
    ("bolt_stress_mean", "their mean"),
    ("bolt_stress_amplitude", "half their difference"),
];

/// Where errors come from.
const ERRORS: [(&str, &str); 8] = [
    ("discretisation", "triangles"),
    ("front", "edge of the cavity"),
    ("transport", "oil spread across the flow"),
    ("geometry", "shape of the liner"),
    ("nonlinear", "nonlinear iteration"),
    ("algebra", "rounding"),
    ("position", "position under the load"),
    ("temperature", "temperature of the film"),
];

/// Where a part of an error comes from.
pub(crate) fn of_error(name: &str) -> &'static str {
    find(&ERRORS, name)
}

/// What a quantity is.
pub(crate) fn of_quantity(name: &str) -> &'static str {
    let key = name.find('.').map_or(name, |dot| &name[..=dot]);
    find(&QUANTITIES, key)
}

fn find(list: &[(&'static str, &'static str)], key: &str) -> &'static str {
    list.iter()
        .find(|(name, _)| *name == key)
        .map_or("", |(_, words)| words)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_regions_are_looked_up_with_their_dot() {
        assert_eq!(of_quantity("load_x"), "its part along x (angle 0)");
        assert_eq!(of_quantity("load_x.hole.b"), "part of W_x over that region");
        assert_eq!(of_quantity("colour"), "");
        let parts = oilwedge_study::result::ErrorParts::default().by_name();
        assert!(parts.iter().all(|(name, _)| !of_error(name).is_empty()));
    }
}
