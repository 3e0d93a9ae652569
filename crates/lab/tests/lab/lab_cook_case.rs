//! Promise: a cook case judges bands at the end, at times and at steps, and trends along a varied parameter.

use saute_kitchen::Library;
use saute_lab::{CookCase, Verdict};

/// A pan that heats for 20 s; the hob is set again half-way.
const PAN: &str = "name = \"pan\"\nsource = \"balance\"\nevidence = \"exact\"\nrecipe = '''\n[[step]]\nhob_w = @hob_w@\n\
    [[step]]\nat_s = 10\nhob_w = 0\n[[step]]\nat_s = 20\nend = true\n'''\n";
const SWEEP: &str = "[sweep]\nreplace = \"@hob_w@\"\nvalues = [400, 800, 1600]\n";

fn case(text: &str) -> Result<CookCase, String> {
    let library = Library::embedded().expect("embedded data");
    CookCase::parse(text, "case.toml", &library).map_err(|e| e.to_string())
}

fn verdicts(text: &str) -> Vec<Verdict> {
    let library = Library::embedded().expect("embedded data");
    case(text).unwrap_or_else(|e| panic!("{e}")).verdicts(&library).unwrap_or_else(|e| panic!("{e}"))
}

/// A case without a sweep.
fn plain(more: &str) -> String {
    PAN.replace("@hob_w@", "1600") + more
}

fn swept(more: &str) -> String {
    format!("{PAN}{SWEEP}{more}")
}

fn band(more: &str) -> String {
    format!("[[expect]]\nquantity = \"pan\"\npointer = \"/pan_c/end\"\nunit = \"°C\"\nlow = 0\nhigh = 500\n{more}\n")
}

fn trend(more: &str) -> String {
    format!("[[trend]]\nquantity = \"pan\"\npointer = \"/pan_c/end\"\nunit = \"°C\"\n{more}\n")
}

/// The pan warms for 10 s, then stays about as it is: readings at times and at steps are in that order.
#[test]
fn a_band_reads_the_summary_at_its_moment() {
    let moments = [
        "at = { step = \"hob_w\" }",
        "at = { s = 5 }",
        "at = { step = \"hob_w\", after_s = 7.5 }",
        "at = { step = \"hob_w\", nth = 2 }",
    ];
    let read = verdicts(&plain(&moments.map(band).concat()));
    let got: Vec<f64> = read.iter().map(|v| v.got.expect("a reading")).collect();
    assert!(got.windows(2).all(|w| w[1] > w[0] + 0.5), "{got:?}");
    // The same moment, named in two ways.
    let same = verdicts(&plain(&["at = { s = 10 }", "at = { step = \"hob_w\", nth = 2 }"].map(band).concat()));
    assert_eq!(same[0].got, same[1].got);
    let ends = verdicts(&plain(&["", "at = { step = \"end\" }"].map(band).concat()));
    assert_eq!(ends[0].got, ends[1].got);
}

#[test]
fn a_moment_that_does_not_come_fails() {
    for at in ["{ s = 21 }", "{ step = \"hob_w\", nth = 3 }", "{ step = \"flip\" }", "{ step = \"end\", after_s = 1 }"]
    {
        let verdict = &verdicts(&plain(&band(&format!("at = {at}"))))[0];
        assert!(verdict.got.is_none() && verdict.falls_short(), "{at}: {verdict:?}");
    }
}

/// The highest temperature less that at the end.
#[test]
fn a_band_may_subtract_another_number() {
    let text = band("less = \"/pan_c/peak\"");
    let verdict = &verdicts(&plain(&text))[0];
    assert!(verdict.got.is_some_and(|got| (-20.0..=0.0).contains(&got)), "{verdict:?}");
    let missing = &verdicts(&plain(&band("less = \"/pan_c/nothing\"")))[0];
    assert!(missing.falls_short(), "{missing:?}");
}

/// More power makes the pan hotter: "not falling" passes, "not rising" fails by the whole rise.
#[test]
fn a_trend_goes_along_the_values_of_the_sweep() {
    let trends = [
        trend("direction = \"not_falling\"\nslack = 0"),
        trend("direction = \"not_rising\"\nslack = 1"),
        trend("direction = \"not_rising\"\nslack_pct = 1"),
        trend("direction = \"not_rising\"\nslack_pct = 1e6"),
    ];
    let [rises, absolute, relative, slack] = &verdicts(&swept(&trends.concat()))[..] else { panic!("four verdicts") };
    assert_eq!((rises.pass, rises.got), (Some(true), Some(0.0)));
    assert!(rises.quantity.contains("never falls (hob_w = 400 to hob_w = 1600)"), "{}", rises.quantity);
    assert!(absolute.falls_short() && absolute.unit == "°C", "{absolute:?}");
    assert!(relative.falls_short() && relative.unit == "%" && relative.got > absolute.got, "{relative:?}");
    assert_eq!(slack.pass, Some(true));
    // At the start all pans are alike.
    let start = "at = { step = \"hob_w\" }\ndirection = \"not_rising\"\nslack = 1e-9";
    assert_eq!(verdicts(&swept(&trend(start)))[0].got, Some(0.0));
}

