// The page's sound: letters as the window writes them (crates/sound/src/letter.rs), and what comes of them.

/** What a window tells of a pan of carbon steel at 180 °C with a tenth of a gram of steam a second under the food, and of a clank. */
export function frying({ clanks = true } = {}) {
  const steam = [1e-4, 0, 0, 0, 0, 0];
  const [stove, pan] = [[0, 0], [1, 0.115, 2.3e-3]];
  const state = [180, 180, 0, 0, ...stove, ...pan, 0, 0.5];
  const clank = [4, 0.8, 0.05, 0];
  return new Float32Array([...steam, ...state, ...(clanks ? clank : [])]);
}

/** Renders seconds in a page by the worklet and a context that renders to memory; returns what can be counted, and how long it took [ms]. */
export const renderInPage = (page, seconds) =>
  page.evaluate(
    async ([seconds, letter]) => {
      const version = document.querySelector("link[href^='sound.js']").href.split("?")[1];
      const { player } = await import(new URL(`sound.js?${version}`, document.baseURI).href);
      const context = new OfflineAudioContext(2, seconds * 48000, 48000);
      const node = await player(context);
      node.connect(context.destination);
      // Told each second, as by a window: a player that is told nothing falls silent.
      for (let second = 0; second < seconds; second += 0.5) {
        context.suspend(second).then(async () => {
          const told = Float32Array.from(letter);
          node.port.postMessage(told.buffer, [told.buffer]);
          await new Promise((resolve) => setTimeout(resolve, 1));
          context.resume();
        });
      }
      const begun = performance.now();
      const [left, right] = await context.startRendering().then((made) => [0, 1].map((side) => made.getChannelData(side)));
      const heard = (from, to) => left.subarray(from * 48000, to * 48000).some((sample) => sample !== 0);
      const silent_seconds = Array.from({ length: seconds }, (_, second) => second).filter((second) => !heard(second, second + 1));
      const loudest = left.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
      const wide = left.some((sample, place) => sample !== right[place]);
      return { samples: left.length, silent_seconds, loudest, wide, took_ms: performance.now() - begun };
    },
    [seconds, [...frying({ clanks: false })]],
  );
