// The page of a run: curve and wall side by side, how it failed, where the energy went, whether it
// was slow enough, what went in.
import type { Bundle } from "./bundle";
import { append, h, svg, type Child } from "./dom";
import { Figure, hideTip, legend, pointIn, showTip, swatch } from "./figure";
import { aroundPrint, type Section } from "./page";
import { Plot, rangeOf, type Point, type Range } from "./plot";
import { assumptions, inputTables, provenanceTable } from "./inputs";
import { table } from "./tables";
import { capital, num, phrase, qty, say, sentence } from "./texts";
import { Frames, readWall } from "./wall";
import { WallView, type FrameInfo } from "./wallview";

interface Curve {
  displacement: number[]; drift: number[]; reaction: number[]; base: number[];
  unbalance: number[]; kinetic: number[]; factor: number[];
}

function readCurve(bundle: Bundle): Curve {
  const get = (name: string): number[] => Array.from(bundle.array(`curve.${name}`));
  return { displacement: get("displacement_mm"), drift: get("drift_percent"), reaction: get("reaction_kN"),
           base: get("base_shear_kN"), unbalance: get("unbalance_ratio"), kinetic: get("kinetic_ratio"),
           factor: get("load_factor") };
}

const zip = (x: number[], y: number[]): Point[] => x.map((v, i) => [v, y[i]]);

// Words for a frame's labels: "peak", "20 mm", "end".
const labelOf = (labels: string[]): string => labels.map((l) => phrase(l)).join(", ");

class RunPage {
  private readonly header: any;
  private readonly s: any;
  private readonly curve: Curve;
  private readonly byFactor: boolean;
  private readonly view: WallView | null;
  private plot: Plot | null = null;
  private cursor: SVGGElement | null = null;

  constructor(private readonly bundle: Bundle) {
    this.header = bundle.header;
    this.s = this.header.summary;
    this.curve = readCurve(bundle);
    this.byFactor = !(this.s.peak_reaction_kN > 0) && this.s.load_factor > 0;
    this.view = this.makeView();
  }

  private makeView(): WallView | null {
    const wall = readWall(this.bundle);
    if (!wall || (this.header.frames ?? []).length === 0) return null;
    const info: FrameInfo[] = this.header.frames.map((f: any) => ({
      label: labelOf(f.labels), displacement: f.displacement_mm, reaction: f.reaction_kN }));
    return new WallView({ id: "wall", wall, frames: new Frames(this.bundle, wall), info, player: true,
                          onFrame: () => this.moveCursor() });
  }

  sections(): Section[] {
    return [
      { id: "push", title: say("section.push"), content: this.push() },
      { id: "failure", title: say("section.failure"), content: this.failure() },
      { id: "energy", title: say("section.energy"), content: this.energy() },
      { id: "trust", title: say("section.trust"), content: this.trust() },
      { id: "inputs", title: say("section.inputs"), content: inputTables(this.header.inputs, this.header.note) },
      { id: "provenance", title: say("section.provenance"), content: this.provenance() },
    ];
  }

  // --- curve and wall ------------------------------------------------------------------------------

  private push(): Child {
    const curve = this.curve.displacement.length > 1 ? this.curveFigure().element
      : h("p", { class: "note" }, say("run.no_curve"));
    const wall = this.view?.element ?? h("p", { class: "note" }, say("run.no_states"));
    return [h("div", { class: "hero" }, curve, wall), this.eventList(), this.view ? this.printStates(this.view) : null];
  }

  private curveFigure(): Figure {
    const kind = this.byFactor ? "factor" : "force";
    const items: [SVGSVGElement, Child][] = [[swatch("force"), say(`curve.${kind}`)]];
    if (!this.byFactor) items.push([swatch("base"), say("curve.base")]);
    if (this.s.bilinear?.force_kN > 0) items.push([swatch("fit"), say("curve.bilinear")]);
    const figure = new Figure({
      id: "curve", title: say(`curve.${kind}.title`), above: legend(items),
      wide: true, draw: (width, onPaper) => this.drawCurve(width, onPaper),
      caption: say("curve.caption"),
      sheet: () => ({ head: ["displacement_mm", "drift_percent", "reaction_kN", "base_shear_kN", "unbalance_ratio", "kinetic_ratio", "load_factor"],
        rows: this.curve.displacement.map((d, i) => [d, this.curve.drift[i], this.curve.reaction[i], this.curve.base[i],
                                                     this.curve.unbalance[i], this.curve.kinetic[i], this.curve.factor[i]]) }),
    });
    return figure;
  }

