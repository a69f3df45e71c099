// All force-displacement curves by failure mode (Fig. 20), and their means against drift (Fig. 21).
import { append, h, onScreen, svg, type Child } from "../base/dom";
import { Figure, hideTip, legend, pointIn, showTip, swatch } from "../base/figure";
import type { DriftLimit, MeanCurve } from "../headers/statistics";
import { Plot, rangeOf, type Point } from "../base/plot";
import { phrase, qty, say } from "../base/texts";
import { atLeast, modeLabel, reactionAt, rowsToEighty, type Campaign, type Sample } from "./data";
import { drawLimits, limitList, limitRows } from "./limits";

const kGrid = 120;

interface Envelope {
  x: number[];
  mean: number[];
  low: number[];
  high: number[];
}

// Mean and extremes of the curves that go this far, if at least half of them do.
function envelopeOf(samples: Sample[], rows: (s: Sample) => number, end: number): Envelope {
  const e: Envelope = { x: [], mean: [], low: [], high: [] };
  for (let i = 0; i <= kGrid; ++i) {
    const x = (end * i) / kGrid;
    const values = samples.map((s) => reactionAt(s, x, rows(s))).filter(Number.isFinite);
    if (values.length === 0 || 2 * values.length < samples.length) break;
    e.x.push(x);
    e.mean.push(values.reduce((a, b) => a + b, 0) / values.length);
    e.low.push(Math.min(...values));
    e.high.push(Math.max(...values));
  }
  return e;
}

// Buttons that show and hide the modes, with their counts.
export function modeChips(campaign: Campaign): HTMLElement {
  const chips = campaign.modes.map((mode) => {
    const count = campaign.answered.filter((s) => s.mode === mode).length;
    const chip = h(
      "button",
      {
        type: "button",
        class: `chip-button ${campaign.css(mode)}`,
        "data-mode": mode,
        "aria-pressed": "true",
        onclick: () => campaign.toggle(mode),
      },
      h("span", { class: "dot", "aria-hidden": "true" }),
      modeLabel(mode),
      h("span", { class: "soft" }, count),
    );
    campaign.onModes(() => chip.setAttribute("aria-pressed", String(campaign.shown(mode))));
    return chip;
  });
  return h("div", { class: "chips", role: "group", "aria-label": say("modes.toggle") }, chips);
}

export class Curves {
  private truncated = false;
  private show = "curves";
  private readonly figure: Figure;

  constructor(private readonly campaign: Campaign) {
    const caption = h("span");
    this.figure = new Figure({
      id: "curves",
      title: say("curves.title"),
      wide: true,
      above: h("div", { class: "controls" }, modeChips(campaign), this.controls()),
      draw: (width, onPaper) => {
        caption.textContent = `${say(this.truncated ? "curves.caption.truncated" : "curves.caption")} `;
        return this.draw(width, onPaper);
      },
      caption: [caption, onScreen(say("curves.press"))],
      sheet: () => this.sheet(),
    });
    campaign.onModes(() => this.figure.redraw());
    campaign.onSample(() => this.figure.redraw());
  }
  get element(): HTMLElement {
    return this.figure.element;
  }

  private controls(): Child {
    const group = (name: string, options: string[], at: string, pick: (o: string) => void): HTMLElement => {
      const buttons = options.map((o) =>
        h(
          "button",
          { type: "button", class: "segment", "data-option": o, "aria-pressed": String(o === at) },
          say(`curves.${o}`),
        ),
      );
      buttons.forEach((b, i) =>
        b.addEventListener("click", () => {
          buttons.forEach((other) => other.setAttribute("aria-pressed", String(other === b)));
          pick(options[i]);
          this.figure.redraw();
        }),
      );
      return h("div", { class: "segments", role: "group", "aria-label": say(`curves.${name}`) }, buttons);
    };
    return [
      group("extent", ["whole", "truncated"], "whole", (o) => {
        this.truncated = o === "truncated";
      }),
      group("content", ["curves", "means", "both"], "curves", (o) => {
        this.show = o;
      }),
    ];
  }
  private readonly rows = (s: Sample): number => (this.truncated ? rowsToEighty(s) : s.displacement.length);
  private visible(): Sample[] {
    return this.campaign.answered.filter((s) => this.campaign.shown(s.mode));
  }

