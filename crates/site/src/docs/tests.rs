//! Promise: the guides of this repository become pages whose links lead somewhere.

use std::path::Path;

use super::links::{Links, Needed};
use super::{guide, markdown, needed};
use crate::error::SiteError;

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn resolved(page: &str, target: &str) -> Result<(String, Option<Needed>), SiteError> {
    let guides = guide::all(root()).unwrap();
    Links { root: root(), guides: &guides }.resolve(Path::new(page), target)
}

fn address(page: &str, target: &str) -> String {
    resolved(page, target).unwrap().0
}

#[test]
fn every_link_of_every_guide_leads_somewhere() {
    let needed = needed(root()).unwrap();
    assert!(needed.contains(&Needed::Picture("docs/steak.png".into())), "{needed:?}");
    assert!(needed.contains(&Needed::Text("docs/refs.toml".into())), "{needed:?}");
    assert!(needed.contains(&Needed::Folder("docs/formats".into())), "{needed:?}");
}

#[test]
fn links_are_relative_so_that_any_base_path_serves() {
    assert_eq!(address("README.md", "docs/your-own-food.md"), "docs/your-own-food.html");
    assert_eq!(address("docs/your-own-food.md", "formats/food.md#surface"), "../docs/formats/food.html#surface");
    assert_eq!(address("docs/your-own-food.md", "formats"), "../docs/formats/index.html");
    assert_eq!(address("ARCHITECTURE.md", "recipes/medium.toml"), "recipes/medium.toml.html");
    assert_eq!(address("README.md", "https://example.org"), "https://example.org");
    assert_eq!(address("README.md", "#keys"), "#keys");
}

#[test]
fn a_link_that_leads_nowhere_is_an_error_with_page_and_target() {
    let error = resolved("README.md", "docs/absent.md").unwrap_err().to_string();
    assert_eq!(error, "README.md: the link (docs/absent.md) leads nowhere");
}

#[test]
fn headings_are_named_as_github_names_them_and_no_style_is_left_in_attributes() {
    let text = "# `[step.oil_g]` and more\n# Keys\n# Keys\n|a|b|\n|--|-:|\n|1|2|\n";
    let (html, _) = markdown::html(text, |target| Ok((target.to_owned(), None))).unwrap();
    for id in ["stepoil_g-and-more", "keys", "keys-1"] {
        assert!(html.contains(&format!("id=\"{id}\"")), "{html}");
    }
    assert!(html.contains("<td class=\"right\">2</td>") && !html.contains("style="), "{html}");
}
