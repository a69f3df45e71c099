// The page of options side by side, in the order of a reader's questions:
// differences, pairs, failure, which walls gain, lost pairs, and the inputs.
import type { Bundle } from "./base/bundle";
import { h, svg, type Child } from "./base/dom";
import { Figure, hideTip, legend, showTip, swatch } from "./base/figure";
import type { Interval, Maybe } from "./headers/common";
import type { ComparedQuantity as Quantity, ComparisonHeader, Gain, Option, PairedResponse } from "./headers/comparison";
import { provenanceTable } from "./run/inputs";
import { Plot, rangeOf, ticks, type Range } from "./base/plot";
import type { Section } from "./page";
import { table } from "./base/tables";
import { fixed, num, pageUnit, phrase, qty, say, sentence, type Said } from "./base/texts";

const kMostListed = 60;
const kDigits = 3;

const percent = (ratio: Maybe): Maybe => (ratio === null ? null : 100 * (ratio - 1));
const signed = (value: Maybe, unit = "", digits = kDigits): string =>
  value === null ? "–" : `${value > 0 ? "+" : ""}${qty(value, unit, digits)}`;
const between = ([low, high]: Interval, unit = "", sign = true): string => {
  const one = (v: Maybe): string => (v === null ? "…" : sign ? signed(v) : num(v));
  return low === null && high === null ? "–" : `${one(low)} … ${one(high)}${unit ? `\u202f${unit}` : ""}`;
};
const colour = (k: number): string => `m${[3, 1, 5, 6, 2, 7, 4, 8][k % 8]}`;
const quantityWords = (q: Quantity): string => say(`quantity.${q.name}`);

class Comparison {
  readonly header: ComparisonHeader;
  readonly options: Option[];
  readonly quantities: Quantity[];
  readonly inputs: { name: string; unit: string; value: number[] }[];
  constructor(bundle: Bundle<ComparisonHeader>) {
    this.header = bundle.header;
    const c = this.header.comparison;
    this.options = c.option;
    this.quantities = this.header.quantities;
    this.inputs = c.input.map((i) => {
      const [unit, factor] = pageUnit(i.unit);
      return { name: i.name, unit, value: i.value.map((v) => v * factor) };
    });
  }
  get base(): string {
    return this.header.comparison.base.name;
  }
  // Quantities with a mean difference of an option, or with the sign of some differences.
  known(option: Option): Quantity[] {
    return this.quantities.filter((q) => {
      const r = option.response[q.key];
      return r.difference !== null || r.larger + r.smaller + r.equal > 0;
    });
  }
}

const inputLabel = (i: { name: string; unit: string }): string => (i.unit ? `${i.name} [${i.unit}]` : i.name);

// --- what differs ---------------------------------------------------------------------------------------

interface Row {
  words: string;
  css: string;
  value: number;
  interval: Interval;
}

// Ratios of all responses as points with their intervals, the options side by side.
function forest(c: Comparison): HTMLElement | null {
  const blocks = c.quantities
    .map((q) => ({
      q,
      rows: c.options.flatMap((o, k): Row[] => {
        const r = o.response[q.key];
        const value = percent(r.ratio);
        return value === null || r.ratio_interval[0] === null
          ? []
          : [
              {
                words: o.name,
                css: colour(k),
                value,
                interval: [percent(r.ratio_interval[0]), percent(r.ratio_interval[1])],
              },
            ];
      }),
    }))
    .filter((b) => b.rows.length > 0);
  if (blocks.length === 0) return null;
  const all = blocks.flatMap((b) => b.rows);
  const x = rangeOf([0, ...all.flatMap((r) => [r.value, ...r.interval])], 0.06);
  const rowHeight = c.options.length > 1 ? 15 : 22,
    gap = 30;
  const height = blocks.reduce((sum, b) => sum + gap + rowHeight * b.rows.length, 66);
  const figure = new Figure({
    id: "forest",
    title: say("compare.forest", { base: c.base }),
    wide: true,
    caption: say("compare.forest.caption"),
    above: c.options.length > 1 ? legend(c.options.map((o, k) => [swatch(`dot ${colour(k)}`, "dot"), o.name])) : null,
    draw: (width) => {
      const plot = new Plot({
        width,
        height,
        left: 16,
        x,
        y: [0, 1],
        noY: true,
        xTicks: ticks(x, Math.max(2, width / 110)),
        xFormat: (v) => signed(v, "%", 3),
        xLabel: say("compare.change", { base: c.base }),
        yLabel: "",
        title: say("compare.forest", { base: c.base }),
      });
      const zero = plot.X(0);
      plot.add(svg("line", { class: "limit", x1: zero, x2: zero, y1: plot.top, y2: plot.bottom }));
      let y = plot.top;
      for (const { q, rows } of blocks) {
        y += gap;
        plot.text(plot.left + 2, y - 10, quantityWords(q), "small halo");
        for (const r of rows) {
          const at = y + rowHeight / 2 - 2;
          const [a, b] = [plot.X(r.interval[0]!), plot.X(r.interval[1]!)];
          plot.add(
            svg("line", { class: `spread-line ${r.css}`, x1: a, x2: b, y1: at, y2: at }),
            svg(
              "circle",
              { class: `dot ${r.css}`, cx: plot.X(r.value), cy: at, r: 5, "data-ratio": r.value },
              svg("title", {}, `${r.words}: ${signed(r.value, "%")} (${between(r.interval, "%")})`),
            ),
          );
          y += rowHeight;
        }
      }
      return plot.svg;
    },
    sheet: () => ({
      head: ["response", "option", "percent", "low", "high"],
      rows: blocks.flatMap((b) => b.rows.map((r) => [b.q.key, r.words, r.value, ...r.interval])),
    }),
  });
  return figure.element;
}

