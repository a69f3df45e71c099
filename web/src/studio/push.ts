// The push: its curve while it runs, and what came out: a sentence, key numbers, the cracks at each state.
import { h } from "../dom";
import { num, phrase, qty, say } from "../texts";
import { Curve } from "./curve";
import { pushOf } from "./drawing";
import type { Answer, Engine } from "./engine";
import { kStopped } from "./engine";
import { readPicture, type Picture } from "./picture";
import type { Fault, Project } from "./project";
import { lengthOf, readQuantity } from "./units";

interface StoredState {
  label: string;
  displacement_mm: number;
  reaction_kN: number;
}
const kStates = 16; // pictures along the push, besides those that the file asks for
const kMostStates = 60; // pictures that are asked for; the answer has those that there are
const kFrames = 40; // of the report's film

export class Push {
  readonly root: HTMLElement;
  readonly curve = new Curve();
  running = false;
  private states: StoredState[] = [];
  private pictures: (Picture | null)[] = [];
  private page = "";
  private length = 1; // of that wall [m]
  private ofText = ""; // the text that was pushed
  private readonly words = h("div", { class: "result-words", role: "status", "aria-live": "polite" });
  private readonly slider = h("input", { type: "range", min: 0, max: 0, step: 1, value: 0, "aria-label": say("studio.state") });
  private readonly at = h("output", { class: "soft" });
  private readonly states_row: HTMLElement;
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": say("studio.progress"), hidden: true });
  private readonly back = h("button", { class: "button small", type: "button", onclick: () => this.leave() }, say("studio.back"));
  private readonly report = h("button", { class: "button small", type: "button", hidden: true, onclick: () => this.openReport() }, say("studio.report"));

  constructor(
    private readonly project: Project,
    private readonly engine: Engine,
    private readonly language: () => string,
    private readonly show: (picture: Picture | null) => void, // cracks, or the wall as it is drawn
    private readonly refused: (faults: Fault[]) => void,
    private readonly changed: () => void,
  ) {
    this.states_row = h("div", { class: "states", hidden: true }, h("span", {}, say("studio.cracks")), this.slider, this.at, this.back, this.report);
    this.slider.addEventListener("input", () => this.showState(Number(this.slider.value)));
    this.curve.pick = (mm) => this.pick(mm);
    this.root = h("section", { class: "push", "aria-label": say("studio.push") },
      this.bar,
      h("div", { class: "curve-box" }, this.curve.root),
      h("div", { class: "result", tabindex: "0", role: "group", "aria-label": say("studio.result") }, this.states_row, this.words));
    this.say(h("p", { class: "soft" }, say("studio.push.before")));
  }

  private say(...what: Node[]): void {
    this.words.replaceChildren(...what);
  }
  // The wall was edited: what is shown belongs to the one before.
  edited(): void {
    if (this.ofText === "") return;
    const stale = this.ofText !== this.project.text;
    this.root.classList.toggle("stale", stale);
    if (stale) this.leave();
  }
  get hasResult(): boolean {
    return this.states.length > 0;
  }

