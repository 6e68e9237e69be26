//! The numbers of a run, as JSON and as tables.

use oilwedge_campaign::Records;
use oilwedge_report::tables::{ShownQuantities, run_report};
use oilwedge_study::result::RunResult;
use pyo3::prelude::*;
use pyo3::types::PyType;

/// The numbers of a run.
#[pyclass(frozen, module = "oilwedge._native")]
pub(crate) struct Numbers {
    /// The text of `result.json`.
    #[pyo3(get)]
    json: String,
    tables: Tables,
}

/// What tables are made of.
enum Tables {
    /// The result itself.
    Run(Box<RunResult>, Box<Records>),
    /// The short and the whole table, of a result that came from another process.
    Texts([String; 2]),
}

impl Numbers {
    pub(crate) fn of_run(json: String, result: RunResult, records: Records) -> Self {
        Self { json, tables: Tables::Run(Box::new(result), Box::new(records)) }
    }

    fn shown(&self, shown: ShownQuantities) -> String {
        match (&self.tables, shown) {
            (Tables::Run(result, records), shown) => run_report(result, shown, records, None),
            (Tables::Texts([short, _]), ShownQuantities::Headlines) => short.clone(),
            (Tables::Texts([_, whole]), ShownQuantities::All) => whole.clone(),
        }
    }
}

#[pymethods]
impl Numbers {
    /// The numbers from the texts that another process made.
    #[new]
    fn of_texts(json: String, headlines: String, whole: String) -> Self {
        Self { json, tables: Tables::Texts([headlines, whole]) }
    }

    /// The main quantities, what was simulated, balances, times and the verdict.
    fn headlines(&self) -> String {
        self.shown(ShownQuantities::Headlines)
    }

    /// All quantities, what was simulated, balances, times and the verdict.
    fn whole(&self) -> String {
        self.shown(ShownQuantities::All)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyType>, (String, String, String)) {
        (py.get_type::<Self>(), (self.json.clone(), self.headlines(), self.whole()))
    }
}