function share(r: PairedResponse): string {
  const [low, high] = r.share_larger_interval;
  if (r.share_larger === null) return "–";
  return `${r.larger} / ${r.pairs} (${num(100 * (low ?? 0), 2)} … ${num(100 * (high ?? 1), 2)}\u202f%)`;
}

// Says which pairs the means use, if others have bounds.
function boundsWords(r: PairedResponse, q: Quantity): string {
  if (r.in_means === 0) return say("compare.no_mean", { n: r.with_bounds });
  return r.up_to === null
    ? say("compare.in_means", { of: r.in_means, n: r.with_bounds })
    : say("compare.up_to", { at: qty(r.up_to, q.unit), n: r.with_bounds });
}

function differences(c: Comparison, option: Option): Child {
  const known = c.known(option);
  const open = c.quantities.filter((q) => !known.includes(q));
  const rows = known.map((q) => {
      const r = option.response[q.key];
      const what = [
        quantityWords(q),
        r.with_bounds === 0 ? null : h("span", { class: "pm" }, boundsWords(r, q)),
        r.without_value > 0 ? h("span", { class: "pm" }, say("compare.without", { n: r.without_value })) : null,
      ];
      return [
        what,
        qty(r.base, q.unit),
        qty(r.option, q.unit),
        [
          ...(r.difference === null
            ? ["–", h("span", { class: "pm" }, say("compare.median", { range: between(r.median_difference_bounds, q.unit) }))]
            : [signed(r.difference, q.unit), h("span", { class: "pm" }, between(r.difference_interval, q.unit))]),
          r.slow_enough < r.pairs && r.difference_slow_enough !== null
            ? h("span", { class: "pm" }, say("compare.slow_only", { n: r.slow_enough, d: signed(r.difference_slow_enough, q.unit) }))
            : null,
        ],
        [signed(percent(r.ratio), "%"), h("span", { class: "pm" }, between(r.ratio_interval.map(percent), "%"))],
        [share(r), r.undecided > 0 ? h("span", { class: "pm" }, say("compare.undecided", { n: r.undecided })) : null],
        [fixed(r.cov_ratio), h("span", { class: "pm" }, between(r.cov_ratio_interval, "", false))],
        r.worth === null ? "–" : `${num(r.worth, 2)}×`,
      ];
    });
  return [
    differenceTable(c, option, rows),
    open.length > 0
      ? h("p", { class: "soft small" }, say("compare.nothing_known", { list: open.map(quantityWords).join(", ") }))
      : null,
  ];
}

function differenceTable(c: Comparison, option: Option, rows: Child[][]): HTMLElement {
  return table(
    [
      { head: say("response"), left: true },
      { head: c.base },
      { head: option.name },
      { head: say("compare.difference") },
      { head: say("compare.ratio") },
      { head: say("compare.larger"), title: say("compare.larger.title") },
      { head: say("compare.cov_ratio"), title: say("compare.cov_ratio.title") },
      { head: say("compare.worth"), title: say("compare.worth.title") },
    ],
    rows,
    `${option.name}: ${say("compare.pairs", { n: option.pairs })}`,
  );
}

function notes(option: Option): Child {
  return option.notes.length === 0
    ? null
    : h(
        "ul",
        { class: "notes" },
        option.notes.map((n) => h("li", {}, sentence(n))),
      );
}

// --- pair by pair ----------------------------------------------------------------------------------------

