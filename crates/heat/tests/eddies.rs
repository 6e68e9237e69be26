//! Turbulent films: the laminar limit, Ng and Pan's integrals by another rule, and a march across many cells.

use oilwedge_heat::{
    BushSide, FilmCell, FilmLink, FilmNetwork, FilmPort, JournalSide, LayerProfile, Layers, NetworkOptions,
    OilProperties, PortKind, TurbulentFlow, solve,
};

const OIL: OilProperties = OilProperties { capacity: 1.7e6, conductivity: 0.13 };
const DENSITY: f64 = 860.0;
const SPEED: f64 = 78.0;
const VISCOSITY: f64 = 0.02;

/// A film of this Reynolds number.
fn film(reynolds_number: f64) -> TurbulentFlow {
    let gap = reynolds_number * VISCOSITY / (DENSITY * SPEED);
    TurbulentFlow { gap, speed: SPEED, density: DENSITY, oil: OIL }
}

fn near(name: &str, found: f64, wanted: f64, tolerance: f64) {
    assert!((found - wanted).abs() <= tolerance * wanted.abs().max(1e-3), "{name}: {found} {wanted}");
}

/// A film that nothing stirs has the profile of a laminar one, whose viscosity is linear in steps.
#[test]
fn a_film_without_inertia_has_no_eddies() {
    for count in [4, 6, 8] {
        let layers = Layers::linear(count).expect("a count");
        let viscosities: Vec<f64> = layers.points.iter().map(|eta| VISCOSITY * (1.0 - 0.4 * eta)).collect();
        let still = TurbulentFlow { speed: 1e-9, ..film(1e3) };
        let profile = LayerProfile::turbulent(&layers, &viscosities, &still);
        let laminar = LayerProfile::of(&layers, &viscosities);
        let eddies = profile.eddies.expect("eddies");
        near("R", profile.resistance, 1.0, 1e-9);
        for (k, scale) in eddies.conductance.into_iter().chain([eddies.shear]).enumerate() {
            near(&format!("scale {k}"), scale, 1.0, 1e-12);
        }
        near("F0", profile.f0, laminar.f0, 1e-3);
        // Trapezoids over the steps are good to the square of their length.
        let square = (count as f64).powi(-2);
        near("F1", profile.f1, laminar.f1, 0.2 * square);
        near("F2", profile.f2, laminar.f2, 3.0 * square);
        (0..=count).for_each(|l| near("weight", profile.weights[l], layers.weights[l], 2e-2));
    }
}

/// C, k_x, k_z and R of a film of one viscosity, by midpoints that are dense at the wall.
fn integrals(reynolds_number: f64) -> [f64; 4] {
    const POINTS: u32 = 20_000;
    let prandtl = VISCOSITY * OIL.capacity / (DENSITY * OIL.conductivity * 0.9);
    let at = |wall_gap: f64| {
        let mut sums = [0.0; 4];
        for point in 0..POINTS {
            let s = (f64::from(point) + 0.5) / f64::from(POINTS);
            let (eta, weight) = (0.5 * s.powi(3), 3.0 * s * s / f64::from(POINTS));
            let (y, t) = (eta * wall_gap, (eta * wall_gap / 10.7).tanh());
            let eddy = 0.4 * (y - 10.7 * t);
            let pressed = weight * (0.5 - eta).powi(2) / (1.0 + eddy);
            sums[0] += weight / (1.0 + eddy);
            sums[1] += pressed * (1.0 - 0.2 * y * t * t / (1.0 + eddy));
            sums[2] += pressed;
            sums[3] += weight / (1.0 + prandtl * eddy);
        }
        sums
    };
    let (mut low, mut high) = (1e-2f64, 1e5f64);
    for _ in 0..60 {
        let middle = (low * high).sqrt();
        let is_below = middle * middle * at(middle)[0] < reynolds_number;
        if is_below { low = middle } else { high = middle }
    }
    let [f0, along, across, resistance] = at(low);
    [1.0 / f0, 1.0 / along, 1.0 / across, resistance]
}

