// The page of a run: curve and wall side by side, and the failure; energy and meters are in trust.ts.
import { assessmentSection } from "./assessment";
import type { Bundle } from "../base/bundle";
import { append, h, onScreen, svg, type Child } from "../base/dom";
import { Figure, hideTip, legend, pointIn, showTip, swatch } from "../base/figure";
import type { Sheet } from "../base/export";
import type { FailureMode, Measured, RunFrame, RunHeader, Summary } from "../headers/run";
import { aroundPrint, type Section } from "../page";
import { Plot, rangeOf, type Point } from "../base/plot";
import { assumptions, inputTables, provenanceTable } from "./inputs";
import { ElementsView } from "./elements";
import { FramesView } from "./frames";
import { isShaken, shakeHistory, shakeSection } from "./shake";
import { cyclesSection, drawEnvelopes, signOf, waysOf } from "./cyclic";
import { layersSaid } from "./layers";
import { energySection, trustSection, zip, type Curve } from "./trust";
import { projectSection, sheetSection } from "./sheet";
import { table } from "../base/tables";
import { asSentence, capital, num, phrase, qty, say, type Said } from "../base/texts";
import { viewOf } from "../wall/spaceview";
import { WallView, type FrameInfo, type View } from "../wall/wallview";

function readCurve(bundle: Bundle<RunHeader>): Curve {
  const get = (name: string): number[] => Array.from(bundle.array(`curve.${name}`));
  return {
    displacement: get("displacement_mm"),
    drift: get("drift_percent"),
    reaction: get("reaction_kN"),
    base: get("base_shear_kN"),
    unbalance: get("unbalance_ratio"),
    kinetic: get("kinetic_ratio"),
    factor: get("load_factor"),
  };
}

const kManyParts = 12, // number of parts in a wall, above which only damaged ones are listed
  kOnPaper = 8, // measures in the printed appendix
  kNear = 0.25; // distance from a threshold that counts as near, as a share of it

// The text for a frame's labels: "peak", "20 mm", "end".
const labelOf = (labels: Said[]): string => labels.map((l) => phrase(l)).join(", ");

// Every sign of every part, with its measure.
const evidenceOf = (mode: FailureMode): Measured[] =>
  mode.elements.flatMap((e) =>
    e.signs.map((s) => ({
      ...s,
      element: e.element,
      measure: `${phrase(s.state)}: ${phrase(s.measure)}`,
      margin: s.threshold > 0 ? s.value / s.threshold - 1 : 0,
    })),
  );

// Index of the smallest.
function nearest(distances: number[]): number {
  let best = 0;
  distances.forEach((d, i) => {
    if (d < distances[best]) best = i;
  });
  return best;
}

class RunPage {
  readonly header: RunHeader;
  readonly curve: Curve;
  readonly view: View | null;
  private readonly s: Summary;
  private readonly byFactor: boolean;
  private plot: Plot | null = null;
  private cursor: SVGGElement | null = null;

  constructor(private readonly bundle: Bundle<RunHeader>) {
    this.header = bundle.header;
    this.s = this.header.summary;
    this.curve = readCurve(bundle);
    this.byFactor = this.s.load_factor > 0;
    this.view = this.makeView();
  }

  private makeView(): View | null {
    if ((this.header.frames ?? []).length === 0) return null;
    const info: FrameInfo[] = this.header.frames.map((f) => ({
      label: labelOf(f.labels) || (typeof f.time_s === "number" ? qty(f.time_s, "s") : ""),
      displacement: f.displacement_mm,
      reaction: f.reaction_kN,
    }));
    return viewOf(this.bundle, { id: "wall", info, onFrame: () => this.moveCursor() });
  }

  private get flat(): WallView | null {
    return this.view instanceof WallView ? this.view : null;
  }
  private get modeName(): string {
    return phrase(this.header.mode.words || this.s.failure_mode.name);
  }
  private get modeWords(): string {
    return phrase(this.header.mode.sentence);
  }

