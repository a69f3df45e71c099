// Inputs: their histograms (Fig. 7), scatter against every response (Fig. 15, 16), and their influence.
import { h, later, onScreen, type Child } from "../base/dom";
import { Figure, hideTip, legend, pointIn, showTip, swatch } from "../base/figure";
import type { Correlation, FirstOrder, Rank } from "../headers/statistics";
import { Plot, rangeOf, type Point } from "../base/plot";
import { sortable } from "../base/tables";
import { fixed, num, pageUnit, phrase, qty, say } from "../base/texts";
import { modeChips } from "./curves";
import {
  allFirst,
  atLeast,
  inputLabel,
  modeLabel,
  quantityLabel,
  type Campaign,
  type Input,
  type Quantity,
  type Sample,
} from "./data";
import { whisker, withInterval } from "./statistics";

const kBars = 20;

function histogram(campaign: Campaign, input: Input): HTMLElement {
  const values = Array.from(input.values as Float32Array).filter(Number.isFinite);
  const low = Math.min(...values),
    high = Math.max(...values);
  const counts = new Array<number>(kBars).fill(0);
  const barOf = (v: number): number => Math.min(kBars - 1, Math.floor(((v - low) / (high - low)) * kBars));
  for (const v of values) ++counts[barOf(v)];
  const width = (high - low) / kBars;
  const figure = new Figure({
    id: `input-${input.name.replace(/[^\w-]/g, "_")}`,
    title: inputLabel(input),
    draw: (w, onPaper) => {
      const density = input.density,
        factor = width * values.length;
      const top = Math.max(...counts, ...(density ? density.y.map((y) => y * factor) : []));
      const plot = new Plot({
        width: w,
        height: onPaper ? 150 : 210,
        left: 44,
        x: [low, high],
        y: [0, 1.08 * top],
        xLabel: inputLabel(input),
        yLabel: say("samples"),
        title: say("histogram.alt", { input: inputLabel(input) }),
      });
      const chosen =
        campaign.picked && campaign.selected ? barOf(input.values[campaign.selected.sample - 1]) : -1;
      counts.forEach((n, b) => {
        if (n > 0)
          plot
            .bar(
              low + b * width,
              low + (b + 1) * width,
              0,
              n,
              b === chosen ? "box chosen" : "box curve-fill",
              `${num(low + b * width)} … ${num(low + (b + 1) * width)}: ${n}`,
            )
            .setAttribute("data-count", String(n));
      });
      if (density)
        plot.line(
          density.x.map((x, i): Point => [x, density.y[i] * factor]),
          "fit",
        );
      return plot.svg;
    },
    sheet: () => ({
      head: ["sample", inputLabel(input)],
      rows: Array.from(input.values as Float32Array).map((v, i) => [i + 1, v]),
    }),
  });
  campaign.onSample(() => figure.redraw());
  return figure.element;
}

const varies = (input: Input): boolean => {
  const [low, high] = rangeOf(Array.from(input.values as Float32Array));
  return input.values.length > 1 && Math.min(...input.values) < Math.max(...input.values) && high > low;
};

export function histograms(campaign: Campaign): Child {
  const random = campaign.inputs.filter((i) => i.random && varies(i));
  const others = campaign.inputs.filter((i) => !i.random && varies(i));
  const more = h("details", {}, h("summary", {}, say("histogram.more", { n: others.length })));
  more.addEventListener("toggle", () => {
    if (!more.querySelector("figure"))
      later(() => {
        more.append(
          h(
            "div",
            { class: "three" },
            others.map((i) => histogram(campaign, i)),
          ),
        );
      });
  });
  return [
    h(
      "div",
      { class: "three", id: "histograms" },
      random.map((i) => histogram(campaign, i)),
    ),
    random.length > 0
      ? h("p", { class: "soft small" }, say("histogram.lead"), onScreen(` ${say("histogram.chosen")}`))
      : null,
    others.length > 0 ? more : null,
  ];
}

