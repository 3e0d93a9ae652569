//! A page that needs no other file: its frame and the style that all pages share.

use maud::{DOCTYPE, Markup, PreEscaped, Render, html};

/// Style of the pages.
const STYLE: &str = include_str!("page.css");

/// Returns a whole page with what is in its `main`; `own_style` follows the style that all pages share.
pub fn whole(title: &str, own_style: &str, content: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                style { (PreEscaped(STYLE)) (PreEscaped(own_style)) }
            }
            body { main { (content) } }
        }
    };
    page.into_string()
}

/// Returns the first row of a table: what its columns are.
pub fn heads(heads: impl IntoIterator<Item = impl Render>) -> Markup {
    html! { tr { @for head in heads { th scope="col" { (head) } } } }
}
