#!/usr/bin/env bash
# Draws forty pictures of foods for somebody who is to name what they show (docs/looks.md), in random order and without
# captions, and the key to them: 18 cut steaks of six classes (cores of 43–46, 49–52, 55–57, 61–63, 66–67 and 75 °C or more at their
# highest), every food of the pantry golden, two raw.
#
#   scripts/forty-pictures.sh SEED FOLDER    FOLDER/01.png to 40.png, FOLDER/key.tsv
#
# Another seed gives other pieces in another order. Pictures that are there already are kept.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# = 2 ] || { sed -n '2,9p' "$0" | sed 's/^# *//' >&2; exit 2; }
SEED="$1"
OUT="$2"
SAUTE="${SAUTE:-${CARGO_TARGET_DIR:-target}/release/saute}"
export SAUTE
# Samples of light of each picture.
SAMPLES="${SAMPLES:-16}"
WORK="$(mktemp -d)"
trap 'rm -rf "$WORK"' EXIT
mkdir -p "$OUT"

# piece FOOD SEED KEYS [PAN_C]: a pan and what goes into it.
piece() {
    printf '[pan]\nkind = "cast-iron-26"\ninitial_c = %s\n' "${4:-20}"
    printf '[[food]]\nid = "it"\nkind = "%s"\nseed = %s\n%s\n' "$1" "$2" "$3"
}

# hot FOOD SEED KEYS C: a food in a little oil in a pan that is held at a temperature.
hot() {
    piece "$@"
    printf '[[step]]\noil_g = 6\n[[step]]\nhob_w = { w = 2200, hold_c = %s }\n[[step]]\nput = "it"\n' "$4"
}

# cut FOOD SEED NAME CORE_C THICKNESS_MM: flipped every 75 s, taken out at a core temperature, rested for four minutes, halved.
cut() {
    hot "$1" "$2" "size_mm = [120, 80, $5]" 200
    printf '[[step]]\nrepeat = { flip = "it", every_s = 75, until = { food = "it", core_c = %s } }\n' "$4"
    printf '[[step]]\nrest = "it"\n[[step]]\nafter_s = 240\nhalve = "it"\n[[step]]\nafter_s = 4\nend = true\n'
}

# raw FOOD SEED KEYS: just laid into a cold pan.
raw() {
    piece "$1" "$2" "$3"
    printf '[[step]]\nput = "it"\n[[step]]\nafter_s = 4\nend = true\n'
}

# golden FOOD SEED KEYS C SECONDS: so long on each side; what has rolled lies as it will.
golden() {
    hot "$1" "$2" "$3" "$4"
    printf '[[step]]\nafter_s = %s\nflip = "it"\n[[step]]\nafter_s = %s\nend = true\n' "$5" "$5"
}

# fried FOOD SEED KEYS C SECONDS: so long, not turned.
fried() {
    hot "$1" "$2" "$3" "$4"
    printf '[[step]]\nafter_s = %s\nend = true\n' "$5"
}

# all: a line for each picture: name of the recipe, where the camera is, answer.
all() {
    local a=$((SEED + 1)) b=$((SEED + 12)) c=$((SEED + 27)) line
    while read -r done core; do
        for piece in lean:$a lean:$b marbled:$c; do
            local food="${piece%%:*}" seed="${piece##*:}"
            cut "beef-$food" "$seed" "$done" "$core" 28 >"$WORK/cut-$food-$done-$seed.toml"
            printf 'cut-%s-%s-%s\t32,24,215\t%s steak, cut: %s, seed %s\n' "$food" "$done" "$seed" "$food" "$done" "$seed"
        done
    done <<LIST
blue 31
rare 37
medium-rare 45
medium 52
medium-well 58
well-done 72
LIST
    # Food, how many, distance of the camera [mm], golden at [°C] for [s] a side.
    while read -r food count mm pan_c side_s; do
        line=""
        [ "$count" = 1 ] || line="count = $count"
        golden "$food" "$b" "$line" "$pan_c" "$side_s" >"$WORK/golden-$food-$b.toml"
        printf 'golden-%s-%s\t42,20,%s\t%s, golden, seed %s\n' "$food" "$b" "$mm" "$food" "$b"
    done <<LIST
bacon 2 240 165 150
beef-lean 1 270 185 150
beef-marbled 1 270 185 150
beef-patty 1 260 180 170
carrot-coin 9 230 170 230
carrot-stick 7 230 170 230
chicken-breast 1 270 165 300
cod-fillet 1 250 165 200
leek-ring 7 230 170 220
mushroom-slice 7 250 180 180
onion-dice 20 210 160 200
onion-ring 4 250 165 240
pepper-strip 8 250 175 200
pork-chop 1 280 180 200
potato-dice 12 210 175 240
potato-slice 7 240 175 300
salmon-fillet 1 250 165 200
shrimp 5 240 190 110
tofu 4 230 175 200
LIST
    fried egg "$b" "" 145 200 >"$WORK/fried-egg-$b.toml"
    printf 'fried-egg-%s\t42,20,210\tegg, fried, seed %s\n' "$b" "$b"
    for food in beef-lean shrimp; do
        local line="" mm=270
        [ "$food" = beef-lean ] || { line="count = 5"; mm=240; }
        raw "$food" "$a" "$line" >"$WORK/raw-$food-$a.toml"
        printf 'raw-%s-%s\t42,20,%s\t%s, raw, seed %s\n' "$food" "$a" "$mm" "$food" "$a"
    done
}

# draw NUMBER RECIPE CAMERA: at its end.
draw() {
    local end_s
    end_s="$("$SAUTE" cook "$WORK/$2.toml" --json | awk -F '[:,]' '/"simulated_s"/ { print $2 + 0 }')"
    "$SAUTE" shot "$WORK/$2.toml" --at "$end_s" --camera "$3" --size 720x480 --quality best --samples "$SAMPLES" --out "$OUT/$1.png"
}

number=0
: >"$OUT/key.tsv"
while IFS=$'\t' read -r recipe camera answer; do
    number=$((number + 1))
    name="$(printf '%02d' "$number")"
    printf '%s\t%s\n' "$name" "$answer" >>"$OUT/key.tsv"
    [ -e "$OUT/$name.png" ] || draw "$name" "$recipe" "$camera" </dev/null
done < <(all | shuf --random-source=<(yes "$SEED"))
