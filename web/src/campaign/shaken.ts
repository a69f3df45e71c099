// A campaign over records: how often each limit state is reached, the response
// at each intensity, the sources of scatter, and shakes that do not count.
import { h, type Child } from "../base/dom";
import { Figure, legend, swatch } from "../base/figure";
import type { Shake } from "../headers/campaign";
import type { IntensityUnit, Scatter, ScatterPart, ShakenFragility } from "../headers/statistics";
import { Plot, type Point } from "../base/plot";
import { zip } from "../run/trust";
import { table } from "../base/tables";
import { num, phrase, qty, say, sentence } from "../base/texts";
import type { Campaign } from "./data";

const kDigits = 3;
const kListed = 200;

// The key of an intensity and its unit, as statistics.json has them.
const keyOf = (campaign: Campaign): IntensityUnit =>
  campaign.statistics.shaking!.measure === "pgv" ? "_m_per_s" : "_m_per_s2";
const unitOf = (campaign: Campaign): string => (campaign.statistics.shaking!.measure === "pgv" ? "m/s" : "m/s²");
const axisOf = (campaign: Campaign): string => {
  const { measure, period_s } = campaign.statistics.shaking!;
  return `${say(`shaken.measure.${measure}`, { period: num(period_s ?? null) })} [${unitOf(campaign)}]`;
};
const end = (value: number | null): string => (value === null ? "?" : num(value, kDigits));
const range = (pair: (number | null)[]): string => `${end(pair[0])} – ${end(pair[1])}`;
const heightFor = (width: number, onPaper: boolean): number =>
  onPaper ? 0.5 * width : Math.max(250, Math.min(350, 0.62 * width));
const verdictWords = (kind: string, verdict: string): string => say(`${kind}.${verdict.replaceAll(" ", "_")}`);

export const isShaken = (campaign: Campaign): boolean => Boolean(campaign.statistics.shaking?.measure);

// --- limit states ----------------------------------------------------------------------------------

function words(campaign: Campaign, f: ShakenFragility): string {
  const key = keyOf(campaign),
    unit = unitOf(campaign),
    out: string[] = [];
  if (f.verdict !== "told") out.push(verdictWords("shaken_verdict", f.verdict));
  else
    out.push(
      say("shaken.words", {
        reached: f.reached,
        n: f.n,
        at: qty(f[`median${key}`], unit),
        low: end(f[`median${key}_interval`]![0]),
        high: end(f[`median${key}_interval`]![1]),
        beta: num(f.beta, 2),
        beta_low: end(f.beta_interval![0]),
        beta_high: end(f.beta_interval![1]),
        by: say(`shaken.by.${f.interval_by!.replaceAll(" ", "_")}`),
      }),
    );
  const lost = f[`median_if_lost${key}`];
  if (f.lost > 0 && lost)
    out.push(
      say("shaken.left_out", { n: f.lost, low: end(lost.reached), high: qty(lost.not_reached, unit) }),
    );
  if (f.came_back > 0) out.push(say("shaken.came_back", { n: f.came_back }));
  return out.join(" ");
}

function draw(campaign: Campaign, f: ShakenFragility, width: number, height: number): SVGSVGElement {
  const key = keyOf(campaign),
    at = f.counts.map((c) => c[`intensity${key}`]);
  // beyond the first intensity at which every sample has reached it, no further one is needed
  const last = f.counts.map((c) => c.n > 0 && c.share! < 1).lastIndexOf(true);
  const most = at[Math.min(last + 2, at.length - 1)];
  const plot = new Plot({
    width,
    height,
    x: [0, 1.04 * most],
    y: [-0.03, 1.03],
    yTicks: [0, 0.25, 0.5, 0.75, 1],
    xLabel: axisOf(campaign),
    yLabel: say("shaken.probability"),
    title: say("shaken.title", { state: f.limit_state }),
  });
  if (f.curve) {
    const x = f.curve[`intensity${key}`];
    if (f.curve.low.every((v) => v !== null)) plot.band(x, f.curve.low as number[], f.curve.high as number[], "spread curve");
    plot.line(zip(x, f.curve.probability), "force");
  }
  for (const [i, count] of f.counts.entries()) {
    if (count.n === 0 || at[i] > most) continue;
    plot.line(
      count.share_interval.map((v): Point => [at[i], v!]),
      "whisker",
    );
    plot.dot(at[i], count.share!, 3.6, "dot m4", { "data-reached": count.reached, "data-n": count.n });
  }
  return plot.svg;
}

function figure(campaign: Campaign, f: ShakenFragility, place: number): Figure {
  const key = keyOf(campaign);
  return new Figure({
    id: `limit-state-${place}`,
    title: say("shaken.title", { state: f.limit_state }),
    caption: words(campaign, f),
    above: legend([
      [swatch("force"), say("shaken.fit")],
      [swatch("whisker"), say("shaken.counts")],
    ]),
    draw: (width, onPaper) => draw(campaign, f, width, heightFor(width, onPaper)),
    sheet: () => ({
      head: [`intensity${key}`, "n", "reached", "share", "low", "high"],
      rows: f.counts.map((c) => [c[`intensity${key}`], c.n, c.reached, c.share, ...c.share_interval]),
    }),
  });
}

