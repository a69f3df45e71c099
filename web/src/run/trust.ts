// Reasons to trust a run: its energy ledger, and how nearly static it was.
import { h, type Child } from "../base/dom";
import { Figure, legend, swatch } from "../base/figure";
import type { QuasiStatic, RunHeader, Summary } from "../headers/run";
import { Plot, rangeOf, type Point, type Range } from "../base/plot";
import { table } from "../base/tables";
import { num, qty, say, sentence } from "../base/texts";

// Columns of force_displacement.csv.
export interface Curve {
  displacement: number[];
  drift: number[];
  reaction: number[];
  base: number[];
  unbalance: number[];
  kinetic: number[];
  factor: number[];
}
export const zip = (x: number[], y: number[]): Point[] => x.map((v, i) => [v, y[i]]);

const kGap = 0.01; // of the ledger; above it a run is not reliable (as in headline.cpp)

// --- energy --------------------------------------------------------------------------------------

export function energySection(header: RunHeader): Child {
  const e = header.summary.energy_J;
  const kParts = ["friction", "fracture", "crushing", "damping", "elastic", "kinetic"] as const;
  const frames = header.frames ?? [],
    ledger = header.energy ?? [];
  const put = Math.max(e.loads, 0) + Math.max(e.drive, 0);
  const share = (j: number): string => (put > 0 ? qty((100 * j) / put, "%") : "–");
  const rows: Child[][] = [[say("energy.drive"), num(e.drive), share(e.drive)]];
  if (e.loads > 0) rows.push([say("energy.loads"), num(e.loads), share(e.loads)]);
  for (const part of kParts)
    rows.push([
      h("span", {}, h("span", { class: `chip e-${part}`, "aria-hidden": "true" }), say(`energy.${part}`)),
      num(e[part]),
      share(e[part]),
    ]);
  if (e.loads < 0) rows.push([say("energy.lifting"), num(-e.loads), share(-e.loads)]);
  const gap = e.gap_ratio ?? NaN,
    bold = (text: string): Child => (Math.abs(gap) > kGap ? h("b", {}, text) : text);
  rows.push([bold(say("energy.gap")), bold(num(e.gap)), bold(qty(100 * gap, "%"))]);
  const list = table(
    [{ head: "", left: true }, { head: "J" }, { head: say("share") }],
    rows.map((r) => r),
    say("energy.table"),
  );
  // the displacement of a shake oscillates, so works are drawn over time
  const overTime = frames.some((f) => typeof f.time_s === "number");
  if (frames.length < 3 || overTime) return [h("p", { class: "soft" }, say("energy.lead")), list];
  // drawn since the first frame
  const from = ledger[0];
  const series = kParts.map((part) => ledger.map((l) => Math.max(0, l[part] - from[part])));
  const x = frames.map((f) => f.displacement_mm);
  const figure = new Figure({
    id: "energy-chart",
    title: say("energy.title"),
    caption: say("energy.caption"),
    above: legend([
      ...kParts.map((part): [SVGSVGElement, Child] => [
        swatch(`area e-${part}`, "box"),
        say(`energy.${part}`),
      ]),
      [swatch("work"), say("energy.work")],
    ]),
    draw: (width) => {
      const total = x.map((_, i) => series.reduce((sum, s) => sum + s[i], 0));
      const work = ledger.map((l) => l.drive - from.drive + l.loads - from.loads);
      const plot = new Plot({
        width,
        height: Math.max(250, Math.min(380, 0.6 * width)),
        x: rangeOf([0, ...x]),
        y: rangeOf([0, ...total, ...work].map((v) => v * 1.04)),
        xLabel: say("axis.displacement"),
        yLabel: say("axis.energy"),
        title: say("energy.title"),
      });
      let low = x.map(() => 0);
      kParts.forEach((part, k) => {
        const high = low.map((v, i) => v + series[k][i]);
        plot.band(x, low, high, `area e-${part}`);
        low = high;
      });
      plot.line(zip(x, work), "work");
      return plot.svg;
    },
    sheet: () => ({
      head: ["displacement_mm", "work_J", ...kParts.map((p) => `${p}_J`)],
      rows: x.map((d, i) => [
        d,
        ledger[i].drive - from.drive + ledger[i].loads - from.loads,
        ...series.map((s) => s[i]),
      ]),
    }),
  });
  return [h("p", { class: "soft" }, say("energy.lead")), h("div", { class: "pair" }, figure.element, list)];
}