  sections(): Section[] {
    return [
      sheetSection(this),
      { id: "push", title: say(this.isPushed() ? "section.push" : "section.shake"), content: this.push() },
      { id: "assessment", title: say("section.assessment"), content: assessmentSection(this.s, this.curve) },
      cyclesSection(this.s),
      shakeSection(this.bundle),
      { id: "failure", title: say("section.failure"), content: this.failure() },
      { id: "frames", title: say("section.frames"), content: FramesView.of(this.bundle, this.view) },
      { id: "layers", title: say("section.layers"), content: layersSaid(this.header) },
      { id: "energy", title: say("section.energy"), content: energySection(this.header) },
      { id: "trust", title: say("section.trust"), content: trustSection(this.s, this.curve) },
      {
        id: "inputs",
        title: say("section.inputs"),
        content: inputTables(this.header.inputs, this.header.note),
      },
      { id: "provenance", title: say("section.provenance"), content: this.provenance() },
      { id: "measures", title: say("section.measures"), content: this.paperMeasures(), paper: true },
      projectSection(this.header),
    ];
  }

  // --- curve and wall ------------------------------------------------------------------------------

  private isPushed(): boolean {
    return this.curve.displacement.length > 1 || !isShaken(this.bundle);
  }
  private push(): Child {
    const curve =
      this.curve.displacement.length > 1
        ? this.curveFigure().element
        : isShaken(this.bundle)
          ? shakeHistory(this.bundle)
          : h("p", { class: "note" }, say("run.no_curve"));
    const wall = this.view?.element ?? h("p", { class: "note" }, say("run.no_states"));
    return [
      h("div", { class: "hero" }, curve, wall),
      this.eventList(),
      this.view ? this.printStates(this.view) : null,
    ];
  }

  private curveFigure(): Figure {
    const kind = this.byFactor ? "factor" : "force";
    const cyclic = waysOf(this.s).length > 0;
    const items: [SVGSVGElement, Child][] = [[swatch(cyclic ? "force thin" : "force"), say(`curve.${kind}`)]];
    if (cyclic) items.push([swatch("work"), say("curve.envelope")]);
    if (!this.byFactor) items.push([swatch("base"), say("curve.base")]);
    if (this.s.bilinear?.force_kN! > 0) items.push([swatch("fit"), say("curve.bilinear")]);
    const figure = new Figure({
      id: "curve",
      title: say(cyclic ? "curve.cyclic.title" : `curve.${kind}.title`),
      above: legend(items),
      wide: true,
      draw: (width, onPaper) => this.drawCurve(width, onPaper),
      caption: [
        this.s.events.length > 0 ? `${say("curve.caption")} ` : "",
        this.view ? onScreen(`${say("curve.press")} `) : "",
        this.bilinearWords(),
        this.validityWords(),
      ],
      sheet: () => this.curveSheet(),
    });
    return figure;
  }

  // All columns of the curve.
  private curveSheet(): Sheet {
    const head = Object.keys(this.header.arrays)
      .filter((name) => name.startsWith("curve."))
      .map((name) => name.slice("curve.".length));
    const columns = head.map((name) => this.bundle.array(`curve.${name}`));
    return { head, rows: this.curve.displacement.map((_, i) => columns.map((column) => column[i])) };
  }

  private drawCurve(width: number, onPaper: boolean): SVGSVGElement {
    const c = this.curve,
      force = this.byFactor ? c.factor : c.reaction;
    const y = rangeOf([0, ...force]),
      x = rangeOf([0, ...c.displacement]);
    const air = 0.1 * (y[1] - y[0]);
    const height = onPaper ? 0.36 * width : Math.max(280, Math.min(520, 0.84 * width));
    const last = c.displacement.findIndex((d, i) => Math.abs(d) > 1e-6 && Math.abs(c.drift[i]) > 0);
    const plot = new Plot({
      width,
      height,
      x: [x[0], x[1] * 1.01],
      y: [y[0] < -0.02 * y[1] ? y[0] - air : 0, y[1] + air],
      xLabel: say("axis.displacement"),
      yLabel: say(this.byFactor ? "axis.factor" : "axis.reaction"),
      title: say("curve.alt", this.altPlaces()),
      topAxis:
        last >= 0
          ? { label: say("drift"), unit: "%", factor: c.drift[last] / c.displacement[last] }
          : undefined,
    });
    if (!this.byFactor) plot.line(zip(c.displacement, c.base), "base");
    this.drawBilinear(plot);
    plot.line(zip(c.displacement, force), this.isCyclic() ? "force thin" : "force");
    drawEnvelopes(plot, this.s);
    this.drawValidity(plot);
    this.drawMarks(plot);
    this.cursor = svg("g", { class: "cursor" });
    plot.over.appendChild(this.cursor);
    this.plot = plot;
    this.moveCursor();
    this.listen(plot);
    return plot.svg;
  }
  private altPlaces(): Record<string, string> {
    return { force: qty(this.s.peak_reaction_kN, "kN"), at: qty(this.s.displacement_at_peak_mm, "mm") };
  }

