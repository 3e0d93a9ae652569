//! Markdown as HTML: tables, identifiers of headings as GitHub makes them, links into the site.

use std::collections::BTreeMap;

use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd};

use super::links::Needed;
use crate::error::SiteError;

/// What a resolver of links returns: the new address, and what the site needs for it.
type Resolved = Result<(String, Option<Needed>), SiteError>;

/// Converts a text; every link passes through `resolve`. Returns also what the site needs for the links.
pub fn html(text: &str, resolve: impl Fn(&str) -> Resolved) -> Result<(String, Vec<Needed>), SiteError> {
    let options = Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH;
    let mut events: Vec<Event> = Parser::new_ext(text, options).collect();
    name_headings(&mut events);
    let mut needed = Vec::new();
    for event in &mut events {
        let target = match event {
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => dest_url,
            _ => continue,
        };
        let (address, needs) = resolve(target)?;
        *target = CowStr::from(address);
        needed.extend(needs);
    }
    let mut html = String::new();
    pulldown_cmark::html::push_html(&mut html, events.into_iter());
    Ok((without_styles(&html), needed))
}

/// Columns are aligned by classes: the page's policy allows no style in an attribute. A wide table scrolls in itself.
fn without_styles(html: &str) -> String {
    let classes = ["left", "center", "right"].into_iter();
    let plain = classes.fold(html.to_owned(), |html, side| {
        html.replace(&format!(" style=\"text-align: {side}\""), &format!(" class=\"{side}\""))
    });
    plain.replace("<table>", "<div class=\"table\"><table>").replace("</table>", "</table></div>")
}

/// Gives each heading the identifier that GitHub gives it.
fn name_headings(events: &mut [Event]) {
    let mut used: BTreeMap<String, usize> = BTreeMap::new();
    for start in 0..events.len() {
        if !matches!(events[start], Event::Start(Tag::Heading { .. })) {
            continue;
        }
        let inside = events[start..].iter().take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_))));
        let words: String = inside.filter_map(words).collect();
        let slug = slug(&words);
        let count = used.entry(slug.clone()).or_default();
        let name = if *count == 0 { slug } else { format!("{slug}-{count}") };
        *count += 1;
        if let Event::Start(Tag::Heading { id, .. }) = &mut events[start] {
            *id = Some(CowStr::from(name));
        }
    }
}

fn words<'a>(event: &'a Event) -> Option<&'a str> {
    match event {
        Event::Text(text) | Event::Code(text) => Some(text),
        _ => None,
    }
}

/// Lower case, spaces as hyphens, no punctuation.
fn slug(words: &str) -> String {
    let kept = words.trim().to_lowercase();
    let kept = kept.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}
