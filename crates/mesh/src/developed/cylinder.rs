//! What a file shows: the unrolled liner in a plane, or the cylinder itself.

use super::AGREEMENT;
use crate::gmsh::MshFile;
use crate::{Circle, Error};

/// Relative thickness below which a mesh is flat.
const FLAT: f64 = 1e-9;

/// Surface on which the nodes of a file lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum FileSurface {
    /// A plane z = constant.
    Plane,
    /// A cylinder along coordinate `axis`, with the circle of its section in the next two.
    Cylinder { axis: usize, section: Circle },
}

impl FileSurface {
    /// Recognises the shape from the nodes marked in `used`. Among several cylinders through few
    /// nodes the one of a radius nearest to `radius` (in the unit of the file) is meant.
    pub(super) fn find(file: &MshFile, used: &[bool], radius: f64) -> Result<Self, Error> {
        let points = || used.iter().zip(&file.nodes).filter(|(used, _)| **used).map(|(_, node)| *node);
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in points() {
            for k in 0..3 {
                low[k] = low[k].min(point[k]);
                high[k] = high[k].max(point[k]);
            }
        }
        let extent: [f64; 3] = std::array::from_fn(|k| high[k] - low[k]);
        let flat = FLAT * extent[0].max(extent[1]).max(extent[2]);
        if extent[2] <= flat {
            return Ok(Self::Plane);
        }
        if let Some(axis) = (0..2).find(|&k| extent[k] <= flat) {
            return Err(Error::WrongPlane { axis: NAMES[axis] });
        }
        let fits = (0..3).filter_map(|axis| {
            let section = Circle::fit(points().map(|point| across(point, axis)))?;
            let off = |point: [f64; 3]| section.distance(across(point, axis)).abs();
            let worst = points().map(off).fold(0.0, f64::max);
            Some((axis, section, worst / section.radius))
        });
        let fits: Vec<_> = fits.collect();
        let good = fits.iter().filter(|(_, _, worst)| *worst <= AGREEMENT);
        let strangeness = |section: &Circle| (section.radius / radius).ln().abs();
        if let Some(&(axis, section, _)) = good.min_by(|a, b| strangeness(&a.1).total_cmp(&strangeness(&b.1))) {
            return Ok(Self::Cylinder { axis, section });
        }
        let Some(&(axis, section, _)) = fits.iter().min_by(|a, b| a.2.total_cmp(&b.2)) else {
            return Err(Error::WrongPlane { axis: '?' });
        };
        let off = |v: usize| section.distance(across(file.nodes[v], axis)).abs();
        let vertices = (0..used.len()).filter(|&v| used[v]);
        let node = vertices.max_by(|&a, &b| off(a).total_cmp(&off(b))).unwrap_or(0);
        Err(Error::NotALiner { node: file.tags[node], distance: off(node), axis: NAMES[axis], radius: section.radius })
    }
}

const NAMES: [char; 3] = ['x', 'y', 'z'];

/// The two coordinates after `axis`: the angle counts from the first to the second.
pub(super) fn across(point: [f64; 3], axis: usize) -> [f64; 2] {
    [point[(axis + 1) % 3], point[(axis + 2) % 3]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn find(nodes: Vec<[f64; 3]>) -> Result<FileSurface, Error> {
        let file = MshFile { tags: (1..=nodes.len() as u64).collect(), nodes, ..MshFile::default() };
        FileSurface::find(&file, &vec![true; file.nodes.len()], 2.0)
    }

    /// Nodes on a cylinder of radius 2 along `axis`, somewhere in space.
    fn cylinder(axis: usize, arc: f64) -> Vec<[f64; 3]> {
        let node = |k: u32| {
            let angle = 0.1 + arc * f64::from(k % 10) / 10.0;
            let mut point = [0.0; 3];
            point[axis] = 50.0 + f64::from(k / 10);
            point[(axis + 1) % 3] = 7.0 + 2.0 * angle.cos();
            point[(axis + 2) % 3] = -3.0 + 2.0 * angle.sin();
            point
        };
        (0..50).map(node).collect()
    }

    #[test]
    fn cylinders_along_each_axis() {
        for along in 0..3 {
            for arc in [0.5, 3.0, 6.0] {
                let FileSurface::Cylinder { axis, section } = find(cylinder(along, arc)).unwrap() else {
                    panic!("a plane");
                };
                assert_eq!(axis, along);
                assert!((section.radius - 2.0).abs() < 1e-8);
                assert!((section.centre[0] - 7.0).abs() + (section.centre[1] + 3.0).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn other_shapes_are_named() {
        let square =
            |point: fn(f64, f64) -> [f64; 3]| find((0..9).map(|k| point(f64::from(k % 3), f64::from(k / 3))).collect());
        assert_eq!(square(|a, b| [a, b, 4.0]).unwrap(), FileSurface::Plane);
        assert!(matches!(square(|a, b| [a, 1.0, b]), Err(Error::WrongPlane { axis: 'y' })));
        let mut bump = cylinder(2, 6.0);
        bump[17][0] += 0.01;
        assert!(matches!(find(bump), Err(Error::NotALiner { node: 18, axis: 'z', .. })));
    }
}