  async start(): Promise<void> {
    if (this.running) return;
    const { project, curve } = this;
    const text = (this.ofText = project.text);
    this.length = project.drawing?.length ?? 1;
    this.running = true;
    this.states = [];
    this.pictures = [];
    this.page = "";
    this.report.hidden = this.states_row.hidden = true;
    this.root.classList.remove("stale");
    curve.points = [];
    curve.peak = curve.cursor = null;
    curve.until = this.until() || 20;
    curve.draw();
    this.bar.value = 0;
    this.bar.hidden = false;
    this.say(h("p", {}, say("studio.pushing")));
    this.changed();
    const answer = await this.engine.ask(
      { task: "run", texts: { model: text, set: this.settings(), language: this.language() }, numbers: { frames: kFrames }, want: ["summary", "states", "page", ...Array.from({ length: kMostStates }, (_, k) => `state ${k} svg`)], tables: ["curve"] },
      (p) => {
        this.bar.value = p.share;
        // the curve belongs to the push, not to the loads before it
        if (p.displacement_mm !== 0) curve.points.push([p.displacement_mm, p.reaction_kN]);
        curve.draw();
        this.say(h("p", { class: "live" }, h("b", {}, qty(p.reaction_kN, "kN")), ` ${say("studio.at", { at: qty(p.displacement_mm, "mm") })} `, h("span", { class: "soft" }, `${Math.round(100 * p.share)} %`)));
      },
    );
    this.running = false;
    this.bar.hidden = true;
    if (answer.code === 0) this.done(answer);
    else if (answer.code === kStopped) this.say(h("p", {}, say("studio.stopped")));
    else if (answer.code === 2) {
      this.say(h("p", {}, say("studio.refused")));
      this.refused(faultsOf(answer));
    } else this.say(h("p", { class: "bad" }, say("studio.failed", { why: answer.texts.error ?? "" })));
    this.changed();
    this.edited();
  }
  stop(): void {
    this.engine.stop();
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

  private done(answer: Answer): void {
    const summary = JSON.parse(answer.texts.summary ?? "{}");
    const table = answer.tables.curve;
    const { curve } = this;
    if (table) {
      curve.points = [];
      table.displacement_mm.forEach((x, k) => curve.points.push([x, table.reaction_kN[k]]));
    }
    this.states = JSON.parse(answer.texts.states ?? "[]");
    this.pictures = this.states.map((_, k) => readPicture(answer.texts[`state ${k} svg`] ?? "", this.length));
    this.page = answer.texts.page ?? "";
    const number = (key: string): number | null => (typeof summary[key] === "number" ? summary[key] : null);
    const peak = number("peak_reaction_kN"),
      at = number("displacement_at_peak_mm");
    curve.peak = peak !== null && at !== null ? [at, peak] : null;
    this.say(
      h("dl", { class: "key" },
        ...card(say("studio.peak"), qty(peak, "kN")),
        ...card(say("studio.peak.drift"), qty(number("drift_percent_at_peak"), "%", 2)),
        ...card(say("studio.ultimate"), `${summary.censored_80 ? "> " : ""}${qty(number("drift_percent_at_80"), "%", 2)}`),
        ...card(say("studio.mode"), phrase(String(summary.failure_mode?.name ?? "–"))),
      ),
      h("p", { class: "answer" }, headlineOf(this.page) || say("run.resists", { force: qty(peak, "kN"), at: qty(at, "mm"), drift: "" })),
    );
    this.report.hidden = this.page === "";
    this.slider.max = String(this.states.length - 1);
    this.states_row.hidden = this.states.length === 0;
    const end = this.states.length - 1;
    if (end >= 0 && this.ofText === this.project.text) this.showState(end);
    curve.draw();
  }

  showState(k: number): void {
    const state = this.states[k];
    if (!state) return;
    this.slider.value = String(k);
    this.slider.setAttribute("aria-valuetext", `${num(state.displacement_mm)} mm, ${num(state.reaction_kN)} kN`);
    this.at.textContent = `${qty(state.displacement_mm, "mm")} · ${qty(state.reaction_kN, "kN")}`;
    this.curve.cursor = state.displacement_mm;
    this.curve.draw();
    this.root.classList.remove("stale");
    this.show(this.pictures[k]);
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
    this.curve.cursor = null;
    this.curve.draw();
    this.show(null);
  }
  openReport(): void {
    if (this.page === "") return;
    const url = URL.createObjectURL(new Blob([this.page], { type: "text/html" }));
    window.open(url, "_blank", "noopener");
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
  }
}

const card = (name: string, value: string): HTMLElement[] => [h("div", {}, h("dt", {}, name), h("dd", {}, value))];

export function faultsOf(answer: Answer): Fault[] {
  const list = JSON.parse(answer.texts.faults || "[]") as Partial<Fault>[];
  return list.map((f) => ({ line: Number(f.line) || 1, path: String(f.path ?? ""), value: String(f.value ?? ""), problem: String(f.problem ?? ""), cure: String(f.cure ?? "") }));
}

// The answer's sentence, as the report's page says it.
function headlineOf(page: string): string {
  if (page === "") return "";
  const answer = new DOMParser().parseFromString(page, "text/html").querySelector("#headline .answer");
  return answer?.textContent?.replace(/\s+/g, " ").trim() ?? "";
}
