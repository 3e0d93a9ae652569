# Licences, versions and sources of all dependencies, on all platforms, judged by deny.toml. Sourced, not run.

# can_deny: whether the tool is there; else prints what is missing. The tests judge this platform's crates without it.
can_deny() {
    command -v cargo-deny >/dev/null || { say "skipped: no cargo-deny (cargo install cargo-deny)"; return 1; }
}

# judge_dependencies: what can be judged without the network.
judge_dependencies() {
    can_deny || return 0
    cargo deny --offline --log-level error check licenses bans sources
}

# judge_advisories: known faults of the versions in use; their database comes over the network.
judge_advisories() {
    can_deny || return 0
    if ! cargo deny fetch db; then say "skipped: the database of advisories cannot be fetched"; return 0; fi
    cargo deny check advisories
}
