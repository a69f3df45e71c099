// Fragility: the probability of an event given one input or two, with
// its samples; the input to measure next; indices by a surrogate.
import { h, type Child } from "../base/dom";
import { Figure, legend, swatch } from "../base/figure";
import type { Fragility as Event, FragilityInput, FragilityPair } from "../headers/statistics";
import { Plot, rangeOf, type Point } from "../base/plot";
import { sortable } from "../base/tables";
import { capital, num, pageUnit, qty, say } from "../base/texts";
import { inputLabel, modeLabel, type Campaign, type Input } from "./data";
import { withInterval } from "./statistics";

const kLevels = [0.1, 0.5, 0.9];
const kBest = 3; // inputs listed for a response
const kDoubt = 0.05; // p below which a law does not fit, and above which an influence is not significant

export function eventLabel(campaign: Campaign, event: Event): string {
  if (event.response === "failure_mode") return modeLabel(event.mode!);
  const q = campaign.quantities.find((c) => c.name === event.response);
  const what = q ? say(`quantity.${q.name}`) : say("fragility.drift");
  return `${what} > ${qty(event.greater_than, event.unit!)}`;
}

// A sample's height in the figure: samples with the event above, those without below, spread to avoid overlaps.
const scatter = (sample: number): number => ((sample * 0.618034) % 1) * 0.08 + 0.02;
const heightOf = (outcome: number, sample: number): number =>
  outcome === 1 ? 1 + scatter(sample) : outcome === 0 ? -scatter(sample) : 0.5;
const lookOf = (campaign: Campaign, event: Event, outcome: number): string => {
  const colour = event.mode ? campaign.css(event.mode) : "m4";
  return `dot ${outcome === 1 ? colour : outcome === 0 ? `censored ${colour}` : "m0"}`;
};

class Fragility {
  private readonly events: Event[];
  private event: Event;
  private input!: FragilityInput; // set by offer()
  private pair: FragilityPair | null = null;
  private readonly words = h("span");
  private readonly pairWords = h("span");
  private readonly single: Figure;
  private readonly double: Figure;
  private readonly inputs = h("select", { class: "pick-fragility-input" });
  private readonly pairs = h("select", { class: "pick-fragility-pair" });

  constructor(private readonly campaign: Campaign) {
    this.events = campaign.statistics.fragility as Event[];
    // the first event with an input that separates it, or else with a fit
    const has = (is: (i: FragilityInput) => unknown): Event | undefined => this.events.find((e) => e.inputs.some(is));
    this.event =
      has((i) => i.verdict === "separated" || (i.fits[0]?.influence_p ?? 1) < kDoubt) ??
      has((i) => i.curve) ??
      this.events[0];
    const events = h(
      "select",
      { class: "pick-event" },
      this.events.map((e, k) =>
        h("option", { value: String(k), selected: e === this.event }, eventLabel(campaign, e)),
      ),
    );
    events.addEventListener("change", () => {
      this.event = this.events[Number(events.value)];
      this.offer();
      this.single.redraw();
      this.double.redraw();
    });
    this.inputs.addEventListener("change", () => {
      this.input = this.event.inputs.find((i) => i.input === this.inputs.value)!;
      this.single.redraw();
    });
    this.pairs.addEventListener("change", () => {
      this.pair = this.event.pairs[Number(this.pairs.value)];
      this.double.redraw();
    });
    this.offer();
    this.single = new Figure({
      id: "fragility-input",
      title: say("fragility.title"),
      caption: this.words,
      above: [
        h(
          "div",
          { class: "controls" },
          h("label", {}, h("span", {}, say("fragility.event")), events),
          h("label", {}, h("span", {}, say("input")), this.inputs),
        ),
        legend([
          [swatch("step"), say("fragility.line")],
          [swatch("spread curve", "box"), say("interval95")],
        ]),
      ],
      draw: (width, onPaper) => this.drawSingle(width, onPaper),
      sheet: () => ({
        head: ["sample", this.input.input, "outcome"],
        rows: this.event.sample.map((s, i) => [s, this.at(this.input.input, s), this.event.outcome[i]]),
      }),
    });
    this.double = new Figure({
      id: "fragility-pair",
      title: say("fragility.pair.title"),
      caption: this.pairWords,
      above: h("div", { class: "controls" }, h("label", {}, h("span", {}, say("fragility.pair")), this.pairs)),
      draw: (width, onPaper) => this.drawDouble(width, onPaper),
      sheet: () => ({
        head: ["sample", ...this.names(), "outcome"],
        rows: this.event.sample.map((s, i) => [
          s,
          ...this.names().map((n) => this.at(n, s)),
          this.event.outcome[i],
        ]),
      }),
    });
  }
  get element(): HTMLElement {
    return h("div", { class: "pair" }, this.single.element, this.double.element);
  }

