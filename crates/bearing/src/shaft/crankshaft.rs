//! A crankshaft along its axis: straight pieces, and throws of a pin between two webs.
//!
//! Journals and pins are beams along z, webs beams along the throw in the middle of their thickness, or rigid arms. A
//! journal reaches to the middle of the web beside it.

use super::beam::{Beam, Material, Point, Section};
use super::frame::BeamFrame;

/// One piece of a shaft; the next one begins where it ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Piece {
    /// A round piece about the axis.
    Straight(Round),
    /// A crank.
    Throw(CrankThrow),
}

/// A round piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Round {
    /// Length [m].
    pub length: f64,
    /// Diameter [m].
    pub diameter: f64,
    /// Diameter of the bore [m], which may be zero.
    pub bore: f64,
}

/// A pin between two webs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrankThrow {
    /// Angle of the throw in the axes of the shaft [rad].
    pub angle: f64,
    /// Radius of the crank [m].
    pub radius: f64,
    /// The pin between the webs.
    pub pin: Round,
    /// Thickness of a web along the axis [m].
    pub web_thickness: f64,
    /// Width of a web across the throw [m]; `None`: webs are rigid.
    pub web_width: Option<f64>,
}

/// A shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct Crankshaft {
    /// What it is made of.
    pub material: Material,
    /// Pieces of the shaft from z = 0 on; a straight one is first, last, and between throws.
    pub pieces: Vec<Piece>,
}

/// The frame of a shaft, and where things are on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Laid {
    /// The beams.
    pub frame: BeamFrame,
    /// Nodes of the places that were asked for.
    pub places: Vec<usize>,
    /// Nodes of the throws, in their order.
    pub throws: Vec<ThrowNodes>,
}

/// Nodes of a throw.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ThrowNodes {
    /// Middle of the pin.
    pub pin: usize,
    /// Middle of both webs, on the axis of the shaft.
    pub webs: [usize; 2],
}

impl Piece {
    /// Length along the axis [m].
    pub fn length(&self) -> f64 {
        match self {
            Self::Straight(round) => round.length,
            Self::Throw(throw) => throw.pin.length + 2.0 * throw.web_thickness,
        }
    }
}

impl Crankshaft {
    /// Axial positions of the middle of the webs and of the pin of each throw [m].
    pub fn throws(&self) -> Vec<[f64; 3]> {
        let mut z = 0.0;
        let mut throws = Vec::new();
        for piece in &self.pieces {
            let (from, to) = (z, z + piece.length());
            if let Piece::Throw(throw) = piece {
                let inset = 0.5 * throw.web_thickness;
                throws.push([from + inset, 0.5 * (from + to), to - inset]);
            }
            z = to;
        }
        throws
    }

    /// The frame, with nodes on the axis at these places [m] of straight pieces.
    pub fn laid(&self, places: &[f64]) -> Laid {
        let mut laying = Laying {
            laid: Laid { frame: BeamFrame::default(), places: vec![0; places.len()], throws: Vec::new() },
            material: self.material,
            z: 0.0,
        };
        laying.node([0.0; 3]);
        for (k, piece) in self.pieces.iter().enumerate() {
            match piece {
                Piece::Straight(round) => {
                    let into = |other: Option<&Piece>| match other {
                        Some(Piece::Throw(throw)) => 0.5 * throw.web_thickness,
                        _ => 0.0,
                    };
                    laying.straight(round, into(self.pieces.get(k + 1)), places);
                }
                Piece::Throw(throw) => laying.throw(throw),
            }
        }
        laying.laid
    }
}

/// A frame in the making; its last node is where the next piece begins.
struct Laying {
    laid: Laid,
    material: Material,
    z: f64,
}

impl Laying {
    fn node(&mut self, at: Point) -> usize {
        self.laid.frame.nodes.push(at);
        self.laid.frame.nodes.len() - 1
    }

    fn beam(&mut self, nodes: [usize; 2], ends: [Point; 2], first_axis: Point, section: Section) {
        self.laid.frame.beams.push(Beam { nodes, ends, first_axis, section, material: self.material });
    }

    /// A straight piece from the last node to its end, and on `into` the web behind it.
    fn straight(&mut self, round: &Round, into: f64, places: &[f64]) {
        let (from, to) = (self.z, self.z + round.length);
        let section = self.material.round(round.diameter, round.bore);
        let mut stops: Vec<(f64, Option<usize>)> = (0..)
            .zip(places)
            .filter(|(_, place)| **place >= from && **place <= to)
            .map(|(number, place)| (*place, Some(number)))
            .chain([(to + into, None)])
            .collect();
        stops.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (z, place) in stops {
            let last = self.laid.frame.nodes.len() - 1;
            let before = self.laid.frame.nodes[last];
            let node = match z > before[2] {
                true => {
                    let node = self.node([0.0, 0.0, z]);
                    self.beam([last, node], [before, [0.0, 0.0, z]], [1.0, 0.0, 0.0], section);
                    node
                }
                false => last,
            };
            if let Some(place) = place {
                self.laid.places[place] = node;
            }
        }
        self.z = to;
    }

    /// A throw from the last node, in the middle of its first web; the node behind it is in the middle of the second
    /// one.
    fn throw(&mut self, throw: &CrankThrow) {
        let first = self.laid.frame.nodes.len() - 1;
        let (sin, cos) = throw.angle.sin_cos();
        let at = |z: f64| [throw.radius * cos, throw.radius * sin, z];
        let on_axis = |z: f64| [0.0, 0.0, z];
        let length = throw.pin.length + 2.0 * throw.web_thickness;
        let [z_1, z_2] = [self.z + 0.5 * throw.web_thickness, self.z + length - 0.5 * throw.web_thickness];
        let middle = at(0.5 * (z_1 + z_2));
        let pin_section = self.material.round(throw.pin.diameter, throw.pin.bore);
        let along_pin = [1.0, 0.0, 0.0];
        let web = throw.web_width.map(|width| self.material.rectangle(throw.web_thickness, width));
        let corner = |laying: &mut Self, z: f64| laying.node(at(z));
        let before = match web {
            Some(section) => {
                let corner = corner(self, z_1);
                self.beam([first, corner], [on_axis(z_1), at(z_1)], [0.0, 0.0, 1.0], section);
                corner
            }
            None => first,
        };
        let pin = self.node(middle);
        self.beam([before, pin], [at(z_1), middle], along_pin, pin_section);
        let behind = web.map(|section| (corner(self, z_2), section));
        let second = self.node(on_axis(z_2));
        let end = behind.map_or(second, |(corner, _)| corner);
        self.beam([pin, end], [middle, at(z_2)], along_pin, pin_section);
        if let Some((corner, section)) = behind {
            self.beam([corner, second], [at(z_2), on_axis(z_2)], [0.0, 0.0, 1.0], section);
        }
        self.laid.throws.push(ThrowNodes { pin, webs: [first, second] });
        self.z += length;
    }
}
