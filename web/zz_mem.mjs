import { resolve } from "node:path";
import { launch } from "./test/browser.mjs";
import { press, stats, until, visit } from "./test/cooking.mjs";
import { serve } from "./test/site_server.mjs";
const [browser, host] = await Promise.all([launch(), serve(resolve(process.env.SAUTE_PAGE))]);
const S = {"version":1,"language":"en","theme":"dark","size":"usual","less_motion":null,"white_balance":"as-shot","light":"daylight","quality":"automatic","introduced":true,"fahrenheit":false,"map":"Uniform","view":"look","split":false,"scale":"paper-2013","speed":1.0,"choice":{"kind":"beef-lean","size_mm":[120.0,80.0,25.0],"initial_c":5.0,"pan":"carbon-steel-26","preheat_c":20.0},"plan":{"scale":"chefs","class":"medium","by_core":false,"core_c":57.0,"crust_pct":null,"most_flips":8,"powers":""},"kitchen":null,"goal_c":62.0,"goals":{},"goal_id":null,"coach":true,"result_opens":true,"skill_mode":false,"pantry_open":false,"pieces_open":false,"curves_open":false,"panels_hidden":false,"forecasts":false,"recent":[],"mirror":{"rig":"flat-screen","projector":"1","stereo":"off","eye_distance_mm":null,"pan_shown":false,"calibrations":{}}};
const prepare = (page) => page.addInitScript((s) => { localStorage["saute.settings"] = s; }, JSON.stringify(S));
const { page } = await visit(browser, `${host.address}?recipe=medium`, process.env.OFF ? { prepare } : {});
await press(page, "]"); await press(page, "]");
let last = 0;
for (let t = 0; t < 660; ) {
  const now = await stats(page);
  if (now.memory_bytes !== last) console.log(now.time_s.toFixed(0), (now.memory_bytes/1e6).toFixed(1), now.pieces[0].place, now.speed);
  last = now.memory_bytes; t = now.time_s;
  await page.waitForTimeout(200);
}
await browser.close(); host.end();