#[test]
fn a_film_of_one_viscosity_has_the_integrals_of_ng_and_pan() {
    let layers = Layers::linear(8).expect("a count");
    let viscosities = [VISCOSITY; 9];
    for reynolds_number in [100.0, 1e3, 1e4, 3e4] {
        let profile = LayerProfile::turbulent(&layers, &viscosities, &film(reynolds_number));
        let eddies = profile.eddies.expect("eddies");
        let [shear, k_x, k_z, resistance] = integrals(reynolds_number);
        near("C", eddies.shear, shear, 1e-4);
        near("k_x", 12.0 / eddies.conductance[0], k_x, 1e-4);
        near("k_z", 12.0 / eddies.conductance[1], k_z, 1e-4);
        near("R", profile.resistance, resistance, 1e-3);
        near("drag", profile.drag_share(), 0.5, 1e-12);
        let [behind, ahead] = [-1e-3, 1e-3].map(|apart| integrals(reynolds_number * f64::exp(apart)));
        let growth = |k: usize| (ahead[k] / behind[k]).ln() / 2e-3;
        near("growth of the shear", eddies.shear_growth, growth(0), 5e-4);
        near("growth of k_x", -eddies.conductance_growth[0], growth(1), 5e-4);
        near("growth of k_z", -eddies.conductance_growth[1], growth(2), 5e-4);
        for shares in [profile.drag, profile.driven, profile.shear_friction, profile.driven_friction, profile.weights] {
            near("sum", shares.iter().sum(), 1.0, 1e-12);
        }
        assert!(profile.weights[..9].iter().all(|weight| *weight > 0.0));
        let places = eddies.places();
        assert!(places.windows(2).all(|pair| pair[0][0] < pair[1][0] && pair[0][1] <= pair[1][1]), "{places:?}");
    }
}

/// A channel between a plane that moves and a wall; oil comes with 45 degrees.
struct Channel {
    flow: TurbulentFlow,
    length: f64,
    plane: f64,
    /// Temperature of the wall; `None`: adiabatic.
    wall: Option<f64>,
}

const COMES: f64 = 318.15;
const COLUMNS: usize = 200;

impl Channel {
    /// Mean temperature of the oil that leaves and temperature of the wall there, by layers.
    fn by_layers(&self, count: usize) -> [f64; 2] {
        let layers = Layers::linear(count).expect("a count");
        let profile = LayerProfile::turbulent(&layers, &vec![VISCOSITY; count + 1], &self.flow);
        let (width, gap, speed) = (self.length / COLUMNS as f64, self.flow.gap, self.flow.speed);
        let dragged = 0.5 * speed * gap;
        let cell = FilmCell {
            thickness: gap,
            film_fraction: 1.0,
            wall_area: width,
            shear_power: speed * speed / (gap * profile.f0) * width,
            driven_power: 0.0,
            cross_power: 0.0,
            angle: 0.0,
            along: 0.0,
        };
        let port = |cell: usize, sign: f64| FilmPort {
            cell,
            kind: PortKind::Opening { temperature: COMES },
            dragged: sign * dragged,
            driven: 0.0,
        };
        let network = FilmNetwork {
            oil: OIL,
            cells: vec![cell; COLUMNS],
            links: (1..COLUMNS).map(|to| FilmLink { from: to - 1, to, dragged, driven: 0.0 }).collect(),
            ports: vec![port(0, 1.0), port(COLUMNS - 1, -1.0)],
            feeds: Vec::new(),
            bush: self.wall.map_or(BushSide::Adiabatic, BushSide::Fixed),
            journal: JournalSide::Fixed(self.plane),
        };
        let profiles = vec![profile; COLUMNS];
        let solved = solve(&network, &layers, &profiles, None, &NetworkOptions::default()).expect("temperatures");
        assert!(solved.sheet.left.abs() < 1e-9 * solved.sheet.power);
        [solved.sheet.outlet.expect("oil leaves"), solved.temperatures.of_cell(&layers, COLUMNS - 1)[0]]
    }

