//! Flow driven by the pressure gradient: in every film.

use std::sync::Arc;

use oilwedge_reynolds::terms::Poiseuille;

use super::{BLANK, Effect};

pub(super) const ROW: Effect = Effect {
    name: "poiseuille",
    sentence: "oil driven by the pressure gradient",
    install: |_, sockets| sockets.terms.push(Arc::new(Poiseuille)),
    ..BLANK
};
