//! The frame round every guide: policy, style, navigation.

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::guide::{GROUPS, Guide};
use super::links::relative;

/// Guides need no script and nothing from elsewhere.
const POLICY: &str = "default-src 'none'; style-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'";
/// The address of the pages' list within each page.
const PAGES: &str = "pages";

/// A whole page; `at` is its path in the site, `body` its HTML.
pub fn page(guides: &[Guide], at: &Path, title: &str, body: &str) -> String {
    let to = |path: &str| relative(at, Path::new(path));
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) @if !title.contains("saute") { " · saute" } }
                link rel="icon" type="image/svg+xml" href=(to("icon.svg"));
                link rel="stylesheet" href=(to("style.css"));
                link rel="stylesheet" href=(to("docs/docs.css"));
            }
            body class="docs" {
                header {
                    a class="home" href=(to("index.html")) { img src=(to("icon.svg")) alt="" width="28" height="28"; "saute" }
                    a class="to-pages" href={ "#" (PAGES) } { "All pages" }
                }
                div class="columns" {
                    main { (PreEscaped(body)) }
                    (navigation(guides, at))
                }
            }
        }
    };
    markup.into_string()
}

fn navigation(guides: &[Guide], at: &Path) -> Markup {
    html! {
        nav id=(PAGES) aria-label="Pages" {
            a class="open" href=(relative(at, Path::new("index.html"))) { "Cook a steak" }
            @for (title, folder) in GROUPS {
                h2 { (title) }
                (items(guides, at, Path::new(folder)))
            }
        }
    }
}

/// The guides of a folder as a list of links.
fn items(guides: &[Guide], at: &Path, folder: &Path) -> Markup {
    html! {
        ul {
            @for guide in guides.iter().filter(|guide| guide.is_in(folder)) {
                @let here = guide.site_path() == at;
                li { a href=(relative(at, &guide.site_path())) aria-current=[here.then_some("page")] { (guide.title) } }
            }
        }
    }
}

/// The page of a folder: its guides, and those of folders in it.
pub fn list(guides: &[Guide], folder: &Path) -> String {
    let at = folder.join("index.html");
    let groups = GROUPS.iter().filter(|(_, inner)| Path::new(inner).starts_with(folder));
    let markup = html! {
        @for (i, (title, inner)) in groups.enumerate() {
            @if i == 0 { h1 { (title) } } @else { h2 { (title) } }
            (items(guides, &at, Path::new(inner)))
        }
    };
    markup.into_string()
}

/// A text file as it is.
pub fn source(text: &str) -> String {
    html! { pre class="source" { code { (text) } } }.into_string()
}
