#!/usr/bin/env bash
# Makes crates/window/fonts/japanese.otf again: the letters of Noto Sans CJK JP that the interface shows, and all kana.
# Run it after new Japanese texts, where a test names the letters that are missing. Needs Debian or Ubuntu (the font
# comes from the package fonts-noto-cjk, unpacked and not installed) and python3 with venv.
set -euo pipefail
cd "$(dirname "$0")/.."

FONTTOOLS=4.68.0
WORK="${CARGO_TARGET_DIR:-target}/japanese-font"
OUT=crates/window/fonts
mkdir -p "$WORK" "$OUT"
WORK="$(cd "$WORK" && pwd)"

if ! ls "$WORK"/fonts-noto-cjk_*.deb >/dev/null 2>&1; then
    (cd "$WORK" && apt-get download fonts-noto-cjk)
fi
dpkg-deb -x "$WORK"/fonts-noto-cjk_*.deb "$WORK/package"
[ -x "$WORK/venv/bin/pyftsubset" ] || {
    python3 -m venv "$WORK/venv"
    "$WORK/venv/bin/pip" install --quiet "fonttools==$FONTTOOLS"
}

# All Japanese is in the texts and in the files of foods, scales, goals and lessons.
cat crates/words/texts/ja.toml data/foods/*.toml data/doneness.toml data/goals.toml scenarios/*.toml >"$WORK/letters.txt"
# Kana, punctuation of Japanese and full-width forms are whole, for titles of a user's own.
KANA="U+3000-303F,U+3041-3096,U+3099-30FF,U+FF01-FF60"

# Face 0 of the collection is the Japanese one. Shaping tables are dropped: the interface does not use them.
"$WORK/venv/bin/pyftsubset" "$WORK/package/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc" --font-number=0 \
    --text-file="$WORK/letters.txt" --unicodes="$KANA" --output-file="$OUT/japanese.otf" \
    --layout-features='' --drop-tables+=GSUB,GPOS,BASE,VORG,vhea,vmtx --no-hinting --desubroutinize \
    --name-IDs='*' --no-recalc-timestamp
# The font's own notice, and the licence as the package has it, without the indents of its format.
notice="$("$WORK/venv/bin/python" -c 'import sys; from fontTools.ttLib import TTFont
print(TTFont(sys.argv[1])["name"].getDebugName(0))' "$OUT/japanese.otf")"
{
    printf 'japanese.otf holds a part of the letters of Noto Sans CJK JP; scripts/japanese-font.sh makes it.\n%s\n\n' "$notice"
    sed -n '/^License: SIL-1.1$/,/^License: GPL/p' "$WORK/package/usr/share/doc/fonts-noto-cjk/copyright" |
        sed -n '/SIL OPEN FONT LICENSE/,$p' | sed -e '/^License: GPL/d' -e '/^ -*$/d' -e 's/^ \.$//' -e 's/^ //'
} >"$OUT/OFL.txt"
wc -c "$OUT"/*
