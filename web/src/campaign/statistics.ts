// Shares of the modes (Fig. 10), Table 3, exceedance and drift limits, running means (Fig. 8).
import { h, onScreen, svg, type Child } from "../base/dom";
import { Figure, legend, swatch } from "../base/figure";
import type { DriftLimit, OfWalls, Precision } from "../headers/statistics";
import { Plot, rangeOf, type Point, type Range } from "../base/plot";
import { pin, sortable, table, type Cell, type Column } from "../base/tables";
import { capital, num, phrase, qty, say } from "../base/texts";
import { drawLimits, limitRows } from "./limits";
import { allFirst, atLeast, modeLabel, quantityLabel, type Campaign, type Quantity } from "./data";

// A value with its interval below it in small print.
export function withInterval(
  value: number | null,
  interval: (number | null)[] | null | undefined,
  digits = 3,
  factor = 1,
): Child {
  const show = (v: number | null | undefined): string =>
    v === null || v === undefined ? "–" : num(v * factor, digits);
  if (!interval || interval[0] === null || interval[0] === undefined) return show(value);
  return [
    show(value),
    h(
      "span",
      { class: "pm" },
      `${show(interval[0])} … ${interval[1] === null ? say("beyond") : show(interval[1])}`,
    ),
  ];
}

// The displacement for which the modes of these samples were evaluated.
export function readWords(campaign: Campaign): string {
  const asked = campaign.statistics.read_modes_at_mm;
  if (!asked) return "";
  const early = campaign.answered
    .filter((s) => s.readEarly)
    .map((s) => s.readAt!);
  const n = campaign.statistics.samples.named_earlier,
    of = campaign.statistics.samples.answered;
  if (n === 0) return say("shares.read_at", { at: qty(asked, "mm") });
  const least = num(Math.min(...early)),
    most = num(Math.max(...early));
  return say(n < of ? "shares.read_some" : "shares.read_all", {
    at: qty(asked, "mm"),
    range: `${least === most ? least : `${least} … ${most}`}\u202fmm`,
    n,
    of,
  });
}

export function shares(campaign: Campaign): HTMLElement | null {
  const all = Object.entries(campaign.statistics.shares);
  if (all.length === 0 || campaign.answered.length === 0) return null;
  const figure = new Figure({
    id: "shares",
    title: say("shares.title"),
    caption: `${say("shares.caption")} ${readWords(campaign)}`,
    draw: (width, onPaper) => {
      const row = onPaper ? 25 : 34,
        left = Math.min(140, Math.max(70, ...all.map(([n]) => 8 * modeLabel(n).length + 12)));
      const most = Math.max(10, ...all.map(([, s]) => 100 * s.share_interval[1]));
      const plot = new Plot({
        width,
        height: row * all.length + 56,
        left,
        top: 6,
        right: 66,
        x: [0, most],
        y: [all.length, 0],
        noY: true,
        xLabel: say("axis.share"),
        yLabel: "",
        title: say("shares.title"),
      });
      all.forEach(([name, s], i) => {
        const single = s.modes.length === 1,
          y = plot.Y(i + 0.5);
        plot
          .bar(
            0,
            100 * s.share,
            i + 0.2,
            i + 0.8,
            `box ${single ? campaign.css(name) : "all faint"}`,
            `${modeLabel(name)}: ${s.count}, ${num(100 * s.share)} %`,
          )
          .setAttribute("data-share", name);
        whisker(plot, 100 * s.share_interval[0], 100 * s.share_interval[1], y);
        plot.text(left - 9, y + 4, modeLabel(name), single ? "strong" : "", { "text-anchor": "end" });
        plot.text(plot.X(100 * s.share_interval[1]) + 7, y + 4, qty(100 * s.share, "%"), "strong halo");
      });
      return plot.svg;
    },
    sheet: () => ({
      head: ["mode", "count", "share", "low", "high"],
      rows: all.map(([n, s]) => [n, s.count, s.share, s.share_interval[0], s.share_interval[1]]),
    }),
  });
  return figure.element;
}