class Pairs {
  private option: Option;
  private quantity: Quantity;
  readonly figure: Figure;

  constructor(private readonly c: Comparison) {
    this.option = c.options.find((o) => o.pairs > 0)!;
    this.quantity = c.quantities[0];
    this.figure = new Figure({
      id: "pairs",
      title: say("compare.scatter"),
      caption: say("compare.scatter.caption"),
      above: [
        pickers(c, (o, q) => {
          this.option = o;
          this.quantity = q;
          this.figure.redraw();
        }),
        legend([
          [swatch("dot m3", "dot"), say("compare.mode_kept")],
          [swatch("dot m1", "dot"), say("compare.mode_changed")],
          [swatch("dot censored m3", "dot"), say("compare.bound")],
        ]),
      ],
      draw: (width, onPaper) => this.draw(width, onPaper),
      sheet: () => {
        const p = this.option.response[this.quantity.key].pair;
        return {
          head: ["sample", this.c.base, this.option.name, `${this.c.base}_censored`, `${this.option.name}_censored`],
          rows: p.sample.map((s, i) => [
            s,
            p.base.value[i],
            p.option.value[i],
            ...[p.base, p.option].map((side) => (side.lower_bounds.includes(s) ? 1 : 0)),
          ]),
        };
      },
    });
  }

  private draw(width: number, onPaper: boolean): SVGSVGElement {
    const p = this.option.response[this.quantity.key].pair;
    const both: Range = rangeOf([...p.base.value, ...p.option.value], 0.06);
    const label = (name: string): string => `${name}: ${quantityWords(this.quantity)} [${this.quantity.unit}]`;
    const plot = new Plot({
      width,
      height: onPaper ? 0.85 * width : Math.max(280, Math.min(480, 0.85 * width)),
      x: both,
      y: both,
      xLabel: label(this.c.base),
      yLabel: label(this.option.name),
      title: say("compare.scatter"),
    });
    plot.line([[both[0], both[0]], [both[1], both[1]]], "fit");
    const changed = new Map(this.option.modes.changed.map((m) => [m.sample, m]));
    const bounds = new Set([...p.base.lower_bounds, ...p.option.lower_bounds]);
    p.sample.forEach((sample, i) => {
      const mode = changed.get(sample);
      const dot = plot.dot(
        p.base.value[i],
        p.option.value[i],
        4.5,
        `dot ${mode ? "m1" : "m3"}${bounds.has(sample) ? " censored" : ""}`,
        { "data-sample": sample },
      );
      dot.addEventListener("pointerenter", (e) =>
        showTip(e as PointerEvent, [
          say("sample.n", { n: sample }),
          [this.c.base, qty(p.base.value[i], this.quantity.unit)],
          [this.option.name, qty(p.option.value[i], this.quantity.unit)],
          ...(mode ? [[say("compare.mode"), `${phrase(mode.base)} → ${phrase(mode.option)}`] as [string, string]] : []),
        ]),
      );
      dot.addEventListener("pointerleave", hideTip);
    });
    return plot.svg;
  }
}

// Choices of option and response, where there are several.
function pickers(c: Comparison, chosen: (o: Option, q: Quantity) => void): HTMLElement {
  const usable = c.options.filter((o) => o.pairs > 0);
  const option = h("select", { class: "pick-option" }, usable.map((o, k) => h("option", { value: k }, o.name)));
  const quantity = h("select", { class: "pick-response" });
  const fill = (): void => {
    const kept = quantity.value;
    quantity.replaceChildren(
      ...c.known(usable[Number(option.value) || 0]).map((q) => h("option", { value: q.key }, quantityWords(q))),
    );
    if ([...quantity.options].some((o) => o.value === kept)) quantity.value = kept;
  };
  fill();
  const tell = (): void => {
    const q = c.quantities.find((one) => one.key === quantity.value);
    if (q) chosen(usable[Number(option.value) || 0], q);
  };
  option.addEventListener("change", () => {
    fill();
    tell();
  });
  quantity.addEventListener("change", tell);
  return h(
    "div",
    { class: "controls" },
    usable.length > 1 ? h("label", {}, h("span", {}, say("compare.option")), option) : null,
    h("label", {}, h("span", {}, say("response")), quantity),
  );
}

// --- modes -------------------------------------------------------------------------------------------------

