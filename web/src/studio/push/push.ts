// The push: its curve and its cracks while it runs, and what came out: a sentence, key numbers, the cracks at each state.
// Other pushes stand beside it (beside.ts, family.ts), and one that was kept (compare.ts).
import { h } from "../../base/dom";
import { farther, pushOf, slower } from "../stages";
import type { Summary } from "../../headers/run";
import { asSentence, languageNow, num, phrase, qty, say } from "../../base/texts";
import { Beside } from "./beside";
import { Compare, type Pushed } from "./compare";
import { Curve, pointsOf } from "./curve";
import { answerOf, faultsOf, hasEngine, kStopped, pieceOf, textIn, type Answer, type Engine, type Progress } from "./engine";
import { Family } from "./family";
import { readPicture, type Picture } from "../board/picture";
import type { Fault, Project } from "../project";
import { whyOf } from "../file/said";
import { lengthOf, readQuantity } from "../file/units";
import { valueAt } from "../file/toml";

interface StoredState {
  label: string;
  displacement_mm: number;
  reaction_kN: number;
}
const kStates = 16; // pictures along the push, besides those that the file asks for
const kMostStates = 60; // pictures that are asked for; the answer has those that there are
const kFrames = 40; // of the report's film
const kRest = 1500; // without an edit, before a push begins by itself [ms]

export class Push {
  readonly root: HTMLElement;
  readonly curve = new Curve();
  running = false;
  paused = false;
  private watching = false; // the drawing shows the wall as it is pushed
  private states: StoredState[] = [];
  private answer: Answer | null = null; // pictures and report
  private pushed: Pushed | null = null; // what is shown
  private length = 1; // of that wall [m]
  private taken = 1; // of the wall that the engine took last [m]
  private turn = 0; // of pictures: those of an earlier one are not shown any more
  private reading = false;
  private next: (() => string) | null = null; // the newest picture that waits
  private ofText = ""; // the text that was pushed
  private itself = false; // a push begins by itself
  private rest = 0; // its timer
  private able = false; // the engine took the text as it is
  readonly family: Family;
  private readonly beside: Beside;
  private readonly compare = new Compare();
  private readonly words = h("div", { class: "result-words", role: "status", "aria-live": "polite" });
  private readonly older = h("p", { class: "soft", hidden: true }, say("studio.family.stale"));
  private readonly slider = h("input", { type: "range", min: 0, max: 0, step: 1, value: 0, "aria-label": say("studio.state") });
  private readonly at = h("output", { class: "soft" });
  private readonly states_row: HTMLElement;
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": say("studio.progress"), hidden: true });
  private readonly back = h("button", { class: "button small", type: "button", onclick: () => this.leave() }, say("studio.back"));
  private readonly report = h("button", { class: "button small", type: "button", hidden: true, onclick: () => this.openReport() }, say("studio.report"));
  private readonly actions = h("div", { class: "actions", role: "group", "aria-label": say("studio.actions") });
  private readonly pauseButton = this.action("pause", () => this.pause());
  private readonly watchButton = this.action("watch", () => this.watch(!this.watching));
  private readonly otherButton = this.action("other", () => (this.beside.running === "other" ? this.beside.stop() : void this.beside.pushOtherWay()));
  private readonly fartherButton = this.action("farther", () => this.pushAnew(farther(this.project.text)));
  private readonly slowerButton = this.action("slower", () => this.pushAnew(slower(this.project.text)));
  private readonly wallsButton = this.action("walls", () => (this.beside.running === "walls" ? this.beside.stop() : void this.beside.pushWalls()));
  private readonly keepButton = this.action("keep", () => this.keep());
  private readonly itselfButton = this.action("itself", () => this.pushItself(!this.itself));

  constructor(
    private readonly project: Project,
    private readonly engine: Engine,
    besides: Engine, // of the pushes beside it
    private readonly show: (picture: Picture | null) => void, // cracks, or the wall as it is drawn
    private readonly refused: (faults: Fault[]) => void,
    private readonly changed: () => void,
  ) {
    const besidesChanged = (): void => {
      this.refresh();
      this.changed();
    };
    this.beside = new Beside(project, besides, besidesChanged);
    this.family = new Family(project, besides, (text) => (text === this.ofText ? this.pushed : null), () => !hasEngine() || this.beside.running !== "", besidesChanged);
    this.states_row = h("div", { class: "states", hidden: true }, h("span", {}, say("studio.cracks")), this.slider, this.at);
    this.actions.prepend(this.back, this.report);
    this.slider.addEventListener("input", () => this.showState(Number(this.slider.value)));
    this.curve.pick = (mm) => this.pick(mm);
    this.root = h("section", { class: "push", "aria-label": say("studio.push") },
      this.bar,
      h("div", { class: "curve-box" }, this.curve.root, this.curve.legend),
      h("div", { class: "result", tabindex: "0", role: "group", "aria-label": say("studio.result") }, this.family.root, this.states_row, this.actions, this.older, this.words));
    this.say(h("p", { class: "soft" }, say("studio.push.before")));
    this.refresh();
  }