  private bilinearWords(): string {
    const b = this.s.bilinear;
    if (this.byFactor || !(b?.force_kN! > 0)) return "";
    return say(this.s.censored_80 ? "curve.bilinear.censored" : "curve.bilinear.80", {
      at: qty(b.ultimate_displacement_mm, "mm"),
    });
  }
  private drawBilinear(plot: Plot): void {
    const b = this.s.bilinear;
    if (this.byFactor || !(b?.force_kN! > 0)) return;
    const ways = this.isCyclic() ? waysOf(this.s) : [{ sign: 1, readings: this.s }];
    for (const { sign, readings } of ways) {
      const w = readings.bilinear;
      if (w.force_kN! > 0)
        plot.line(
          [
            [0, 0],
            [sign * w.yield_displacement_mm!, sign * w.force_kN!],
            [sign * w.ultimate_displacement_mm!, sign * w.force_kN!],
          ],
          "fit",
        );
    }
  }
  private isCyclic(): boolean {
    return waysOf(this.s).length > 0;
  }

  // Marks where blocks have slid off each other: beyond, the curve means little.
  private drawValidity(plot: Plot): void {
    const lost = this.s.validity?.overlap_lost_at_mm;
    if (typeof lost !== "number") return;
    const x = plot.X(lost);
    plot.add(
      svg("rect", {
        class: "beyond",
        x,
        y: plot.top,
        width: Math.max(0, plot.right - x),
        height: plot.bottom - plot.top,
        "data-beyond": lost,
      }),
    );
  }
  private validityWords(): string {
    const v = this.s.validity;
    if (typeof v?.overlap_lost_at_mm !== "number") return "";
    return ` ${say("curve.beyond", { at: qty(v.overlap_lost_at_mm, "mm"), n: v.joints ?? 1 })}`;
  }

  private drawMarks(plot: Plot): void {
    if (!this.byFactor && this.s.peak_reaction_kN! > 0) {
      const sign = signOf(this.s);
      plot.dot(sign * this.s.displacement_at_peak_mm!, sign * this.s.peak_reaction_kN!, 4.5, "peak");
      if (!this.s.censored_80)
        plot.dot(
          sign * this.s.displacement_at_80_percent_mm!,
          sign * 0.8 * this.s.peak_reaction_kN!,
          4.5,
          "peak",
        );
    }
    let before: Point = [-100, -100];
    this.s.events.forEach((e, i) => {
      let at: Point = [plot.X(e.displacement_mm!), plot.Y(this.byFactor ? 0 : e.reaction_kN!)];
      if (!Number.isFinite(at[0] + at[1])) return;
      // marks at one place are shifted downwards, to the right of the curve
      if (Math.hypot(at[0] - before[0], at[1] - before[1]) < 18) at = [before[0] + 11, before[1] + 14];
      before = at;
      append(plot.over, [
        svg(
          "g",
          { class: "event", "data-event": Array.isArray(e.name) ? e.name[0] : e.name },
          svg("title", {}, `${phrase(e.name)}: ${qty(e.displacement_mm, "mm")}, ${qty(e.reaction_kN, "kN")}`),
          svg("circle", { class: "mark", cx: at[0], cy: at[1], r: 8 }),
          svg("text", { class: "markno", x: at[0], y: at[1] + 3.6, "text-anchor": "middle" }, i + 1),
        ),
      ]);
    });
  }