#[test]
fn a_guard_leaves_out_the_cooks_beyond_its_limit() {
    let end = |watts: &str| {
        let text = PAN.replace("@hob_w@", watts) + &band("");
        verdicts(&text)[0].got.expect("a reading")
    };
    let [low, high] = [end("400"), end("800")];
    let guarded = |limit: f64| {
        let more = format!(
            "direction = \"not_rising\"\nslack = 1\nwhile_below = {{ pointer = \"/pan_c/end\", limit = {limit} }}"
        );
        verdicts(&swept(&trend(&more)))[0].clone()
    };
    // Two of three cooks remain, and their rise alone.
    let two = guarded(high + 0.1);
    assert!(two.got.is_some_and(|got| (got - (high - low)).abs() < 1e-9), "{two:?} {low} {high}");
    // One cook is no trend.
    assert!(guarded(low + 0.1).got.is_none() && guarded(low + 0.1).falls_short());
    let missing = "direction = \"not_falling\"\nslack = 1\nwhile_below = { pointer = \"/nothing\", limit = 1 }";
    assert!(verdicts(&swept(&trend(missing)))[0].falls_short());
}

/// Bands of a sweep are judged for each value, trends for each value of `each`; both name it.
#[test]
fn a_sweep_judges_every_value_and_each_variant() {
    let pans = PAN.replace("'''\n[[step]]\nhob_w", "'''\n[pan]\nkind = \"@pan@\"\n[[step]]\nhob_w");
    let each = "[each]\nreplace = \"@pan@\"\nvalues = [\"cast-iron-26\", \"carbon-steel-26\"]\n";
    let text = format!("{pans}{SWEEP}{each}{}{}", band(""), trend("direction = \"not_falling\"\nslack = 0"));
    let verdicts = verdicts(&text);
    assert_eq!(verdicts.len(), 2 * (3 + 1));
    assert_eq!(verdicts[1].quantity, "pan (pan = cast-iron-26, hob_w = 800)");
    assert!(verdicts[7].quantity.contains("carbon-steel-26"), "{}", verdicts[7].quantity);
    assert!(verdicts.iter().all(|v| v.pass == Some(true)), "{verdicts:?}");
    assert!(verdicts[4].got > verdicts[0].got, "carbon steel is thinner: {verdicts:?}");
}

#[test]
fn a_cook_case_of_information_fails_nothing() {
    let far = band("").replace("low = 0\nhigh = 500", "low = 900\nhigh = 901");
    let text = plain(&far).replace("\"exact\"", "\"information\"");
    assert_eq!(verdicts(&text)[0].pass, None);
}

#[test]
fn bad_cook_cases_say_what_to_write() {
    let falling = trend("direction = \"not_falling\"\nslack = 1");
    let bad = [
        (plain(&band("at = { s = 5, step = \"flip\" }")), "a moment is"),
        (plain(&band("at = { step = \"flip\", nth = 0 }")), "a moment is"),
        (plain(&band("at = { s = -1 }")), "a moment is"),
        (plain(&band("at = { step = \"fry\" }")), "step = \"fry\" is not an action"),
        (plain(&falling), "a trend needs a sweep"),
        (plain(SWEEP), "does not contain replace = \"@hob_w@\""),
        (swept(""), "the sweep expects nothing"),
        (swept(&falling).replace("[400, 800, 1600]", "[400]"), "fewer than two values"),
        (swept(&falling).replace("800", "9999"), "case.toml, recipe with hob_w = 9999:2:"),
        (swept(&falling.replace("slack = 1", "")), "one of slack and slack_pct"),
        (swept(&falling.replace("slack = 1", "slack = 1\nslack_pct = 1")), "one of slack and slack_pct"),
        (swept(&falling.replace("not_falling", "falling")), "falling"),
        (swept(&falling).replace("[sweep]", "against = ''\n[sweep]"), "a sweep has no against"),
        (plain(&band("")).replace("evidence = \"exact\"\n", ""), "evidence"),
        (plain(&band("")).replace("\"exact\"", "\"sure\""), "kitchen-band"),
    ];
    for (text, expected) in bad {
        let error = case(&text).expect_err("is refused");
        assert!(error.contains(expected) && error.contains("case.toml") && error.contains("remedy:"), "{error}");
    }
    let each = "[each]\nreplace = \"at_s\"\nvalues = [1, 2]\n";
    let error = case(&plain(&format!("{each}{}", band("")))).expect_err("is refused");
    assert!(error.contains("each needs a sweep"), "{error}");
}
