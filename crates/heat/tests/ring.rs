//! Films around journals.

use std::f64::consts::PI;

use oilwedge_heat::{
    BushSide, FilmNetwork, JournalSide, LayerProfile, Layers, NetworkOptions, PortKind, SolvedNetwork, solve,
};

use crate::journal_film::{Bearing, Grid, Groove, JournalFilm, engine, ferron, turbine};

/// Film and temperature in turn, `rounds` times.
fn coupled(bearing: &Bearing, grid: Grid, count: usize, rounds: usize) -> (JournalFilm, SolvedNetwork) {
    let layers = Layers::new(count).expect("a count");
    let mut film = JournalFilm::new(bearing, grid);
    let mut temperatures = vec![bearing.supply; film.cell_count() * (count + 1)];
    let mut before: Option<SolvedNetwork> = None;
    for round in 0.. {
        let profiles = film.profiles(&layers, &temperatures);
        film.solve(&profiles);
        let network = film.network(&profiles);
        let options = NetworkOptions { tolerance: 1e-6, ..NetworkOptions::default() };
        let start = before.as_ref().map(|solved| &solved.temperatures);
        let solved = solve(&network, &layers, &profiles, start, &options).expect("temperatures");
        if round == rounds {
            return (film, solved);
        }
        temperatures.iter_mut().zip(&solved.temperatures.layers).for_each(|(t, next)| *t += 0.6 * (next - *t));
        before = Some(solved);
    }
    unreachable!("rounds end");
}

/// What a film of a reference has: greatest pressure [MPa], power, heat into the bush [W], highest temperature,
/// temperatures of the journal, of the oil that leaves and of the first feed [degrees Celsius].
type Row = [f64; 7];

/// Finite volumes with film and temperature of their own, extrapolated over grids and layers, which a second code
/// confirms (rows F1, E1, T1, F4): films at the positions at which they carry their loads. Bars cover the grid, which
/// is upwind of first order, and the uncertainty of the reference.
#[test]
fn films_of_four_bearings() {
    let adiabatic = Bearing { bush: BushSide::Adiabatic, ..ferron(0.7, 310.0) };
    let rows: [(&str, Bearing, Grid, usize, Row, Row); 4] = [
        (
            "F1",
            ferron(0.547_271_53, 327.008_5),
            [120, 16],
            6,
            [1.7994, 1659.06, 47.503, 57.472, 48.527, 47.291, 44.030],
            [0.007, 2.5, 0.19, 0.1, 0.1, 0.02, 0.03],
        ),
        (
            "E1",
            engine(),
            [90, 40],
            4,
            [21.509, 156.568, 28.379, 106.994, 104.333, 101.582, 90.209],
            [0.06, 0.9, 0.5, 0.15, 0.1, 0.12, 0.05],
        ),
        (
            "T1",
            turbine(),
            [144, 16],
            6,
            [3.5307, 14824.3, 389.08, 87.387, 70.094, 68.575, 68.794],
            [0.03, 75.0, 1.0, 0.2, 0.2, 0.4, 0.5],
        ),
        (
            "F4",
            adiabatic,
            [120, 16],
            6,
            [3.7628, 1788.56, 0.0, 67.6, 50.101, 46.025, 43.296],
            [0.019, 7.3, 1e-6, 0.4, 0.4, 0.03, 0.15],
        ),
    ];
    for (name, bearing, grid, count, expected, bars) in rows {
        let (film, SolvedNetwork { temperatures, sheet, .. }) = coupled(&bearing, grid, count, 12);
        let highest = film.pressures.iter().copied().fold(0.0, f64::max);
        let celsius = |kelvin: f64| kelvin - 273.15;
        let found = [
            1e-6 * highest,
            sheet.power,
            sheet.bush,
            celsius(temperatures.highest()),
            celsius(temperatures.journal.expect("a journal")),
            celsius(sheet.outlet.expect("oil leaves")),
            celsius(temperatures.feeds[0]),
        ];
        for i in 0..found.len() {
            assert!((found[i] - expected[i]).abs() < bars[i], "{name}: {found:?} for {expected:?}, bars {bars:?}");
        }
    }
}

/// Film of cold oil, with what its network needs.
fn cold(bearing: &Bearing, grid: Grid, layers: &Layers) -> (JournalFilm, Vec<LayerProfile>, FilmNetwork) {
    let mut film = JournalFilm::new(bearing, grid);
    // Viscosity falls towards the journal, so that layers have flows of their own.
    let across: Vec<f64> = layers.points.iter().map(|eta| bearing.supply + 20.0 * eta).collect();
    let profiles = film.profiles(layers, &across.repeat(film.cell_count()));
    film.solve(&profiles);
    let network = film.network(&profiles);
    (film, profiles, network)
}

