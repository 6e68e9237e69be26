//! The solved film as a picture: nodes of the quadratic triangles and the fields there.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::film_heat::FilmHeat;
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::quantities::stream::streams;
use oilwedge_reynolds::quantities::turbulence::reynolds_numbers;

use crate::fields::{
    ANGLE, AXIAL_PLACE, BEARING_STRESS, BUSH_TEMPERATURE, CONTACT_PRESSURE, DEFLECTION, ERROR_INDICATOR, FILM_FRACTION,
    FILM_THICKNESS, FieldRow, GREATEST_TEMPERATURE, JOURNAL_STRESS, JOURNAL_TEMPERATURE, LAYER_TEMPERATURES, PRESSURE,
    REYNOLDS_NUMBER, TEMPERATURE, VISCOSITY, VOLUME_FLOW,
};
use crate::film::Film;
use crate::film_lines::film_lines;

/// A film on its triangles: where they are, and the fields on them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FilmPicture {
    /// Nodes [m].
    pub points: Vec<[f64; 3]>,
    /// Triangles by their nodes: three vertices, then the middles of edges 01, 12, 20 (as VTK and gmsh have it).
    pub cells: Vec<[u32; 6]>,
    /// Fields on the nodes.
    pub point_data: Vec<PictureField>,
    /// Fields on the triangles.
    pub cell_data: Vec<PictureField>,
    /// Lines by name ([`crate::film_lines`]), each of pieces between two points [m].
    pub lines: Vec<(String, Vec<[[f64; 3]; 2]>)>,
}

/// A field of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct PictureField {
    /// Name of the field. The unit in brackets belongs to the name, but for the fields that scripts know without one.
    pub name: Cow<'static, str>,
    /// Unit of the values, as `Pa`.
    pub unit: Cow<'static, str>,
    /// A value for each node or triangle.
    pub values: FieldValues,
}

/// Values of a field.
#[derive(Debug, Clone, PartialEq)]
pub enum FieldValues {
    /// One number each.
    Scalars(Vec<f64>),
    /// One vector each, in the directions of the points.
    Vectors(Vec<[f64; 3]>),
    /// A row of so many numbers each, one row after the other.
    Rows(usize, Vec<f64>),
}

impl FieldValues {
    /// All numbers, those of a vector one after the other.
    pub fn numbers(&self) -> &[f64] {
        match self {
            Self::Scalars(values) | Self::Rows(_, values) => values,
            Self::Vectors(values) => values.as_flattened(),
        }
    }

    /// Nodes or triangles that have a value.
    pub fn len(&self) -> usize {
        match self {
            Self::Scalars(values) => values.len(),
            Self::Vectors(values) => values.len(),
            Self::Rows(width, values) => values.len() / width,
        }
    }

    /// True if there are no values.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl PictureField {
    /// The field of this row.
    fn of(row: &FieldRow, values: FieldValues) -> Self {
        Self { name: row.name.into(), unit: row.unit.into(), values }
    }
}

impl FilmPicture {
    /// The field on the nodes of this name.
    pub fn at_points(&self, name: &str) -> Option<&FieldValues> {
        let field = self.point_data.iter().find(|field| field.name == name);
        field.map(|field| &field.values)
    }
}

/// Surface on which a film is drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Surface {
    /// The cylinder `(R cos phi, R sin phi, z)`.
    #[default]
    Cylinder,
    /// Unrolled, `(R phi, z, 0)`.
    Developed,
}

/// Which fields a picture has.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum FieldChoice {
    /// All but flow, shear stresses and temperatures of layers.
    #[default]
    Usual,
    /// All.
    All,
}

/// How a film is drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct PictureOptions {
    /// Where.
    pub surface: Surface,
    /// By which fields.
    pub fields: FieldChoice,
}

