// The texts of the page before the window is there.

const ENGLISH = {
  title: "saute: a frying pan, simulated",
  about: "A frying pan, the food in it and the heat inside, simulated.",
  guides: "Guides",
  teach: "For teachers",
  report: "Report a problem",
  report_copied: "Copied: version and browser. Paste it into a message to whoever runs this page.",
  private: "Nothing leaves this page.",
  version: (version) => `Version ${version}`,
  again: "Try again",
  by_hand: "The browser did not let this be copied. Copy it here:",
  done: "Done",
  describe: "Describe the cook",
  choose: "What do you want to cook?",
  starts: {
    last: ["Your last cook", "Go on where it stopped."],
    steak: ["First steak", "You cook, with advice at each step."],
    shrimp: ["Shrimps", "Hot and short. Watch, or take over."],
    stir: ["Stir fry", "Carrots and leeks, then a steak in the same pan."],
    burger: ["Burger", "A patty of minced beef. You cook."],
    inside: ["Look inside", "A steak cut open while it cooks."],
  },
  loading: "Loading",
  loaded: (done, all) => `${done} of ${all} MB`,
  preparing: "Preparing the kitchen",
  held_up:
    "Nothing has come for a while. The network may be slow or gone, or a filter, as many schools have one, may hold back " +
    "the .wasm file of this site. It is still being waited for.",
  typed: "What is typed into the picture",
  picture: "The kitchen. Tab goes from control to control; after Escape it leaves.",
  tilt: "Let this page feel how the phone is held",
  no_graphics:
    "This browser offers neither WebGPU nor WebGL 2, and the kitchen is drawn with one of them. Update the browser, " +
    "switch on hardware acceleration in its settings, or open this page in another browser.",
  no_wasm: "This browser cannot run WebAssembly, and the kitchen is made of it. Update it, or try another one.",
  not_loaded:
    "The kitchen could not be loaded. Look whether the network is there. Where a filter guards it, as in many schools, " +
    "ask for this site's .js and .wasm files to be let through.",
  not_started: "The kitchen could not be started.",
  bad_address: "The address asks for something that is not there. Correct it above, or go without it.",
  without: "Open the kitchen without it",
  stopped: "The kitchen has stopped because of an error. The last cook is offered again at the next start.",
  storage_refused: "the browser lets this page store nothing; allow it site data to change that",
  storage_full: "the storage of the browser is full; remove something there to change that",
};

const JAPANESE = {
  title: "saute：フライパンのシミュレーター",
  about: "フライパンと食材と、その中の熱のシミュレーター。",
  guides: "説明書（英語）",
  teach: "先生へ（英語）",
  report: "不具合を伝える",
  report_copied: "バージョンとブラウザーをコピーしました。このページの管理者への連絡に貼り付けてください。",
  private: "データはこのページの外へ送られません。",
  version: (version) => `バージョン ${version}`,
  again: "もう一度",
  by_hand: "ブラウザーがコピーを許しませんでした。ここからコピーしてください。",
  done: "閉じる",
  describe: "調理の様子を聞く",
  choose: "何を作りますか？",
  starts: {
    last: ["前回の続き", "止めたところから続けます。"],
    steak: ["初めてのステーキ", "助言を見ながら自分で焼きます。"],
    shrimp: ["えび", "強火で短く。見るだけでも、途中から自分でも。"],
    stir: ["野菜炒め", "にんじんとねぎ、同じフライパンでステーキ。"],
    burger: ["ハンバーグ", "牛ひき肉を自分で焼きます。"],
    inside: ["中をのぞく", "焼けていくステーキの断面。"],
  },
  loading: "読み込み中",
  loaded: (done, all) => `${all} MB のうち ${done} MB`,
  preparing: "台所を準備中",
  held_up:
    "しばらくデータが届いていません。ネットワークが遅いか切れている、または学校などのフィルターがこのサイトの .wasm ファイルを" +
    "止めている可能性があります。まだ待っています。",
  typed: "画面への文字入力",
  picture: "台所。Tab で次の操作へ進み、Escape の後の Tab で外へ出ます。",
  tilt: "スマホの傾きを読むことを許可",
  no_graphics:
    "このブラウザーでは WebGPU も WebGL 2 も使えないため、台所を描けません。ブラウザーを新しくするか、設定で" +
    "ハードウェアアクセラレーションを有効にするか、別のブラウザーで開いてください。",
  no_wasm: "このブラウザーでは WebAssembly を使えません。ブラウザーを新しくするか、別のブラウザーで開いてください。",
  not_loaded:
    "台所を読み込めませんでした。ネットワークを確かめてください。学校などでフィルターがある場合は、このサイトの .js と .wasm を" +
    "許可してもらってください。",
  not_started: "台所を始められませんでした。",
  bad_address: "アドレスに書かれたものがありません。アドレスを直すか、それなしで開いてください。",
  without: "それなしで台所を開く",
  stopped: "エラーのため台所が止まりました。次に開くと、前回の続きから始められます。",
  storage_refused: "ブラウザーがこのページの保存を許していません。サイトのデータを許可すると保存されます",
  storage_full: "ブラウザーの保存場所がいっぱいです。空きを作ると保存されます",
};

/** The texts in the language of a code such as `ja` or `ja-JP`; English for any other. */
export function words(code) {
  return code.toLowerCase().split("-")[0] === "ja" ? JAPANESE : ENGLISH;
}
