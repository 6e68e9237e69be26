//! Parallel plates of one temperature, one of which moves: friction heats the film, which thins.

use oilwedge_heat::{
    BushSide, FilmCell, FilmNetwork, JournalSide, LayerProfile, Layers, NetworkOptions, OilProperties, solve,
};

/// Oil of viscosity mu0 exp(-beta T) between plates of temperature 0.
const VISCOSITY: f64 = 0.03;
const BETA: f64 = 0.04;
const CONDUCTIVITY: f64 = 0.13;
const GAP: f64 = 1e-4;

/// Greatest beta T and the shear stress over mu0 U/h, for a Nahme number beta mu0 U^2/k.
fn plates(count: usize, nahme: f64) -> [f64; 2] {
    let layers = Layers::new(count).expect("a count");
    let speed = (nahme * CONDUCTIVITY / (BETA * VISCOSITY)).sqrt();
    let mut temperatures = vec![0.0; count + 1];
    loop {
        let viscosities: Vec<f64> = temperatures.iter().map(|t: &f64| VISCOSITY * (-BETA * t).exp()).collect();
        let profile = LayerProfile::of(&layers, &viscosities);
        let network = FilmNetwork {
            oil: OilProperties { capacity: 1.7e6, conductivity: CONDUCTIVITY },
            cells: vec![FilmCell {
                thickness: GAP,
                film_fraction: 1.0,
                wall_area: 1.0,
                shear_power: speed * speed / (GAP * profile.f0),
                driven_power: 0.0,
                cross_power: 0.0,
                angle: 0.0,
                along: 0.0,
            }],
            links: Vec::new(),
            ports: Vec::new(),
            feeds: Vec::new(),
            bush: BushSide::Fixed(0.0),
            journal: JournalSide::Fixed(0.0),
        };
        let solved = solve(&network, &layers, &[profile], None, &NetworkOptions::default()).expect("temperatures");
        let next = solved.temperatures.layers;
        let change = next.iter().zip(&temperatures).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // Half a step: the whole one overshoots at large numbers.
        temperatures.iter_mut().zip(&next).for_each(|(t, next)| *t += 0.5 * (next - *t));
        if change < 1e-11 {
            let highest = temperatures.iter().copied().fold(0.0, f64::max);
            return [BETA * highest, 1.0 / (VISCOSITY * profile.f0)];
        }
    }
}

/// Nahme, Ing.-Arch. 11 (1940) 191: sinh^2 a = Na/8, beta dT = 2 ln cosh a.
#[test]
fn plates_of_nahme_and_griffith() {
    for (nahme, expected, tolerances) in [
        (1.0, [0.117_783_035_656_383_69, 0.924_196_240_746_593_6], [1e-4, 1e-8]),
        (10.0, [0.810_930_216_216_328_8, 0.573_878_587_952_005_4], [3e-3, 1e-5]),
        (100.0, [2.602_689_685_444_383_7, 0.152_069_199_260_189_28], [4e-2, 1e-3]),
    ] {
        for (count, tolerance) in [4, 8].into_iter().zip(tolerances) {
            let found = plates(count, nahme);
            let errors = [0, 1].map(|i| (found[i] / expected[i] - 1.0).abs());
            assert!(errors.iter().all(|error| *error < tolerance), "Na {nahme} N {count}: {errors:?}");
        }
    }
}
