//! The page `docs/validation/engine_bearings.md`: a car's crankshaft bearing in balance of heat, and the bearing and
//! bolts of a tractor's connecting rod.

use oilwedge_tests::engine_bearings::{CAR, by_film, by_standard, car, tractor};

use crate::tables::{replace, row};

const DIGITS: [usize; 7] = [2, 2, 3, 4, 2, 2, 3];

/// The page with its tables computed anew.
pub fn page(page: &str) -> String {
    let mut rows = vec![row([
        "n [rpm]",
        "F [N]",
        "by",
        "t [C]",
        "t_out [C]",
        "eta [mPa.s]",
        "eps",
        "h_min [um]",
        "friction [W]",
        "flow [l/min]",
    ])];
    for (turns, force, printed) in CAR {
        let (result, heat) = car(turns, force);
        let lines =
            [("printed", printed), ("ISO 7902, recomputed", by_standard(&heat)), ("film (`jfo`)", by_film(&result))];
        for (by, numbers) in lines {
            let mut line = vec![format!("{turns}"), format!("{force}"), by.to_owned()];
            line.extend(numbers.iter().zip(DIGITS).map(|(number, digits)| format!("{number:.digits$}")));
            rows.push(line);
        }
    }
    let page = replace(page, "car", &rows);
    let mut rows = vec![row(["number", "follows by", "printed", "recomputed", "off, in its last digit"])];
    for link in tractor() {
        let off = (link.value - link.printed) / link.digit;
        rows.push(vec![
            link.what.to_owned(),
            format!("`{}`", link.formula),
            format!("{}", link.printed),
            format!("{:.6}", link.value),
            format!("{off:+.2}"),
        ]);
    }
    replace(&page, "tractor", &rows)
}