export function inputTable(campaign: Campaign): HTMLElement {
  const cell = (v: number | null, digits = 3): { show: string; sort: number | null } => ({
    show: num(v, digits),
    sort: v,
  });
  return sortable(
    [
      { head: say("input"), left: true },
      { head: say("unit"), left: true },
      { head: say("mean") },
      { head: "CoV" },
      { head: say("smallest") },
      { head: say("largest") },
      { head: say("input.kind"), left: true },
    ],
    campaign.inputs.map((i) => {
      const s = campaign.statisticsOf(i.name);
      return [
        i.name,
        i.unit,
        cell(s.mean, 4),
        cell(s.cov),
        cell(s.min),
        cell(s.max),
        {
          show: i.formula ? h("code", {}, i.formula) : phrase(i.distribution ?? ""),
          sort: i.formula ?? i.distribution ?? "",
        },
      ];
    }),
    say("input.table", {
      design: phrase(campaign.statistics.design),
      n: campaign.header.drawn,
      seed: campaign.statistics.seed,
    }),
  );
}

// --- scatter ---------------------------------------------------------------------------------------

const correlationOf = (campaign: Campaign, group: string, response: string, input: string): Correlation | undefined =>
  campaign.statistics.correlation.find(
    (c) => c.group === group && c.response === response && c.input === input,
  );

// The random input with the largest correlation to a response.
function strongest(campaign: Campaign, response: string): Input {
  const rank = (i: Input): number =>
    Math.abs(correlationOf(campaign, "all", response, i.name)?.spearman ?? 0);
  return [...campaign.inputs].sort((a, b) => rank(b) - rank(a))[0];
}

class Scatter {
  private input: Input;
  private readonly figure: Figure;
  private readonly words = h("span");

  constructor(
    private readonly campaign: Campaign,
    private quantity: Quantity,
    id: string,
  ) {
    this.input = strongest(campaign, quantity.key);
    const inputs = h(
      "select",
      { class: "pick-input" },
      campaign.inputs
        .filter(varies)
        .map((i) => h("option", { value: i.name, selected: i === this.input }, inputLabel(i))),
    );
    const responses = h(
      "select",
      { class: "pick-response" },
      campaign.quantities.map((q) =>
        h("option", { value: q.name, selected: q === quantity }, quantityLabel(q)),
      ),
    );
    inputs.addEventListener("change", () => {
      this.input = campaign.inputs.find((i) => i.name === inputs.value)!;
      this.figure.redraw();
    });
    responses.addEventListener("change", () => {
      this.quantity = campaign.quantities.find((q) => q.name === responses.value)!;
      this.figure.redraw();
    });
    this.figure = new Figure({
      id,
      title: say("scatter.title"),
      caption: this.words,
      above: h(
        "div",
        { class: "controls" },
        h("label", {}, h("span", {}, say("input")), inputs),
        h("label", {}, h("span", {}, say("response")), responses),
      ),
      draw: (width, onPaper) => this.draw(width, onPaper),
      sheet: () => ({
        head: ["sample", "failure_mode", this.input.title, this.quantity.key, "censored"],
        rows: this.visible().map((s) => [
          s.sample,
          s.mode,
          this.x(s),
          this.y(s),
          s.censored[this.at] ? 1 : 0,
        ]),
      }),
    });
    campaign.onModes(() => this.figure.redraw());
    campaign.onSample(() => this.figure.redraw());
  }
  get element(): HTMLElement {
    return this.figure.element;
  }
  private get at(): number {
    return this.campaign.quantities.indexOf(this.quantity);
  }
  private visible(): Sample[] {
    return this.campaign.answered.filter((s) => this.campaign.shown(s.mode));
  }
  private readonly x = (s: Sample): number => this.input.values[s.sample - 1];
  private readonly y = (s: Sample): number => s.response[this.at] ?? NaN;

