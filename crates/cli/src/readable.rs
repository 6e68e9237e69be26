//! Numbers for people, as all reports write them.

pub(crate) use oilwedge_report::digits::{bar, quantity_value, significant};
pub(crate) use oilwedge_report::readable::readable_unit;