  private action(name: string, does: () => void): HTMLButtonElement {
    const button = h("button", { class: "button small", type: "button", "data-action": name, title: say(`studio.do.${name}`), onclick: does }, say(`studio.button.${name}`));
    this.actions.append(button);
    return button;
  }
  private say(...what: Node[]): void {
    this.words.replaceChildren(...what);
  }
  // The engine takes the wall as it is: it is pushed by itself, beside the drawing, if that was asked for and nothing changes for a while.
  ready(length: number): void {
    this.taken = length;
    this.able = true;
    this.wait();
  }
  private wait(): void {
    window.clearTimeout(this.rest);
    if (!this.itself || !this.able || this.running || (this.pushed && !this.isStale)) return;
    this.rest = window.setTimeout(() => void this.start(false), kRest);
  }
  private pushItself(on: boolean): void {
    this.itself = on;
    this.wait();
    this.refresh();
  }
  // The wall was edited: what is shown belongs to the one before.
  edited(): void {
    this.able = false;
    window.clearTimeout(this.rest);
    if (this.itself && this.running && this.isStale) this.stop();
    this.family.edited();
    if (this.ofText === "") return this.refresh();
    const stale = this.isStale;
    this.root.classList.toggle("stale", stale);
    if (stale) {
      this.beside.stop();
      this.watching = false;
      this.leave();
    }
    this.refresh();
  }
  private get isStale(): boolean {
    return this.ofText !== this.project.text;
  }
  // Whether any wall is being pushed.
  get busy(): boolean {
    return this.running || this.beside.running !== "" || this.family.running;
  }
  get kept(): Pushed | null {
    return this.compare.kept;
  }
  set kept(pushed: Pushed | null) {
    this.compare.kept = pushed;
    this.refresh();
  }
  // Results beside the push that is kept.
  get hasMore(): boolean {
    return (this.pushed !== null && this.pushed !== this.kept) || this.beside.hasResult || this.family.hasResult;
  }
  get hasResult(): boolean {
    return this.states.length > 0;
  }
  // Buttons and lines as they belong to what there is.
  private refresh(): void {
    const { beside, curve, family } = this;
    const shown = this.pushed !== null && !this.running;
    const fresh = shown && !this.isStale;
    this.older.hidden = !shown || fresh;
    this.back.hidden = !shown;
    this.slider.disabled = !fresh;
    this.pauseButton.hidden = this.watchButton.hidden = !this.running;
    this.pauseButton.textContent = say(this.paused ? "studio.button.goon" : "studio.button.pause");
    this.watchButton.setAttribute("aria-pressed", String(this.watching));
    this.watchButton.disabled = this.isStale;
    this.otherButton.hidden = this.wallsButton.hidden = this.fartherButton.hidden = this.slowerButton.hidden = !shown;
    this.otherButton.textContent = say(beside.running === "other" ? "studio.button.stop" : "studio.button.other");
    this.otherButton.disabled = beside.running === "walls" || family.running || !fresh || !beside.canTurn;
    this.wallsButton.textContent = say(beside.running === "walls" ? "studio.button.stop" : "studio.button.walls");
    this.wallsButton.disabled = beside.running === "other" || family.running || !fresh;
    this.fartherButton.disabled = !fresh || !(this.until() > 0) || !this.project.drawable;
    this.slowerButton.disabled = !fresh || !this.project.drawable || slower(this.project.text) === null;
    this.keepButton.hidden = !shown && this.compare.kept === null;
    this.keepButton.textContent = say(this.compare.kept ? "studio.button.unkeep" : "studio.button.keep");
    this.keepButton.setAttribute("aria-pressed", String(this.compare.kept !== null));
    this.itselfButton.setAttribute("aria-pressed", String(this.itself));
    curve.name = say("studio.now");
    curve.lines = [...(this.compare.kept === this.pushed ? [] : this.compare.line()), ...(beside.other ? [beside.other] : []), ...family.lines];
    curve.walls = beside.walls;
    if (this.ofText === "") curve.until = this.until() || 20;
    curve.draw();
    this.root.classList.toggle("doubled", family.has(this.ofText));
    family.refresh();
    this.compare.show(this.running ? null : this.pushed);
  }

