//! Triangles and outlines become a mesh as a file would list it: groups, bulges, the seam glued.

use std::collections::HashMap;

use super::outline::{Edge, Outline};
use super::shape::Feature;
use super::triangulate::{FilledDomain, Triangles};
use crate::{Circle, RawMesh};

/// Triangles and outlines as a mesh file would list them, the seam glued.
pub(super) fn raw_mesh(domain: &FilledDomain, outline: &Outline, filled: Triangles) -> RawMesh {
    let Triangles { points, mut triangles } = filled;
    let mut glued: Vec<u32> = (0..points.len() as u32).collect();
    for &[left, right] in &outline.seam {
        glued[right as usize] = left;
    }
    let cells_of = |feature: &Feature| -> Vec<u32> {
        let inside = |triangle: &[u32; 3]| {
            let centre = [0, 1].map(|d| triangle.iter().map(|&v| points[v as usize][d]).sum::<f64>() / 3.0);
            feature.shape.distance(centre, domain.sheet.period()) < 0.0
        };
        (0u32..).zip(&triangles).filter(|(_, triangle)| inside(triangle)).map(|(t, _)| t).collect()
    };
    let mut surfaces: Vec<(String, Vec<u32>)> = (domain.features.iter())
        .filter(|feature| feature.meshed)
        .map(|feature| (feature.name.clone(), cells_of(feature)))
        .collect();
    surfaces.push(("film".to_owned(), film_cells(&surfaces, triangles.len())));
    let bulges = bulges(&points, &triangles, outline);
    for vertex in triangles.iter_mut().flatten() {
        *vertex = glued[*vertex as usize];
    }
    let mut curves: Vec<(String, Vec<[u32; 2]>)> = Vec::new();
    for Edge { ends, group, .. } in &outline.edges {
        if let Some(group) = group {
            let ends = ends.map(|end| glued[end as usize]);
            match curves.iter_mut().find(|(name, _)| name == group) {
                Some((_, edges)) => edges.push(ends),
                None => curves.push((group.clone(), vec![ends])),
            }
        }
    }
    let mut circles: Vec<(Circle, Vec<[u32; 2]>)> = Vec::new();
    for Edge { ends, circle, .. } in &outline.edges {
        if let Some(circle) = circle {
            let ends = ends.map(|end| glued[end as usize]);
            match circles.iter_mut().find(|(known, _)| known == circle) {
                Some((_, edges)) => edges.push(ends),
                None => circles.push((*circle, vec![ends])),
            }
        }
    }
    RawMesh { circles, points, labels: Vec::new(), triangles, bulges, curves, surfaces, period: domain.sheet.period() }
}

/// Triangles in none of the surfaces.
fn film_cells(surfaces: &[(String, Vec<u32>)], count: usize) -> Vec<u32> {
    let mut film = vec![true; count];
    for &cell in surfaces.iter().flat_map(|(_, cells)| cells) {
        film[cell as usize] = false;
    }
    (0..count as u32).filter(|&cell| film[cell as usize]).collect()
}

/// Edges on a circle bulge to it.
fn bulges(points: &[[f64; 2]], triangles: &[[u32; 3]], outline: &Outline) -> Vec<(u32, u8, [f64; 2])> {
    let on_circle: HashMap<[u32; 2], Circle> = (outline.edges.iter())
        .filter_map(|edge| {
            let [a, b] = edge.ends;
            edge.circle.map(|circle| ([a.min(b), a.max(b)], circle))
        })
        .collect();
    let mut bulges = Vec::new();
    if on_circle.is_empty() {
        return bulges;
    }
    for (t, triangle) in (0u32..).zip(triangles) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            if let Some(circle) = on_circle.get(&[a.min(b), a.max(b)]) {
                let middle = [0, 1].map(|d| 0.5 * (points[a as usize][d] + points[b as usize][d]));
                let arm = [0, 1].map(|d| middle[d] - circle.centre[d]);
                let stretch = circle.radius / arm[0].hypot(arm[1]) - 1.0;
                bulges.push((t, k as u8, arm.map(|x| x * stretch)));
            }
        }
    }
    bulges
}
