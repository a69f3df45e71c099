// The family of curves of one number: the wall is pushed once for each of some values, the nearest to the present one first, and
// a slider goes along them. The pushes are those of one worker, one after another; closing, stopping and any edit of the file but
// to one of these values end them.
import { h, svg } from "../../base/dom";
import { languageNow, num, phrase, qty, say } from "../../base/texts";
import { strengthOf } from "./beside";
import type { Pushed } from "./compare";
import { pointsOf, type Line } from "./curve";
import { answerOf, faultsOf, kStopped, type Engine } from "./engine";
import type { Project } from "../project";
import { whyOf } from "../file/said";
import { nearest, rangeOf, shown, valuesBetween, type Varied } from "./varied";

const kCounts = [5, 6, 7];

interface Member {
  value: number;
  share: number; // of the way from the first to the last
  text: string | null; // the file with this value
  pushed: Pushed | null;
  force: number | null; // the most that it carries [kN]
  trouble: string; // why it has no curve
}

export class Family {
  readonly root: HTMLElement;
  running = false;
  private number: Varied | null = null;
  private members: Member[] = [];
  private at = 0; // of the slider
  private base = ""; // the text that they are values of
  private turn = 0; // of pushes: those of an earlier one count no more
  private under: Member | null = null; // way
  private opener: HTMLElement | null = null;
  private readonly title = h("h2");
  private readonly from = this.limit("from");
  private readonly to = this.limit("to");
  private readonly unit = h("span");
  private readonly count = h("select", { "aria-label": say("studio.family.count"), onchange: () => this.refresh() }, kCounts.map((n) => h("option", { value: n }, say("studio.family.values", { count: n }))));
  private readonly go = h("button", { class: "button small", type: "button", "data-action": "family", onclick: () => (this.running ? this.stop() : void this.push()) });
  private readonly slider = h("input", { type: "range", min: 0, step: 1, oninput: () => this.slide(Number(this.slider.value)) });
  private readonly values = h("ol", { class: "family-values" });
  private readonly scale = h("div", { class: "family-scale" }, this.slider, this.values);
  private readonly words = h("div", { class: "family-words" });
  private readonly status = h("p", { class: "soft", role: "status", "aria-live": "polite" });
  private readonly take = h("button", { class: "button small", type: "button", "data-action": "take", onclick: () => this.takeIt() });

  constructor(
    private readonly project: Project,
    private readonly engine: Engine,
    private readonly known: (text: string) => Pushed | null, // a push that there is already
    private readonly busy: () => boolean, // there is no worker, or it pushes something else
    private readonly changed: () => void, // shows it anew too
  ) {
    this.root = h("section", { class: "family", hidden: true, "aria-label": say("studio.family") },
      h("div", { class: "family-head" }, this.title, this.go, h("button", { class: "button small icon-only", type: "button", title: say("studio.close"), "aria-label": say("studio.family.close"), onclick: () => this.close() }, "×")),
      h("div", { class: "family-range" }, say("studio.family.from"), this.from, say("studio.family.to"), this.to, this.unit, this.count),
      this.scale, this.words, this.status);
    this.root.addEventListener("keydown", (e) => {
      if (e.key === "Enter" && (e.target === this.from || e.target === this.to)) this.go.click();
      if (e.key !== "Escape") return;
      e.stopPropagation();
      this.close();
    });
  }
  private limit(name: "from" | "to"): HTMLInputElement {
    return h("input", { type: "text", inputmode: "decimal", autocomplete: "off", "aria-label": say(`studio.family.${name}`), oninput: () => this.refresh() });
  }

