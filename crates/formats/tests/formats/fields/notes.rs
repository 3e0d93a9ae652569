//! Promise: what food it is is in a comment at the top of a file, whatever a person called it.

use saute_formats::vtk::Grid;

/// The comment of a grid whose food has this name.
fn comment(name: &str) -> String {
    let grid = Grid { notes: vec![("food", name.to_owned()), ("kind", "beef-lean".to_owned())], ..Grid::default() };
    let file = grid.vtu();
    let text = String::from_utf8_lossy(&file);
    text.lines().find(|line| line.starts_with("<!--")).expect("a comment").to_owned()
}

/// XML allows neither two hyphens in a row nor control characters in a comment.
#[test]
fn no_name_ends_the_comment_or_makes_the_file_invalid() {
    for (name, written) in [
        ("steak", "steak"),
        ("a --> b ---> c-----d", "a - -> b - - -> c- - - - -d"),
        ("a\u{1}b\nc", "a b c"),
        ("<&\">", "<&\">"),
    ] {
        assert_eq!(comment(name), format!("<!-- food: {written}; kind: beef-lean -->"));
    }
}
