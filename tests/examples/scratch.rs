#![allow(missing_docs)]
use oilwedge_reynolds::quantities::{load, similarity};
use oilwedge_reynolds::*;
use oilwedge_tests::*;
use std::sync::Arc;
use std::time::Instant;
fn main() {
    // plain360 B/D=1: D = 2R = 0.1, B = 0.1
    for (eps, so_ref, att) in [
        (0.1, 0.11969, 79.411),
        (0.5, 0.89103, 56.699),
        (0.8, 3.5719, 36.227),
        (0.9, 8.4566, 26.473),
    ] {
        for n in [32u32, 64, 128, 256] {
            let length = 0.1;
            let mesh = ring(n, n / 4, length, std::f64::consts::PI);
            let regions = ends(&mesh, length, Some(std::f64::consts::PI));
            let t0 = Instant::now();
            let system = FilmSystem::new(Arc::new(mesh), 2, regions).unwrap();
            let mut film = plain_film(length, eps, 0.0, SPEED);
            film.cavitation = match std::env::args().nth(1).as_deref() {
                Some("jfo") => Cavitation::Jfo { pressure: 0.0 },
                _ => Cavitation::Reynolds { pressure: 0.0 },
            };
            let t1 = t0.elapsed();
            let system = if std::env::args().nth(2).is_some() {
                system
            } else {
                system.with_coarser(&film.bearing, &film.film_thickness)
            };
            let t2 = t0.elapsed();
            match film.solve(&system) {
                Ok(s) => {
                    let l = load::load(&film, &system, &s);
                    let so =
                        similarity::sommerfeld_number(&film.bearing, VISCOSITY, &film.journal, l.magnitude()).unwrap();
                    let a = similarity::attitude_angle(&film.journal, l.angle()).to_degrees();
                    let pm = film.greatest_unknown(&system, &s) / pressure_scale();
                    println!(
                        "eps {eps} dofs {} So {so:.6} ({:+.2e}) att {a:.4} ({:+.4}) pm {pm:.5} its {} levels {} cav {} [{:?}] sys {t1:?} coarse {:?} total {:?} {:?} {:?}",
                        system.space().dofs(),
                        so / so_ref - 1.0,
                        a - att,
                        s.history.len(),
                        s.levels,
                        s.cavity.iter().filter(|c| **c).count(),
                        s.fallbacks,
                        t2 - t1,
                        t0.elapsed(),
                        s.seconds,
                        s.history.iter().map(|h| h.active).collect::<Vec<_>>()
                    );
                }
                Err(e) => println!("eps {eps} n {n}: {e}"),
            }
        }
    }
}
