// Before and after: one pushed wall is kept, and the next push is compared with it, in numbers and in pictures at one scale.
import { h, svg } from "../../base/dom";
import type { Summary } from "../../headers/run";
import type { Point } from "../../base/plot";
import { num, qty, say } from "../../base/texts";
import type { Line } from "./curve";
import { readPicture } from "../board/picture";

export interface Pushed {
  name: string;
  summary: Partial<Summary>; // the engine's
  points: Point[];
  end: End | null; // a wall that fell under its own loads has none
}
// The wall at the end of its push.
export interface End {
  svg: string; // the engine's picture
  length: number; // of the wall [m]
  displacement_mm: number;
  reaction_kN: number;
}
// What is compared: where the summary has it, where it says that it is a lower bound, and its unit.
const kCompared = [
  ["stiffness", "initial_stiffness_kN_per_mm", "", "kN/mm"],
  ["strength", "peak_reaction_kN", "", "kN"],
  ["displacement", "displacement_at_80_percent_mm", "censored_80", "mm"],
] as const;

const kWhen = ["studio.compare.before", "studio.compare.now"];
const kEdge = 4; // around a picture, for the half of its lines [px of the picture]
const kThin = 0.5; // cracks are drawn for a picture some three times as large
type Pair = [before: Pushed, now: Pushed];

// How much larger, in per cent; with a sign for what is only known from one side.
function change(before: number | null, after: number | null, least: boolean, most: boolean): string {
  if (before === null || after === null || !(before > 0) || (least && most)) return "–";
  const percent = Math.round(100 * (after / before - 1));
  const sign = percent > 0 ? "+" : percent < 0 ? "−" : "±";
  return `${least ? "≥ " : most ? "≤ " : ""}${sign}${num(Math.abs(percent))}\u202f%`;
}

export class Compare {
  kept: Pushed | null = null;
  private pair: Pair | null = null; // what is shown
  readonly root = h("div", { class: "compare", hidden: true });

  line(): Line[] {
    return this.kept ? [{ css: "kept", name: say("studio.kept", { name: this.kept.name }), points: this.kept.points }] : [];
  }
  // The push that is shown, beside the one that is kept.
  show(now: Pushed | null): void {
    const pair: Pair | null = this.kept && now && now !== this.kept ? [this.kept, now] : null;
    this.root.hidden = pair === null;
    if (pair?.[0] === this.pair?.[0] && pair?.[1] === this.pair?.[1]) return;
    this.pair = pair;
    this.root.replaceChildren(...(pair ? [tableOf(pair)] : []));
    if (pair?.[0].end && pair[1].end) void this.addPictures([pair[0].end, pair[1].end], () => pair === this.pair);
  }
  private async addPictures(ends: [End, End], isWanted: () => boolean): Promise<void> {
    const read = [];
    for (const end of ends) read.push(await readPicture(end.svg, end.length, isWanted));
    const [before, now] = read;
    if (!before || !now || !isWanted()) return;
    for (const { shapes } of [before, now]) for (const crack of shapes.querySelectorAll(".crack")) crack.setAttribute("stroke-width", String(kThin * Number(crack.getAttribute("stroke-width"))));
    const walls = [before, now].map(({ shapes, left, bottom, metre }) => svg("g", { transform: `scale(${before.metre / metre}) translate(${-left} ${-bottom})` }, shapes));
    const frames = walls.map((wall, k) => svg("svg", { role: "img", preserveAspectRatio: "xMinYMax", "aria-label": say("studio.compare.picture", { when: say(kWhen[k]) }) }, wall));
    this.root.append(
      h("div", { class: "pair" }, ...ends.map(({ displacement_mm, reaction_kN }, k) => h("figure", {}, frames[k], h("figcaption", {}, h("b", {}, say(kWhen[k])), ` · ${qty(displacement_mm, "mm")} · ${qty(reaction_kN, "kN")}`)))),
      h("p", { class: "soft" }, say("studio.compare.scale")),
    );
    // each has room for both, so that both have one scale, one ground and one left end
    const boxes = frames.map((frame) => frame.getBBox());
    const [x, y] = [Math.min(...boxes.map((b) => b.x)), Math.min(...boxes.map((b) => b.y))];
    const [wide, high] = [Math.max(...boxes.map((b) => b.x + b.width)) - x, Math.max(...boxes.map((b) => b.y + b.height)) - y];
    for (const frame of frames) frame.setAttribute("viewBox", `${x - kEdge} ${y - kEdge} ${wide + 2 * kEdge} ${high + 2 * kEdge}`);
  }
}

function tableOf(pair: Pair): HTMLElement {
  const rows = kCompared.map(([name, key, bound, unit]) => {
    const [a, b] = pair.map((p) => p.summary[key] ?? null);
    const [atLeastBefore, atLeastNow] = pair.map((p) => bound !== "" && p.summary[bound] === true);
    const cell = (value: number | null, atLeast: boolean): string => `${atLeast ? "> " : ""}${qty(value, unit)}`;
    return h("tr", {},
      h("th", { scope: "row" }, say(`studio.compare.${name}`)),
      h("td", {}, cell(a, atLeastBefore)), h("td", {}, cell(b, atLeastNow)),
      h("td", {}, h("b", {}, change(a, b, atLeastNow, atLeastBefore))));
  });
  return h("table", {},
    h("thead", {}, h("tr", {}, h("td", {}), ...[...kWhen, "studio.compare.change"].map((name) => h("th", { scope: "col" }, say(name))))),
    h("tbody", {}, ...rows));
}