function modes(option: Option): Child {
  const m = option.modes;
  const unclear = m.unclear > 0 ? h("p", { class: "soft small" }, `${option.name}: ${say("compare.unclear", { n: m.unclear })}`) : null;
  const named = m.pairs - m.unclear;
  if (named === 0) return unclear;
  if (m.changed.length === 0)
    return [
      h(
        "p",
        {},
        `${option.name}: ${say("compare.modes_caption", { n: 0, of: named })} (${m.modes.map((mode) => phrase(mode)).join(", ")}).`,
      ),
      unclear,
    ];
  const name = (mode: string): string => phrase(mode);
  const shift = m.shift;
  return h(
    "div",
    { class: "mode-changes" },
    table(
      [
        { head: say("compare.from_to"), left: true },
        ...m.modes.map((mode) => ({ head: name(mode) })),
        { head: say("all") },
      ],
      m.modes.map((mode, i) => [
        name(mode),
        ...m.count[i].map((n, j) => (i === j ? h("b", {}, String(n)) : n === 0 ? "·" : String(n))),
        String(shift[i].base),
      ]),
      `${option.name}: ${say("compare.modes_caption", { n: m.changed.length, of: named })}`,
    ),
    table(
      [
        { head: say("compare.mode"), left: true },
        { head: say("compare.share_shift") },
        { head: say("compare.came") },
        { head: say("compare.went") },
        { head: "p" },
      ],
      shift.map((s) => [
        name(s.mode),
        [
          signed(s.share_difference === null ? null : 100 * s.share_difference, "%", 2),
          h("span", { class: "pm" }, between(s.share_difference_interval.map((v) => (v === null ? null : 100 * v)), "%")),
        ],
        String(s.came),
        String(s.went),
        fixed(s.p_adjusted, 3),
      ]),
      say("compare.shift_caption"),
    ),
    unclear,
    m.changed.length > 0
      ? h(
          "p",
          { class: "soft small" },
          say("compare.changed_samples"),
          " ",
          m.changed
            .slice(0, kMostListed)
            .map((s) => `${s.sample} (${name(s.base)} → ${name(s.option)})`)
            .join(", "),
          m.changed.length > kMostListed ? ", …" : "",
        )
      : null,
  );
}

// --- who gains ---------------------------------------------------------------------------------------------

class Gains {
  private option: Option;
  private quantity: Quantity;
  private input: string;
  readonly element: HTMLElement;
  private readonly figure: Figure;
  private readonly list = h("div");
  private readonly pick = h("select", { class: "pick-input" });

  constructor(private readonly c: Comparison) {
    this.option = c.options.find((o) => c.quantities.some((q) => o.response[q.key].gain.length > 0))!;
    this.quantity = c.quantities.find((q) => this.option.response[q.key].gain.length > 0)!;
    this.input = this.strongest();
    this.figure = new Figure({
      id: "gain",
      title: say("compare.gain"),
      caption: say("compare.gain.caption"),
      above: [
        pickers(c, (o, q) => {
          this.option = o;
          this.quantity = q;
          this.input = this.strongest();
          this.fill();
          this.figure.redraw();
        }),
        h("div", { class: "controls" }, h("label", {}, h("span", {}, say("input")), this.pick)),
      ],
      draw: (width, onPaper) => this.draw(width, onPaper),
      sheet: () => ({ head: ["sample", this.input, "difference"], rows: this.points() }),
    });
    this.pick.addEventListener("change", () => {
      this.input = this.pick.value;
      this.figure.redraw();
    });
    this.fill();
    this.element = h("div", { class: "pair" }, this.figure.element, this.list);
  }

