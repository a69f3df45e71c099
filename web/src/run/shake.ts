// A wall under an earthquake: the motion of a point over time, the loops of base shear, points and records.
import type { Bundle } from "../base/bundle";
import { h, svg, type Child } from "../base/dom";
import { Figure } from "../base/figure";
import type { RunHeader, Shaking } from "../headers/run";
import type { Section } from "../page";
import { Plot, rangeOf, type Point } from "../base/plot";
import { zip } from "./trust";
import { table } from "../base/tables";
import { num, qty, say } from "../base/texts";

const kMostPoints = 4000; // of a line on the screen

export const isShaken = (bundle: Bundle): boolean => "shake.time_s" in (bundle.header.arrays ?? {});

class ShakeView {
  private readonly time: number[];
  private readonly s: Shaking;
  private readonly words: Record<string, string>;

  constructor(private readonly bundle: Bundle<RunHeader>) {
    this.s = bundle.header.summary.shaking!;
    this.time = this.column("time_s");
    this.words = { point: this.s.points[0]?.name ?? "", record: this.s.records[0]?.record ?? "" };
  }
  private column(name: string): number[] {
    return Array.from(this.bundle.array(`shake.${name}`));
  }
  // Reduces points for drawing: the extremes of each group of rows are kept.
  private line(y: number[]): Point[] {
    const points = zip(this.time, y);
    const run = Math.ceil((2 * points.length) / kMostPoints);
    if (run <= 2) return points;
    const kept: Point[] = [];
    for (let k = 0; k < points.length; k += run) {
      const part = points.slice(k, k + run);
      const low = part.reduce((a, b) => (b[1] < a[1] ? b : a));
      const high = part.reduce((a, b) => (b[1] > a[1] ? b : a));
      kept.push(...(low[0] < high[0] ? [low, high] : [high, low]));
    }
    return kept;
  }

  history(): Figure {
    const head = ["time_s", "displacement_mm", "acceleration_g", "base_shear_kN", "opening_mm"];
    return new Figure({
      id: "shake-history",
      title: say("shake.history"),
      wide: true,
      draw: (width) => this.drawHistory(width),
      caption: say("shake.history.caption", this.words),
      sheet: () => {
        const columns = head.map((name) => this.column(name));
        return { head, rows: this.time.map((_, i) => columns.map((c) => c[i])) };
      },
    });
  }
  private drawHistory(width: number): SVGSVGElement {
    const above = this.plotOver(width, 0.42 * width, "displacement_mm", "axis.shake.displacement", "force");
    const below = this.plotOver(width, 0.24 * width, "acceleration_g", "axis.base", "base");
    const height = above.spec.height + below.spec.height;
    below.svg.setAttribute("y", String(above.spec.height));
    return svg(
      "svg",
      {
        class: "plot",
        viewBox: `0 0 ${width} ${height}`,
        width,
        height,
        role: "img",
        "aria-label": say("shake.history.alt", this.words),
      },
      above.svg,
      below.svg,
    ) as SVGSVGElement;
  }
  private plotOver(width: number, height: number, name: string, label: string, look: string): Plot {
    const y = this.column(name);
    const range = rangeOf([0, ...y]);
    const air = 0.08 * (range[1] - range[0] || 1);
    const plot = new Plot({
      width,
      height: Math.max(130, Math.min(360, height)),
      x: [0, this.time[this.time.length - 1] || 1],
      y: [range[0] - air, range[1] + air],
      xLabel: say("axis.time"),
      yLabel: say(label),
      title: say("shake.history.alt", this.words),
    });
    plot.line(this.line(y), look);
    return plot;
  }

  loops(): Figure {
    return new Figure({
      id: "shake-loops",
      title: say("shake.loops"),
      draw: (width) => this.drawLoops(width),
      caption: say("shake.loops.caption", this.words),
    });
  }
  private drawLoops(width: number): SVGSVGElement {
    const x = this.column("displacement_mm"),
      y = this.column("base_shear_kN");
    const wide = rangeOf([0, ...x]),
      tall = rangeOf([0, ...y]);
    const air = 0.06 * (tall[1] - tall[0] || 1),
      side = 0.04 * (wide[1] - wide[0] || 1);
    const plot = new Plot({
      width,
      height: Math.max(260, Math.min(460, 0.7 * width)),
      x: [wide[0] - side, wide[1] + side],
      y: [tall[0] - air, tall[1] + air],
      xLabel: say("axis.shake.displacement"),
      yLabel: say("axis.reaction"),
      title: say("shake.loops.alt", this.words),
    });
    plot.line(zip(x, y), "force thin");
    return plot.svg;
  }

