// Macro-block mechanisms: bodies that rotate about their hinges, and their curves with those of runs (Fig. 19).
import { h, svg, type Child } from "../base/dom";
import { Figure, hideTip, legend, pointIn, showTip, swatch } from "../base/figure";
import type { Envelope, MechanismAssessment, Opinion, OpinionOnRuns } from "../headers/limit";
import { Plot, rangeOf, ticks, type Point } from "../base/plot";
import { num, qty, say } from "../base/texts";

export interface Mechanism {
  name: string;
  mode: string;
  hypothesis: string;
  force_at_rest_kN: number;
  displacement_without_force_mm: number;
  rotation_ratios: number[];
  inputs: Record<string, { value: number | string; unit: string }>;
  hinge_names: string[];
  hinges_m: Point[];
  bodies: {
    name: string;
    outline_m: Point[];
    loads: { at_m: Point; kind: string; fx_kN: number; fy_kN: number }[];
  }[];
  load_point_m: Point;
  loaded_body: number;
  direction: number;
  assessment?: MechanismAssessment;
  curve: {
    ends_where: string;
    displacement_mm: number[];
    force_kN: number[];
    rotation_rad: number[][];
    hinges_m: Point[][];
  };
}

const css = (hypothesis: string): string => `hyp-${hypothesis}`;
// The first state shown, rotated enough to be visible: in a chart
// that ends with the runs, or one that goes on to zero force.
const kShown = 0.95,
  kShownAlone = 0.3;

export const hypothesisLabel = (m: Mechanism): string => say(`hypothesis.${m.hypothesis}`);

// Position of a body's point in a state: the body rotates about the previous hinge, which has moved.
function placed(m: Mechanism, state: number, body: number, [x, y]: Point): Point {
  const [hx, hy] = m.hinges_m[body === 2 ? 3 : body],
    [nx, ny] = m.curve.hinges_m[state][body === 2 ? 3 : body];
  const turn = m.curve.rotation_rad[state][body],
    c = Math.cos(turn),
    s = Math.sin(turn);
  return [nx + c * (x - hx) - s * (y - hy), ny + s * (x - hx) + c * (y - hy)];
}

// --- animated mechanism ------------------------------------------------------------------------------

class MechanismView {
  readonly element: HTMLElement;
  private readonly figure: Figure;
  private m: Mechanism;
  private state = 0;
  private timer = 0;
  private readonly slider = h("input", {
    type: "range",
    min: 0,
    step: 1,
    "aria-label": say("mechanism.displacement"),
  });
  private readonly play = h("button", { type: "button", class: "play", "aria-label": say("wall.play") }, "▶");
  private readonly caption = h("output", { class: "wall-caption" });