  // Fills the choices of the event: the most significant input first, and the pair that adds most.
  private offer(): void {
    const { inputs, pairs } = this.event;
    // an input that separates the samples comes first
    const doubt = (i: FragilityInput): number => (i.verdict === "separated" ? -1 : (i.fits[0]?.influence_p ?? 2));
    this.input = [...inputs].sort((a, b) => doubt(a) - doubt(b))[0];
    const gain = (p: FragilityPair): number => p.added_p ?? 2;
    this.pair = [...pairs].sort((a, b) => gain(a) - gain(b))[0] ?? null;
    this.inputs.replaceChildren(
      ...inputs.map((i) =>
        h("option", { value: i.input, selected: i === this.input }, inputLabel(this.inputOf(i.input))),
      ),
    );
    this.pairs.replaceChildren(
      ...pairs.map((p, k) =>
        h("option", { value: String(k), selected: p === this.pair }, p.inputs.join(", ")),
      ),
    );
  }
  private inputOf(name: string): Input {
    return this.campaign.inputs.find((i) => i.name === name)!;
  }
  private at(name: string, sample: number): number {
    return this.inputOf(name).values[sample - 1];
  }
  // Two inputs to show, also if no pair has a result.
  private names(): string[] {
    const all = this.event.inputs.map((i) => i.input);
    return this.pair?.inputs ?? [all[0], all[1] ?? all[0]];
  }

  private drawSingle(width: number, onPaper: boolean): SVGSVGElement {
    const { event, input } = this,
      shown = this.inputOf(input.input),
      factor = pageUnit(input.unit === "1" ? "" : input.unit)[1];
    const x = event.sample.map((s) => this.at(input.input, s));
    const plot = new Plot({
      width,
      height: onPaper ? 0.5 * width : Math.max(280, Math.min(380, 0.62 * width)),
      x: rangeOf(x, 0.03),
      y: [-0.13, 1.13],
      yTicks: [0, 0.25, 0.5, 0.75, 1],
      xLabel: inputLabel(shown),
      yLabel: say("fragility.axis"),
      title: `${eventLabel(this.campaign, event)} – ${inputLabel(shown)}`,
    });
    if (input.curve) {
      const at = input.curve.input.map((v) => v * factor);
      plot.band(at, input.curve.low, input.curve.high, "spread curve");
      plot.line(
        at.map((v, i): Point => [v, input.curve!.probability[i]]),
        (input.fits[0].fit_p ?? 1) < kDoubt ? "fit" : "step",
        { "data-law": input.curve.law },
      );
    }
    event.outcome.forEach((y, i) =>
      plot.dot(x[i], heightOf(y, event.sample[i]), 3, lookOf(this.campaign, event, y), {
        "data-outcome": y,
      }),
    );
    this.words.textContent = this.singleWords(shown, factor);
    return plot.svg;
  }
  private singleWords(shown: Input, factor: number): string {
    const { event, input } = this,
      words = [say("fragility.lead", { n: event.seen, of: event.n })];
    if (input.verdict !== "told") {
      // the two ends may be close, so they have more digits than other values
      const gap = (input.parted_between ?? []).map((v) => num(v === null ? v : v * factor, 5));
      words.push(
        say(`fragility_verdict.${input.verdict.replace(" ", "_")}`, {
          low: gap[0] ?? "–",
          high: `${gap[1] ?? "–"}\u202f${shown.unit}`,
        }),
      );
    } else {
      const fit = input.fits[0],
        [low, high] = fit.half_at_interval;
      const end = (v: number | null): string => (v === null ? say("beyond") : num(v * factor, 3));
      words.push(say(`fragility_law.${fit.law}`));
      words.push(
        fit.influence_p === null
          ? say("fragility.influence_unknown", { n: event.unknown })
          : fit.influence_p > kDoubt
            ? say("fragility.no_influence", { p: num(fit.influence_p, 2) })
            : say(fit.slope! > 0 ? "fragility.rises" : "fragility.falls"),
      );
      if (fit.influence_p !== null && fit.influence_p <= kDoubt)
        words.push(
          fit.half_at === null
            ? say("fragility.half.none")
            : say("fragility.half", {
                at: qty(fit.half_at * factor, shown.unit),
                low: end(low),
                high: end(high),
              }),
        );
      words.push(
        fit.fit_p === null
          ? say("fragility.fit.none")
          : say(fit.fit_p < kDoubt ? "fragility.fit.bad" : "fragility.fit", { p: num(fit.fit_p, 2) }),
      );
      if (input.entangled_with.length > 0)
        words.push(say("fragility.entangled", { inputs: input.entangled_with.join(", ") }));
    }
    return [...words, ...this.caution()].join(" ");
  }
  private caution(): string[] {
    const { unknown, not_slow_enough, repeated, lost, n } = this.event;
    return [
      unknown > 0 ? say(this.event.mode ? "fragility.unknown.mode" : "fragility.unknown", { n: unknown }) : "",
      not_slow_enough > 0 ? say("fragility.not_slow", { n: not_slow_enough, of: n }) : "",
      repeated > 0 ? say("fragility.repeated", { n: repeated }) : "",
      lost > 0 ? say("fragility.lost", { n: lost }) : "",
    ].filter((w) => w);
  }

