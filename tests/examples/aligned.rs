#![allow(missing_docs)]
use oilwedge_reynolds::quantities::load;
use oilwedge_reynolds::supply::*;
use oilwedge_reynolds::*;
use oilwedge_tests::*;
use std::sync::Arc;
fn main() {
    for (n, rows) in [(48u32, 8u32), (96, 16), (192, 32)] {
        let length = 0.08;
        let mesh = ring(n, rows, length, 0.0);
        let mut regions = ends(&mesh, length, None);
        let half = 0.01;
        let cells: Vec<u32> = (0..mesh.triangles().len())
            .filter(|&t| {
                let c = mesh.corners(t);
                let x = (c[0][0] + c[1][0] + c[2][0]) / 3.0 / RADIUS;
                let z = (c[0][1] + c[1][1] + c[2][1]) / 3.0;
                x.to_degrees() > 82.5 && x.to_degrees() < 97.5 && z.abs() < half
            })
            .map(|t| t as u32)
            .collect();
        regions.push(SupplyRegion {
            name: "groove".into(),
            place: Place::Feed,
            pressure: 70000.0,
            edges: vec![],
            cells,
            disc: None,
            film_fraction: None,
        });
        let mut film = plain_film(length, 0.5, 0.0, 314.159265);
        film.bearing.clearance = 150e-6;
        film.film_thickness = vec![Arc::new(oilwedge_reynolds::film_thickness::Eccentricity {
            radius: RADIUS,
            clearance: 150e-6,
        })];
        film.journal = JournalState::at_eccentricity(0.5, 0.0, 150e-6, 314.159265);
        film.lubricant.viscosity = 0.01;
        film.cavitation = Cavitation::Jfo { pressure: 0.0 };
        let system = FilmSystem::new(Arc::new(mesh), 2, regions)
            .unwrap()
            .with_coarser(&film.bearing, &film.film_thickness);
        match film.solve(&system) {
            Ok(s) => {
                let l = load::load(&film, &system, &s);
                println!(
                    "n {} F {:.2} {:+.1e} {:?} its {} {:?}",
                    system.space().dofs(),
                    l.magnitude(),
                    l.magnitude() / 1651.5 - 1.0,
                    l.total.force,
                    s.history.len(),
                    s.fallbacks
                );
            }
            Err(e) => println!("{e}"),
        }
    }
}