export function whisker(plot: Plot, low: number, high: number, y: number): void {
  const a = plot.X(low),
    b = plot.X(high);
  plot.add(
    svg("path", { class: "whisker", d: `M${a} ${y - 4}V${y + 4}M${a} ${y}H${b}M${b} ${y - 4}V${y + 4}` }),
  );
}

// --- Table 3 ---------------------------------------------------------------------------------------

function rowsOfTable(campaign: Campaign, q: Quantity): (Cell | Child)[][] {
  const table = campaign.statistics.table;
  return allFirst(Object.keys(table)).flatMap((group) => {
    const all = table[group],
      c = all[q.key];
    if (!c || c.n === 0) return [];
    const known = campaign.bounds(q, all.modes);
    // a value, with "≥" where lower bounds make it one; intervals only of known values
    const cell = (key: "mean" | "median" | "survival_mean", bound: boolean): Cell => ({
      show: [
        atLeast(bound),
        bound && known.many ? num(c[key]) : withInterval(c[key]!, c[`${key}_interval`]),
      ],
      sort: c[key] ?? null,
    });
    const plain = (v: number | null): Cell => ({ show: atLeast(known.reach(v)) + num(v), sort: v });
    const cov: Cell = known.many
      ? { show: "–", sort: null }
      : { show: withInterval(c.cov, c.cov_interval, 2), sort: c.cov ?? null };
    const name: Cell = {
      show: h(
        "b",
        { class: all.modes.length === 1 ? `tag-text ${campaign.css(group)}` : "" },
        modeLabel(group),
      ),
      sort: group,
    };
    const count: Cell = {
      show:
        known.count > 0
          ? [String(c.n), h("span", { class: "pm" }, say("table3.censored", { n: known.count }))]
          : String(c.n),
      sort: c.n,
    };
    const far =
      c.percentile_95 === null && q.canBeCensored
        ? say("beyond")
        : atLeast(known.reach(c.percentile_95)) + num(c.percentile_95);
    const row = [
      name,
      count,
      cell("mean", known.count > 0),
      cov,
      cell("median", known.reach(c.median)),
      plain(c.min),
      plain(c.max),
      {
        show: `${atLeast(known.reach(c.percentile_5))}${num(c.percentile_5)} … ${far}`,
        sort: c.percentile_5,
      },
    ];
    const whole = q.canBeCensored ? [...row, cell("survival_mean", known.reach(c.max))] : row;
    return [group === "all" ? pin(whole) : whole];
  });
}

export function tableThree(campaign: Campaign): HTMLElement {
  const place = h("div", { id: "table3-rows" });
  const pick = h(
    "select",
    { id: "table3-quantity" },
    campaign.quantities.map((q, i) => h("option", { value: i }, quantityLabel(q))),
  );
  const heads = (q: Quantity): Column[] => [
    { head: say("mode"), left: true },
    { head: say("samples") },
    { head: say("mean") },
    { head: "CoV" },
    { head: say("median") },
    { head: say("smallest") },
    { head: say("largest") },
    { head: say("table3.range") },
    ...(q.canBeCensored ? [{ head: say("table3.survival"), title: say("table3.survival.means") }] : []),
  ];
  const fill = (): void => {
    const q = campaign.quantities[Number(pick.value)];
    place.replaceChildren(
      sortable(heads(q), rowsOfTable(campaign, q), capital(quantityLabel(q))),
      h("p", { class: "soft small" }, `${capital(say(`quantity.${q.name}.means`))}.`),
    );
  };
  pick.addEventListener("change", fill);
  fill();
  const paper = h(
    "div",
    { class: "print-only" },
    campaign.quantities
      .slice(1, 3)
      .map((q) => table(heads(q), rowsOfTable(campaign, q), capital(quantityLabel(q)))),
  );
  return h(
    "div",
    { class: "panel", id: "table3" },
    h("div", { class: "controls" }, h("label", {}, h("span", {}, say("response")), pick)),
    place,
    paper,
    h("p", { class: "soft small" }, say("table3.lead"), onScreen(` ${say("table.sort")}`)),
  );
}

// --- exceedance ------------------------------------------------------------------------------------

