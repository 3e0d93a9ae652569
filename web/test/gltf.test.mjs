// Promise: the cooked food that the program writes as glTF is valid to the letter of the format.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import validator from "gltf-validator";

/** A thin steak and a shrimp, the steak halved: skins of every kind, and a cut face. */
const RECIPE = `title = "valid"
[pan]
initial_c = 200
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 15]
mesh = "2013"
[[food]]
id = "shrimp"
kind = "shrimp"
[[step]]
put = "steak"
[[step]]
put = "shrimp"
at_mm = [55, 0]
[[step]]
at_s = 2
rest = "steak"
[[step]]
at_s = 6
halve = "steak"
[[step]]
at_s = 6.2
end = true
`;

test("the cooked food as glTF is valid", async () => {
  const folder = mkdtempSync(join(tmpdir(), "saute-gltf-"));
  try {
    const recipe = join(folder, "valid.toml");
    writeFileSync(recipe, RECIPE);
    execFileSync(process.env.SAUTE_PROGRAM, ["cook", recipe, "--out", join(folder, "out")], { stdio: "pipe" });
    const file = readFileSync(join(folder, "out", "cooked.glb"));
    const { issues, info } = await validator.validateBytes(new Uint8Array(file), { maxIssues: 20 });
    assert.deepEqual(issues.messages, []);
    assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0]);
    assert.equal(info.drawCallCount, 3, "two halves and a shrimp");
    assert.ok(info.totalTriangleCount > 1000);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