  // `watch`: the drawing shows the wall as it is pushed.
  async start(watch = true): Promise<void> {
    if (this.running) return;
    window.clearTimeout(this.rest);
    const { project, curve } = this;
    const text = (this.ofText = project.text);
    this.length = project.drawable && project.drawing ? project.drawing.length : this.taken;
    this.running = true;
    this.watching = watch;
    this.paused = false;
    this.states = [];
    this.answer = this.pushed = null;
    this.beside.forget();
    this.report.hidden = this.states_row.hidden = true;
    this.root.classList.remove("stale");
    curve.points = [];
    curve.peak = curve.cursor = null;
    curve.until = this.until() || 20;
    this.bar.value = 0;
    this.bar.hidden = false;
    this.say(h("p", {}, say("studio.pushing")));
    this.refresh();
    this.changed();
    const name = String((project.doc && valueAt(project.doc, ["name"])) ?? "");
    const answer = await this.engine.ask(
      { task: "run", texts: { model: text, set: this.settings(), language: languageNow() }, numbers: { frames: kFrames }, want: ["summary", "states", "reason"], bytes: ["page", ...Array.from({ length: kMostStates }, (_, k) => picture(k))], tables: ["curve"], pieces: true },
      (p) => this.hear(p),
    );
    this.engine.rest();
    const watched = this.watching;
    this.running = this.watching = this.paused = false;
    this.root.classList.remove("held");
    this.bar.hidden = true;
    if (answer.code === 0) this.done(answer, name, watched);
    else {
      if (watched) this.leave();
      if (answer.code === kStopped) this.say(h("p", {}, say("studio.stopped")));
      else if (answer.code === 2) {
        this.say(h("p", {}, say("studio.refused")));
        this.refused(faultsOf(answer));
      } else this.say(h("p", { class: "bad" }, say("studio.failed", { why: whyOf(answer) })));
    }
    this.refresh();
    this.changed();
    this.edited();
  }
  private hear(p: Progress): void {
    if (p.svg !== undefined) {
      if (this.watching && !this.isStale && !document.hidden) void this.reveal(() => p.svg!);
      return;
    }
    if (p.held) return void this.root.classList.toggle("held", this.paused);
    this.bar.value = p.share;
    // the curve belongs to the push, not to the loads before it
    if (p.displacement_mm !== 0) this.curve.points.push([p.displacement_mm, p.reaction_kN]);
    this.curve.draw();
    this.say(h("p", { class: "live" }, h("b", {}, qty(p.reaction_kN, "kN")), ` ${say("studio.at", { at: qty(p.displacement_mm, "mm") })} `, h("span", { class: "soft" }, `${Math.round(100 * p.share)} %`)));
  }
  stop(): void {
    this.engine.stop();
  }
  pause(): void {
    if (!this.running) return;
    this.paused = !this.paused;
    this.root.classList.remove("held");
    this.engine.pause(this.paused);
    this.refresh();
  }
  // The wall as it is pushed, or the drawing meanwhile.
  private watch(on: boolean): void {
    this.watching = on;
    if (!on) this.hide();
    this.refresh();
  }
  // An edit of the file as any other, and a push.
  private pushAnew(text: string | null): void {
    if (text === null || this.running) return;
    this.project.endStep();
    this.project.change(text);
    void this.start();
  }
  private keep(): void {
    this.kept = this.kept ? null : this.pushed;
  }

  private until(): number {
    const push = this.project.doc && pushOf(this.project.doc);
    return 1e3 * (lengthOf(push?.until) ?? 0);
  }
  // States for pictures all along the push; they change nothing of what is computed.
  private settings(): string[] {
    const until = this.until();
    const doc = this.project.doc;
    if (!(until > 0) || !doc) return [];
    const asked = new Set<number>();
    for (let k = 1; k < kStates; ++k) asked.add(Number(((until * k) / kStates).toPrecision(3)));
    const output = doc.root.keys.get("output")?.node;
    const own = output?.kind === "table" ? output.keys.get("states")?.node : undefined;
    if (own?.kind === "list")
      for (const item of own.items) {
        const q = item.kind === "value" ? readQuantity(item.data) : null;
        if (q?.base === "m") asked.add(Number((1e3 * q.value).toPrecision(6)));
      }
    const all = [...asked].sort((a, b) => a - b).map((mm) => `"${mm} mm"`);
    return [`output.states=[${all.join(", ")}]`];
  }