  private moveCursor(): void {
    if (!this.plot || !this.cursor || !this.view) return;
    const info = this.view.spec.info[this.view.look.frame];
    const x = this.plot.X(info.displacement);
    const row = this.rowAt(info.displacement);
    const force = this.isCyclic() ? info.reaction : this.curve.reaction[row];
    const y = this.plot.Y(this.byFactor ? this.curve.factor[row] : force);
    this.cursor.replaceChildren(
      svg("line", { class: "cursor-line", x1: x, x2: x, y1: this.plot.top, y2: this.plot.bottom }),
      svg("circle", { class: "cursor-dot", cx: x, cy: y, r: 5 }),
    );
  }
  private rowAt(displacement: number): number {
    return nearest(this.curve.displacement.map((d) => Math.abs(d - displacement)));
  }
  // The row or state at a displacement. If the push passes it
  // several times, the one nearest to a place in the plot.
  private pointed(x: number[], y: number[], plot: Plot, [px, py]: Point): number {
    return nearest(
      x.map((d, i) =>
        this.isCyclic() ? Math.hypot(plot.X(d) - px, plot.Y(y[i]) - py) : Math.abs(d - plot.xAt(px)),
      ),
    );
  }
  private listen(plot: Plot): void {
    const point = (event: PointerEvent): void => {
      const at = pointIn(plot.svg, event);
      if (at[0] < plot.left || at[0] > plot.right) return hideTip();
      const c = this.curve,
        row = this.pointed(c.displacement, c.reaction, plot, at);
      showTip(event, [
        [say("displacement"), qty(c.displacement[row], "mm")],
        [say("drift"), qty(c.drift[row], "%")],
        this.byFactor
          ? [say("curve.factor"), num(c.factor[row])]
          : [say("curve.force"), qty(c.reaction[row], "kN", 4)],
        ...(this.byFactor ? [] : [[say("curve.base"), qty(c.base[row], "kN", 4)] as [string, string]]),
      ]);
      if (!this.view || (event.buttons === 0 && event.type !== "pointerdown")) return;
      const info = this.view.spec.info;
      this.view.show(
        this.pointed(
          info.map((f) => f.displacement),
          info.map((f) => f.reaction),
          plot,
          at,
        ),
      );
    };
    plot.svg.addEventListener("pointermove", point);
    plot.svg.addEventListener("pointerdown", point);
    plot.svg.addEventListener("pointerleave", hideTip);
    plot.svg.style.touchAction = "pan-y";
    plot.svg.style.cursor = "crosshair";
  }

  private eventList(): Child {
    if (this.s.events.length === 0) return null;
    return h(
      "ol",
      { class: "events", "aria-label": say("events") },
      this.s.events.map((e) =>
        h(
          "li",
          {},
          h("b", {}, capital(phrase(e.name))),
          " ",
          h("span", { class: "soft" }, `${qty(e.displacement_mm, "mm")}, ${qty(e.reaction_kN, "kN")}`),
          e.where ? `: ${phrase(e.where)}` : "",
        ),
      ),
    );
  }

  // Pictures of the labelled states, for paper only.
  private printStates(view: View): HTMLElement {
    const place = h("div", { class: "print-only pictures" });
    aroundPrint(
      () => {
        const labelled = this.header.frames
          .map((f, i): [RunFrame, number] => [f, i])
          .filter(([f]) => f.labels.length > 0 && f.labels[0] !== "start");
        const peak = labelled.filter(([f]) => f.labels.includes("peak")),
          end = labelled.slice(-1);
        place.replaceChildren(
          ...[...new Map([...peak, ...end].map((p): [number, [RunFrame, number]] => [p[1], p])).values()].map(([, i]) =>
            view.picture(i, 400, 250),
          ),
        );
      },
      () => place.replaceChildren(),
    );
    return place;
  }

  // --- how it failed -------------------------------------------------------------------------------

  private failure(): Child {
    const mode = this.s.failure_mode;
    if (mode.evidence.length === 0 && mode.elements.length === 0) return null;
    const elements = new ElementsView(this.bundle, mode, this.flat);
    const mechanism = this.header.mode.mechanism;
    return [
      h(
        "p",
        { class: "lead" },
        h("b", {}, this.modeName),
        this.modeWords ? `: ${this.modeWords}. ` : ". ",
        h("span", { class: "soft" }, say("failure.read_at", { at: qty(mode.read_at_mm, "mm") })),
      ),
      mechanism
        ? h("p", { id: "mechanism" }, h("b", {}, `${say("failure.mechanism")}: `), asSentence(phrase(mechanism)))
        : null,
      this.s.censored_80 && this.s.status !== "collapsed"
        ? h(
            "p",
            { class: "note" },
            say("failure.so_far"),
            mode.name === "unclear" ? "" : ` ${say("failure.words")}`,
          )
        : null,
      this.scores(mode),
      h("div", { class: "pair" }, elements.list(), elements.map?.element, this.flags(mode), elements.chart?.element),
      this.sensitivity(mode),
      h("details", {}, h("summary", {}, say("failure.measures")), this.measures(evidenceOf(mode))),
    ];
  }