  private draw(width: number, onPaper: boolean): SVGSVGElement {
    const all = this.campaign.answered;
    const end = Math.max(...all.map((s) => s.displacement[this.rows(s) - 1] ?? 0));
    const top = Math.max(...all.map((s) => s.response[0] ?? rangeOf(s.reaction)[1]));
    const drift = this.campaign.driftPerMillimetre;
    const low = Math.min(0, ...all.map((s) => Math.min(...s.reaction.subarray(0, this.rows(s)))));
    const plot = new Plot({
      width,
      height: onPaper ? 0.36 * width : Math.max(300, Math.min(520, 0.5 * width)),
      x: [Math.min(0, ...all.map((s) => Math.min(...s.displacement))), end * 1.005],
      y: [low < -0.02 * top ? low : 0, 1.06 * top],
      xLabel: say("axis.displacement"),
      yLabel: say("axis.reaction"),
      title: say("curves.alt", { n: all.length }),
      topAxis: drift > 0 ? { label: say("drift"), unit: "%", factor: drift } : undefined,
    });
    const visible = this.visible();
    if (this.show !== "curves") this.drawEnvelopes(plot, visible, end);
    if (this.show !== "means") this.drawSamples(plot, visible);
    if (this.show !== "curves") this.drawMeans(plot, visible, end);
    this.drawSelected(plot);
    this.listen(plot);
    return plot.svg;
  }
  private drawSamples(plot: Plot, samples: Sample[]): void {
    const css = samples.length > 60 ? "sample many" : samples.length > 12 ? "sample" : "sample few";
    const g = svg("g", { class: this.show === "both" ? "samples faint" : "samples" });
    append(
      g,
      samples.map((s) =>
        svg("path", {
          class: `${css} ${this.campaign.css(s.mode)}`,
          "data-sample": s.sample,
          d: plot.path(this.points(s)),
        }),
      ),
    );
    plot.add(g);
  }
  private points(s: Sample): Point[] {
    return Array.from({ length: this.rows(s) }, (_, i): Point => [s.displacement[i], s.reaction[i]]);
  }
  private drawEnvelopes(plot: Plot, samples: Sample[], end: number): void {
    for (const mode of this.campaign.modes) {
      const of = samples.filter((s) => s.mode === mode);
      if (of.length < 2) continue;
      const e = envelopeOf(of, this.rows, end);
      plot.band(e.x, e.low, e.high, `envelope ${this.campaign.css(mode)}`);
    }
  }
  private drawMeans(plot: Plot, samples: Sample[], end: number): void {
    for (const mode of this.campaign.modes) {
      const of = samples.filter((s) => s.mode === mode);
      if (of.length === 0) continue;
      const e = envelopeOf(of, this.rows, end);
      plot.line(
        e.x.map((x, i): Point => [x, e.mean[i]]),
        `mean ${this.campaign.css(mode)}`,
        { "data-mean": mode },
      );
    }
  }
  private drawSelected(plot: Plot): void {
    const s = this.campaign.selected;
    if (!s || !s.answered || !this.campaign.picked) return;
    plot.line(this.points(s), "selected-back");
    plot.line(this.points(s), `selected ${this.campaign.css(s.mode)}`, { "data-selected": s.sample });
  }

  private nearest(plot: Plot, px: number, py: number): Sample | null {
    let best = 14,
      found: Sample | null = null;
    const x = plot.xAt(px);
    for (const s of this.visible()) {
      const r = reactionAt(s, x, this.rows(s));
      const off = Number.isFinite(r) ? Math.abs(plot.Y(r) - py) : Infinity;
      if (off < best) {
        best = off;
        found = s;
      }
    }
    return found;
  }
  private listen(plot: Plot): void {
    let lit: Element | null = null;
    const leave = (): void => {
      lit?.classList.remove("lit");
      lit = null;
      hideTip();
    };
    plot.svg.addEventListener("pointermove", (event) => {
      const s = this.nearest(plot, ...pointIn(plot.svg, event));
      leave();
      if (!s) return;
      lit = plot.marks.querySelector(`[data-sample="${s.sample}"]`);
      lit?.classList.add("lit");
      showTip(event, [
        say("sample.n", { n: s.sample }),
        [say("mode"), modeLabel(s.mode)],
        [say("quantity.peak_reaction"), atLeast(s.censored[0]) + qty(s.response[0], "kN")],
        [say("quantity.displacement_at_80_percent"), atLeast(s.censored[2]) + qty(s.response[2], "mm")],
        say("sample.click"),
      ]);
    });
    plot.svg.addEventListener("pointerleave", leave);
    plot.svg.addEventListener("click", (event) => {
      const s = this.nearest(plot, ...pointIn(plot.svg, event));
      if (!s) return;
      hideTip();
      this.campaign.select(s);
      document.getElementById("sample")?.scrollIntoView({ block: "start" });
    });
    plot.svg.style.cursor = "pointer";
  }
  private sheet(): { head: string[]; rows: (string | number)[][] } {
    const rows: (string | number)[][] = [];
    for (const s of this.visible())
      for (let i = 0; i < this.rows(s); ++i) rows.push([s.sample, s.mode, s.displacement[i], s.reaction[i]]);
    return { head: ["sample", "failure_mode", "displacement_mm", "reaction_kN"], rows };
  }
}

// Names the drift limits of the code on the lines, or says that they all lie beyond the chart.
function limitWords(all: DriftLimit[], inRange: DriftLimit[], short: boolean): string {
  if (all.length === 0) return "";
  const clause = phrase(all[0].clause);
  const least = Math.min(...all.map((l) => l.limit_drift_percent));
  if (inRange.length === 0) return say("means.limits.beyond", { clause, least: qty(least, "%", 4) });
  const which = short ? ` ${say("means.limits.which", { list: limitList(inRange) })}` : "";
  return say("means.limits", { clause }) + which;
}

