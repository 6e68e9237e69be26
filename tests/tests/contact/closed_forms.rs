//! Integrals of contact that have a closed form, and scenes without contact.

use std::sync::Arc;

use oilwedge_reynolds::analytical::bearing_curve::force_and_moment;
use oilwedge_reynolds::contact::greenwood_tripp::integral;
use oilwedge_reynolds::contact::{BearingCurve, Contact, Fineness};
use oilwedge_reynolds::film_thickness::{Eccentricity, Tilt};
use oilwedge_reynolds::flow_factors::PatirCheng;
use oilwedge_reynolds::quantities::contact::{share, unsure};
use oilwedge_reynolds::quantities::friction::friction;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::{Bearing, Cavitation, FilmProblem, FilmSystem, JournalState};
use oilwedge_study::measure::measure;
use oilwedge_tests::rough_surfaces::contacts;
use oilwedge_tests::tilted_bearings::numbers;
use oilwedge_tests::*;

use oilwedge_tests::rough_surfaces::block;

/// `F_5/2` of the second code, nine digits.
#[test]
fn the_integral_of_greenwood_and_tripp() {
    let block = block("F_5_2");
    let values = block["values"].as_object().expect("values");
    for (l, value) in values {
        let (l, value): (f64, f64) = (l.parse().expect("a number"), value.as_f64().expect("a number"));
        assert!((integral(5, l) / value - 1.0).abs() < 2e-9, "{l}: {:e} {value:e}", integral(5, l));
    }
}

/// The closed force and moment, and those of the film with its cosine by another quadrature: by the quadrature of films
/// on a ring of 96 by 16 cells.
#[test]
fn force_and_moment_of_a_bearing_curve() {
    let (radius, clearance, length) = (0.1, 0.15e-3, 0.08);
    let curve = BearingCurve { depth: 3e-6, hardness: 9e8 };
    let bearing = Bearing { radius, length, clearance, end_pressure: 0.0 };
    let mesh = ring_of_radius(radius, 96, 16, length, 0.0);
    let regions = ends(&mesh, length, None);
    let system = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("the ends close the ring"));
    for row in block("zharov_contact")["rows"].as_array().expect("rows") {
        let row = numbers(row);
        let [e, tilt, force, moment, force_of_film, moment_of_film] = row[..] else {
            panic!("a row of {}", row.len());
        };
        let [closed, closed_moment] = force_and_moment(&bearing, &curve, 1e-3 * e, tilt);
        // The table has seven digits or more; the sums are exact to round-off.
        close(closed, force, 5e-8);
        close_or_zero(closed_moment, 1e-3 * moment, 5e-8);
        let [summed, summed_moment] = summed(&bearing, &curve, 1e-3 * e, tilt);
        close(closed, summed, 1e-9);
        close_or_zero(closed_moment, summed_moment, 1e-9);
        let problem = FilmProblem {
            bearing,
            journal: JournalState { offset: [1e-3 * e, 0.0], tilt: [tilt, 0.0], ..JournalState::default() },
            film_thickness: vec![
                std::sync::Arc::new(Eccentricity { radius, clearance }),
                std::sync::Arc::new(Tilt { radius }),
            ],
            contact: Some(Contact { law: Arc::new(curve), friction: 0.0, fineness: Fineness::Reported }),
            ..plain_film(length, 0.5, 0.0, 0.0)
        };
        let found = share(&problem, &system).expect("contact");
        // The other quadrature is 5e-4 off where the zone of contact is smallest.
        close(found.force[0], force_of_film, 1e-3);
        close_or_zero(found.moment[0], 1e-3 * moment_of_film, 1e-3);
        assert!(found.force[1].abs() < 1e-9 * force);
        let rough = share(&problem.clone().with_contact(Fineness::Tried), &system).expect("contact");
        close(rough.force[0], found.force[0], 1e-5);
        let unsure = unsure(&problem, &system, &found);
        assert!(unsure > 0.0 && unsure < 1e-3 * force, "{unsure:e}");
    }
}