  private draw(width: number, onPaper: boolean): SVGSVGElement {
    const all = this.campaign.answered;
    const plot = new Plot({
      width,
      height: onPaper ? 0.54 * width : Math.max(280, Math.min(400, 0.66 * width)),
      x: rangeOf(all.map(this.x), 0.03),
      y: rangeOf(all.map(this.y), 0.05),
      xLabel: inputLabel(this.input),
      yLabel: quantityLabel(this.quantity),
      title: `${quantityLabel(this.quantity)} – ${inputLabel(this.input)}`,
    });
    for (const s of this.visible()) {
      if (!Number.isFinite(this.y(s))) continue; // no force in balance
      const chosen = this.campaign.picked && this.campaign.selected === s;
      plot.dot(
        this.x(s),
        this.y(s),
        chosen ? 6.5 : 3.8,
        `dot ${this.campaign.css(s.mode)}${s.censored[this.at] ? " censored" : ""}${chosen ? " chosen" : ""}`,
        { "data-sample": s.sample },
      );
    }
    this.caption();
    this.listen(plot);
    return plot.svg;
  }
  private caption(): void {
    const groups = ["all", ...this.campaign.modes.filter((m) => this.campaign.shown(m))];
    const parts = groups
      .map((g): [string, Correlation | undefined] => [g, correlationOf(this.campaign, g, this.quantity.key, this.input.name)])
      .filter(([, c]) => c && c.spearman !== null) as [string, Correlation][];
    const words = (c: Correlation): string =>
      `${fixed(c.spearman)} (${c.spearman_interval?.[0] != null ? `${fixed(c.spearman_interval[0])} … ${fixed(c.spearman_interval[1])}` : "–"})`;
    this.words.replaceChildren(
      ...(parts.length === 0
        ? [say("scatter.none")]
        : [
            `${say("scatter.spearman")}: `,
            h(
              "span",
              { class: "rho" },
              parts.map(([g, c]) =>
                h(
                  "span",
                  { class: g === "all" ? "rho-item" : `rho-item ${this.campaign.css(g)}` },
                  h("b", {}, modeLabel(g)),
                  ` ${words(c)}`,
                ),
              ),
            ),
            this.openWords(),
          ]),
    );
  }
  private openWords(): string {
    const known = this.campaign.bounds(this.quantity);
    return known.count > 0 ? say("scatter.censored", { n: known.count, of: known.of }) : "";
  }
  private nearest(plot: Plot, px: number, py: number): Sample | null {
    let best = 12,
      found: Sample | null = null;
    for (const s of this.visible()) {
      const off = Math.hypot(plot.X(this.x(s)) - px, plot.Y(this.y(s)) - py);
      if (off < best) {
        best = off;
        found = s;
      }
    }
    return found;
  }
  private listen(plot: Plot): void {
    plot.svg.addEventListener("pointermove", (event) => {
      const s = this.nearest(plot, ...pointIn(plot.svg, event));
      if (!s) return hideTip();
      showTip(event, [
        say("sample.n", { n: s.sample }),
        [say("mode"), modeLabel(s.mode)],
        [this.input.name, qty(this.x(s), this.input.unit)],
        [
          say(`quantity.${this.quantity.name}`),
          atLeast(s.censored[this.at]) + qty(this.y(s), this.quantity.unit),
        ],
        say("sample.click"),
      ]);
    });
    plot.svg.addEventListener("pointerleave", hideTip);
    plot.svg.addEventListener("click", (event) => {
      const s = this.nearest(plot, ...pointIn(plot.svg, event));
      if (!s) return;
      hideTip();
      this.campaign.select(s);
      document.getElementById("sample")?.scrollIntoView({ block: "start" });
    });
  }
}

export function scatters(campaign: Campaign): Child {
  if (campaign.answered.length < 2 || campaign.inputs.filter(varies).length === 0) return null;
  return [
    modeChips(campaign),
    h(
      "div",
      { class: "pair" },
      new Scatter(campaign, campaign.quantities[0], "scatter-1").element,
      new Scatter(campaign, campaign.quantities[2], "scatter-2").element,
    ),
  ];
}

// --- sensitivity ---------------------------------------------------------------------------------

const kMeasures = ["spearman", "pearson", "partial_rank", "first_order"] as const;