  get isOpen(): boolean {
    return !this.root.hidden;
  }
  open(number: Varied, opener: HTMLElement | null): void {
    this.forget();
    this.number = number;
    this.opener = opener;
    const now = number.now();
    const [low, high] = rangeOf(Number.isFinite(now) ? now : 1, number.whole);
    const plain = (value: number): string => String(Number(value.toPrecision(4)));
    this.from.value = plain(low);
    this.to.value = now === 0 ? "" : plain(high);
    this.root.hidden = false;
    this.changed();
    this.root.scrollIntoView({ block: "nearest" });
    (now === 0 ? this.to : this.go).focus();
  }
  close(): void {
    this.forget();
    this.root.hidden = true;
    this.changed();
    const back = this.opener?.isConnected ? this.opener : document.querySelector<HTMLElement>(".canvas");
    back?.focus();
  }
  private forget(): void {
    this.stop();
    this.members = [];
    this.base = "";
    this.at = 0;
  }
  stop(): void {
    if (!this.running) return;
    this.running = false;
    this.under = null;
    ++this.turn;
    this.engine.stop();
    this.changed();
  }
  // The file is another.
  edited(): void {
    if (this.isOpen && this.isStale) this.stop();
    this.refresh();
  }
  private get isStale(): boolean {
    const { text } = this.project;
    return this.members.length > 0 && text !== this.base && !this.members.some((m) => m.text === text);
  }
  // Between which values, or null.
  private get range(): [number, number] | null {
    const [low, high] = [this.from, this.to].map((field) => (/\d/.test(field.value) ? Number(field.value.trim().replace(",", ".")) : NaN));
    return low < high && (!this.number?.whole || (low >= 1 && Number.isInteger(low) && Number.isInteger(high))) ? [low, high] : null;
  }
  get lines(): Line[] {
    if (!this.isOpen || this.isStale) return [];
    const chosen = this.chosen;
    const line = (m: Member): Line => ({ css: m === chosen ? "member chosen" : "member", name: "", points: m.pushed?.points ?? [], share: m.share });
    const drawn = this.members.filter((m) => m.pushed !== null && m.pushed.points.length > 1);
    return [...drawn.filter((m) => m !== chosen), ...drawn.filter((m) => m === chosen)].map(line);
  }
  get hasResult(): boolean {
    return this.members.some((m) => m.pushed !== null);
  }
  // The push of that text is one of these.
  has(text: string): boolean {
    return this.isOpen && !this.isStale && this.members.some((m) => m.text === text && m.pushed !== null);
  }
  // Of those that have been pushed, the one nearest to the slider.
  private get chosen(): Member | null {
    const done = this.members.filter((m) => m.pushed !== null || m.trouble !== "");
    return done.length === 0 ? null : done[nearest(done.map((m) => this.members.indexOf(m)), this.at)];
  }

  private async push(): Promise<void> {
    const { number, range } = this;
    if (!number || !range) return;
    const now = number.now();
    const values = valuesBetween(...range, Number(this.count.value), now, number.whole);
    this.base = this.project.text;
    this.members = values.map((value, k) => ({ value, share: values.length > 1 ? k / (values.length - 1) : 0, text: value === now ? this.base : number.text(value), pushed: null, force: null, trouble: "" }));
    const first = nearest(values, now);
    this.at = first;
    this.running = true;
    const turn = ++this.turn;
    const order = this.members.map((_, k) => k).sort((a, b) => Math.abs(a - first) - Math.abs(b - first));
    for (const k of order) {
      this.under = this.members[k];
      this.changed();
      const stopped = await this.pushOne(this.under);
      if (turn !== this.turn) return;
      if (stopped) break;
    }
    this.running = false;
    this.under = null;
    this.engine.rest();
    this.changed();
  }
  // Whether it was stopped.
  private async pushOne(member: Member): Promise<boolean> {
    const { text } = member;
    if (text === null) {
      member.trouble = say("studio.family.none");
      return false;
    }
    let why = "";
    let pushed = this.known(text);
    if (!pushed) {
      const answer = await this.engine.ask({ task: "run", texts: { model: text, language: languageNow() }, want: ["summary", "reason"], tables: ["curve"] });
      if (answer.code === kStopped) return true;
      why = answer.texts.reason ?? "";
      if (answer.code === 0) pushed = { name: "", summary: answerOf(answer.texts.summary, {}), points: pointsOf(answer), end: null };
      else member.trouble = say("studio.family.unbuilt", { why: whyOf(answer, faultsOf(answer)[0]) });
    }
    if (!pushed) return false;
    member.pushed = pushed;
    member.force = strengthOf(pushed.summary, pushed.points);
    if (member.force === null) member.trouble = why || String(pushed.summary.status);
    return false;
  }

