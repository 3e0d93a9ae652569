// Serves a folder by the program that `./run.sh web` uses.

import { spawn } from "node:child_process";

/** Starts the server named by SAUTE_SITE; `plain` sends no file compressed. Returns its address and a way to end it. */
export async function serve(folder, { plain = false } = {}) {
  const program = spawn(process.env.SAUTE_SITE, ["serve", folder, "--port", "0", ...(plain ? ["--plain"] : [])]);
  const address = await new Promise((resolve, reject) => {
    let said = "";
    const hear = (text) => {
      said += text;
      const found = said.match(/http:\/\/\S+\//);
      if (found) resolve(found[0]);
    };
    program.stdout.on("data", hear);
    program.stderr.on("data", hear);
    program.on("exit", (code) => reject(new Error(`the server ended with ${code}: ${said}`)));
  });
  // A test that fails on its way does not end it: then it ends with the tests of the file, which do not wait for it.
  process.once("exit", () => program.kill());
  for (const part of [program, program.stdin, program.stdout, program.stderr]) part.unref();
  return { address, end: () => program.kill() };
}
