use super::*;

const OIL: ThermalBalance = ThermalBalance { inlet: 348.15, heat_capacity: 1.8e6, housing: None };

/// Friction that falls, and a flow that grows with temperature.
fn film(temperature: f64) -> ThermalFlows {
    let thinner = (-0.03 * (temperature - 348.15)).exp();
    ThermalFlows { power: 500.0 * thinner, flow: 1e-5 + 2e-6 / thinner, carried_over: 0.0 }
}

fn found(balance: &ThermalBalance, start: f64, film: impl Fn(f64) -> ThermalFlows) -> Balanced {
    find(balance, start, 1e-12, |t| Ok::<_, ()>(film(t))).expect("a balance")
}

#[test]
fn the_root_is_found_from_any_start() {
    let housing = |conductance, ambient| ThermalBalance { housing: Some(Housing { conductance, ambient }), ..OIL };
    for balance in [OIL, housing(5.0, 313.15), housing(500.0, 250.0), housing(3.0, 400.0)] {
        let reference = found(&balance, balance.inlet, film);
        for start in [0.0, 250.0, 300.0, 348.15, 349.0, 355.0, 400.0, 598.0, 1e9] {
            let other = found(&balance, start, film);
            assert!((other.temperature - reference.temperature).abs() < 1e-8, "{balance:?} {start}");
            assert!(other.surplus.abs() < 1e-9 * other.film.power && other.films < 40, "{other:?}");
            let heat = balance.carried(other.temperature, &other.film) + balance.given_off(other.temperature);
            assert!((heat / other.film.power - 1.0).abs() < 1e-6);
        }
        let left = |t: f64| balance.surplus(t, &film(t));
        let t = reference.temperature;
        let slope = (left(t + 1e-3) - left(t - 1e-3)) / 2e-3;
        assert!((reference.slope / slope - 1.0).abs() < 0.05, "{} {slope}", reference.slope);
    }
}

/// Friction that hardly changes and then falls from a cliff: false position alone would creep.
#[test]
fn cliffs_are_bisected() {
    for cliff in [349.0, 360.0, 500.0, 590.0] {
        let film = |t: f64| ThermalFlows { power: if t < cliff { 1e5 } else { 1e-3 }, flow: 1e-6, carried_over: 0.0 };
        let found = found(&OIL, 348.15, film);
        assert!((found.temperature - cliff).abs() < 1e-9, "{found:?}");
        assert!(found.films <= MOST_FILMS);
    }
}

/// Fresh oil q_1 and hot oil q_0 mix to the oil that enters, and what is heated is both.
#[test]
fn carried_over_oil_balances() {
    let film = |t: f64| ThermalFlows { carried_over: 0.7, ..film(t) };
    let found = found(&OIL, 348.15, film);
    let [inlet, outlet] = OIL.ends(found.temperature, 0.7);
    assert!((inlet - (OIL.inlet + 0.7 * (outlet - inlet))).abs() < 1e-9);
    assert!((0.5 * (inlet + outlet) - found.temperature).abs() < 1e-9);
    let through = 1.7 * found.film.flow * OIL.heat_capacity * (outlet - inlet);
    assert!((through / found.film.power - 1.0).abs() < 1e-9);
    let without = super::find(&OIL, 348.15, 1e-12, |t| Ok::<_, ()>(self::film(t))).expect("a balance");
    assert!(found.temperature > without.temperature);
}

#[test]
fn what_has_no_balance_is_told() {
    let dry = |t: f64| ThermalFlows { flow: 0.0, ..film(t) };
    let none = find(&OIL, 348.15, 1e-9, |t| Ok::<_, ()>(dry(t)));
    assert!(
        matches!(none, Err(NoThermalBalance::TooHot { temperature, .. }) if temperature == OIL.inlet + HOTTEST),
        "{none:?}"
    );
    let none = find(&OIL, 348.15, 1e-9, |_| Err::<ThermalFlows, _>("torn"));
    assert_eq!(none, Err(NoThermalBalance::NoFilm("torn")));
    // Films up to 350 K only, and the balance beyond; from above it is reached too.
    let torn = |t: f64| if t < 350.0 { Ok(film(t)) } else { Err("torn") };
    for start in [348.15, 500.0] {
        match find(&OIL, start, 1e-9, torn) {
            Err(NoThermalBalance::Ends { temperature, reason, .. }) => {
                assert!(reason == "torn" && (350.0 - temperature) < EDGE && temperature < 350.0);
            }
            other => panic!("{other:?}"),
        }
    }
    // A film that begins only above the inlet, as with Barus' oil.
    let late = |t: f64| if t > 351.0 { Ok(film(t)) } else { Err("thick") };
    assert!(find(&OIL, 348.15, 1e-9, late).is_ok());
}