  private get found(): Gain[] {
    return this.option.response[this.quantity.key].gain;
  }
  private strongest(): string {
    const rank = (g: Gain): number => Math.abs(g.spearman ?? 0);
    const best = [...this.found].sort((a, b) => rank(b) - rank(a))[0];
    return best?.input ?? this.c.inputs[0]?.name ?? "";
  }
  private points(): [number, number, number][] {
    const r = this.option.response[this.quantity.key];
    const values = this.c.inputs.find((i) => i.name === this.input)?.value ?? [];
    const cut = (v: number): number => (r.up_to === null ? v : Math.min(v, r.up_to));
    const bounds = new Set(r.up_to === null ? [...r.pair.base.lower_bounds, ...r.pair.option.lower_bounds] : []);
    return r.pair.sample
      .map((s, i): [number, number, number] => [
        s,
        values[s - 1],
        cut(r.pair.option.value[i]) - cut(r.pair.base.value[i]),
      ])
      .filter(([s]) => r.in_means > 0 && !bounds.has(s));
  }
  private fill(): void {
    const unit = this.quantity.unit;
    this.pick.replaceChildren(
      ...this.c.inputs.map((i) => h("option", { value: i.name, selected: i.name === this.input }, inputLabel(i))),
    );
    this.pick.value = this.input;
    this.list.replaceChildren(
      table(
        [
          { head: say("input"), left: true },
          { head: say("compare.spearman"), title: say("scatter.spearman") },
          { head: "p", title: say("compare.p_adjusted") },
          { head: say("compare.low_third") },
          { head: say("compare.high_third") },
        ],
        this.found.map((g) => [
          g.p_adjusted !== null && g.p_adjusted < 0.05 ? h("b", {}, g.input) : g.input,
          [fixed(g.spearman), h("span", { class: "pm" }, between(g.spearman_interval.map((v) => (v === null ? null : Number(v.toFixed(2))))))],
          fixed(g.p_adjusted, 3),
          signed(g.low_third, unit),
          signed(g.high_third, unit),
        ]),
        `${this.option.name}, ${quantityWords(this.quantity)}: ${say("compare.gain.table")}`,
      ),
    );
  }
  private draw(width: number, onPaper: boolean): SVGSVGElement {
    const points = this.points();
    const input = this.c.inputs.find((i) => i.name === this.input)!;
    const plot = new Plot({
      width,
      height: onPaper ? 0.7 * width : Math.max(260, Math.min(400, 0.7 * width)),
      x: rangeOf(points.map((p) => p[1]), 0.04),
      y: rangeOf([0, ...points.map((p) => p[2])], 0.06),
      xLabel: inputLabel(input),
      yLabel: `${say("compare.difference")} [${this.quantity.unit}]`,
      title: say("compare.gain"),
    });
    for (const [sample, x, y] of points) plot.dot(x, y, 4, "dot m3", { "data-sample": sample });
    return plot.svg;
  }
}

// --- lost pairs, what was compared -------------------------------------------------------------------------

function lost(c: Comparison): Child {
  const options = c.options.filter((o) => o.lost > 0);
  if (options.length === 0) return null;
  const side = (status: string, reason: Said, answered: boolean): Child =>
    answered
      ? say("compare.answered")
      : status === ""
        ? say("compare.not_run")
        : [phrase(status), reason ? h("span", { class: "pm" }, sentence(reason)) : null];
  return options.map((o) => [
    table(
      [{ head: say("sample"), left: true }, { head: c.base, left: true }, { head: o.name, left: true }],
      o.lost_pairs
        .slice(0, kMostListed)
        .map((l) => [
          String(l.sample),
          side(l.base_status, l.base_reason, l.base_answered),
          side(l.option_status, l.option_reason, l.option_answered),
        ]),
      `${o.name}: ${say("compare.lost_caption", { n: o.lost, of: o.lost + o.pairs })}`,
    ),
    o.lost > kMostListed ? h("p", { class: "soft small" }, say("compare.lost_more", { n: kMostListed })) : null,
  ]);
}

function compared(c: Comparison): Child {
  const of = c.header.comparison;
  return [
    table(
      [
        { head: say("compare.option"), left: true },
        { head: say("compare.folder"), left: true },
        { head: say("compare.changes"), left: true },
      ],
      [
        [c.base, h("code", {}, of.base.folder), say("compare.is_base")],
        ...c.options.map((o) => [
          o.name,
          h("code", {}, o.folder),
          o.changes.length === 0 ? say("compare.no_changes") : o.changes.map((s) => h("div", {}, h("code", {}, s))),
        ]),
      ],
      say("compare.compared", { n: of.samples }),
    ),
    h("p", { class: "soft small" }, say("compare.lead")),
    provenanceTable([[say("provenance.program"), c.header.provenance || "–"]]),
  ];
}

export function comparisonSections(bundle: Bundle<ComparisonHeader>): Section[] {
  const c = new Comparison(bundle);
  const some = c.options.filter((o) => o.pairs > 0);
  const gain = some.some((o) => c.quantities.some((q) => o.response[q.key].gain.length > 0));
  return [
    {
      id: "differences",
      title: say("section.differences"),
      content: some.length > 0 ? [forest(c), h("div", { class: "spaced" }, some.map((o) => [differences(c, o), notes(o)]))] : c.options.map(notes),
    },
    {
      id: "who",
      title: say("section.pairs"),
      content: some.length > 0 ? h("div", { class: "pair" }, new Pairs(c).figure.element, h("div", {}, some.map(modes))) : null,
    },
    { id: "gains", title: say("section.gains"), content: gain ? new Gains(c).element : null },
    { id: "lost", title: say("section.lost"), content: lost(c) },
    { id: "compared", title: say("section.compared"), content: compared(c) },
  ];
}
