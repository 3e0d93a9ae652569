"""A folder of one's own with a recipe, a pan, and a food whose shape is a surface file; and a sweep of them."""

import pathlib

ROOT = pathlib.Path(__file__).parent.parent.parent
RECIPE = """title = "my cube"
[pan]
kind = "my-pan"
initial_c = 150
[[food]]
id = "cube"
kind = "my-cube"
[[step]]
put = "cube"
[[step]]
at_s = 20
end = true
"""
#: What varies is in the recipe, in the own pan and in the own food, whose last scale is too large.
SPEC = """recipe = "mine"
for_s = 0.5
coarseness = 4
rows_per_part = 4
[vary]
"pan.initial_c" = { from = 120, to = 200, n = 2 }
"pans.my-pan.wall.height_mm" = [30, 54]
"foods.my-cube.mesh.scale_mm" = [0.9, 1.1, 450]
[design]
kind = "grid"
"""
CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, 20) for y in (0, 20) for z in (0, 20))
FACES = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"


def own_kitchen(folder):
    """Writes the folder; returns it."""
    for name in ("recipes", "pans", "foods"):
        (folder / name).mkdir(parents=True)
    (folder / "recipes" / "mine.toml").write_text(RECIPE)
    pan = (ROOT / "data" / "pans" / "carbon-steel-26.toml").read_text(encoding="utf-8")
    (folder / "pans" / "my-pan.toml").write_text(pan, encoding="utf-8")
    food = (ROOT / "fuzz" / "seeds" / "food" / "from-a-surface.toml").read_text(encoding="utf-8")
    (folder / "foods" / "my-cube.toml").write_text(food, encoding="utf-8")
    (folder / "foods" / "piece.obj").write_text(CUBE + FACES)
    return folder
