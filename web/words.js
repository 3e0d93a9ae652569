// The texts of the page before the window is there.

const ENGLISH = {
  about: "A frying pan, the food in it and the heat inside, simulated.",
  guides: "Guides",
  again: "Try again",
  loading: "Loading",
  loaded: (done, all) => `${done} of ${all} MB`,
  preparing: "Preparing the kitchen",
  typed: "What is typed into the picture",
  picture: "The kitchen. Tab goes from control to control; after Escape it leaves.",
  tilt: "Let this page feel how the phone is held",
  no_graphics:
    "This browser offers neither WebGPU nor WebGL 2, and the kitchen is drawn with one of them. Update the browser, " +
    "switch on hardware acceleration in its settings, or open this page in another browser.",
  no_wasm: "This browser cannot run WebAssembly, and the kitchen is made of it. Update it, or try another one.",
  not_loaded: "The kitchen could not be loaded.",
  not_started: "The kitchen could not be started.",
  stopped: "The kitchen has stopped because of an error.",
};

const JAPANESE = {
  about: "フライパンと食材と、その中の熱のシミュレーター。",
  guides: "説明書（英語）",
  again: "もう一度",
  loading: "読み込み中",
  loaded: (done, all) => `${all} MB のうち ${done} MB`,
  preparing: "台所を準備中",
  typed: "画面への文字入力",
  picture: "台所。Tab で次の操作へ進み、Escape の後の Tab で外へ出ます。",
  tilt: "スマホの傾きを読むことを許可",
  no_graphics:
    "このブラウザーでは WebGPU も WebGL 2 も使えないため、台所を描けません。ブラウザーを新しくするか、設定で" +
    "ハードウェアアクセラレーションを有効にするか、別のブラウザーで開いてください。",
  no_wasm: "このブラウザーでは WebAssembly を使えません。ブラウザーを新しくするか、別のブラウザーで開いてください。",
  not_loaded: "台所を読み込めませんでした。",
  not_started: "台所を始められませんでした。",
  stopped: "エラーのため台所が止まりました。",
};

/** The texts in the language of a code such as `ja` or `ja-JP`; English for any other. */
export function words(code) {
  return code.toLowerCase().split("-")[0] === "ja" ? JAPANESE : ENGLISH;
}