  private done(answer: Answer, name: string, watched: boolean): void {
    const summary = answerOf<Partial<Summary>>(answer.texts.summary, {});
    const { curve } = this;
    if (answer.tables.curve) curve.points = pointsOf(answer);
    this.states = answerOf(answer.texts.states, []);
    const end = this.states.length - 1;
    this.pushed = { name, summary, points: curve.points, end: end < 0 ? null : { ...this.states[end], svg: textIn(answer, picture(end)), length: this.length } };
    this.answer = answer;
    const headline = headlineOf(answer);
    const peak = summary.peak_reaction_kN ?? null,
      at = summary.displacement_at_peak_mm ?? null;
    curve.peak = curve.points.length > 0 && peak !== null && at !== null ? [at, peak] : null; // a wall that fell before its push has none
    this.say(
      this.compare.root,
      h("dl", { class: "key" },
        ...card(say("studio.peak"), qty(peak, "kN")),
        ...card(say("studio.peak.drift"), qty(summary.drift_percent_at_peak, "%", 2)),
        ...card(say("studio.ultimate"), `${summary.censored_80 ? "> " : ""}${qty(summary.drift_percent_at_80, "%", 2)}`),
        ...card(say("studio.mode"), phrase(summary.failure_mode?.name ?? "–")),
      ),
      this.beside.root,
      h("p", { class: "answer" }, headline || say("run.resists", { force: qty(peak, "kN"), at: qty(at, "mm"), drift: "" })),
      ...(answer.texts.reason ? [h("p", { class: "ended" }, asSentence(answer.texts.reason))] : []),
    );
    this.report.hidden = !hasPage(answer);
    this.slider.max = String(this.states.length - 1);
    this.states_row.hidden = this.states.length === 0;
    this.slider.value = String(end);
    this.at.textContent = "";
    if (end >= 0 && watched) this.showState(end); // else somebody draws
  }

  // The picture under way is finished before the newest one: who goes along the states sees them pass.
  private async reveal(text: () => string): Promise<void> {
    this.next = text;
    if (this.reading) return;
    this.reading = true;
    document.documentElement.dataset.reading = "yes"; // until the picture is the newest
    let failure: unknown = null; // of one picture; the newest one is shown all the same
    while (this.next) {
      const turn = this.turn;
      const now = this.next;
      this.next = null;
      try {
        const shown = await readPicture(now(), this.length, () => turn === this.turn);
        if (turn === this.turn) this.show(shown);
      } catch (error) {
        failure = error;
      }
    }
    this.reading = false;
    delete document.documentElement.dataset.reading;
    if (failure) throw failure;
  }
  private hide(): void {
    ++this.turn;
    this.next = null;
    this.show(null);
  }

  showState(k: number): void {
    const state = this.states[k];
    if (!state || this.isStale) return; // cracks of another wall do not fit into this outline
    this.slider.value = String(k);
    this.slider.setAttribute("aria-valuetext", `${num(state.displacement_mm)} mm, ${num(state.reaction_kN)} kN`);
    this.at.textContent = `${qty(state.displacement_mm, "mm")} · ${qty(state.reaction_kN, "kN")}`;
    this.curve.cursor = state.displacement_mm;
    this.curve.draw();
    const { answer } = this;
    if (answer) void this.reveal(() => textIn(answer, picture(k)));
  }
  // The state nearest to a displacement on the curve.
  private pick(mm: number): void {
    if (this.states.length === 0) return;
    let best = 0;
    this.states.forEach((s, k) => {
      if (Math.abs(s.displacement_mm - mm) < Math.abs(this.states[best].displacement_mm - mm)) best = k;
    });
    this.showState(best);
  }
  step(by: number): void {
    if (this.hasResult) this.showState(Math.min(this.states.length - 1, Math.max(0, Number(this.slider.value) + by)));
  }
  // Back to the drawing.
  leave(): void {
    this.watching = false;
    this.curve.cursor = null;
    this.curve.draw();
    this.hide();
    this.watchButton.setAttribute("aria-pressed", "false");
  }
  openReport(): void {
    const { answer } = this;
    if (!answer || !hasPage(answer)) return;
    const page = (answer.bytes?.page as Uint8Array<ArrayBuffer> | undefined) ?? answer.texts.page;
    // it stays as long as this page, so that the report can be loaded again and saved
    answer.address ??= URL.createObjectURL(new Blob([page], { type: "text/html" }));
    window.open(answer.address, "_blank", "noopener");
  }
}

const picture = (state: number): string => `state ${state} svg`;
const card = (name: string, value: string): HTMLElement[] => [h("div", {}, h("dt", {}, name), h("dd", {}, value))];

const hasPage = (answer: Answer): boolean => (answer.bytes?.page?.length ?? answer.texts.page?.length ?? 0) > 0;

// The answer's sentence, as the report's page says it. The page may have many megabytes: only what stands there is read.
const kOfHeadline = 20_000; // bytes, plenty
function headlineOf(answer: Answer): string {
  const piece = pieceOf(answer, "page", '<header id="headline"', kOfHeadline);
  const sentence = new DOMParser().parseFromString(piece, "text/html").querySelector("#headline .answer");
  return sentence?.textContent?.replace(/\s+/g, " ").trim() ?? "";
}