const phi = (z: number): number => 0.5 * erfc(-z / Math.SQRT2);
// Chebyshev fit of Numerical Recipes, error below 1.2e-7.
function erfc(x: number): number {
  const t = 1 / (1 + 0.5 * Math.abs(x));
  const y =
    t *
    Math.exp(
      -x * x -
        1.26551223 +
        t *
          (1.00002368 +
            t *
              (0.37409196 +
                t *
                  (0.09678418 +
                    t *
                      (-0.18628806 +
                        t *
                          (0.27886807 +
                            t * (-1.13520398 + t * (1.48851587 + t * (-0.82215223 + t * 0.17087277)))))))),
    );
  return x >= 0 ? y : 2 - y;
}

export function exceedance(campaign: Campaign, name: string): HTMLElement | null {
  const q = campaign.quantities.find((c) => c.name === name)!;
  const e = campaign.statistics.exceedance[q.key];
  if (!e || e.probability.length < 2 || e.censored === e.n) return null;
  const values = e[`value_${q.unit}`];
  const byDrift = q.unit === "mm" && campaign.loadHeight > 0;
  const factor = byDrift ? campaign.driftPerMillimetre : 1;
  const median = e.lognormal[`median_${q.unit}`] as number | null,
    beta = e.lognormal.beta;
  // for a drift, the axis, its caption and the code's limits are in per cent
  const height = qty(campaign.loadHeight, "m");
  const medianWords =
    byDrift && median !== null ? `${qty(median * factor, "%")} (${qty(median, q.unit)})` : qty(median, q.unit);
  const beyond = median !== null && median > values[values.length - 1] && e.censored > 0;
  return new Figure({
    id: `exceedance-${q.name}`,
    title: capital(say(`exceedance.${q.name}`)),
    above: legend([
      [swatch("step"), say("exceedance.samples")],
      [swatch("spread curve", "box"), say("interval95")],
      [swatch("fit"), say("exceedance.fit")],
    ]),
    caption: [
      say("exceedance.caption", {
        median: medianWords,
        beta: num(beta, 2),
        misfit: num(e.lognormal.misfit, 2),
      }),
      beyond ? ` ${say("exceedance.extrapolated")}` : "",
      e.censored > 0 ? ` ${say("exceedance.censored", { n: e.censored, of: e.n })}` : "",
      byDrift ? ` ${say("exceedance.drift", { height })}` : "",
    ],
    draw: (width, onPaper) => {
      const x = values.map((v) => v * factor);
      const range = rangeOf(x, 0.04),
        span: Range = byDrift ? [0, range[1]] : range;
      const limits = byDrift
        ? limitRows(campaign.statistics.drift_limits, span, width, 16, "near collapse")
        : null;
      const plot = new Plot({
        width,
        height: onPaper ? 0.54 * width : Math.max(260, Math.min(350, 0.62 * width)),
        x: span,
        y: [0, 1],
        top: limits?.top ?? 14,
        xLabel: byDrift
          ? say("axis.drift_of", { height })
          : quantityLabel(q),
        yLabel: say("axis.exceedance"),
        title: say(`exceedance.${q.name}`),
      });
      const step: Point[] = [[plot.spec.x[0], 1]];
      x.forEach((v, i) => step.push([v, i === 0 ? 1 : e.probability[i - 1]], [v, e.probability[i]]));
      plot.band(x, e.low, e.high, "spread curve");
      if (limits) drawLimits(plot, limits);
      plot.line(step, "step", { "data-steps": x.length });
      if (median !== null && beta !== null) {
        const fit = Array.from(
          { length: 121 },
          (_, i) => plot.spec.x[0] + ((plot.spec.x[1] - plot.spec.x[0]) * i) / 120,
        );
        plot.line(
          fit.map((v): Point => [v, v > 0 ? 1 - phi(Math.log(v / (median * factor)) / beta) : 1]),
          "fit",
        );
      }
      return plot.svg;
    },
    sheet: () => ({
      head: [q.key, "probability", "low", "high"],
      rows: values.map((v, i) => [v, e.probability[i], e.low[i], e.high[i]]),
    }),
  }).element;
}