  constructor(
    all: Mechanism[],
    private readonly far: number, // displacement at the end of the chart [mm]
    private readonly moved: (m: Mechanism, displacement: number) => void,
  ) {
    this.m = all[all.length - 1];
    const pick = h(
      "select",
      { "aria-label": say("mechanism.hypothesis") },
      all.map((m) => h("option", { value: m.name, selected: m === this.m }, hypothesisLabel(m))),
    );
    pick.addEventListener("change", () => {
      this.m = all.find((m) => m.name === pick.value)!;
      this.choose();
    });
    this.slider.addEventListener("input", () => {
      this.stop();
      this.show(Number(this.slider.value));
    });
    this.play.addEventListener("click", () => (this.timer ? this.stop() : this.start()));
    this.figure = new Figure({
      id: `mechanism-${this.m.mode}`,
      title: say("mechanism.title", { mode: this.m.mode }),
      above: h(
        "div",
        { class: "controls" },
        h("label", {}, h("span", {}, say("mechanism.hypothesis")), pick),
      ),
      draw: (width) => this.draw(width),
      caption: [h("div", { class: "time" }, this.play, this.slider), this.caption],
      sheet: () => ({
        head: [
          "displacement_mm",
          "force_kN",
          ...this.m.bodies.map((b) => `rotation_${b.name.replace(/ /g, "_")}_rad`),
        ],
        rows: this.m.curve.displacement_mm.map((d, i) => [
          d,
          this.m.curve.force_kN[i],
          ...this.m.curve.rotation_rad[i],
        ]),
      }),
    });
    this.element = this.figure.element;
    this.choose();
  }
  private choose(): void {
    const d = this.m.curve.displacement_mm,
      last = d.length - 1;
    this.slider.max = String(last);
    const at = this.far < d[last] ? kShown * this.far : kShownAlone * d[last];
    const seen = d.findIndex((v) => v >= at);
    this.show(Math.max(1, seen - 1));
  }
  private show(state: number): void {
    this.state = Math.min(state, this.m.curve.displacement_mm.length - 1);
    this.slider.value = String(this.state);
    const d = this.m.curve.displacement_mm[this.state],
      f = this.m.curve.force_kN[this.state];
    this.caption.textContent = `${qty(d, "mm")} · ${qty(f, "kN")} · ${say("wall.to_scale")}`;
    this.slider.setAttribute("aria-valuetext", `${qty(d, "mm")}, ${qty(f, "kN")}`);
    this.figure?.redraw();
    this.moved(this.m, d);
  }
  private start(): void {
    const last = this.m.curve.displacement_mm.length - 1;
    if (this.state >= last) this.show(0);
    this.play.textContent = "❚❚";
    const step = Math.max(1, Math.round(last / 60));
    this.timer = window.setInterval(
      () => (this.state >= last ? this.stop() : this.show(Math.min(last, this.state + step))),
      60,
    );
  }
  private stop(): void {
    window.clearInterval(this.timer);
    this.timer = 0;
    this.play.textContent = "▶";
  }

  private draw(width: number): SVGSVGElement {
    const m = this.m,
      outline = m.bodies.flatMap((b) => b.outline_m);
    const xs = outline.map((p) => p[0]),
      ys = outline.map((p) => p[1]);
    const x0 = Math.min(...xs),
      x1 = Math.max(...xs),
      y0 = Math.min(...ys),
      y1 = Math.max(...ys);
    const k = Math.min((width - 130) / (1.12 * (x1 - x0)), 330 / (y1 - y0));
    const height = (y1 - y0) * k + 92,
      left = (width - (x1 - x0) * k) / 2;
    const X = (x: number): number => left + (x - x0) * k,
      Y = (y: number): number => height - 50 - (y - y0) * k;
    const path = (points: Point[]): string =>
      "M" + points.map(([x, y]) => `${X(x).toFixed(1)} ${Y(y).toFixed(1)}`).join("L") + "Z";
    const picture = svg(
      "svg",
      {
        class: "plot mechanism",
        viewBox: `0 0 ${width} ${height}`,
        width,
        height,
        role: "img",
        "aria-label": say("mechanism.alt", { mode: m.mode }),
      },
      svg("line", { class: "ground", x1: X(x0) - 30, x2: X(x1) + 30, y1: Y(y0), y2: Y(y0) }),
    );
    m.bodies.forEach((b) => picture.appendChild(svg("path", { class: "body-before", d: path(b.outline_m) })));
    m.bodies.forEach((b, i) =>
      picture.appendChild(
        svg("path", {
          class: `body body${i}`,
          "data-body": b.name,
          d: path(b.outline_m.map((p) => placed(m, this.state, i, p))),
        }),
      ),
    );
    m.curve.hinges_m[this.state].forEach(([x, y], i) =>
      picture.append(
        svg("circle", { class: "hinge", cx: X(x), cy: Y(y), r: 5.5 }),
        svg("text", { class: "strong halo", x: X(x) + 9, y: Y(y) + (i === 1 ? -8 : 16) }, m.hinge_names[i]),
      ),
    );
    const [tx, ty] = placed(m, this.state, m.loaded_body, m.load_point_m),
      back = -m.direction * 44,
      px = X(tx),
      py = Y(ty);
    picture.appendChild(
      svg("path", {
        class: "arrow",
        d: `M${px + back} ${py}L${px} ${py}M${px + back / 5} ${py - 6}L${px} ${py}L${px + back / 5} ${py + 6}`,
      }),
    );
    const metres = ticks([0, (x1 - x0) / 4], 2)[1] ?? 1;
    picture.append(
      svg("path", { class: "scalebar", d: `M${width - 12 - metres * k} ${height - 12}v4h${metres * k}v-4` }),
      svg(
        "text",
        { class: "tick", x: width - 12 - (metres * k) / 2, y: height - 15, "text-anchor": "middle" },
        `${num(metres)}\u202fm`,
      ),
    );
    return picture;
  }
}