// --- trust ---------------------------------------------------------------------------------------

// For a force that was slow enough: whether a slow push would give the same displacement or mode.
function promise(of: "displacement" | "mode", q: QuasiStatic): Child {
  const said = q[of];
  if (q.judgement !== "slow enough" || !said || said.verdict === "no push") return null;
  if (said.verdict === "slow enough") return h("p", { class: "soft" }, say(`trust.${of}`));
  return h("p", { class: "warning" }, `${say(`trust.${of}.not_known`)} ${sentence(said.reason)}`);
}

export function trustSection(summary: Summary, curve: Curve): Child {
  const q = summary.quasi_static;
  // the meaning of a measure is below its name
  const named = (words: string, means: string): Child => [words, h("span", { class: "pm" }, means)];
  const list = table(
    [{ head: say("trust.measure"), left: true }, { head: say("mean") }, { head: say("largest") }],
    [
      [
        named(say("trust.unbalance"), say("trust.unbalance.means")),
        num(q.unbalance_ratio_mean),
        num(q.unbalance_ratio_max),
      ],
      [
        named(say("trust.kinetic"), say("trust.kinetic.means")),
        num(q.kinetic_ratio_mean),
        num(q.kinetic_ratio_max),
      ],
      [named(say("trust.shear"), say("trust.shear.means")), num(q.shear_gap), ""],
      [named(say("trust.damping"), say("trust.damping.means")), num(q.damping_share), ""],
    ],
  );
  const fine = ["slow enough", "no push", undefined].includes(q.judgement);
  const verdict = [
    h("p", { class: fine ? "lead" : "warning" }, sentence(q.verdict)),
    ...(["displacement", "mode"] as const).map((of) => promise(of, q)),
  ];
  const stages =
    summary.stages.length === 0
      ? null
      : table(
          [
            { head: say("stage"), left: true },
            { head: say("stage.time") },
            { head: say("stage.steps") },
            { head: say("stage.unbalance") },
            { head: say("stage.settled") },
          ],
          summary.stages.map((g) => [
            g.name,
            qty(g.time_s, "s"),
            String(g.steps),
            num(g.unbalance_ratio),
            g.settled ? say("yes") : "–",
          ]),
          say("stages"),
        );
  if (curve.displacement.length < 3) return [...verdict, list, stages];
  return [
    ...verdict,
    h("div", { class: "pair" }, ratioFigure(summary, curve).element, h("div", {}, list, stages)),
  ];
}

function ratioFigure(summary: Summary, c: Curve): Figure {
  // ratios near the start, where little work is done, mean nothing
  const counts = c.displacement.map((d) => Math.abs(d) >= 0.1 * (summary.displacement_at_peak_mm ?? 0));
  const positive = [
    ...c.unbalance.filter((v, i) => counts[i] && v > 0),
    ...c.kinetic.filter((v, i) => counts[i] && v > 0),
  ];
  const log10 = (v: number): number => Math.log10(Math.max(1e-9, v));
  const range: Range = [
    Math.floor(log10(Math.min(...positive, 1e-3))),
    Math.ceil(log10(Math.max(...positive, 1e-2))),
  ];
  return new Figure({
    id: "ratios",
    title: say("trust.title"),
    caption: say("trust.caption"),
    above: legend([
      [swatch("force"), say("trust.unbalance")],
      [swatch("base"), say("trust.kinetic")],
    ]),
    draw: (width) => {
      const plot = new Plot({
        width,
        height: Math.max(230, Math.min(330, 0.55 * width)),
        x: rangeOf([0, ...c.displacement]),
        y: range,
        yTicks: Array.from({ length: range[1] - range[0] + 1 }, (_, i) => range[0] + i),
        yFormat: (v) =>
          v === 0 ? "1" : `10${String(v).replace(/./g, (d) => (d === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(d)]))}`,
        xLabel: say("axis.displacement"),
        yLabel: say("axis.ratio"),
        title: say("trust.title"),
      });
      const log = (v: number[]): Point[] =>
        zip(
          c.displacement,
          v.map((x) => (x > 0 ? Math.log10(x) : NaN)),
        );
      plot.line(log(c.kinetic), "base");
      plot.line(log(c.unbalance), "force thin");
      return plot.svg;
    },
    sheet: () => ({
      head: ["displacement_mm", "unbalance_ratio", "kinetic_ratio"],
      rows: c.displacement.map((d, i) => [d, c.unbalance[i], c.kinetic[i]]),
    }),
  });
}