  private drawDouble(width: number, onPaper: boolean): SVGSVGElement {
    const { event, pair } = this,
      [a, b] = this.names().map((n) => this.inputOf(n));
    const x = event.sample.map((s) => this.at(a.name, s)),
      y = event.sample.map((s) => this.at(b.name, s));
    const plot = new Plot({
      width,
      height: onPaper ? 0.5 * width : Math.max(280, Math.min(380, 0.62 * width)),
      x: rangeOf(x, 0.03),
      y: rangeOf(y, 0.03),
      xLabel: inputLabel(a),
      yLabel: inputLabel(b),
      title: `${eventLabel(this.campaign, event)} – ${inputLabel(a)}, ${inputLabel(b)}`,
    });
    event.outcome.forEach((o, i) =>
      plot.dot(x[i], y[i], 3.4, lookOf(this.campaign, event, o), { "data-outcome": o }),
    );
    if (pair?.verdict === "told") this.levels(plot, a, b, rangeOf(x), rangeOf(y));
    this.pairWords.textContent = !pair
      ? say("fragility.pair.none")
      : pair.verdict !== "told"
        ? say(`fragility_verdict.${pair.verdict.replace(" ", "_")}`, { low: "–", high: "–" })
        : [
            say("fragility.pair.lead"),
            pair.added_p! === null
              ? say("fragility.pair.unknown", { n: event.unknown })
              : say(pair.added_p! < kDoubt ? "fragility.pair.adds" : "fragility.pair.adds_not", {
                  p: num(pair.added_p, 2),
                }),
            pair.fit_p! !== null && pair.fit_p! < kDoubt ? say("fragility.fit.bad", { p: num(pair.fit_p, 2) }) : "",
          ].join(" ");
    return plot.svg;
  }
  // Lines of equal probability, within the box of the samples: log-odds = c + s1 a + s2 b.
  private levels(plot: Plot, a: Input, b: Input, [left, right]: Point, [low, high]: Point): void {
    const unitOf = (name: string): string => {
      const unit = this.event.inputs.find((i) => i.input === name)!.unit;
      return unit === "1" ? "" : unit;
    };
    const s1 = this.pair!.slope_1! / pageUnit(unitOf(a.name))[1],
      s2 = this.pair!.slope_2! / pageUnit(unitOf(b.name))[1];
    for (const level of kLevels) {
      const odds = Math.log(level / (1 - level)) - this.pair!.intercept!;
      const edge: Point[] = [
        ...[left, right].map((v): Point => [v, (odds - s1 * v) / s2]),
        ...[low, high].map((v): Point => [(odds - s2 * v) / s1, v]),
      ].filter(
        ([u, v]) =>
          u >= left - 1e-9 * (right - left) &&
          u <= right + 1e-9 * (right - left) &&
          v >= low - 1e-9 * (high - low) &&
          v <= high + 1e-9 * (high - low),
      );
      if (edge.length < 2) continue;
      edge.sort((p, q) => p[0] - q[0] || p[1] - q[1]);
      const ends: Point[] = [edge[0], edge[edge.length - 1]];
      plot.line(ends, level === 0.5 ? "step" : "fit", { "data-level": level });
      plot.text(plot.X(ends[1][0]) - 4, plot.Y(ends[1][1]) - 4, num(level), "halo", { "text-anchor": "end" });
    }
  }
}