// --- curves over the runs (Fig. 19) --------------------------------------------------------------------

const kBeyond = 1.6; // of the displacement of the runs: end of the chart
const kEnvelope = ["low", "percentile_5", "mean", "percentile_95", "high"] as const;

class OverlayFigure {
  readonly figure: Figure;
  private cursor: SVGGElement | null = null;
  private plot: Plot | null = null;
  private at: [Mechanism, number] | null = null;

  constructor(
    private readonly mode: string,
    private readonly mechanisms: Mechanism[],
    private readonly comparison: OpinionOnRuns | null,
  ) {
    const items: [SVGSVGElement, Child][] = mechanisms.map((m) => [
      swatch(`mean ${css(m.hypothesis)}`),
      hypothesisLabel(m),
    ]);
    const envelope = this.envelope;
    if (envelope)
      items.push(
        [swatch("mean runs"), say("overlay.mean")],
        ...(this.hasBand
          ? ([
              [swatch("spread runs", "box"), say("overlay.band")],
              [swatch("extreme runs"), say("overlay.extremes")],
            ] as [SVGSVGElement, Child][])
          : ([[swatch("spread runs", "box"), say("overlay.envelope")]] as [SVGSVGElement, Child][])),
      );
    if (comparison?.curve) items.push([swatch("mean runs"), say("overlay.run")]);
    this.figure = new Figure({
      id: `overlay-${mode}`,
      title: say("overlay.title", { mode }),
      above: legend(items),
      draw: (width, onPaper) => this.draw(width, onPaper),
      caption: say(
        envelope ? "overlay.caption" : comparison?.curve ? "overlay.caption.run" : "overlay.caption.alone",
      ),
      sheet: () => ({
        head: ["curve", "displacement_mm", "force_kN"],
        rows: [
          ...mechanisms.flatMap((m) =>
            m.curve.displacement_mm.map((d, i): (string | number)[] => [m.name, d, m.curve.force_kN[i]]),
          ),
          ...(envelope
            ? kEnvelope.filter((k) => `${k}_kN` in envelope).flatMap((k) =>
                envelope.displacement_mm.map((d, i): (string | number)[] => [
                  `runs_${k}`,
                  d,
                  envelope[`${k}_kN`]![i],
                ]),
              )
            : []),
        ],
      }),
    });
  }
  // Envelope of several runs; a single one is drawn itself.
  private get envelope(): Envelope | undefined {
    return this.comparison?.runs! > 1 ? this.comparison!.envelopes?.[this.mode] : undefined;
  }
  // With few runs that fell early, a band from the least to the largest value would mislead.
  private get hasBand(): boolean {
    return this.envelope?.percentile_5_kN !== undefined;
  }
  // Displacement up to which the curves of runs are well visible.
  get far(): number {
    const { envelope } = this,
      run = this.comparison?.curve;
    const last = Math.max(...this.mechanisms.map((m) => m.curve.displacement_mm.at(-1)!));
    const runs = envelope?.displacement_mm ?? run?.displacement_mm;
    return runs ? Math.min(last, kBeyond * Math.max(...runs)) : last;
  }
  move(m: Mechanism, displacement: number): void {
    const inside = Math.max(this.far, this.at?.[1] ?? 0);
    this.at = [m, displacement];
    // the chart grows for a mark that leaves it, and shrinks back
    if (Math.max(inside, displacement) > this.far) this.figure.redraw();
    this.mark();
  }
  private mark(): void {
    if (!this.plot || !this.cursor || !this.at) return;
    const [m, d] = this.at,
      i = m.curve.displacement_mm.findIndex((v) => v >= d);
    if (i < 0 || d > this.plot.spec.x[1]) return this.cursor.replaceChildren();
    this.cursor.replaceChildren(
      svg("circle", {
        class: "cursor-dot",
        cx: this.plot.X(d),
        cy: this.plot.Y(m.curve.force_kN[i]),
        r: 5.5,
      }),
    );
  }
  private draw(width: number, onPaper: boolean): SVGSVGElement {
    const envelope = this.envelope,
      run = this.comparison?.curve;
    const last = Math.max(this.far, 1.04 * (this.at?.[1] ?? 0));
    const forces = [
      ...this.mechanisms.map((m) => m.force_at_rest_kN),
      ...((this.hasBand ? envelope!.percentile_95_kN : envelope?.high_kN) ?? []),
      ...(run?.force_kN ?? []),
    ];
    const plot = new Plot({
      width,
      height: onPaper ? 0.54 * width : Math.max(300, Math.min(430, 0.8 * width)),
      x: [0, last],
      y: [0, 1.06 * rangeOf(forces)[1]],
      xLabel: say("axis.load_displacement"),
      yLabel: say("axis.force"),
      title: say("overlay.title", { mode: this.mode }),
    });
    if (envelope) {
      const d = envelope.displacement_mm;
      if (this.hasBand) {
        plot.band(d, envelope.percentile_5_kN!, envelope.percentile_95_kN!, "spread runs");
        for (const key of ["low_kN", "high_kN"] as const)
          plot.line(
            d.map((v, i): Point => [v, envelope[key][i]]),
            "extreme runs",
            { "data-extreme": key },
          );
      } else plot.band(d, envelope.low_kN, envelope.high_kN, "spread runs");
      plot.line(
        envelope.displacement_mm.map((d, i): Point => [d, envelope.mean_kN[i]]),
        "mean runs",
        { "data-envelope": this.mode },
      );
    }
    if (run)
      plot.line(
        run.displacement_mm.map((d, i): Point => [d, run.force_kN[i]]),
        "mean runs",
        { "data-run": "run" },
      );
    for (const m of this.mechanisms)
      plot.line(
        m.curve.displacement_mm.map((d, i): Point => [d, m.curve.force_kN[i]]),
        `mean ${css(m.hypothesis)}`,
        { "data-mechanism": m.name },
      );
    this.cursor = svg("g");
    plot.over.appendChild(this.cursor);
    this.plot = plot;
    this.mark();
    plot.svg.addEventListener("pointermove", (event) => {
      const d = plot.xAt(pointIn(plot.svg, event)[0]);
      if (d < 0 || d > last) return hideTip();
      const lines: [string, string][] = this.mechanisms.map((m) => {
        const i = m.curve.displacement_mm.findIndex((v) => v >= d);
        return [hypothesisLabel(m), i < 0 ? "–" : qty(m.curve.force_kN[i], "kN")];
      });
      showTip(event, [qty(d, "mm"), ...lines]);
    });
    plot.svg.addEventListener("pointerleave", hideTip);
    return plot.svg;
  }
}

export function mechanisms(opinion: Opinion): Child {
  const all = opinion.mechanisms;
  return [...new Set(all.map((m) => m.mode))].map((mode) => {
    const of = all.filter((m) => m.mode === mode);
    const overlay = new OverlayFigure(mode, of, opinion.comparison);
    const view = new MechanismView(of, overlay.far, (m, d) => overlay.move(m, d));
    return h("div", { class: "hero" }, overlay.figure.element, view.element);
  });
}
