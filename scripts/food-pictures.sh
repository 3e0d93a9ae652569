#!/usr/bin/env bash
# Makes the pictures of the foods in the window's pantry again, next to the files of the foods: one for each food with a look, raw in
# the pan, in 20 colours, a fifth of the bytes. Run it after the look of a food has changed; names of foods limit it to them.
# Needs pngquant (Debian's package of that name).
set -euo pipefail
cd "$(dirname "$0")/.."

SAUTE="${SAUTE:-${CARGO_TARGET_DIR:-target}/release/saute}"

for look in gallery/looks/*.toml; do
    name="$(basename "$look" .toml)"
    [ -e "data/foods/$name.toml" ] || continue
    [ $# = 0 ] || [[ " $* " == *" $name "* ]] || continue
    # The distance of the camera [mm], so that every food fills its picture.
    distance="$(sed -n 's/^# In the pantry it is seen from \([0-9]*\) mm\.$/\1/p' "$look")"
    "$SAUTE" shot "$look" --at 2 --camera "48,20,${distance:?$look states no distance}" --size 108x72 --quality best \
        --out "data/foods/$name.png"
    pngquant --speed 1 --strip --force --output "data/foods/$name.png" 20 "data/foods/$name.png"
done
