// Before and after: one pushed wall is kept, and the next push is compared with it.
import { h } from "../dom";
import type { Point } from "../plot";
import { num, qty, say } from "../texts";
import type { Line } from "./curve";

export interface Pushed {
  name: string;
  summary: Record<string, unknown>; // the engine's
  points: Point[];
}
// What is compared: where the summary has it, where it says that it is a lower bound, and its unit.
const kCompared = [
  ["stiffness", "initial_stiffness_kN_per_mm", "", "kN/mm"],
  ["strength", "peak_reaction_kN", "", "kN"],
  ["displacement", "displacement_at_80_percent_mm", "censored_80", "mm"],
] as const;

const numberIn = (pushed: Pushed, key: string): number | null => {
  const value = pushed.summary[key];
  return typeof value === "number" ? value : null;
};

// How much larger, in per cent; with a sign for what is only known from one side.
function change(before: number | null, after: number | null, least: boolean, most: boolean): string {
  if (before === null || after === null || !(before > 0) || (least && most)) return "–";
  const percent = Math.round(100 * (after / before - 1));
  const sign = percent > 0 ? "+" : percent < 0 ? "−" : "±";
  return `${least ? "≥ " : most ? "≤ " : ""}${sign}${num(Math.abs(percent))}\u202f%`;
}

export class Compare {
  kept: Pushed | null = null;
  readonly root = h("div", { class: "compare", hidden: true });

  line(): Line[] {
    return this.kept ? [{ css: "kept", name: say("studio.kept", { name: this.kept.name }), points: this.kept.points }] : [];
  }
  // The push that is shown, beside the one that is kept.
  show(now: Pushed | null): void {
    const { kept } = this;
    this.root.hidden = !kept || !now || now === kept;
    if (!kept || !now || now === kept) return;
    const rows = kCompared.map(([name, key, bound, unit]) => {
      const [a, b] = [kept, now].map((p) => numberIn(p, key));
      const [atLeastBefore, atLeastNow] = [kept, now].map((p) => bound !== "" && p.summary[bound] === true);
      const cell = (value: number | null, atLeast: boolean): string => `${atLeast ? "> " : ""}${qty(value, unit)}`;
      return h("tr", {},
        h("th", { scope: "row" }, say(`studio.compare.${name}`)),
        h("td", {}, cell(a, atLeastBefore)), h("td", {}, cell(b, atLeastNow)),
        h("td", {}, h("b", {}, change(a, b, atLeastNow, atLeastBefore))));
    });
    this.root.replaceChildren(
      h("table", {},
        h("thead", {}, h("tr", {}, h("td", {}), ...["before", "now", "change"].map((name) => h("th", { scope: "col" }, say(`studio.compare.${name}`))))),
        h("tbody", {}, ...rows)));
  }
}