  // One strip for each storey, the uppermost at the top, with one scale.
  storeys(): Figure | null {
    const names = (this.s.storeys ?? []).map((storey) => String(storey.name));
    if (names.length === 0 || !(`shake.storey_0_percent` in this.bundle.header.arrays)) return null;
    const columns = names.map((_, k) => this.column(`storey_${k}_percent`));
    return new Figure({
      id: "shake-storeys",
      title: say("shake.storeys"),
      wide: true,
      draw: (width) => this.drawStoreys(width, names, columns),
      caption: say("shake.storeys.caption", this.words),
      sheet: () => ({
        head: ["time_s", ...names.map((name) => `${name}_drift_percent`)],
        rows: this.time.map((t, i) => [t, ...columns.map((c) => c[i])]),
      }),
    });
  }
  private drawStoreys(width: number, names: string[], columns: number[][]): SVGSVGElement {
    const range = rangeOf([0, ...columns.flat()]);
    const air = 0.08 * (range[1] - range[0] || 1);
    let below = 0;
    const strips: SVGSVGElement[] = [];
    for (let k = names.length - 1; k >= 0; --k) {
      const plot = new Plot({
        width,
        height: Math.max(150, Math.min(200, 0.2 * width)),
        x: [0, this.time[this.time.length - 1] || 1],
        y: [range[0] - air, range[1] + air],
        xLabel: k === 0 ? say("axis.time") : "",
        yLabel: say("axis.shake.storey", { storey: names[k] }),
        title: say("shake.storeys.alt", { storey: names[k] }),
      });
      plot.line(this.line(columns[k]), "force");
      plot.svg.setAttribute("y", String(below));
      below += plot.spec.height;
      strips.push(plot.svg);
    }
    return svg(
      "svg",
      {
        class: "plot",
        viewBox: `0 0 ${width} ${below}`,
        width,
        height: below,
        role: "img",
        "aria-label": say("shake.storeys.alt", { storey: names.join(", ") }),
      },
      ...strips,
    ) as SVGSVGElement;
  }
  private storeyTable(): Child {
    const storeys = this.s.storeys ?? [];
    if (storeys.length === 0) return null;
    return table(
      [
        { head: say("shake.storey"), left: true },
        { head: say("shake.height") },
        { head: say("shake.peak") },
        { head: say("shake.peak_at") },
        { head: say("shake.residual") },
      ],
      [...storeys]
        .reverse()
        .map((p) => [
          p.name,
          qty(p.height_m, "m"),
          qty(p.peak_drift_percent, "%", 2),
          qty(p.peak_at_s, "s"),
          qty(p.residual_drift_percent, "%", 2),
        ]),
      say("shake.storeys"),
    );
  }

  tables(gap: number): Child {
    const s = this.s;
    return [
      h(
        "p",
        {},
        say("shake.drifts", {
          peak: qty(s.peak_drift_percent, "%"),
          residual: qty(s.residual_drift_percent, "%", 2),
          opening: qty(s.largest_opening_mm, "mm"),
          slip: qty(s.largest_slip_mm, "mm"),
          gap: qty(100 * gap, "%", 2),
        }),
      ),
      table(
        [
          { head: say("shake.point"), left: true },
          { head: say("shake.height") },
          { head: say("shake.peak") },
          { head: say("shake.peak_at") },
          { head: say("shake.residual") },
        ],
        s.points.map((p) => [
          p.name,
          qty(p.height_m, "m"),
          qty(p.peak_displacement_mm, "mm"),
          qty(p.peak_at_s, "s"),
          qty(p.residual_displacement_mm, "mm", 2),
        ]),
        say("shake.points"),
      ),
      this.storeyTable(),
      table(
        [
          { head: say("shake.record"), left: true },
          { head: say("shake.pga") },
          { head: say("shake.pgv") },
          { head: say("shake.arias") },
          { head: say("shake.duration") },
          { head: say("shake.factor") },
        ],
        s.records.map((r) => [
          r.record,
          qty(r.pga_g, "g"),
          qty(r.pgv_mm_per_s, "mm/s"),
          qty(r.arias_m_per_s, "m/s"),
          qty(r.duration_s, "s"),
          num(r.factor),
        ]),
        say("shake.records"),
      ),
    ];
  }
}

// The chart beside a wall that was not pushed.
export function shakeHistory(bundle: Bundle<RunHeader>): HTMLElement {
  return new ShakeView(bundle).history().element;
}

// The section of a shaken wall; empty for another wall.
export function shakeSection(bundle: Bundle<RunHeader>): Section {
  const section = { id: "shake", title: say("section.shake.numbers"), content: null as Child };
  if (!isShaken(bundle)) return section;
  const view = new ShakeView(bundle);
  section.content = [view.loops().element, view.storeys()?.element ?? null, view.tables(bundle.header.summary.energy_J?.gap_ratio ?? 0)];
  return section;
}