export function sensitivity(campaign: Campaign): HTMLElement | null {
  const table = campaign.statistics.correlation,
    indices = campaign.statistics.first_order;
  if (table.length === 0) return null;
  let q = campaign.quantities[0],
    measure: (typeof kMeasures)[number] = "spearman",
    group = "all";
  const groups = allFirst([...new Set(table.map((c) => c.group))]);
  const caption = h("span");
  const bars = (): { input: string; value: number | null; interval: (number | null)[] }[] =>
    measure === "first_order"
      ? indices
          .filter((f) => f.response === q.key)
          .map((f) => ({ input: f.input, value: f.index, interval: f.index_interval ?? [null, null] }))
      : table
          .filter((c) => c.group === group && c.response === q.key)
          .map((c) => ({
            input: c.input,
            value: c[measure as Rank],
            interval: c[`${measure as Rank}_interval`] ?? [null, null],
          }));
  const pick = (
    name: string,
    values: readonly string[],
    words: (v: string) => string,
    act: (v: string) => void,
  ): HTMLElement => {
    const select = h(
      "select",
      {},
      values.map((v) => h("option", { value: v }, words(v))),
    );
    select.addEventListener("change", () => {
      act(select.value);
      figure.redraw();
    });
    return h("label", {}, h("span", {}, say(name)), select);
  };
  const figure: Figure = new Figure({
    id: "sensitivity",
    title: say("sensitivity.title"),
    caption,
    wide: true,
    above: h(
      "div",
      { class: "controls" },
      pick(
        "response",
        campaign.quantities.map((c) => c.name),
        (v) => say(`quantity.${v}`),
        (v) => {
          q = campaign.quantities.find((c) => c.name === v)!;
        },
      ),
      pick(
        "measure",
        kMeasures,
        (v) => say(`sensitivity.${v}`),
        (v) => {
          measure = v as typeof measure;
        },
      ),
      pick("mode", groups, modeLabel, (v) => {
        group = v;
      }),
    ),
    draw: (width) => {
      const list = bars().sort((a, b) => Math.abs(b.value ?? 0) - Math.abs(a.value ?? 0));
      const first = measure === "first_order",
        row = 32,
        left = Math.min(180, Math.max(60, ...list.map((b) => 7.5 * b.input.length + 14)));
      const plot = new Plot({
        width,
        height: Math.max(1, list.length) * row + 60,
        left,
        top: 6,
        x: first ? [-0.2, 1] : [-1, 1],
        y: [Math.max(1, list.length), 0],
        noY: true,
        xLabel: say(`sensitivity.${measure}`),
        yLabel: "",
        title: say("sensitivity.title"),
      });
      list.forEach((b, i) => {
        const y = plot.Y(i + 0.5);
        plot.text(left - 9, y + 4, b.input, "", { "text-anchor": "end" });
        if (b.value === null) return;
        plot
          .bar(
            Math.min(0, b.value),
            Math.max(0, b.value),
            i + 0.22,
            i + 0.78,
            `box ${b.value < 0 ? "minus" : "plus"}`,
            `${b.input}: ${num(b.value, 2)}`,
          )
          .setAttribute("data-input", b.input);
        if (b.interval[0] !== null && b.interval[1] !== null) whisker(plot, b.interval[0], b.interval[1], y);
      });
      plot.line(
        [
          [0, 0],
          [0, Math.max(1, list.length)],
        ],
        "axis",
      );
      const censored = campaign.bounds(q, campaign.statistics.table[group]?.modes).count;
      caption.textContent = [
        first ? say("sensitivity.first_order.lead") : say("sensitivity.lead"),
        group !== "all" && !first ? say("sensitivity.inside") : "",
        censored > 0 ? say("sensitivity.censored", { n: censored }) : "",
      ]
        .filter((w) => w)
        .join(" ");
      return plot.svg;
    },
    sheet: () => ({
      head: ["input", measure, "low", "high"],
      rows: bars().map((b) => [b.input, b.value, b.interval[0], b.interval[1]]),
    }),
  });
  return figure.element;
}

const kEntangled = 0.1; // as in wythe/parts/statistics.h
const kNamed = 4;

// Inputs that are correlated share their influence: a caution beside the bars.
export function entangled(campaign: Campaign): Child {
  const pairs = campaign.statistics.input_correlation.filter(
    (c) => c.spearman !== null && Math.abs(c.spearman) > kEntangled,
  );
  if (pairs.length === 0) return null;
  const words = pairs.slice(0, kNamed).map((c) => `${c.a}, ${c.b} (${fixed(c.spearman)})`);
  if (pairs.length > kNamed) words.push(say("sensitivity.more", { n: pairs.length - kNamed }));
  return h(
    "p",
    { class: "warning small", id: "entangled" },
    say("sensitivity.entangled", { pairs: words.join("; ") }),
  );
}

