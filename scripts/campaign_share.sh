# Which share of the campaign `./test.sh` runs. Sourced, not run.

# Random cooks of crates/kitchen/tests/kitchen/properties.rs. All random tests are drawn from one seed, so that every run of
# ./test.sh makes the same ones; the campaign draws new ones.
SHARE_RANDOM_COOKS=24
SHARE_SEED=20131120
CAMPAIGN_RANDOM_COOKS=250

# Random packets for each door to a device; of ./test.sh 256, the default of proptest.
CAMPAIGN_RANDOM_PACKETS=20000

# Length of each check of the haptic loop with faults in the campaign [s]. Of ./test.sh it is 5 s, stated in
# crates/cli/tests/cli/haptics.rs.
CAMPAIGN_HAPTICS_S=60

# Length of the cook that must keep its memory and balances [simulated minutes]; the campaign runs a day.
SHARE_SOAK_MINUTES=10

# Longest time of one target of the fuzzer in the campaign [s], in the plain build and under the address sanitizer; it ends
# sooner with the executions of fuzz_goal. ./test.sh replays seeds and found cases, and the same few thousand mutations
# every time (crates/attack/tests): to build the fuzzer takes a quarter of an hour.
CAMPAIGN_FUZZ_S=3600
CAMPAIGN_SANITIZER_S=600

# Random instants at which a dish is stored and restored (crates/kitchen/tests/kitchen/bytes.rs), and random sessions that are played again
# (crates/recipe/tests/recipe/sessions.rs).
SHARE_RANDOM_INSTANTS=20
CAMPAIGN_RANDOM_INSTANTS=200
SHARE_RANDOM_SESSIONS=10
CAMPAIGN_RANDOM_SESSIONS=100

# Plans that are verified by the cooks of their recipes (crates/plan/tests/plan/verified.rs): of ./test.sh the quick ones of its list.
CAMPAIGN_PLANS=all

# Fits of a kitchen at home to simulated logs (crates/plan/tests/plan/fit.rs). ./test.sh makes 3.
CAMPAIGN_FIT_TRIALS=100

# Kills of a cook that is recorded (crates/cli/tests/cli/sessions.rs). ./test.sh makes 20.
CAMPAIGN_RANDOM_KILLS=1000

# Updates of the policy in the training example; the whole training makes 110. ./test.sh makes 2, without a verdict.
CAMPAIGN_TRAINING_UPDATES=40

# fix_campaign_share: hands the share to the tests.
fix_campaign_share() {
    export SAUTE_RANDOM_COOKS="$SHARE_RANDOM_COOKS"
    export SAUTE_RANDOM_INSTANTS="$SHARE_RANDOM_INSTANTS"
    export SAUTE_RANDOM_SESSIONS="$SHARE_RANDOM_SESSIONS"
    export PROPTEST_RNG_SEED="$SHARE_SEED"
}