export function fragility(campaign: Campaign): Child {
  const events = campaign.statistics.fragility as Event[] | undefined;
  if (!events || events.length === 0 || events[0].inputs.length === 0) return null;
  return new Fragility(campaign).element;
}

// Per cent; the estimate of a share scatters below 0 if there is no influence.
const percent = (value: number | null, interval: (number | null)[]): { show: Child; sort: number | null } => ({
  show: withInterval(
    Math.max(0, value ?? 0),
    interval.map((v) => (v === null ? v : Math.min(1, Math.max(0, v)))),
    2,
    100,
  ),
  sort: value,
});
const responseOf = (campaign: Campaign, key: string): string => {
  const q = campaign.quantities.find((c) => c.key === key);
  return q ? say(`quantity.${q.name}`) : key;
};

// The input to measure next: the estimated gain from each.
export function measuring(campaign: Campaign): Child {
  const all = campaign.statistics.measuring ?? [];
  // the best few of each response
  const rows = all.filter(
    (m, i) =>
      m.variance_share !== null &&
      all.slice(0, i).filter((o) => o.response === m.response).length < kBest,
  );
  if (all.length === 0) return null;
  const censored = rows.filter((m) => m.censored > 0).map((m) => m.response);
  const untold = all.filter((m) => m.variance_share === null).map((m) => m.response);
  const named = (keys: string[]): string => [...new Set(keys)].map((k) => responseOf(campaign, k)).join(", ");
  const soft = (key: string, of: string[]): Child =>
    of.length > 0 ? h("p", { class: "soft small" }, say(key, { responses: named(of) })) : null;
  return [
    h("h3", {}, say("measuring.title")),
    rows.length > 0
      ? h(
          "div",
          { id: "measuring" },
          sortable(
            [
              { head: say("response"), left: true },
              { head: say("input"), left: true },
              { head: say("measuring.variance") },
              { head: say("measuring.width") },
              { head: say("measuring.best") },
            ],
            rows.map((m) => [
              responseOf(campaign, m.response),
              m.input,
              percent(m.variance_share, m.variance_share_interval),
              percent(m.width_share, m.width_share_interval),
              { show: num(100 * m.is_best!, 2), sort: m.is_best },
            ]),
            say("measuring.lead"),
          ),
        )
      : null,
    soft("measuring.censored", censored),
    soft("measuring.untold", untold),
  ];
}

// First-order and total indices by a surrogate, or the reason why there are none.
export function surrogateIndices(campaign: Campaign): Child {
  const all = campaign.statistics.surrogate_indices ?? [];
  if (all.length === 0) return null;
  const told = all.filter((r) => r.verdict === "told");
  return h(
    "details",
    { id: "surrogate-indices" },
    h("summary", {}, say("indices.title")),
    told.length > 0
      ? sortable(
          [
            { head: say("response"), left: true },
            { head: say("input"), left: true },
            { head: say("sensitivity.first_order") },
            { head: say("indices.total") },
          ],
          told.flatMap((r) =>
            r.inputs.map((i) => [
              responseOf(campaign, r.response),
              i.input,
              { show: withInterval(i.first_order, i.first_order_interval, 2), sort: i.first_order },
              { show: withInterval(i.total, i.total_interval, 2), sort: i.total },
            ]),
          ),
          say("indices.lead"),
        )
      : null,
    all.map((r) =>
      h(
        "p",
        { class: "soft small" },
        `${capital(responseOf(campaign, r.response))}: ${say(`indices_verdict.${r.verdict.replace(" ", "_")}`, {
          q2: r.q2 === null ? "–" : num(100 * r.q2, 2),
          asked: num(100 * r.q2_asked, 2),
          n: r.n,
        })}`,
      ),
    ),
  );
}