  // The damage of a part, and its measures with their thresholds.
  private measures(rows: Measured[], word = say("failure.reached"), caption = ""): HTMLElement {
    const unit = (u: string): string => (u === "share" || u === "-" ? "" : u);
    return table(
      [
        { head: say("failure.element"), left: true },
        { head: say("failure.sign"), left: true },
        { head: say("failure.measured") },
        { head: say("failure.threshold") },
        { head: word },
      ],
      rows.map((e) => [
        phrase(e.element),
        phrase(e.measure),
        qty(e.value, unit(e.unit)),
        qty(e.threshold, unit(e.unit)),
        h(e.margin >= 0 ? "b" : "span", {}, say(e.margin >= 0 ? "yes" : "no")),
      ]),
      caption,
    );
  }
  private flags(mode: FailureMode): Child {
    const all = mode.flags;
    if (all.length === 0) return null;
    const shown = all.length > kManyParts ? all.filter((f) => f.margin >= 0) : all;
    return h(
      "div",
      { id: "severity" },
      shown.length > 0 ? this.measures(shown, say("failure.raised"), say("failure.severity")) : null,
      shown.length < all.length
        ? h(
            "p",
            { class: "soft small" },
            say(shown.length > 0 ? "failure.others_not_raised" : "failure.none_raised", {
              n: all.length - shown.length,
            }),
          )
        : null,
    );
  }
  // An appendix: the measures nearest to their thresholds, which could
  // as well lie on the other side. Paper has no space for the others.
  private paperMeasures(): Child {
    const all = evidenceOf(this.s.failure_mode);
    const near = all
      .filter((e) => Math.abs(e.margin) <= kNear)
      .sort((a, b) => Math.abs(a.margin) - Math.abs(b.margin))
      .slice(0, kOnPaper);
    if (near.length === 0) return null;
    return [
      this.measures(near),
      near.length < all.length
        ? h("p", { class: "small" }, say("failure.others_far", { n: all.length - near.length }))
        : null,
    ];
  }

  private scores(mode: FailureMode): Child {
    const entries = Object.entries(mode.scores);
    if (entries.length === 0) return null;
    return h(
      "dl",
      { class: "scores" },
      entries.map(([name, score]) =>
        h(
          "div",
          { class: name === mode.name ? "score chosen" : "score" },
          h("dt", {}, phrase(name)),
          h(
            "dd",
            {},
            h(
              "span",
              { class: "meter", "aria-hidden": "true" },
              h("span", { style: `inline-size:${Math.max(0, Math.min(100, 100 * score)).toFixed(1)}%` }),
            ),
            h("span", {}, num(score, 2)),
          ),
        ),
      ),
    );
  }

  private sensitivity(mode: FailureMode): Child {
    const others = mode.sensitivity.filter((r) => r.name !== mode.name);
    if (mode.sensitivity.length === 0) return null;
    const n = mode.sensitivity.length;
    return h(
      "p",
      {},
      others.length === 0
        ? say("failure.stable", { n })
        : say("failure.unstable", {
            n,
            others: others.map((r) => `${phrase(r.what)}: ${phrase(r.name)}`).join("; "),
          }),
    );
  }

  private provenance(): Child {
    const s = this.s;
    return [
      h("p", { class: "soft" }, say("provenance.lead")),
      assumptions(this.header),
      provenanceTable([
        [say("provenance.program"), `wythe ${s.provenance.version} (${s.provenance.commit})`],
        [
          say("provenance.compiler"),
          `${s.provenance.compiler}, ${s.provenance.build_type}, ${s.provenance.flags}`,
        ],
        [say("provenance.model"), s.provenance.spec_hash],
        [say("provenance.state"), s.state_hash],
        [
          say("provenance.size"),
          say("provenance.counts", { blocks: s.blocks, joints: s.joints, points: s.points }),
        ],
        [
          say("provenance.steps"),
          say("provenance.step_words", {
            steps: s.steps,
            step: qty(s.time_step_s, "s"),
            seconds: qty(s.wall_seconds, "s"),
          }),
        ],
      ]),
      h(
        "details",
        {},
        h("summary", {}, say("provenance.model_text")),
        h("pre", { tabindex: 0 }, this.header.model_text),
      ),
    ];
  }
}

export function runSections(bundle: Bundle<RunHeader>): Section[] {
  return new RunPage(bundle).sections();
}