/// The fields of a solved film at its nodes, on the cylinder `(R cos phi, R sin phi, z)` or unrolled `(R phi, z, 0)`,
/// where nodes on the cut of a ring are on both sides of it: pressure (nowhere below that of a cavity), film thickness,
/// viscosity, where surfaces touch the pressure of contact, of a mass-conserving film the film fraction, place and,
/// where all are chosen, flow per width and shear stress on the walls. Nodes on the edge of a pocket are on both sides
/// of it too, for the film is thicker on one. The indicator [N], a value for each triangle, is what each adds to the
/// error of the load.
pub fn picture(
    film: &Film,
    solved: &SolvedFilm,
    indicator: Option<&[f64]>,
    PictureOptions { surface, fields }: PictureOptions,
) -> FilmPicture {
    let (nodes, cells) = numbered(film, surface);
    let radius = film.problem.bearing.radius;
    let place = |&[x, z]: &[f64; 2]| {
        if surface == Surface::Developed {
            return [x, z, 0.0];
        }
        let (sin, cos) = (x / radius).sin_cos();
        [radius * cos, radius * sin, z]
    };
    let mut point_data = pointwise(solved, &nodes);
    if let Some(heat) = &film.heat {
        point_data.extend(temperatures(film, heat, &nodes));
        point_data.extend((fields == FieldChoice::All).then(|| layers(heat, &nodes)));
    }
    point_data.extend(places(film, &nodes, surface));
    if fields == FieldChoice::All {
        point_data.extend(streaming(solved, (&nodes, &cells), surface));
    }
    let indicator = indicator.map(|values| scalars(&ERROR_INDICATOR, values.to_vec()));
    FilmPicture {
        points: nodes.positions.iter().map(place).collect(),
        cells,
        lines: (film_lines(film, solved).into_iter())
            .map(|(name, pieces)| (name, pieces.iter().map(|piece| [place(&piece[0]), place(&piece[1])]).collect()))
            .collect(),
        point_data,
        cell_data: indicator.into_iter().collect(),
    }
}

fn scalars(row: &FieldRow, values: Vec<f64>) -> PictureField {
    PictureField::of(row, FieldValues::Scalars(values))
}

/// What the film is at each node.
fn pointwise(film: &SolvedFilm, nodes: &Nodes) -> Vec<PictureField> {
    let SolvedFilm { problem, solution, .. } = film;
    let floor = problem.cavitation.pressure().unwrap_or(f64::NEG_INFINITY);
    let pressure = |&dof: &usize| problem.pressure_at(solution.unknown[dof]).max(floor);
    let pressure: Vec<f64> = nodes.dofs.iter().map(pressure).collect();
    let mut thickness = Vec::with_capacity(nodes.cells.len());
    // Nodes that were met in one triangle follow each other.
    for cells in nodes.cells.chunk_by(|a, b| a == b) {
        let positions = &nodes.positions[thickness.len()..][..cells.len()];
        thickness.extend_from_slice(&problem.thickness_at(cells[0], positions)[..cells.len()]);
    }
    let contact =
        (problem.contact.as_ref()).map(|contact| thickness.iter().map(|&gap| contact.law.at(gap).pressure).collect());
    let viscosity = (pressure.iter().zip(&nodes.dofs)).map(|(&p, &dof)| problem.viscosity_at_dof(p, dof)).collect();
    let mut fields =
        vec![scalars(&PRESSURE, pressure), scalars(&FILM_THICKNESS, thickness), scalars(&VISCOSITY, viscosity)];
    if !problem.is_laminar() {
        let at = |(&cell, position): (&usize, &[f64; 2])| reynolds_numbers(problem, cell, &[*position])[0];
        let values = nodes.cells.iter().zip(&nodes.positions).map(at).collect();
        fields.push(scalars(&REYNOLDS_NUMBER, values));
    }
    fields.extend(contact.map(|pressure| scalars(&CONTACT_PRESSURE, pressure)));
    if let Some(deflection) = problem.deflection() {
        let values = nodes.positions.iter().map(|&position| deflection.at(position)).collect();
        fields.push(scalars(&DEFLECTION, values));
    }
    if let Some(fraction) = &solution.film_fraction {
        let values = nodes.dofs.iter().map(|&dof| fraction.values[dof]).collect();
        fields.push(scalars(&FILM_FRACTION, values));
    }
    fields
}