#[test]
fn heat_balances_to_rounding_for_all_walls() {
    let layers = Layers::new(4).expect("a count");
    let mut bearing = ferron(0.6, 320.0);
    // Oil leaves through the second feed.
    bearing.grooves.push(Groove { angles: [265.0, 285.0].map(f64::to_radians), length: 0.5, pressure: 1e4 });
    let (_, profiles, network) = cold(&bearing, [48, 16], &layers);
    let through = |feed| network.ports.iter().filter(move |port| port.kind == PortKind::Feed(feed));
    let supplied = [0, 1].map(|feed| through(feed).map(|port| port.dragged + port.driven).sum::<f64>());
    assert!(supplied[0] > 0.0 && supplied[1] < 0.0, "{supplied:?}");
    let shaft = JournalSide::Turning { conductance: 5.0, ambient: 303.15 };
    for bush in [network.bush.clone(), BushSide::Adiabatic, BushSide::Fixed(320.0)] {
        for journal in [network.journal, shaft, JournalSide::Adiabatic, JournalSide::Fixed(320.0)] {
            let network = FilmNetwork { bush: bush.clone(), journal, ..network.clone() };
            let options = NetworkOptions { tolerance: 1e-14, ..NetworkOptions::default() };
            let solved = solve(&network, &layers, &profiles, None, &options).expect("temperatures");
            let sheet = solved.sheet;
            assert!(sheet.left.abs() < 1e-12 * sheet.power, "{:?} {journal:?}: {sheet:?}", network.bush);
            assert!(sheet.carried > 0.5 * sheet.power, "{sheet:?}");
            let again = solve(&network, &layers, &profiles, Some(&solved.temperatures), &NetworkOptions::default());
            assert_eq!(again.expect("temperatures").steps, 0);
            for (cell, place) in network.cells.iter().enumerate() {
                let Some(bush) = solved.temperatures.bush_at(&network, place.angle, place.along) else {
                    continue;
                };
                assert!((bush - solved.temperatures.of_cell(&layers, cell)[0]).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn few_steps_for_three_bearings() {
    for (bearing, most) in [(ferron(0.547, 327.0), 15), (engine(), 28), (turbine(), 32)] {
        for count in [4, 6] {
            let layers = Layers::new(count).expect("a count");
            let (_, profiles, network) = cold(&bearing, [96, 24], &layers);
            let options = NetworkOptions { tolerance: 1e-8, ..NetworkOptions::default() };
            let solved = solve(&network, &layers, &profiles, None, &options).expect("temperatures");
            assert!(solved.steps <= most, "N {count}: {} steps", solved.steps);
        }
    }
}

/// Bearing, feeds and load turned by whole cells: temperatures turn with them, whatever the number of a cell.
#[test]
fn a_turned_bearing_has_the_same_temperatures() {
    const GRID: Grid = [48, 12];
    const CELLS: usize = 7;
    let layers = Layers::new(4).expect("a count");
    let turn = 2.0 * PI * CELLS as f64 / GRID[0] as f64;
    let bearing = ferron(0.6, 320.0);
    let mut turned = bearing.clone();
    turned.least_at += turn;
    turned.grooves[0].angles = turned.grooves[0].angles.map(|angle| angle + turn);
    let options = NetworkOptions { tolerance: 1e-12, ..NetworkOptions::default() };
    let [(film, solved), (turned_film, turned)] = [bearing, turned].map(|bearing| {
        let (film, profiles, network) = cold(&bearing, GRID, &layers);
        let solved = solve(&network, &layers, &profiles, None, &options).expect("temperatures");
        (film, solved.temperatures)
    });
    assert!((solved.journal.expect("a journal") - turned.journal.expect("a journal")).abs() < 1e-8);
    assert!((solved.feeds[0] - turned.feeds[0]).abs() < 1e-8);
    for place in 0..film.cells.len() {
        let other = (place + CELLS * GRID[1]) % film.cells.len();
        match (film.cells[place], turned_film.cells[other]) {
            (Ok(cell), Ok(other)) => {
                let (own, other) = (solved.of_cell(&layers, cell), turned.of_cell(&layers, other));
                assert!(own.iter().zip(other).all(|(own, other)| (own - other).abs() < 1e-8), "{own:?} {other:?}");
            }
            (own, other) => assert_eq!(own, other),
        }
    }
}
