//! The report of a study: a page that needs no other file.

use maud::{Markup, html};
use saute_study::Analysis;
use saute_study::analysis::Quantity;

use super::{curves_plot, tables};
use crate::page;

/// Returns the whole page.
pub fn page(analysis: &Analysis) -> String {
    let title = format!("Study {}: {}", analysis.study, tables::who(analysis));
    let content = html! {
        (header(analysis, &title))
        @for quantity in Quantity::ALL {
            section { h2 { (tables::quantity(quantity)) } (curves_plot::figure(analysis, quantity)) }
        }
        (changes(analysis))
        (participants(analysis))
        (method(analysis))
        footer { "saute " (env!("CARGO_PKG_VERSION")) }
    };
    page::whole(&title, "", &content)
}

fn header(analysis: &Analysis, title: &str) -> Markup {
    html! {
        header {
            h1 { (title) }
            p { (tables::counts(analysis)) "." br; "Protocol " (analysis.protocol) "." }
            @if analysis.simulated {
                p.notice {
                    "The participants are simulated: programs that follow rules with errors that shrink by a stated formula. The \
                     curves show that formula and the simulator. They say nothing about people."
                }
            }
        }
    }
}

fn changes(analysis: &Analysis) -> Markup {
    html! {
        section {
            h2 { "Before and after the real cook" }
            @if analysis.changes.is_empty() {
                p { "There is nothing to compare: no cook at a real stove is in the logs, or no trial on one side of it." }
            } @else {
                table.steps {
                    (page::heads(["quantity", "compared", "condition", "n", "missing", "before", "after", "difference (90 %)"]))
                    @for change in &analysis.changes {
                        tr {
                            th scope="row" { (tables::quantity(change.quantity)) }
                            td style="white-space: normal" { (tables::span(change.span)) }
                            td { (tables::condition(change)) }
                            td { (change.n) }
                            td { (change.missing) }
                            td { (format!("{:.1}", change.before)) }
                            td { (format!("{:.1}", change.after)) }
                            td {
                                @let d = change.difference;
                                (format!("{:+.1} ({:+.1} to {:+.1})", d.median, d.low, d.high))
                            }
                        }
                    }
                }
            }
        }
    }
}

fn participants(analysis: &Analysis) -> Markup {
    html! {
        section {
            h2 { "Who took part" }
            table.steps {
                (page::heads(["participant", "condition", "trials", "missing", "answers"]))
                @for taker in &analysis.participants {
                    tr {
                        th scope="row" { (taker.participant) }
                        td { (taker.condition) }
                        td { (taker.trials) }
                        td { (taker.missing_trials) }
                        td { (taker.answers) }
                    }
                }
            }
        }
    }
}

fn method(analysis: &Analysis) -> Markup {
    html! {
        section {
            h2 { "Method" }
            p {
                "Medians over participants. Intervals: participants are drawn 2000 times with replacement; an interval holds the middle 90 % \
                 of the medians of the draws (percentile method, seed " (analysis.seed) "). A comparison takes each participant's own \
                 difference; who lacks one side is left out and counted as missing. Trials are numbered over all phases; a trial counts as \
                 missing if another participant has it. No hypothesis is tested."
            }
        }
    }
}