// If every push ended before the limit, its share is only a bound, or not known.
function shareBelow(d: DriftLimit): Child {
  if (d.share_below === null) return say("limit.share.unknown");
  if (!d.share_below_is_lower_bound) return withInterval(d.share_below, d.share_below_interval, 3, 100);
  return say("limit.at_least", { share: num(100 * d.share_below) });
}

export function driftLimits(campaign: Campaign): Child {
  const limits = campaign.statistics.drift_limits;
  if (!limits || limits.length === 0 || !(campaign.loadHeight > 0)) return null;
  return h(
    "div",
    { id: "drift-limits" },
    sortable(
      [
        { head: say("limit.drift") },
        { head: say("limit.for"), left: true },
        { head: say("limit.state"), left: true },
        { head: say("limit.below") },
        { head: say("limit.share") },
      ],
      limits.map((d) => [
        { show: qty(d.limit_drift_percent, "%", 4), sort: d.limit_drift_percent },
        `${phrase(d.element)}, ${phrase(d.mechanism)}`,
        say(`limit.${d.state}`),
        {
          show:
            d.unknown > 0
              ? [String(d.below), h("span", { class: "pm" }, say("limit.unknown", { n: d.unknown }))]
              : String(d.below),
          sort: d.below,
        },
        { show: shareBelow(d), sort: d.share_below },
      ]),
      say("limit.title", { clause: phrase(limits[0].clause) }),
    ),
    h("p", { class: "soft small" }, say("limit.lead", { height: qty(campaign.loadHeight, "m") })),
  );
}

interface Median {
  n: number;
  bounds: number;
  median: number | null;
  at_least: number | null;
  low: number | null;
  high: number | null;
}

// Medians over the walls of this model, with the interval by order statistics; a single wall cannot show it.
export function medians(campaign: Campaign): Child {
  const walls = campaign.statistics.walls;
  if (!walls || campaign.answered.length < 2) return null;
  const show = (v: number | null, of: Median): string =>
    v === null ? (of.bounds > 0 ? say("beyond") : "–") : num(v, 3);
  const row = (what: string, unit: string, of: Median): Cell[] => [
    { show: what },
    { show: of.median === null && of.bounds > 0 ? `> ${num(of.at_least, 3)}` : show(of.median, of) },
    { show: of.n < 6 ? "–" : `${show(of.low, of)} … ${show(of.high, of)}` },
    { show: unit },
    { show: String(of.n) },
    { show: String(of.bounds) },
  ];
  const read = (json: OfWalls): Median => ({
    ...json,
    low: json.median_interval?.[0] ?? null,
    high: json.median_interval?.[1] ?? null,
  });
  const d = walls.drift_capacity;
  const rows = [
    row(say("quantity.peak_reaction"), "kN", read(walls.peak_reaction_kN)),
    row(say("quantity.displacement_at_peak"), "mm", read(walls.displacement_at_peak_mm)),
    ...d.left.map((left, k) =>
      row(say("medians.left", { share: qty(100 * left, "%") }), "mm", {
        n: d.n[k],
        median: d.median_mm[k],
        at_least: d.at_least_mm[k],
        low: d.low_mm[k],
        high: d.high_mm[k],
        bounds: d.bounds[k],
      }),
    ),
  ];
  return h(
    "div",
    { id: "medians" },
    table(
      [
        { head: "", left: true },
        { head: say("medians.median") },
        { head: "95 %" },
        { head: "" },
        { head: say("medians.walls") },
        { head: say("medians.bounds") },
      ],
      rows,
      say("medians.title"),
    ),
    h("p", { class: "soft small" }, say("medians.lead")),
  );
}

// --- running means -----------------------------------------------------------------------------------

