// A cyclic push: the envelopes on the curve, and the results of each cycle.
import { h, type Child } from "../base/dom";
import type { Cycle, Direction, DriftCapacity, Summary } from "../headers/run";
import type { Section } from "../page";
import type { Plot, Point } from "../base/plot";
import { zip } from "./trust";
import { table } from "../base/tables";
import { ends, num, qty, say } from "../base/texts";

const kMuchDrag = 0.1; // of a loop's energy

export interface Way {
  sign: number;
  readings: Direction;
}
// The two directions of a cyclic push; empty for another push.
export function waysOf(summary: Summary): Way[] {
  const c = summary.cyclic;
  return c
    ? [
        { sign: 1, readings: c.positive },
        { sign: -1, readings: c.negative },
      ]
    : [];
}
// Sense of the main responses: 1 along the push, -1 against it.
export const signOf = (summary: Summary): number => (summary.cyclic?.read_in === "negative" ? -1 : 1);

export function drawEnvelopes(plot: Plot, summary: Summary): void {
  for (const { sign, readings } of waysOf(summary))
    plot.line(
      zip(readings.envelope.displacement_mm, readings.envelope.reaction_kN).map(
        ([x, y]): Point => [sign * x, sign * y],
      ),
      "work",
    );
}

// "12.1 / −11.8", with a dash for a side that the cycle does not reach.
function bothSides(high: number | null, low: number | null): string {
  return high === null || low === null ? num(high ?? low) : `${num(high)} / ${num(low)}`;
}

function cycleRow(c: Cycle, k: number): Child[] {
  const drags =
    !c.in_balance ||
    (c.dissipated_J !== null && Math.abs(c.drag_J!) > kMuchDrag * Math.abs(c.dissipated_J));
  return [
    `${k + 1}, ${say(`cycle.${c.kind}`)}`,
    bothSides(c.displacement_max_mm, c.displacement_min_mm),
    bothSides(c.reaction_max_kN, c.reaction_min_kN),
    c.repeat > 1 ? qty(c.strength_kept === null ? null : 100 * c.strength_kept, "%") : "",
    num(c.stiffness_kN_per_mm),
    bothSides(c.residual_max_mm, c.residual_min_mm),
    num(c.dissipated_J),
    c.damping_ratio === null ? "–" : `${qty(100 * c.damping_ratio, "%")}${drags ? " *" : ""}`,
  ];
}

function directionRow({ sign, readings: r }: Way): Child[] {
  const bound = (censored: boolean): string => (censored ? "≥ " : "");
  return [
    say(sign > 0 ? "cycles.along" : "cycles.against"),
    qty(r.peak_reaction_kN, "kN"),
    qty(r.displacement_at_peak_mm, "mm"),
    bound(r.censored_80) + qty(r.displacement_at_80_percent_mm, "mm"),
    bound(r.censored_max) + qty(r.displacement_max_mm, "mm"),
    qty(r.initial_stiffness_kN_per_mm, "kN/mm"),
    bound(r.bilinear.censored) + num(r.bilinear.ductility),
  ];
}

type Reading = "first_mm" | "lasting_mm" | "last_mm";
type Known = "censored_first" | "censored" | "censored_last";

// d(r) of both directions: the first fall, the one that lasts, the last.
function capacityRow(ways: Way[], k: number): Child[] {
  const one = (d: DriftCapacity, mm: Reading, censored: Known): string =>
    (d[censored][k] && d[mm][k] !== null ? "≥ " : "") + num(d[mm][k]);
  return [
    qty(100 * ways[0].readings.drift_capacity.left[k], "%"),
    ...ways.flatMap(({ readings: { drift_capacity: d } }) => [
      one(d, "first_mm", "censored_first"),
      one(d, "lasting_mm", "censored"),
      one(d, "last_mm", "censored_last"),
    ]),
  ];
}

function dipsOf({ sign, readings }: Way): Child[] {
  return readings.drift_capacity.dips.map((dip) => {
    const [from, back] = ends(dip.from_mm, dip.back_mm, "mm");
    return h(
      "li",
      {},
      say(dip.before_peak ? "cycles.dip.before" : "cycles.dip", {
        direction: say(sign > 0 ? "cycles.along" : "cycles.against"),
        lowest: qty(100 * dip.lowest_left, "%"),
        from,
        back,
      }),
    );
  });
}

function capacityTable(ways: Way[]): Child {
  const heads = ways.flatMap(({ sign }) => {
    const way = say(sign > 0 ? "cycles.along" : "cycles.against");
    return ["first", "lasting", "last"].map((fall) => ({ head: `${way}: ${say(`cycles.${fall}`)}` }));
  });
  return table(
    [{ head: say("cycles.left"), title: say("cycles.left.means") }, ...heads],
    ways[0].readings.drift_capacity.left.map((_, k) => capacityRow(ways, k)),
    say("cycles.capacity"),
  );
}

// The section of a cyclic push; empty for another push.
export function cyclesSection(summary: Summary): Section {
  const section = { id: "cycles", title: say("section.cycles"), content: null as Child };
  const cyclic = summary.cyclic;
  if (!cyclic) return section;
  const rows = cyclic.cycles.map(cycleRow);
  const ways = waysOf(summary);
  const knows = ways.every(({ readings }) => readings.drift_capacity); // absent in results of earlier programs
  const dips = knows ? ways.flatMap(dipsOf) : [];
  const marked = rows.some((r) => String(r[r.length - 1]).endsWith("*"));
  section.content = [
    h("p", {}, say("cycles.lead")),
    table(
      [
        { head: say("cycles.direction"), left: true },
        { head: say("card.peak") },
        { head: say("card.at_peak") },
        { head: say("card.at_80") },
        { head: say("card.max") },
        { head: say("card.stiffness") },
        { head: say("cycles.ductility") },
      ],
      ways.map(directionRow),
      say("cycles.directions"),
    ),
    table(
      [
        { head: say("cycles.cycle"), left: true },
        { head: say("cycles.displacements") },
        { head: say("cycles.forces") },
        { head: say("cycles.kept"), title: say("cycles.kept.means") },
        { head: say("cycles.stiffness"), title: say("cycles.stiffness.means") },
        { head: say("cycles.residual"), title: say("cycles.residual.means") },
        { head: say("cycles.energy"), title: say("cycles.energy.means") },
        { head: say("cycles.damping"), title: say("cycles.damping.means") },
      ],
      rows,
      say("cycles.table"),
    ),
    marked ? h("p", { class: "note" }, say("cycles.drag")) : null,
    h("p", { class: "soft" }, say("cycles.means")),
    knows ? capacityTable(ways) : null,
    dips.length > 0 ? h("ul", {}, dips) : null,
  ];
  return section;
}
