// Pushes beside the one that is shown: the same wall the other way, and walls whose strengths scatter. One after another in a
// worker of their own; an edit of the file stops them.
import { h } from "../../base/dom";
import { pushOf, setDirection } from "../stages";
import type { Summary } from "../../headers/run";
import type { Point } from "../../base/plot";
import { languageNow, phrase, qty, say } from "../../base/texts";
import { pointsOf, type Line } from "./curve";
import { answerOf, faultsOf, kStopped, type Answer, type Engine } from "./engine";
import type { Project } from "../project";
import { whyOf } from "../file/said";
import { valueAt, type Doc } from "../file/toml";

export const kWalls = 8;

// Kinds of masonry whose scatter is known (docs/theory/fields.md), by words in the names of materials.
const kKinds: [RegExp, string][] = [
  [/tuff/, "tuff"],
  [/calcium_silicate/, "calcium_silicate"],
  [/stone|rubble|blocks|granite/, "stone"],
];
export const kindOf = (masonry: string): string => kKinds.find(([words]) => words.test(masonry))?.[1] ?? "clay_brick";

// Settings that give the file's own fields another seed; a field by a formula has none.
function seedsOf(doc: Doc, seed: number): string[] {
  const fields = doc.root.keys.get("field")?.node;
  const names = fields?.kind === "table" ? [...fields.keys.keys()] : [];
  return names.filter((name) => valueAt(doc, ["field", name, "formula"]) === undefined).map((name) => `field.${name}.seed=${seed}`);
}
// What makes a wall one of many: the file's own scatter or fields with another seed, else the scatter of its masonry.
export function settingsOfWall(doc: Doc, seed: number): string[] {
  const seeds = seedsOf(doc, seed);
  if (doc.root.keys.has("scatter")) return [`scatter.seed=${seed}`, ...seeds];
  return seeds.length > 0 ? seeds : [`scatter.use="${kindIn(doc)}"`, `scatter.seed=${seed}`];
}
const kindIn = (doc: Doc): string => kindOf(String(valueAt(doc, ["masonry", "use"]) ?? ""));
const scatterOf = (doc: Doc): string => say(`studio.scatter.${doc.root.keys.has("scatter") || seedsOf(doc, 1).length > 0 ? "own" : kindIn(doc)}`);

// The strength of a wall [kN]: 0 where it fell before the push, null where the run gives none.
export function strengthOf(summary: Partial<Summary>, points: Point[]): number | null {
  if (summary.status === "collapsed" && points.length < 2) return 0;
  return isAnswer(summary) && points.length > 1 ? (summary.peak_reaction_kN ?? null) : null;
}
const isAnswer = (summary: Partial<Summary>): boolean => summary.status === "completed" || summary.status === "collapsed";

export class Beside {
  readonly root = h("div", { class: "beside" });
  running: "" | "other" | "walls" = "";
  other: Line | null = null;
  walls: Point[][] = []; // those that have a strength
  private peaks: number[] = []; // theirs [kN]
  private failed = 0; // walls without
  private scatter = ""; // of the text that they are of, in words
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
    this.failed = 0;
    this.otherWords = this.trouble = "";
    this.tell();
  }
  stop(): void {
    if (this.running !== "") this.engine.stop();
  }

  get hasResult(): boolean {
    return this.other !== null || this.walls.length > 0;
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
    const failed = answer.code === 0 && !isAnswer(summary);
    if (answer.code === 0 && !failed) {
      this.other = { css: "other", name: wayName(way), points: pointsOf(answer) };
      this.otherWords = say("studio.other.answer", { way: wayName(way), force: qty(summary.peak_reaction_kN, "kN"), at: qty(summary.displacement_at_peak_mm, "mm"), drift: qty(summary.drift_percent_at_peak, "%", 2), mode: phrase(summary.failure_mode?.name ?? "–") });
    }
    this.end(answer, failed ? answer.texts.reason || String(summary.status) : "");
  }
  async pushWalls(): Promise<void> {
    const { project } = this;
    const { text, doc } = project;
    if (this.running !== "" || !doc) return;
    this.walls = [];
    this.peaks = [];
    this.failed = 0;
    this.scatter = scatterOf(doc);
    this.begin("walls");
    let answer: Answer | null = null;
    for (let seed = 1; seed <= kWalls; ++seed) {
      this.tell(seed);
      const pushed = await this.push(text, settingsOfWall(doc, seed));
      answer = pushed.answer;
      if (answer.code !== 0) break;
      const points = pointsOf(answer),
        force = strengthOf(pushed.summary, points);
      if (force === null) ++this.failed;
      else {
        this.walls.push(points);
        this.peaks.push(force);
      }
      this.changed();
    }
    if (answer) this.end(answer);
  }

  private async push(model: string, set: string[]): Promise<{ answer: Answer; summary: Partial<Summary> }> {
    const answer = await this.engine.ask({ task: "run", texts: { model, set, language: languageNow() }, want: ["summary", "reason"], tables: ["curve"] });
    return { answer, summary: answerOf(answer.texts.summary, {}) };
  }
  private begin(what: "other" | "walls"): void {
    this.running = what;
    this.trouble = "";
    this.tell();
    this.changed();
  }
  private end(answer: Answer, trouble = ""): void {
    this.running = "";
    this.trouble = trouble;
    this.engine.rest();
    if (answer.code !== 0 && answer.code !== kStopped) this.trouble = whyOf(answer, faultsOf(answer)[0]);
    this.tell();
    this.changed();
  }
  private tell(wall = 0): void {
    const words: string[] = [];
    if (this.running === "other") words.push(say("studio.other.running"));
    else if (this.otherWords !== "") words.push(this.otherWords);
    if (this.running === "walls") words.push(say("studio.walls.running", { wall: Math.max(1, wall), count: kWalls }));
    if (this.peaks.length > 1) {
      const forces = [...this.peaks].sort((a, b) => a - b);
      const median = (forces[(forces.length - 1) >> 1] + forces[forces.length >> 1]) / 2;
      words.push(say(forces.length % 2 === 1 ? "studio.walls.odd" : "studio.walls.answer", { count: forces.length, median: qty(median, "kN"), low: qty(forces[0], "kN"), high: qty(forces[forces.length - 1], "kN"), scatter: this.scatter }));
    }
    if (this.failed > 0) words.push(say("studio.walls.failed", { failed: this.failed, count: this.failed + this.peaks.length }));
    if (this.trouble !== "") words.push(say("studio.failed", { why: this.trouble }));
    this.root.replaceChildren(...words.map((w) => h("p", {}, w)));
  }
}

const wayName = (way: string): string => say(way === "-x" ? "studio.leftwards" : "studio.right");