export function running(campaign: Campaign): HTMLElement | null {
  const all = campaign.statistics.running;
  if (campaign.answered.length < 3) return null;
  let q = campaign.quantities[0];
  const pick = h(
    "select",
    { "aria-label": say("response") },
    campaign.quantities.map((c, i) => h("option", { value: i }, quantityLabel(c))),
  );
  const caption = h("span");
  const figure = new Figure({
    id: "running",
    title: say("running.title"),
    caption,
    above: h("div", { class: "controls" }, h("label", {}, h("span", {}, say("response")), pick)),
    draw: (width, onPaper) => {
      const r = all[q.key],
        known = campaign.bounds(q);
      caption.textContent =
        say("running.caption") +
        (known.count > 0 ? ` ${say("running.censored", { n: known.count, of: known.of })}` : "");
      // the wide intervals of the first few samples would compress the others
      const from = Math.min(9, r.n.length - 1);
      const y = rangeOf([...r.mean.slice(from), ...r.low.slice(from), ...r.high.slice(from)], 0.05);
      const plot = new Plot({
        width,
        height: onPaper ? 0.5 * width : Math.max(250, Math.min(360, 0.6 * width)),
        x: [0, r.n[r.n.length - 1]],
        y,
        xLabel: say("axis.samples"),
        yLabel: say("axis.mean_of", { what: quantityLabel(q) }),
        title: say("running.title"),
      });
      plot.band(r.n, r.low as number[], r.high as number[], "spread curve");
      plot.line(
        r.n.map((n, i): Point => [n, r.mean[i]!]),
        "step",
        { "data-points": r.n.length },
      );
      return plot.svg;
    },
    sheet: () => ({
      head: ["n", "mean", "low", "high"],
      rows: all[q.key].n.map((n, i) => [
        n,
        all[q.key].mean[i],
        all[q.key].low[i],
        all[q.key].high[i],
      ]),
    }),
  });
  pick.addEventListener("change", () => {
    q = campaign.quantities[Number(pick.value)];
    figure.redraw();
  });
  return figure.element;
}

export function precision(campaign: Campaign): Child {
  const all = campaign.statistics.precision;
  const met = (p: Precision | undefined): Child =>
    p === undefined
      ? ""
      : p.held_from
        ? String(p.held_from)
        : p.expected_at
          ? h("span", { class: "soft" }, `≈ ${p.expected_at}`)
          : "–";
  const block = (
    names: string[],
    width: (v: number | null) => string,
    word: (n: string) => Child,
    title: string,
    unknown: (n: string) => boolean = () => false,
  ): Child => {
    const asked = [
      ...new Set(all.filter((p) => names.includes(p.what)).map((p) => p.half_width_asked)),
    ];
    return table(
      [
        { head: say("precision.what"), left: true },
        { head: say("precision.now") },
        ...asked.map((a) => ({ head: width(a) })),
      ],
      names.map((name) => {
        const of = all.filter((p) => p.what === name);
        if (unknown(name)) return [word(name), "–", ...asked.map(() => "–")];
        return [
          word(name),
          width(of[0]?.half_width_now ?? null),
          ...asked.map((a) => met(of.find((p) => p.half_width_asked === a))),
        ];
      }),
      title,
    );
  };
  const relative = (v: number | null): string => (v === null ? "–" : `±${qty(100 * v, "%", 2)}`);
  const plain = (v: number | null): string => (v === null ? "–" : `±${num(v, 2)}`);
  const quantity = (name: string): Quantity => campaign.quantities.find((q) => q.key === name)!;
  const until = campaign.header.until;
  return [
    block(
      campaign.quantities.map((q) => q.key),
      relative,
      (n) => {
        const known = campaign.bounds(quantity(n));
        return [say(`quantity.${quantity(n).name}`), known.many ? h("span", { class: "pm" }, known.words()) : null];
      },
      say("precision.title"),
      (n) => campaign.bounds(quantity(n)).many,
    ),
    campaign.quantities.some((q) => campaign.bounds(q).many)
      ? h("p", { class: "soft small" }, say("precision.censored"))
      : null,
    block(["share"], plain, () => say("precision.share"), ""),
    until
      ? h(
          "p",
          {},
          say("precision.rule"),
          " ",
          h("code", {}, until.rule),
          `: ${say(until.met ? "precision.rule.met" : "precision.rule.unmet")}; ${phrase(until.measures)}.`,
        )
      : null,
    h("p", { class: "soft small" }, say("precision.lead")),
  ];
}
