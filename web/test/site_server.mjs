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
  return { address, end: () => program.kill() };
}
