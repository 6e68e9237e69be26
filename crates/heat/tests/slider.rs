//! Infinitely wide sliders, whose film is an integral: closed forms, and an independent march across the film.

use oilwedge_heat::{
    BushSide, FilmCell, FilmLink, FilmNetwork, FilmPort, JournalSide, LayerProfile, Layers, NetworkOptions,
    OilProperties, PortKind, SolvedNetwork, solve,
};

/// A slider: the pad is the bush, the plane is the journal.
#[derive(Clone, Copy)]
struct Slider {
    length: f64,
    inlet: f64,
    outlet: f64,
    speed: f64,
    viscosity: f64,
    thinning: f64,
    capacity: f64,
    conductivity: f64,
}

/// Flow for each width, greatest pressure, load for each width, highest temperature, temperature of what leaves; all
/// temperatures above that of the oil that comes.
type Answer = [f64; 5];

/// Temperature of the oil that comes, and of walls that have one [K].
const COLD: f64 = 313.15;

impl Slider {
    fn thickness(&self, share: f64) -> f64 {
        self.inlet + (self.outlet - self.inlet) * share
    }

    fn profile(&self, layers: &Layers, temperatures: &[f64]) -> LayerProfile {
        let at = |t: &f64| self.viscosity * (-self.thinning * (t - COLD)).exp();
        LayerProfile::of(layers, &temperatures.iter().map(at).collect::<Vec<f64>>())
    }

    /// The network of `columns` cells, pressures at their faces, and the flow.
    fn film(&self, profiles: &[LayerProfile], walls: &(BushSide, JournalSide)) -> (FilmNetwork, Vec<f64>, f64) {
        let columns = profiles.len();
        let width = self.length / columns as f64;
        let middle = |i: usize| self.thickness((i as f64 + 0.5) / columns as f64);
        let slope = |i: usize, q: f64| {
            let h = middle(i);
            (self.speed * h * profiles[i].drag_share() - q) / (h.powi(3) * profiles[i].f2)
        };
        let sum = |of: &dyn Fn(usize) -> f64| -> f64 { (0..columns).map(of).sum() };
        let q = sum(&|i| slope(i, 0.0)) / sum(&|i| slope(i, 0.0) - slope(i, 1.0));
        let mut pressures = vec![0.0];
        (0..columns).for_each(|i| pressures.push(pressures[i] + width * slope(i, q)));
        let cells = (0..columns).map(|i| {
            let (h, slope) = (middle(i), slope(i, q));
            FilmCell {
                thickness: h,
                film_fraction: 1.0,
                wall_area: width,
                shear_power: self.speed.powi(2) / (h * profiles[i].f0) * width,
                driven_power: h.powi(3) * profiles[i].f2 * slope * slope * width,
                cross_power: 2.0 * h * slope * self.speed * width,
                angle: 0.0,
                along: 0.0,
            }
        });
        let dragged = |face: usize| {
            let (before, after) = (face.saturating_sub(1), face.min(columns - 1));
            let share = 0.5 * (profiles[before].drag_share() + profiles[after].drag_share());
            self.speed * self.thickness(face as f64 / columns as f64) * share
        };
        let link =
            |face: usize| FilmLink { from: face - 1, to: face, dragged: dragged(face), driven: q - dragged(face) };
        let port = |cell: usize, face: usize, sign: f64| FilmPort {
            cell,
            kind: PortKind::Opening { temperature: COLD },
            dragged: sign * dragged(face),
            driven: sign * (q - dragged(face)),
        };
        let network = FilmNetwork {
            oil: OilProperties { capacity: self.capacity, conductivity: self.conductivity },
            cells: cells.collect(),
            links: (1..columns).map(link).collect(),
            ports: vec![port(0, 0, 1.0), port(columns - 1, columns, -1.0)],
            feeds: Vec::new(),
            bush: walls.0.clone(),
            journal: walls.1,
        };
        (network, pressures, q)
    }

