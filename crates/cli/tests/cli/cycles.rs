//! Promise: cycles of imports between the modules of a crate do not grow. `scripts/cycles.toml` has the most modules that one cycle of
//! each crate may have; a larger one fails with its members, and so does a ceiling above what is there.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Modules of a crate by their paths (`a::b`, the root empty), each with those whose names it uses.
type Imports = BTreeMap<String, BTreeSet<String>>;

/// Source files of a folder and the folders in it.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let sources = files.into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "rs"));
    sources.chain(folders.iter().flat_map(|folder| self::files(folder))).collect()
}

/// Path of the module in a file.
fn module(src: &Path, file: &Path) -> String {
    let inside = file.strip_prefix(src).expect("in the crate").with_extension("");
    let parts: Vec<&str> = inside.iter().filter_map(|part| part.to_str()).collect();
    match parts.as_slice() {
        ["lib" | "main"] => String::new(),
        [before @ .., "mod"] => before.join("::"),
        all => all.join("::"),
    }
}

/// Text without comments and without tests at its end.
fn code(text: &str) -> String {
    let ends = text.find("#[cfg(test)]\nmod tests {").unwrap_or(text.len());
    let lines = text[..ends].lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// Paths that a text names, each from the root of its crate: `a::{b, c::D}` are two.
fn named(code: &str, own: &str) -> Vec<String> {
    let parent = own.rsplit_once("::").map_or("", |(parent, _)| parent);
    let mut found = Vec::new();
    for (start, base) in [("crate::", ""), ("super::", parent), ("self::", own)] {
        for (at, _) in code.match_indices(start) {
            let is_whole = !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':');
            if is_whole {
                unfold(&code[at + start.len()..], base, &mut found);
            }
        }
    }
    found
}

/// Adds the paths that begin a text, below a base; returns how much of the text they take.
fn unfold(text: &str, base: &str, found: &mut Vec<String>) -> usize {
    let name = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
    if let Some(inner) = text.strip_prefix('{') {
        let mut at = 1;
        loop {
            at += text[at..].find(|c: char| !c.is_whitespace() && c != ',').unwrap_or(text.len() - at);
            if text[at..].starts_with('}') || at >= inner.len() {
                return at + 1;
            }
            at += unfold(&text[at..], base, found).max(1);
        }
    }
    let below = if base.is_empty() { text[..name].to_owned() } else { format!("{base}::{}", &text[..name]) };
    match text[name..].strip_prefix("::") {
        Some(rest) if !rest.starts_with('<') => {
            if &text[..name] == "super" {
                let parent = base.rsplit_once("::").map_or("", |(parent, _)| parent);
                return name + 2 + unfold(rest, parent, found);
            }
            name + 2 + unfold(rest, &below, found)
        }
        _ => {
            found.push(below);
            name
        }
    }
}

/// The module that a path is in, or names.
fn resolved<'a>(path: &str, modules: &'a BTreeSet<String>) -> &'a str {
    let mut path = path;
    loop {
        if let Some(found) = modules.get(path) {
            return found;
        }
        path = path.rsplit_once("::").map_or("", |(before, _)| before);
    }
}

fn imports(src: &Path) -> Imports {
    let files = files(src);
    let modules: BTreeSet<String> = files.iter().map(|file| module(src, file)).chain([String::new()]).collect();
    let of = |file: &PathBuf| {
        let own = module(src, file);
        let code = code(&std::fs::read_to_string(file).expect("reads"));
        let used = named(&code, &own).iter().map(|path| resolved(path, &modules).to_owned()).collect::<BTreeSet<_>>();
        // What is inside of a module is no arrow of it.
        (own.clone(), used.into_iter().filter(|used| *used != own).collect())
    };
    files.iter().map(of).collect()
}

/// Modules that each one reaches.
fn reached(imports: &Imports) -> Imports {
    let of = |from: &String| {
        let (mut found, mut open) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(next) = open.pop() {
            let all = imports.get(&next).into_iter().flatten();
            open.extend(all.filter(|used| found.insert((*used).clone())).cloned().collect::<Vec<_>>());
        }
        (from.clone(), found)
    };
    imports.keys().map(of).collect()
}

/// The cycle with the most modules.
fn largest_cycle(imports: &Imports) -> BTreeSet<String> {
    let reached = reached(imports);
    let reaches = |from: &String, to: &String| reached.get(from).is_some_and(|found| found.contains(to));
    let cycle = |of: &String| imports.keys().filter(|to| reaches(of, to) && reaches(to, of)).cloned().collect();
    imports.keys().map(cycle).max_by_key(BTreeSet::len).unwrap_or_default()
}

#[test]
fn no_cycle_of_imports_grows() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = std::fs::read_to_string(root.join("scripts/cycles.toml")).expect("scripts/cycles.toml");
    let most: BTreeMap<String, usize> = toml::from_str(&text).expect("a number for each crate");
    let mut wrong = Vec::new();
    let mut seen = BTreeSet::new();
    for folder in std::fs::read_dir(root.join("crates")).expect("crates") {
        let folder = folder.expect("a crate").path();
        let name = folder.file_name().and_then(|name| name.to_str()).expect("a name").to_owned();
        let cycle = largest_cycle(&imports(&folder.join("src")));
        let allowed = most.get(&name).copied().unwrap_or(0);
        seen.insert(name.clone());
        if cycle.len() > allowed {
            wrong.push(format!("{name}: {} modules in one cycle, and {allowed} are allowed: {cycle:?}", cycle.len()));
        } else if cycle.len() < allowed {
            wrong
                .push(format!("{name}: {} modules in the largest cycle; write so in scripts/cycles.toml", cycle.len()));
        }
    }
    wrong
        .extend(most.keys().filter(|name| !seen.contains(*name)).map(|name| format!("{name}: there is no such crate")));
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn paths_are_found_in_braces_beside_and_above_and_not_in_comments_and_tests() {
    let text = "use crate::a::{b::C, d, self};\nfn f() { super::e::g(); crate::h::<u8>() } // crate::no\n#[cfg(test)]\nmod tests { use crate::no; }";
    let found: BTreeSet<String> = named(&code(text), "m::n").into_iter().collect();
    let wanted = ["a::b::C", "a::d", "a::self", "m::e::g", "h"].map(str::to_owned).into();
    assert_eq!(found, wanted);
    let modules = ["", "a", "a::b", "m", "m::n"].map(str::to_owned).into();
    assert_eq!(["a::b::C", "a::d", "h"].map(|path| resolved(path, &modules)), ["a::b", "a", ""]);
    let arrows = [("x", vec!["y"]), ("y", vec!["z"]), ("z", vec!["x"]), ("w", vec!["x"])];
    let arrows = arrows.map(|(from, to)| (from.to_owned(), to.into_iter().map(str::to_owned).collect()));
    assert_eq!(largest_cycle(&arrows.into()), ["x", "y", "z"].map(str::to_owned).into());
}
