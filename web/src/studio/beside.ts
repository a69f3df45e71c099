// Pushes beside the one that is shown: the same wall the other way, and walls whose strengths scatter. One after another in a
// worker of their own; an edit of the file stops them.
import { h } from "../dom";
import type { Point } from "../plot";
import { phrase, qty, say } from "../texts";
import type { Line } from "./curve";
import { pushOf, setDirection } from "./drawing";
import type { Answer, Engine } from "./engine";
import { kStopped } from "./engine";
import { pointsOf } from "./push";
import type { Project } from "./project";
import { countAt, valueAt, type Doc } from "./toml";

export const kWalls = 8;

// Kinds of masonry whose scatter is known (docs/theory/fields.md), by words in the names of materials.
const kKinds: [RegExp, string][] = [
  [/tuff/, "tuff"],
  [/calcium_silicate/, "calcium_silicate"],
  [/stone|rubble|blocks|granite/, "stone"],
];
export const kindOf = (masonry: string): string => kKinds.find(([words]) => words.test(masonry))?.[1] ?? "clay_brick";

// What makes a wall one of many: the file's own scatter or fields with another seed, else the scatter of its masonry.
export function settingsOfWall(doc: Doc, seed: number): string[] {
  const fields = doc.root.keys.get("field")?.node;
  const names = fields?.kind === "table" ? [...fields.keys.keys()] : [];
  const seeds = names.filter((name) => valueAt(doc, ["field", name, "formula"]) === undefined).map((name) => `field.${name}.seed=${seed}`);
  if (doc.root.keys.has("scatter")) return [`scatter.seed=${seed}`, ...seeds];
  if (seeds.length > 0) return seeds;
  return [`scatter.use="${kindOf(String(valueAt(doc, ["masonry", "use"]) ?? ""))}"`, `scatter.seed=${seed}`];
}
const hasScatter = (doc: Doc): boolean => doc.root.keys.has("scatter") || countAt(doc, ["field"]) > 0 || doc.root.keys.has("field");

interface Peak {
  force: number; // [kN]
}

export class Beside {
  readonly root = h("div", { class: "beside" });
  running: "" | "other" | "walls" = "";
  other: Line | null = null;
  walls: Point[][] = [];
  private peaks: Peak[] = [];
  private otherWords = "";
  private trouble = "";

  constructor(
    private readonly project: Project,
    private readonly engine: Engine,
    private readonly changed: () => void,
  ) {}

  forget(): void {
    this.stop();
    this.other = null;
    this.walls = [];
    this.peaks = [];
    this.otherWords = this.trouble = "";
    this.tell();
  }
  stop(): void {
    if (this.running !== "") this.engine.stop();
  }

  get canTurn(): boolean {
    return this.project.drawable && this.project.doc !== null && pushOf(this.project.doc) !== null;
  }
  async pushOtherWay(): Promise<void> {
    const { project } = this;
    if (this.running !== "" || !this.canTurn) return;
    const way = pushOf(project.doc!)!.direction === "-x" ? "+x" : "-x";
    this.begin("other");
    const { answer, summary } = await this.push(setDirection(project.text, project.drawing!, way), []);
    if (answer.code === 0) {
      const drift = summary.drift_percent_at_peak;
      this.other = { css: "other", name: wayName(way), points: pointsOf(answer) };
      this.otherWords = say("studio.other.answer", { way: wayName(way), force: qty(numberOr(summary.peak_reaction_kN), "kN"), at: qty(numberOr(summary.displacement_at_peak_mm), "mm"), drift: qty(numberOr(drift), "%", 2), mode: phrase(String((summary.failure_mode as { name?: string } | undefined)?.name ?? "–")) });
    }
    this.end(answer);
  }
  async pushWalls(): Promise<void> {
    const { project } = this;
    const { text, doc } = project;
    if (this.running !== "" || !doc) return;
    this.walls = [];
    this.peaks = [];
    this.begin("walls");
    let answer: Answer | null = null;
    for (let seed = 1; seed <= kWalls; ++seed) {
      this.tell(seed);
      const pushed = await this.push(text, settingsOfWall(doc, seed));
      answer = pushed.answer;
      if (answer.code !== 0) break;
      const force = pushed.summary.peak_reaction_kN;
      this.walls.push(pointsOf(answer));
      if (typeof force === "number") this.peaks.push({ force });
      this.changed();
    }
    if (answer) this.end(answer);
  }

  private async push(model: string, set: string[]): Promise<{ answer: Answer; summary: Record<string, unknown> }> {
    const answer = await this.engine.ask({ task: "run", texts: { model, set }, want: ["summary"], tables: ["curve"] });
    return { answer, summary: JSON.parse(answer.texts.summary || "{}") };
  }
  private begin(what: "other" | "walls"): void {
    this.running = what;
    this.trouble = "";
    this.tell();
    this.changed();
  }
  private end(answer: Answer): void {
    this.running = "";
    this.engine.rest();
    if (answer.code !== 0 && answer.code !== kStopped) this.trouble = answer.texts.error ?? "";
    this.tell();
    this.changed();
  }
  private tell(wall = 0): void {
    const words: string[] = [];
    if (this.running === "other") words.push(say("studio.other.running"));
    else if (this.otherWords !== "") words.push(this.otherWords);
    if (this.running === "walls") words.push(say("studio.walls.running", { wall: Math.max(1, wall), count: kWalls }));
    if (this.peaks.length > 1) {
      const forces = this.peaks.map((p) => p.force).sort((a, b) => a - b);
      const median = (forces[(forces.length - 1) >> 1] + forces[forces.length >> 1]) / 2;
      words.push(say("studio.walls.answer", { count: forces.length, median: qty(median, "kN"), low: qty(forces[0], "kN"), high: qty(forces[forces.length - 1], "kN"), scatter: this.scatter() }));
    }
    if (this.trouble !== "") words.push(say("studio.failed", { why: this.trouble }));
    this.root.replaceChildren(...words.map((w) => h("p", {}, w)));
  }
  private scatter(): string {
    const doc = this.project.doc;
    if (doc && hasScatter(doc)) return say("studio.scatter.own");
    return say(`studio.scatter.${kindOf(String((doc && valueAt(doc, ["masonry", "use"])) ?? ""))}`);
  }
}

const wayName = (way: string): string => say(way === "-x" ? "studio.leftwards" : "studio.right");
const numberOr = (value: unknown): number | null => (typeof value === "number" ? value : null);