type Reaction = "reaction_mean_kN" | "reaction_5_percent_kN" | "reaction_95_percent_kN";

// Means of the statistics at equal displacement against drift, with the code's limits (Fig. 21).
export function meanCurves(campaign: Campaign): HTMLElement | null {
  const curves = campaign.statistics.mean_curves;
  const byDrift = campaign.loadHeight > 0;
  const groups = Object.keys(curves).filter((g) => g !== "all" || campaign.modes.length < 2);
  if (campaign.answered.length < 2) return null;
  // a mean needs at least half of its curves
  const kept = (c: MeanCurve): number[] =>
    c.n.map((_, i) => i).filter((i) => 2 * c.n[i] >= c.curves);
  const x = (c: MeanCurve): number[] => kept(c).map((i) => (byDrift ? c.drift_percent[i]! : c.displacement_mm[i]));
  const pick = (c: MeanCurve, key: Reaction): number[] => kept(c).map((i) => c[key][i]);
  const all = byDrift ? campaign.statistics.drift_limits : [];
  const xs = groups.flatMap((g) => x(curves[g])),
    ys = groups.flatMap((g) => pick(curves[g], "reaction_95_percent_kN"));
  const span = rangeOf([0, ...xs]);
  const limits = all.filter((l) => l.limit_drift_percent <= span[1]);
  const caption = h("span");
  const figure = new Figure({
    id: "mean-curves",
    title: say("means.title"),
    wide: true,
    above: [
      legend([
        [swatch("mean all"), say("means.mean")],
        [swatch("spread all", "box"), say("means.band")],
        // only for lines in the chart
        ...["life safety", "near collapse"]
          .filter((state) => limits.some((l) => l.state === state))
          .map((state): [SVGSVGElement, Child] => [
            swatch(state === "life safety" ? "limit life" : "limit"),
            say(`limit.${state}`),
          ]),
      ]),
      modeChips(campaign),
    ],
    caption,
    draw: (width, onPaper) => {
      const shown = groups.filter((g) => g === "all" || campaign.shown(g));
      const rows = limits.length > 0 ? limitRows(limits, span, width, 84) : null;
      caption.textContent = `${say("means.caption")} ${limitWords(all, limits, rows?.short ?? false)}`;
      const plot = new Plot({
        width,
        height: onPaper ? 0.36 * width : Math.max(320, Math.min(500, 0.47 * width)),
        x: span,
        y: [0, 1.05 * rangeOf(ys)[1]],
        top: rows?.top ?? 14,
        right: 84,
        xLabel: byDrift ? say("axis.drift") : say("axis.displacement"),
        yLabel: say("axis.reaction"),
        title: say("means.title"),
      });
      if (rows) drawLimits(plot, rows);
      for (const g of shown)
        if (curves[g].curves >= 5)
          plot.band(
            x(curves[g]),
            pick(curves[g], "reaction_5_percent_kN"),
            pick(curves[g], "reaction_95_percent_kN"),
            `spread ${g === "all" ? "all" : campaign.css(g)}`,
          );
      const tags: { y: number; x: number; name: string; css: string }[] = [];
      for (const g of shown) {
        const css = g === "all" ? "all" : campaign.css(g),
          gx = x(curves[g]),
          gy = pick(curves[g], "reaction_mean_kN");
        if (gx.length === 0) continue;
        plot.line(
          gx.map((v, i): Point => [v, gy[i]]),
          `mean ${css}`,
          { "data-mean": g },
        );
        tags.push({ x: plot.X(gx[gx.length - 1]), y: plot.Y(gy[gy.length - 1]), name: modeLabel(g), css });
      }
      let free = -Infinity;
      for (const tag of tags.sort((a, b) => a.y - b.y)) {
        const y = Math.max(tag.y, free);
        free = y + 15;
        plot.text(
          plot.right + 7,
          y + 4,
          tag.name.length > 11 ? tag.name.slice(0, 10) + "…" : tag.name,
          `strong tag ${tag.css}`,
        );
      }
      return plot.svg;
    },
    sheet: () => ({
      head: [
        "group",
        "displacement_mm",
        "drift_percent",
        "n",
        "reaction_mean_kN",
        "reaction_standard_deviation_kN",
        "reaction_5_percent_kN",
        "reaction_95_percent_kN",
      ],
      rows: Object.entries(curves).flatMap(([g, c]) =>
        c.n.map((n, i) => [
          g,
          c.displacement_mm[i],
          c.drift_percent[i],
          n,
          c.reaction_mean_kN[i],
          c.reaction_standard_deviation_kN[i],
          c.reaction_5_percent_kN[i],
          c.reaction_95_percent_kN[i],
        ]),
      ),
    }),
  });
  campaign.onModes(() => figure.redraw());
  return figure.element;
}