    /// Both numbers by a march along the channel with many cells across, dense at the walls.
    fn by_cells(&self) -> [f64; 2] {
        const HALF: usize = 200;
        let flow = &self.flow;
        let side = |i: usize| 0.5 * (i as f64 / HALF as f64).powi(3);
        let edges: Vec<f64> = (0..=HALF).map(side).chain((0..HALF).rev().map(|i| 1.0 - side(i))).collect();
        let cells = 2 * HALF;
        let middle = |i: usize| 0.5 * (edges[i] + edges[i + 1]);
        let size = |i: usize| edges[i + 1] - edges[i];
        let eddies = |stress: f64, eta: f64| {
            let y = eta.min(1.0 - eta) * flow.gap * (flow.density * stress).sqrt() / VISCOSITY;
            VISCOSITY * 0.4 * (y - 10.7 * (y / 10.7).tanh())
        };
        let slip = |stress: f64, i: usize| stress * size(i) * flow.gap / (VISCOSITY + eddies(stress, middle(i)));
        let (mut low, mut high) = (1.0f64, 1e7f64);
        for _ in 0..80 {
            let stress = (low * high).sqrt();
            let is_below = (0..cells).map(|i| slip(stress, i)).sum::<f64>() < flow.speed;
            if is_below { low = stress } else { high = stress }
        }
        let stress = low;
        let mut velocity = vec![0.0; cells];
        let mut sum = 0.0;
        for i in 0..cells {
            velocity[i] = sum + 0.5 * slip(stress, i);
            sum += slip(stress, i);
        }
        let conductivity = |eta: f64| OIL.conductivity + OIL.capacity / flow.density * eddies(stress, eta) / 0.9;
        let between = |edge: usize| {
            let (left, right) =
                (if edge > 0 { middle(edge - 1) } else { 0.0 }, if edge < cells { middle(edge) } else { 1.0 });
            conductivity(edges[edge]) / (flow.gap * (right - left))
        };
        let at_wall = if self.wall.is_some() { between(0) } else { 0.0 };
        let carried = |i: usize| OIL.capacity * velocity[i] * size(i) * flow.gap / (self.length / COLUMNS as f64);
        let mut temperatures = vec![COMES; cells];
        for _ in 0..COLUMNS {
            // Thomas' elimination from the wall to the plane.
            let (mut factors, mut sides) = (vec![0.0; cells], vec![0.0; cells]);
            for i in 0..cells {
                let below = if i > 0 { between(i) } else { at_wall };
                let above = between(i + 1);
                let (known, factor, side) = match i {
                    0 => (at_wall * self.wall.unwrap_or(0.0), 0.0, 0.0),
                    _ => (0.0, factors[i - 1], sides[i - 1]),
                };
                let last = if i + 1 == cells { above * self.plane } else { 0.0 };
                let made = stress * slip(stress, i);
                let pivot = carried(i) + above + below - if i > 0 { below * factor } else { 0.0 };
                factors[i] = above / pivot;
                sides[i] =
                    (made + known + last + carried(i) * temperatures[i] + if i > 0 { below * side } else { 0.0 })
                        / pivot;
            }
            temperatures[cells - 1] = sides[cells - 1];
            for i in (0..cells - 1).rev() {
                temperatures[i] = sides[i] + factors[i] * temperatures[i + 1];
            }
        }
        let all: f64 = (0..cells).map(carried).sum();
        let mean = (0..cells).map(|i| carried(i) * temperatures[i]).sum::<f64>() / all;
        [mean, self.wall.unwrap_or(temperatures[0])]
    }
}

/// The oil warms by 0.7 to 23 K, an adiabatic wall by 2 to 25 K.
#[test]
fn a_channel_warms_as_by_many_cells() {
    for (reynolds_number, wall) in [(1e3, None), (1e3, Some(343.15)), (4e3, None), (4e3, Some(343.15)), (1.5e4, None)] {
        let channel = Channel { flow: film(reynolds_number), length: 0.6, plane: 328.15, wall };
        let wanted = channel.by_cells();
        let mut before = f64::INFINITY;
        for (count, tolerance) in [(4, 0.2), (6, 0.1), (8, 0.06)] {
            let found = channel.by_layers(count);
            let off = (found[0] - wanted[0]).abs();
            let off_at_wall = (found[1] - wanted[1]).abs();
            let which = format!("{reynolds_number} {wall:?} {count}: {off} {off_at_wall}");
            assert!(off < tolerance && off_at_wall < 0.12, "{which}");
            assert!(off < before);
            before = off;
        }
    }
}