/// The force and the moment of the parabola by sums: Gauss's rule of three points around, which is exact, and Simpson's
/// rule along the axis in the root of the depth, in which the integrand is smooth.
fn summed(bearing: &Bearing, curve: &BearingCurve, offset: f64, tilt: f64) -> [f64; 2] {
    const STEPS: u32 = 2000;
    let depth_at = |z: f64| offset + tilt * z - (bearing.clearance - curve.depth);
    let per_length = |depth: f64| {
        let half = (2.0 * depth / bearing.clearance).sqrt();
        let gauss = [(-0.6f64.sqrt(), 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.6f64.sqrt(), 5.0 / 9.0)];
        let pressure = |s: f64| curve.hardness * (depth * (1.0 - s * s) / curve.depth).powi(2);
        bearing.radius * half * gauss.iter().map(|(s, weight)| weight * pressure(*s)).sum::<f64>()
    };
    let ends = bearing.ends();
    if tilt == 0.0 {
        return [per_length(depth_at(0.0)) * bearing.length, 0.0];
    }
    let [low, high] = ends.map(|z| depth_at(z).max(0.0).sqrt());
    let step = (high - low) / f64::from(STEPS);
    let mut sums = [0.0; 2];
    for k in 0..=STEPS {
        let root = low + step * f64::from(k);
        let weight = match k {
            0 | STEPS => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let z = (root * root - depth_at(0.0)) / tilt;
        let part = weight * step / 3.0 * per_length(root * root) * 2.0 * root / tilt;
        sums[0] += part;
        sums[1] += part * z;
    }
    sums
}

/// Contact is the same on a mesh four times as fine, to its own error of integration.
#[test]
fn contact_depends_on_no_mesh() {
    let [coarse, fine] = [48, 192].map(|columns| ring_system(columns, columns / 6, 0.06, None));
    for contact in contacts() {
        let problem = FilmProblem { contact: Some(contact), ..plain_film(0.06, 0.96, 0.4, SPEED) };
        let [coarse_share, fine_share] = [&coarse, &fine].map(|system| share(&problem, system).expect("contact"));
        let ([x, y], [fine_x, fine_y]) = (coarse_share.force, fine_share.force);
        let (off, size) = ((x - fine_x).hypot(y - fine_y), fine_x.hypot(fine_y));
        let bar = unsure(&problem, &coarse, &coarse_share);
        assert!(off < 1e-5 * size && off < bar + 1e-12 * size, "{off:e} {bar:e} {size:e}");
    }
}

/// Far apart, without hardness or roughness: the film without the table.
#[test]
fn neutral_values_are_absence() {
    let system = ring_system(48, 8, 0.06, Some(std::f64::consts::PI));
    for model in [
        Cavitation::None,
        Cavitation::Guembel { pressure: 0.0 },
        Cavitation::Reynolds { pressure: 0.0 },
        Cavitation::Jfo { pressure: 0.0 },
    ] {
        let mut plain = plain_film(0.06, 0.6, 0.0, SPEED);
        plain.cavitation = model;
        let mut neutral = FilmProblem {
            flow_factors: vec![std::sync::Arc::new(PatirCheng { roughness: 1e-12 })],
            contact: contacts().into_iter().next_back(),
            ..plain.clone()
        };
        // The film is 20 um thin, the profiles 4 um high.
        neutral.journal.speed = SPEED;
        let values = |problem: &FilmProblem| {
            let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
            let measured = measure(&film);
            let total = load(&film).total;
            let friction = friction(&problem.journal, &measured.power).expect("the journal turns");
            [total.force[0], total.force[1], friction.on_journal, friction.on_bearing]
        };
        for (a, b) in values(&plain).into_iter().zip(values(&neutral)) {
            assert!((a - b).abs() <= 1e-12 * a.abs().max(1.0), "{model:?}: {a} {b}");
        }
    }
}

/// Friction of contact is `R mu_b Int p_a dA` on both surfaces, against either sense of rotation.
#[test]
fn contact_rubs() {
    let system = ring_system(48, 8, 0.06, None);
    for contact in contacts() {
        for speed in [SPEED, -SPEED] {
            let mut with = plain_film(0.06, 0.96, 0.0, speed);
            with.cavitation = Cavitation::Reynolds { pressure: 0.0 };
            let without = with.clone();
            with.contact = Some(contact.clone());
            let torques = |problem: &FilmProblem| {
                let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
                let measured = measure(&film);
                assert!(measured.power.imbalance < 1e-8, "{:?}", measured.power);
                let friction = friction(&problem.journal, &measured.power).expect("the journal turns");
                let thrust = measured.contact.map_or(0.0, |contact| contact.share.pressure);
                (friction, thrust)
            };
            let ((rough, thrust), (smooth, _)) = (torques(&with), torques(&without));
            let added = RADIUS * contact.friction * thrust;
            assert!(thrust > 0.0);
            close(rough.on_journal - smooth.on_journal, added, 1e-9);
            close(rough.on_bearing - smooth.on_bearing, added, 1e-9);
        }
    }
}

#[track_caller]
fn close(value: f64, wanted: f64, part: f64) {
    assert!((value / wanted - 1.0).abs() < part, "{value} {wanted}: {:e}", value / wanted - 1.0);
}

#[track_caller]
fn close_or_zero(value: f64, wanted: f64, part: f64) {
    match wanted == 0.0 {
        true => assert!(value.abs() < 1e-6, "{value}"),
        false => close(value, wanted, part),
    }
}
