//! The order of cells in which oil passes through them.
//!
//! Flow around a ring has no first cell: it is cut at the angle that the least flow passes, which is a feed where there
//! is one. Where flow goes round in an eddy, the cell with the least share of its inflow to come is next.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};
use std::f64::consts::TAU;

use crate::FilmNetwork;

/// Angles at which a ring may be cut.
const CUTS: usize = 72;

/// Flow from one cell to another.
struct OilStream {
    from: usize,
    to: usize,
    flow: f64,
}

/// All cells, sources of oil before those to which it flows.
pub(crate) fn in_flow_order(network: &FilmNetwork) -> Vec<usize> {
    let cells = network.cells.len();
    let streams = uncut(network);
    let mut starts = vec![0; cells + 1];
    let (mut waiting, mut remaining, mut inflow) = (vec![0_usize; cells], vec![0.0; cells], vec![0.0; cells]);
    for stream in &streams {
        starts[stream.from + 1] += 1;
        waiting[stream.to] += 1;
        remaining[stream.to] += stream.flow;
        inflow[stream.to] += stream.flow;
    }
    for c in 0..cells {
        starts[c + 1] += starts[c];
    }
    let mut next = starts.clone();
    let mut leaving = vec![0; streams.len()];
    for (index, stream) in streams.iter().enumerate() {
        leaving[next[stream.from]] = index;
        next[stream.from] += 1;
    }
    let mut ready: VecDeque<usize> = (0..cells).filter(|c| waiting[*c] == 0).collect();
    // Shares of the inflow to come, which are not negative: their bits have the order of the numbers.
    let share = |c: usize, remaining: &[f64], inflow: &[f64]| (remaining[c].max(0.0) / inflow[c]).to_bits();
    let stuck = (0..cells).filter(|c| waiting[*c] > 0);
    let mut later: BinaryHeap<_> = stuck.map(|c| Reverse((share(c, &remaining, &inflow), c))).collect();
    let mut is_done = vec![false; cells];
    let mut order = Vec::with_capacity(cells);
    while let Some(cell) = ready.pop_front().or_else(|| later.pop().map(|Reverse((_, cell))| cell)) {
        if std::mem::replace(&mut is_done[cell], true) {
            continue;
        }
        order.push(cell);
        for &index in &leaving[starts[cell]..starts[cell + 1]] {
            let OilStream { to, flow, .. } = streams[index];
            if is_done[to] {
                continue;
            }
            waiting[to] -= 1;
            remaining[to] -= flow;
            match waiting[to] {
                0 => ready.push_back(to),
                _ => later.push(Reverse((share(to, &remaining, &inflow), to))),
            }
        }
    }
    order
}

/// Streams between cells, without those that pass the angle of the cut.
fn uncut(network: &FilmNetwork) -> Vec<OilStream> {
    let mut through = vec![0.0; CUTS];
    let streams: Vec<OilStream> = (network.links.iter())
        .map(|link| (link, link.dragged + link.driven))
        .filter(|(_, flow)| *flow != 0.0)
        .map(|(link, flow)| match flow > 0.0 {
            true => OilStream { from: link.from, to: link.to, flow },
            false => OilStream { from: link.to, to: link.from, flow: -flow },
        })
        .collect();
    for stream in &streams {
        passed(network, stream).for_each(|cut| through[cut] += stream.flow);
    }
    let least = (0..CUTS).min_by(|&a, &b| through[a].total_cmp(&through[b]));
    streams.into_iter().filter(|stream| passed(network, stream).all(|cut| Some(cut) != least)).collect()
}

/// Angles of cuts between the two cells of a stream, by the shorter arc.
fn passed(network: &FilmNetwork, stream: &OilStream) -> impl Iterator<Item = usize> {
    let [from, to] = [stream.from, stream.to].map(|c| network.cells[c].angle / TAU);
    let turn = to - from - (to - from).round();
    let [low, high] = [from.min(from + turn), from.max(from + turn)].map(|turns| (turns * CUTS as f64).floor() as i64);
    (low..high).map(|cut| (cut + 1).rem_euclid(CUTS as i64) as usize)
}