  private drawCurve(width: number, onPaper: boolean): SVGSVGElement {
    const c = this.curve, force = this.byFactor ? c.factor : c.reaction;
    const y = rangeOf([0, ...force]), x = rangeOf([0, ...c.displacement]);
    const air = 0.1 * (y[1] - y[0]);
    const height = onPaper ? 0.42 * width : Math.max(280, Math.min(520, 0.84 * width));
    const last = c.displacement.findIndex((d, i) => Math.abs(d) > 1e-6 && Math.abs(c.drift[i]) > 0);
    const plot = new Plot({ width, height, x: [x[0], x[1] * 1.01], y: [y[0] < -0.02 * y[1] ? y[0] - air : 0, y[1] + air],
      xLabel: say("axis.displacement"), yLabel: say(this.byFactor ? "axis.factor" : "axis.reaction"), title: say("curve.alt", this.altPlaces()),
      topAxis: last >= 0 ? { label: say("drift"), unit: "%", factor: c.drift[last] / c.displacement[last] } : undefined });
    if (!this.byFactor) plot.line(zip(c.displacement, c.base), "base");
    this.drawBilinear(plot);
    plot.line(zip(c.displacement, force), "force");
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

  private drawBilinear(plot: Plot): void {
    const b = this.s.bilinear;
    if (this.byFactor || !(b?.force_kN > 0)) return;
    plot.line([[0, 0], [b.yield_displacement_mm, b.force_kN], [b.ultimate_displacement_mm, b.force_kN]], "fit");
  }

  private drawMarks(plot: Plot): void {
    if (!this.byFactor && this.s.peak_reaction_kN > 0) {
      plot.dot(this.s.displacement_at_peak_mm, this.s.peak_reaction_kN, 4.5, "peak");
      if (!this.s.censored_80) plot.dot(this.s.displacement_at_80_percent_mm, 0.8 * this.s.peak_reaction_kN, 4.5, "peak");
    }
    let before: Point = [-100, -100];
    (this.s.events as any[]).forEach((e, i) => {
      let at: Point = [plot.X(e.displacement_mm), plot.Y(this.byFactor ? 0 : e.reaction_kN)];
      if (!Number.isFinite(at[0] + at[1])) return;
      // marks at one place stack downwards, to the right of the curve
      if (Math.hypot(at[0] - before[0], at[1] - before[1]) < 18) at = [before[0] + 11, before[1] + 14];
      before = at;
      append(plot.over, [svg("g", { class: "event", "data-event": e.name },
        svg("title", {}, `${phrase(e.name)}: ${qty(e.displacement_mm, "mm")}, ${qty(e.reaction_kN, "kN")}`),
        svg("circle", { class: "mark", cx: at[0], cy: at[1], r: 8 }),
        svg("text", { class: "markno", x: at[0], y: at[1] + 3.6, "text-anchor": "middle" }, i + 1))]);
    });
  }

  private moveCursor(): void {
    if (!this.plot || !this.cursor || !this.view) return;
    const info = this.view.spec.info[this.view.look.frame];
    const x = this.plot.X(info.displacement);
    const row = this.rowAt(info.displacement);
    const y = this.plot.Y(this.byFactor ? this.curve.factor[row] : this.curve.reaction[row]);
    this.cursor.replaceChildren(svg("line", { class: "cursor-line", x1: x, x2: x, y1: this.plot.top, y2: this.plot.bottom }),
                                svg("circle", { class: "cursor-dot", cx: x, cy: y, r: 5 }));
  }
  private rowAt(displacement: number): number {
    let best = 0;
    this.curve.displacement.forEach((d, i) => {
      if (Math.abs(d - displacement) < Math.abs(this.curve.displacement[best] - displacement)) best = i;
    });
    return best;
  }
  private frameAt(displacement: number): number {
    const info = this.view!.spec.info;
    let best = 0;
    info.forEach((f, i) => {
      if (Math.abs(f.displacement - displacement) < Math.abs(info[best].displacement - displacement)) best = i;
    });
    return best;
  }
  private listen(plot: Plot): void {
    const point = (event: PointerEvent): void => {
      const [px] = pointIn(plot.svg, event);
      if (px < plot.left || px > plot.right) return hideTip();
      const row = this.rowAt(plot.xAt(px)), c = this.curve;
      showTip(event, [[say("displacement"), qty(c.displacement[row], "mm")], [say("drift"), qty(c.drift[row], "%")],
        this.byFactor ? [say("curve.factor"), num(c.factor[row])] : [say("curve.force"), qty(c.reaction[row], "kN", 4)],
        ...(this.byFactor ? [] : [[say("curve.base"), qty(c.base[row], "kN", 4)] as [string, string]])]);
      if (this.view && (event.buttons > 0 || event.type === "pointerdown")) this.view.show(this.frameAt(plot.xAt(px)));
    };
    plot.svg.addEventListener("pointermove", point);
    plot.svg.addEventListener("pointerdown", point);
    plot.svg.addEventListener("pointerleave", hideTip);
    plot.svg.style.touchAction = "pan-y";
    plot.svg.style.cursor = "crosshair";
  }

  private eventList(): Child {
    if (this.s.events.length === 0) return null;
    return h("ol", { class: "events", "aria-label": say("events") }, this.s.events.map((e: any) =>
      h("li", {}, h("b", {}, capital(phrase(e.name))), " ",
        h("span", { class: "soft" }, `${qty(e.displacement_mm, "mm")}, ${qty(e.reaction_kN, "kN")}`),
        e.where ? `: ${phrase(e.where)}` : "")));
  }

  // Pictures of the labelled states, for paper only.
  private printStates(view: WallView): HTMLElement {
    const place = h("div", { class: "print-only pictures" });
    aroundPrint(() => {
      const labelled = this.header.frames.map((f: any, i: number) => [f, i]).filter(([f]: any) => f.labels.length > 0 && f.labels[0] !== "start");
      const peak = labelled.filter(([f]: any) => f.labels.includes("peak")), end = labelled.slice(-1);
      place.replaceChildren(...[...new Map([...peak, ...end].map((p: any) => [p[1], p])).values()].map(([, i]: any) =>
        h("figure", {}, view.picture(i, 400), h("figcaption", {}, `${view.spec.info[i].label}: ${qty(view.spec.info[i].displacement, "mm")}, ${qty(view.spec.info[i].reaction, "kN")}`))));
    }, () => place.replaceChildren());
    return place;
  }

  // --- how it failed -------------------------------------------------------------------------------

  private failure(): Child {
    const mode = this.s.failure_mode;
    if (mode.evidence.length === 0 && mode.elements.length === 0) return null;
    const unit = (u: string): string => (u === "share" || u === "-" ? "" : u);
    const measured = (rows: any[], word: string): Child => table(
      [{ head: say("failure.element"), left: true }, { head: say("failure.sign"), left: true }, { head: say("failure.measured") },
       { head: say("failure.threshold") }, { head: word }],
      rows.map((e) => [phrase(e.element), phrase(e.measure), qty(e.value, unit(e.unit)), qty(e.threshold, unit(e.unit)),
                       h(e.margin >= 0 ? "b" : "span", {}, say(e.margin >= 0 ? "yes" : "no"))]));
    return [
      h("p", { class: "lead" }, h("b", {}, phrase(mode.name)), mode.sentence ? `: ${phrase(mode.sentence)}. ` : ". ",
        h("span", { class: "soft" }, say("failure.read_at", { at: qty(mode.read_at_mm, "mm") }))),
      this.scores(mode),
      mode.elements.length > 0 ? table([{ head: say("failure.element"), left: true }, { head: say("failure.state"), left: true },
        { head: say("failure.first") }], mode.elements.map((e: any) => [phrase(e.element), phrase(e.state),
        e.displacement_first_mm === null ? "–" : qty(e.displacement_first_mm, "mm")]), say("failure.elements")) : null,
      this.sensitivity(mode),
      mode.flags.length > 0 ? [h("h3", {}, say("failure.severity")), measured(mode.flags, say("failure.raised"))] : null,
      h("details", { class: "print-open" }, h("summary", {}, say("failure.measures")), measured(mode.evidence, say("failure.reached"))),
    ];
  }

  private scores(mode: any): Child {
    const entries = Object.entries(mode.scores as Record<string, number>);
    if (entries.length === 0) return null;
    return h("dl", { class: "scores" }, entries.map(([name, score]) => h("div", { class: name === mode.name ? "score chosen" : "score" },
      h("dt", {}, phrase(name)), h("dd", {}, h("span", { class: "meter", "aria-hidden": "true" },
        h("span", { style: `inline-size:${Math.max(0, Math.min(100, 100 * score)).toFixed(1)}%` })), h("span", {}, num(score, 2))))));
  }

  private sensitivity(mode: any): Child {
    const others = mode.sensitivity.filter((r: any) => r.name !== mode.name);
    if (mode.sensitivity.length === 0) return null;
    const n = mode.sensitivity.length;
    return h("p", {}, others.length === 0 ? say("failure.stable", { n })
      : say("failure.unstable", { n, others: others.map((r: any) => `${phrase(r.what)}: ${phrase(r.name)}`).join("; ") }));
  }

  // --- energy --------------------------------------------------------------------------------------

  private energy(): Child {
    const e = this.s.energy_J;
    const kParts = ["friction", "fracture", "crushing", "damping", "elastic", "kinetic"] as const;
    const frames = (this.header.frames ?? []) as any[], ledger = (this.header.energy ?? []) as any[];
    const put = Math.max(e.loads, 0) + Math.max(e.drive, 0);
    const share = (j: number): string => (put > 0 ? qty(100 * j / put, "%") : "–");
    const rows: Child[][] = [[say("energy.drive"), num(e.drive), share(e.drive)]];
    if (e.loads > 0) rows.push([say("energy.loads"), num(e.loads), share(e.loads)]);
    for (const part of kParts)
      rows.push([h("span", {}, h("span", { class: `chip e-${part}`, "aria-hidden": "true" }), say(`energy.${part}`)), num(e[part]), share(e[part])]);
    if (e.loads < 0) rows.push([say("energy.lifting"), num(-e.loads), share(-e.loads)]);
    rows.push([say("energy.gap"), num(e.gap), qty(e.gap_ratio === null ? null : 100 * e.gap_ratio, "%")]);
    const list = table([{ head: "", left: true }, { head: "J" }, { head: say("share") }], rows.map((r) => r), say("energy.table"));
    if (frames.length < 3) return [h("p", { class: "soft" }, say("energy.lead")), list];
    // dissipated since the start of the push, stored as it is above the start
    const from = ledger[0];
    const series = kParts.map((part) => ledger.map((l) => Math.max(0, l[part] - from[part])));
    const x = frames.map((f) => f.displacement_mm);
    const figure = new Figure({
      id: "energy-chart", title: say("energy.title"), caption: say("energy.caption"),
      above: legend([...kParts.map((part): [SVGSVGElement, Child] => [swatch(`area e-${part}`, "box"), say(`energy.${part}`)]),
                     [swatch("work"), say("energy.work")]]),
      draw: (width) => {
        const total = x.map((_, i) => series.reduce((sum, s) => sum + s[i], 0));
        const work = ledger.map((l) => l.drive - from.drive + l.loads - from.loads);
        const plot = new Plot({ width, height: Math.max(250, Math.min(380, 0.6 * width)), x: rangeOf([0, ...x]), y: rangeOf([0, ...total, ...work].map((v) => v * 1.04)),
                                xLabel: say("axis.displacement"), yLabel: say("axis.energy"), title: say("energy.title") });
        let low = x.map(() => 0);
        kParts.forEach((part, k) => {
          const high = low.map((v, i) => v + series[k][i]);
          plot.band(x, low, high, `area e-${part}`);
          low = high;
        });
        plot.line(zip(x, work), "work");
        return plot.svg;
      },
      sheet: () => ({ head: ["displacement_mm", "work_J", ...kParts.map((p) => `${p}_J`)],
        rows: x.map((d, i) => [d, ledger[i].drive - from.drive + ledger[i].loads - from.loads, ...series.map((s) => s[i])]) }),
    });
    return [h("p", { class: "soft" }, say("energy.lead")), h("div", { class: "pair" }, figure.element, list)];
  }

  // --- trust ---------------------------------------------------------------------------------------

  private trust(): Child {
    const q = this.s.quasi_static;
    const rows: Child[][] = [
      [say("trust.unbalance"), num(q.unbalance_ratio_mean), num(q.unbalance_ratio_max), say("trust.unbalance.means")],
      [say("trust.kinetic"), num(q.kinetic_ratio_mean), num(q.kinetic_ratio_max), say("trust.kinetic.means")],
      [say("trust.shear"), num(q.shear_gap), "", say("trust.shear.means")],
      [say("trust.damping"), num(q.damping_share), "", say("trust.damping.means")]];
    const list = table([{ head: say("trust.measure"), left: true }, { head: say("mean") }, { head: say("largest") }, { head: say("trust.means"), left: true }], rows);
    const verdict = h("p", { class: "lead" }, sentence(q.verdict));
    const stages = this.s.stages.length === 0 ? null : table(
      [{ head: say("stage"), left: true }, { head: say("stage.time") }, { head: say("stage.steps") }, { head: say("stage.unbalance") }, { head: say("stage.settled") }],
      this.s.stages.map((g: any) => [g.name, qty(g.time_s, "s"), String(g.steps), num(g.unbalance_ratio), g.settled ? say("yes") : "–"]), say("stages"));
    if (this.curve.displacement.length < 3) return [verdict, list, stages];
    return [verdict, h("div", { class: "pair" }, this.ratioFigure().element, h("div", {}, list, stages))];
  }

  private ratioFigure(): Figure {
    const c = this.curve;
    const positive = [...c.unbalance, ...c.kinetic].filter((v) => v > 0);
    const range: Range = [Math.floor(Math.log10(Math.max(1e-8, Math.min(...positive)))), Math.ceil(Math.log10(Math.max(...positive, 1e-2)))];
    return new Figure({
      id: "ratios", title: say("trust.title"), caption: say("trust.caption"),
      above: legend([[swatch("force"), say("trust.unbalance")], [swatch("base"), say("trust.kinetic")]]),
      draw: (width) => {
        const plot = new Plot({ width, height: Math.max(230, Math.min(330, 0.55 * width)), x: rangeOf([0, ...c.displacement]), y: range,
          yTicks: Array.from({ length: range[1] - range[0] + 1 }, (_, i) => range[0] + i),
          yFormat: (v) => num(10 ** v, 2), xLabel: say("axis.displacement"), yLabel: say("axis.ratio"), title: say("trust.title") });
        const log = (v: number[]): Point[] => zip(c.displacement, v.map((x) => (x > 0 ? Math.log10(x) : NaN)));
        plot.line(log(c.kinetic), "base");
        plot.line(log(c.unbalance), "force thin");
        return plot.svg;
      },
      sheet: () => ({ head: ["displacement_mm", "unbalance_ratio", "kinetic_ratio"], rows: c.displacement.map((d, i) => [d, c.unbalance[i], c.kinetic[i]]) }),
    });
  }

  private provenance(): Child {
    const s = this.s;
    return [h("p", { class: "soft" }, say("provenance.lead")), assumptions(), provenanceTable([
      [say("provenance.program"), `wythe ${s.provenance.version} (${s.provenance.commit})`],
      [say("provenance.compiler"), `${s.provenance.compiler}, ${s.provenance.build_type}, ${s.provenance.flags}`],
      [say("provenance.model"), s.provenance.spec_hash], [say("provenance.state"), s.state_hash],
      [say("provenance.size"), say("provenance.counts", { blocks: s.blocks, joints: s.joints, points: s.points })],
      [say("provenance.steps"), say("provenance.step_words", { steps: s.steps, step: qty(s.time_step_s, "s"), seconds: qty(s.wall_seconds, "s") })]]),
      h("details", {}, h("summary", {}, say("provenance.model_text")), h("pre", { tabindex: 0 }, this.header.model_text))];
  }
}

export function runSections(bundle: Bundle): Section[] {
  return new RunPage(bundle).sections();
}