export function limitStates(campaign: Campaign): Child {
  const states = campaign.statistics.fragility as ShakenFragility[];
  if (states.length === 0) return null;
  const key = keyOf(campaign),
    told = (f: ShakenFragility, show: () => Child): Child => (f.verdict === "told" ? show() : "–");
  return [
    h("div", { class: "pair" }, states.map((f, i) => figure(campaign, f, i + 1).element)),
    table(
      [
        { head: say("shaken.state"), left: true },
        { head: "n" },
        { head: say("shaken.reached") },
        { head: `${say("shaken.median")} [${unitOf(campaign)}]` },
        { head: "β" },
      ],
      states.map((f) => [
        f.limit_state,
        String(f.n),
        String(f.reached),
        told(f, () => [num(f[`median${key}`], kDigits), h("span", { class: "pm" }, range(f[`median${key}_interval`]!))]),
        told(f, () => [num(f.beta, 2), h("span", { class: "pm" }, range(f.beta_interval!))]),
      ]),
      say("shaken.table"),
    ),
    scatter(states),
  ];
}

function scatter(states: ShakenFragility[]): Child {
  const cell = (s: Scatter, key: ScatterPart): Child =>
    s.verdict === "told" ? [num(s[key], 2), h("span", { class: "pm" }, range(s[`${key}_interval`]!))] : "–";
  const untold = states.filter((f) => f.scatter.verdict !== "told");
  return [
    h("h3", {}, say("shaken.scatter")),
    h("p", { class: "soft" }, say("shaken.scatter.lead")),
    table(
      [
        { head: say("shaken.state"), left: true },
        { head: say("shaken.scatter.record") },
        { head: say("shaken.scatter.wall") },
        { head: say("shaken.scatter.rest") },
      ],
      states.map((f) => [
        f.limit_state,
        cell(f.scatter, "record_to_record"),
        cell(f.scatter, "wall_to_wall"),
        cell(f.scatter, "rest"),
      ]),
      say("shaken.scatter"),
    ),
    untold.map((f) =>
      h("p", { class: "soft small" }, `${f.limit_state}: ${verdictWords("scatter_verdict", f.scatter.verdict)}`),
    ),
  ];
}

// --- response ---------------------------------------------------------------------------------------

export function response(campaign: Campaign): Child {
  const shakes = campaign.header.shakes ?? [];
  if (shakes.length === 0) return null;
  const bySample = new Map<number, Shake[]>();
  for (const shake of shakes) bySample.set(shake.sample, [...(bySample.get(shake.sample) ?? []), shake]);
  const key = keyOf(campaign),
    grid = campaign.statistics.shaking!.intensities;
  const drifts = shakes.filter((s) => !s.collapsed).map((s) => s.drift_percent);
  const most = drifts.length > 0 ? Math.max(...drifts) : 1;
  const strengths = shakes.map((s) => s.intensity);
  const figure = new Figure({
    id: "shaken-response",
    title: say("shaken.ida.title"),
    caption: say("shaken.ida.words"),
    above: legend([
      [swatch("base"), say("shaken.one")],
      [swatch("force"), say("shaken.middle")],
    ]),
    draw: (width, onPaper) => {
      const plot = new Plot({
        width,
        height: heightFor(width, onPaper),
        x: [0, 1.08 * most],
        y: [0, 1.04 * Math.max(...strengths)],
        xLabel: say("shaken.drift"),
        yLabel: axisOf(campaign),
        title: say("shaken.ida.title"),
      });
      for (const of of bySample.values()) {
        of.sort((a, b) => a.intensity - b.intensity);
        const stood = of.filter((s) => !s.collapsed);
        plot.line([[0, 0], ...stood.map((s): Point => [s.drift_percent, s.intensity])], "base");
        const fell = of.find((s) => s.collapsed);
        if (fell) {
          const x = plot.X(1.06 * most),
            y = plot.Y(fell.intensity);
          plot.text(x, y + 3, "▸", "halo small", { "text-anchor": "middle", "data-sample": fell.sample });
        }
      }
      plot.line(
        [
          [0, 0],
          ...grid
            .filter((g) => g.drift_percent_50 !== null)
            .map((g): Point => [g.drift_percent_50!, g[`intensity${key}`]]),
        ],
        "force",
      );
      return plot.svg;
    },
    sheet: () => ({
      head: ["sample", "wall", "record", `intensity${key}`, "drift_percent", "residual_percent", "collapsed"],
      rows: shakes.map((s) => [
        s.sample,
        s.wall,
        campaign.header.records![s.record - 1],
        s.intensity,
        s.drift_percent,
        s.residual_percent,
        s.collapsed ? 1 : 0,
      ]),
    }),
  });
  return figure.element;
}

export function lostShakes(campaign: Campaign): Child {
  const lost = campaign.statistics.shaking!.lost;
  if (lost.length === 0) return null;
  return [
    table(
      [
        { head: say("sample"), left: true },
        { head: `${say("shaken.intensity")} [${unitOf(campaign)}]` },
        { head: say("status"), left: true },
        { head: say("cause"), left: true },
      ],
      lost
        .slice(0, kListed)
        .map((l) => [
          String(l.sample),
          num(l[`intensity${keyOf(campaign)}`], kDigits),
          phrase(l.status),
          l.reason ? sentence(l.reason) : "–",
        ]),
      say("section.lost_shakes"),
    ),
    lost.length > kListed
      ? h("p", { class: "soft small" }, say("unanswered.more", { n: kListed, of: lost.length }))
      : null,
  ];
}