    /// Film and temperature in turn, until neither changes.
    fn solved(&self, count: usize, columns: usize, walls: &(BushSide, JournalSide)) -> Answer {
        let layers = Layers::new(count).expect("a count");
        let mut temperatures = vec![COLD; columns * (count + 1)];
        loop {
            let profiles: Vec<_> =
                temperatures.chunks_exact(count + 1).map(|cell| self.profile(&layers, cell)).collect();
            let (network, pressures, q) = self.film(&profiles, walls);
            let options = NetworkOptions { tolerance: 1e-11, ..NetworkOptions::default() };
            let solved: SolvedNetwork = solve(&network, &layers, &profiles, None, &options).expect("temperatures");
            let next = &solved.temperatures.layers;
            let change = next.iter().zip(&temperatures).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            temperatures.iter_mut().zip(next).for_each(|(t, next)| *t += 0.8 * (next - *t));
            if change < 1e-8 {
                let sheet = solved.sheet;
                assert!(sheet.left.abs() < 1e-9 * sheet.power, "{sheet:?}");
                let width = self.length / columns as f64;
                let highest = pressures.iter().copied().fold(0.0, f64::max);
                let load = width * pressures.iter().sum::<f64>();
                let out = sheet.outlet.expect("oil leaves");
                let hottest = (0..columns)
                    .flat_map(|cell| (0..=100).map(move |i| (cell, f64::from(i) / 100.0)))
                    .map(|(cell, eta)| layers.at(solved.temperatures.of_cell(&layers, cell), eta))
                    .fold(0.0, f64::max);
                return [q, highest, load, hottest - COLD, out - COLD];
            }
        }
    }

    /// Upwind is of first order in columns: what it tends to.
    fn limit(&self, count: usize, columns: usize, walls: (BushSide, JournalSide)) -> Answer {
        let [coarse, fine] = [columns, 2 * columns].map(|columns| self.solved(count, columns, &walls));
        std::array::from_fn(|i| 2.0 * fine[i] - coarse[i])
    }
}

/// Relative errors, each less than `tolerance` and what the reference is unsure of.
fn compare(name: &str, found: Answer, expected: Answer, unsure: Answer, tolerance: f64) {
    let errors: Answer = std::array::from_fn(|i| (found[i] / expected[i] - 1.0).abs());
    for i in 0..5 {
        assert!(errors[i] < tolerance + unsure[i] / expected[i], "{name}: {errors:?}");
    }
}

/// One temperature across is the film of an oil that conducts well between adiabatic walls:
/// `exp(beta dT) - 1 = beta mu0/(rho c q) Int U^2/h + 12 (U h/2 - q)^2/h^3 dx`, by quadratures.
#[test]
fn adiabatic_sliders_of_one_temperature_across() {
    for (name, slider, [q, rise, pressure, load]) in [
        (
            "adiabatic_slider_5",
            Slider {
                length: 0.25,
                inlet: 1e-4,
                outlet: 5e-5,
                speed: 5.0,
                viscosity: 0.03,
                thinning: 0.04,
                capacity: 1.7e6,
                conductivity: 1e3,
            },
            [0.000_169_653_903_089_223_95, 8.450_165_856_476_017, 3_155_535.927_752_734, 510_418.170_039_383_9],
        ),
        (
            "adiabatic_slider_6",
            Slider {
                length: 0.1,
                inlet: 8e-5,
                outlet: 4e-5,
                speed: 10.0,
                viscosity: 0.05,
                thinning: 0.03,
                capacity: 1.7e6,
                conductivity: 1e3,
            },
            [0.000_273_552_299_246_832_27, 16.164_687_438_381_282, 6_079_187.223_818_031, 396_270.900_428_688_4],
        ),
    ] {
        for count in [2, 4] {
            let found = slider.limit(count, 100, (BushSide::Adiabatic, JournalSide::Adiabatic));
            compare(&format!("{name} N {count}"), found, [q, pressure, load, rise, rise], [0.0; 5], 1e-3);
        }
    }
}

/// Sliders with temperature across, against an independent march with volumes across the film.
#[test]
fn sliders_with_walls() {
    let slider = Slider {
        length: 0.1,
        inlet: 1.6e-4,
        outlet: 1e-4,
        speed: 20.0,
        viscosity: 0.03,
        thinning: 0.04,
        capacity: 1.7e6,
        conductivity: 0.13,
    };
    let plane = JournalSide::Fixed(COLD);
    for (name, pad, expected, unsure) in [
        (
            "slider_walls_8",
            BushSide::Fixed(COLD),
            [0.001_241_793_903_514_522_5, 1_193_906.954_660_645, 78_298.334_202_625_79, 4.914_821_563, 2.797_206_769],
            [1.1e-8, 39.0, 3.0, 0.0109, 0.0031],
        ),
        (
            "slider_walls_9",
            BushSide::Adiabatic,
            [0.001_284_806_832_524_053_7, 999_367.417_332_453_7, 65_789.676_133_734_57, 11.765_097_455, 3.464_489_501],
            [3.7e-8, 132.0, 8.8, 0.0281, 0.0038],
        ),
    ] {
        for (count, tolerance) in [(4, 3e-2), (6, 1e-3), (8, 1e-3)] {
            let found = slider.limit(count, 160, (pad.clone(), plane));
            compare(&format!("{name} N {count}"), found, expected, unsure, tolerance);
        }
    }
}