/// Temperatures [degrees C] at each node, those of the oil fed where a feed covers the film.
fn temperatures(film: &Film, heat: &FilmHeat, nodes: &Nodes) -> [PictureField; 4] {
    let (points, fed) = (heat.layers.points.len(), film.model.sockets.heat_field.as_ref());
    let fed = fed.map_or(0.0, |model| model.surroundings.inlet);
    let mut at_dofs = vec![[fed - ZERO_CELSIUS; 4]; film.system.space().dofs()];
    for ((at, &dof), profile) in heat.temperatures.layers.chunks_exact(points).zip(&heat.dofs).zip(&heat.profiles) {
        let greatest = at.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        at_dofs[dof] = [profile.mean(at), greatest, at[0], at[points - 1]].map(|t| t - ZERO_CELSIUS);
    }
    let rows = [&TEMPERATURE, &GREATEST_TEMPERATURE, &BUSH_TEMPERATURE, &JOURNAL_TEMPERATURE];
    [0, 1, 2, 3].map(|k| scalars(rows[k], nodes.dofs.iter().map(|&dof| at_dofs[dof][k]).collect()))
}

/// Temperatures [degrees C] at the points across the film of each node.
fn layers(heat: &FilmHeat, nodes: &Nodes) -> PictureField {
    let points = heat.layers.points.len();
    let at = |&dof: &usize| heat.at_dofs[dof * points..][..points].iter().map(|t| t - ZERO_CELSIUS);
    let values = nodes.dofs.iter().flat_map(at).collect();
    PictureField::of(&LAYER_TEMPERATURES, FieldValues::Rows(points, values))
}

/// Where each node is on the liner. On a closed ring the angle jumps at one line, in the plane nowhere.
fn places(film: &Film, nodes: &Nodes, surface: Surface) -> [PictureField; 2] {
    let radius = film.problem.bearing.radius;
    let turn = match (surface, film.system.space().mesh().period()) {
        (Surface::Cylinder, Some(_)) => 360.0,
        _ => f64::INFINITY,
    };
    let angle = |&[x, _]: &[f64; 2]| {
        let angle = (x / radius).to_degrees();
        // Most angles are within the turn, and a division takes long.
        if (0.0..turn).contains(&angle) || turn.is_infinite() { angle } else { angle.rem_euclid(turn) % turn }
    };
    [
        scalars(&ANGLE, nodes.positions.iter().map(angle).collect()),
        scalars(&AXIAL_PLACE, nodes.positions.iter().map(|&[_, z]| z).collect()),
    ]
}

/// Flow and stresses: at each node the mean of its triangles, weighted with their areas; zero where a feed covers them
/// all.
fn streaming(film: &SolvedFilm, (nodes, cells): (&Nodes, &[[u32; 6]]), surface: Surface) -> [PictureField; 3] {
    let mut sums = vec![(0.0, [[0.0; 2]; 3]); nodes.dofs.len()];
    for (cell, found) in cells.iter().zip(streams(film)) {
        let Some((area, streams)) = found else { continue };
        for (&node, at) in cell.iter().zip(streams) {
            let (whole, vectors) = &mut sums[node as usize];
            *whole += area;
            for (sum, vector) in vectors.iter_mut().zip([at.flow, at.on_journal, at.on_bearing]) {
                (0..2).for_each(|d| sum[d] += area * vector[d]);
            }
        }
    }
    for [here, there] in nodes.twins() {
        let (a, b) = (sums[here], sums[there]);
        let both = [0, 1, 2].map(|k| [0, 1].map(|d| a.1[k][d] + b.1[k][d]));
        (sums[here], sums[there]) = ((a.0 + b.0, both), (a.0 + b.0, both));
    }
    let radius = film.problem.bearing.radius;
    let directed = |k: usize| {
        let vector = |(&(area, vectors), &[x, _]): (&(f64, [[f64; 2]; 3]), &[f64; 2])| {
            let [around, axial] = vectors[k].map(|sum| if area > 0.0 { sum / area } else { 0.0 });
            let (sin, cos) = (x / radius).sin_cos();
            match surface {
                Surface::Developed => [around, axial, 0.0],
                Surface::Cylinder => [-around * sin, around * cos, axial],
            }
        };
        FieldValues::Vectors(sums.iter().zip(&nodes.positions).map(vector).collect())
    };
    let rows = [&VOLUME_FLOW, &JOURNAL_STRESS, &BEARING_STRESS];
    std::array::from_fn(|k| PictureField::of(rows[k], directed(k)))
}

