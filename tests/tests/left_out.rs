//! Names what the tests left out because this machine lacks something. Its name puts it behind all other tests; it has
//! no harness, so that what it prints is seen.

fn main() {
    let notes = oilwedge_tests::left_out::notes();
    println!();
    match notes.is_empty() {
        true => println!("No test was left out."),
        false => println!("LEFT OUT:\n{}", notes.concat()),
    }
}