  private slide(to: number): void {
    this.at = to;
    this.changed();
  }
  // Writes the value into the file, as one step.
  private takeIt(): void {
    const text = this.chosen?.text;
    if (!text) return;
    this.project.endStep();
    this.project.change(text);
  }

  refresh(): void {
    const { number, members, project } = this;
    if (!number) return;
    const now = number.now();
    const stale = this.isStale;
    this.title.textContent = say("studio.family.title", { name: number.name, now: Number.isFinite(now) ? shown(now, number) : "–" });
    this.unit.textContent = number.unit;
    for (const field of [this.from, this.to]) field.setAttribute("aria-invalid", String(field.value.trim() !== "" && !this.range));
    this.go.textContent = this.running ? say("studio.button.stop") : say("studio.family.go", { count: this.count.value });
    this.go.disabled = !this.running && (!this.range || project.broken !== null || !Number.isFinite(now) || this.busy());
    for (const field of [this.from, this.to, this.count]) field.disabled = this.running;
    this.scale.hidden = members.length === 0 || stale;
    this.scale.style.setProperty("--values", String(members.length));
    this.slider.max = String(Math.max(0, members.length - 1));
    this.slider.value = String(this.at);
    this.slider.setAttribute("aria-label", say("studio.family.slider", { name: number.name }));
    const chosen = this.chosen;
    this.slider.setAttribute("aria-valuetext", chosen ? `${shown(chosen.value, number)}: ${forceOf(chosen)}` : "…");
    this.values.replaceChildren(...members.map((m, k) =>
      h("li", { class: m === chosen ? "chosen" : undefined, style: `--share: ${m.share}`, onclick: () => this.slide(k) },
        svg("svg", { class: "curve swatch", viewBox: "0 0 22 6", "aria-hidden": "true" }, svg("path", { class: "line member", d: "M0 3H22" })),
        h("span", {}, num(m.value, 4)), h("span", { class: "soft" }, forceOf(m)))));
    this.words.replaceChildren(...(chosen && !stale ? [this.answer(chosen, number)] : []));
    const words = stale ? say("studio.family.stale") : this.under ? say("studio.family.running", { value: shown(this.under.value, number), done: members.filter((m) => m.pushed || m.trouble).length, count: members.length }) : "";
    if (this.status.textContent !== words) this.status.textContent = words;
  }
  private answer(chosen: Member, number: Varied): HTMLElement {
    this.take.textContent = say("studio.family.take", { value: shown(chosen.value, number) });
    this.take.disabled = chosen.text === null || chosen.text === this.project.text;
    if (chosen.pushed === null || chosen.force === null)
      return h("div", { class: "family-answer" }, h("p", { class: "bad" }, `${shown(chosen.value, number)}: ${chosen.trouble}`));
    const { summary } = chosen.pushed;
    const card = (name: string, value: string): HTMLElement => h("div", {}, h("dt", {}, name), h("dd", {}, value));
    return h("div", { class: "family-answer" },
      h("dl", { class: "key" },
        card(say("studio.peak"), qty(chosen.force, "kN")),
        card(say("studio.compare.stiffness"), qty(summary.initial_stiffness_kN_per_mm, "kN/mm")),
        card(say("studio.mode"), phrase(summary.failure_mode?.name ?? "–"))),
      this.take);
  }
}

const forceOf = (m: Member): string => (m.force !== null ? qty(m.force, "kN") : m.trouble !== "" ? "–" : "…");