/// The nodes of the picture, and those of each triangle.
fn numbered(film: &Film, surface: Surface) -> (Nodes, Vec<[u32; 6]>) {
    let mesh = film.system.space().mesh();
    let leftmost = mesh.points().iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
    // The far side of the cut of a ring; rounding of the last column does not count.
    let cut = match mesh.period() {
        Some(period) if surface == Surface::Developed => leftmost + period * (1.0 - 1e-9),
        _ => f64::INFINITY,
    };
    let mut pocket_of = vec![0u8; mesh.triangles().len()];
    for (number, name) in (1..).zip(film.pockets()) {
        for &cell in mesh.region(name).map_or(&[][..], |region| &region.cells) {
            pocket_of[cell as usize] = number;
        }
    }
    let mut nodes = Nodes::on(film.system.space().dofs());
    let mut cells = Vec::with_capacity(mesh.triangles().len());
    for t in 0..mesh.triangles().len() {
        let dofs = film.system.space().element_dofs(t);
        let positions = mesh.nodes(t);
        let pocket = pocket_of[t];
        cells.push(std::array::from_fn(|i| {
            let side = (positions[i][0] >= cut, pocket);
            nodes.number(dofs[i], side, positions[i], t)
        }));
    }
    (nodes, cells)
}

/// Side of the cut and pocket in which a node stands.
type Side = (bool, u8);

/// The side of most nodes.
const MAIN: Side = (false, 0);
/// Marks dofs not met yet.
const UNMET: u32 = u32::MAX;

/// Nodes numbered in the order in which they are met.
struct Nodes {
    /// Number of each dof on the main side.
    on_main: Vec<u32>,
    /// Number of each dof elsewhere.
    beside: HashMap<(usize, Side), u32>,
    dofs: Vec<usize>,
    positions: Vec<[f64; 2]>,
    /// A cell at each node, on its side.
    cells: Vec<usize>,
}

impl Nodes {
    fn on(dofs: usize) -> Self {
        Self {
            on_main: vec![UNMET; dofs],
            beside: HashMap::new(),
            dofs: Vec::with_capacity(dofs),
            positions: Vec::with_capacity(dofs),
            cells: Vec::with_capacity(dofs),
        }
    }

    /// Nodes at one place on the two sides of the cut.
    fn twins(&self) -> Vec<[usize; 2]> {
        let beyond = self.beside.iter().filter(|((_, (is_beyond, _)), _)| *is_beyond);
        let twin = |(&(dof, (_, pocket)), &far): (&(usize, Side), &u32)| {
            let near = match pocket {
                0 => self.on_main[dof],
                _ => *self.beside.get(&(dof, (false, pocket)))?,
            };
            (near != UNMET).then_some([near as usize, far as usize])
        };
        beyond.filter_map(twin).collect()
    }

    fn number(&mut self, dof: usize, side: Side, position: [f64; 2], cell: usize) -> u32 {
        let number = match side {
            MAIN => &mut self.on_main[dof],
            _ => self.beside.entry((dof, side)).or_insert(UNMET),
        };
        if *number == UNMET {
            *number = self.dofs.len() as u32;
            self.dofs.push(dof);
            self.positions.push(position);
            self.cells.push(cell);
        }
        *number
    }
}
