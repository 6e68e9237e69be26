//! Tables inside Markdown pages, between `<!-- table: NAME -->` and `<!-- end -->`.

/// Replaces the table `name` of `page` by `rows` (the first is the head); all other text stays.
///
/// # Panics
/// If the page has no such table.
pub fn replace(page: &str, name: &str, rows: &[Vec<String>]) -> String {
    let opening = format!("<!-- table: {name} -->\n");
    let start = page.find(&opening).unwrap_or_else(|| panic!("no table {name}")) + opening.len();
    let end = start + page[start..].find("<!-- end -->").unwrap_or_else(|| panic!("table {name} does not end"));
    format!("{}{}{}", &page[..start], written(rows), &page[end..])
}

/// The table of `rows` (the first is the head) in Markdown.
pub fn written(rows: &[Vec<String>]) -> String {
    let mut table = String::new();
    for (k, row) in rows.iter().enumerate() {
        table += &format!("| {} |\n", row.join(" | "));
        if k == 0 {
            table += &format!("|{}\n", "---|".repeat(row.len()));
        }
    }
    table
}

/// `[a, b, ...]` as strings.
pub fn row<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(str::to_owned).to_vec()
}

/// The first row of a table, its cells between `|`.
pub fn head(cells: &str) -> Vec<String> {
    cells.split(" | ").map(str::to_owned).collect()
}