export function sensitivityTable(campaign: Campaign): Child {
  const rows = campaign.statistics.correlation.filter((c) => c.group === "all");
  if (rows.length === 0) return null;
  const indices = campaign.statistics.first_order;
  const of = (c: Correlation, key: Rank): { show: Child; sort: number | null } => ({
    show: withInterval(c[key], c[`${key}_interval`], 2),
    sort: c[key] ?? null,
  });
  return h(
    "details",
    {},
    h("summary", {}, say("sensitivity.all")),
    sortable(
      [
        { head: say("response"), left: true },
        { head: say("input"), left: true },
        ...kMeasures.map((m) => ({ head: say(`sensitivity.${m}`) })),
      ],
      rows.map((c) => {
        const index: Partial<FirstOrder> = indices.find((f) => f.input === c.input && f.response === c.response) ?? {};
        const response = campaign.quantities.find((q) => q.key === c.response)!;
        const known = campaign.bounds(response);
        return [
          {
            show: [
              say(`quantity.${response.name}`),
              known.many ? h("span", { class: "pm" }, known.words()) : null,
            ],
            sort: say(`quantity.${response.name}`),
          },
          c.input,
          of(c, "spearman"),
          of(c, "pearson"),
          of(c, "partial_rank"),
          { show: withInterval(index.index ?? null, index.index_interval, 2), sort: index.index ?? null },
        ];
      }),
      say("sensitivity.table"),
    ),
  );
}

// --- modes against inputs ----------------------------------------------------------------------------

export function modeBins(campaign: Campaign): Child {
  const all = campaign.statistics.mode_against_input;
  if (campaign.modes.length < 2 || all.length === 0) return null;
  return [
    h("h3", {}, say("bins.title")),
    legend(campaign.modes.map((m) => [swatch(`box ${campaign.css(m)}`, "box"), modeLabel(m)])),
    h(
      "div",
      { class: "three", id: "mode-bins" },
      all.map(
        (a) => {
          const [unit, factor] = pageUnit(a.unit),
            label = inputLabel({ name: a.input, unit });
          const bins = a.bins.map((b) => ({ ...b, low: b.low * factor, high: b.high * factor }));
          return new Figure({
            id: `modes-${a.input.replace(/[^\w-]/g, "_")}`,
            title: label,
            draw: (width, onPaper) => {
              // bins meet half-way between their values
              const low = (i: number): number =>
                i === 0 ? bins[0].low : 0.5 * (bins[i - 1].high + bins[i].low);
              const high = (i: number): number => (i + 1 === bins.length ? bins[i].high : low(i + 1));
              const plot = new Plot({
                width,
                height: onPaper ? 180 : 250,
                left: 48,
                x: [low(0), high(bins.length - 1)],
                y: [0, 100],
                xLabel: label,
                yLabel: say("axis.share"),
                title: say("bins.alt", { input: a.input }),
              });
              bins.forEach((bin, i) => {
                let below = 0;
                for (const [mode, s] of Object.entries(bin.share)) {
                  if (!(s.share > 0)) continue;
                  plot.bar(
                    low(i),
                    high(i),
                    below,
                    below + 100 * s.share,
                    `box ${campaign.css(mode)}`,
                    `${modeLabel(mode)}: ${num(100 * s.share)} % (${num(100 * s.share_interval[0], 2)} … ${num(100 * s.share_interval[1], 2)} %), n = ${bin.n}`,
                  );
                  below += 100 * s.share;
                }
              });
              return plot.svg;
            },
            sheet: () => ({
              head: ["low", "high", "n", "mode", "share", "share_low", "share_high"],
              rows: bins.flatMap((b) =>
                Object.entries(b.share).map(([m, s]) => [
                  b.low,
                  b.high,
                  b.n,
                  m,
                  s.share,
                  s.share_interval[0],
                  s.share_interval[1],
                ]),
              ),
            }),
          }).element;
        },
      ),
    ),
    h("p", { class: "soft small" }, say("bins.lead"), onScreen(` ${say("bins.point")}`)),
  ];
}
