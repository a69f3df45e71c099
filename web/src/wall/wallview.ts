// The wall with its controls: 2D or 3D, display of joints, magnification, time and play.
import { atRest, h, later, svg } from "../base/dom";
import { download, standalone, toCsv, toPng } from "../base/export";
import { hideTip, legend, pointIn, showTip, swatch } from "../base/figure";
import { Painter } from "../base/paths";
import { Player } from "../base/player";
import { num, qty, say, sentence } from "../base/texts";
import { canvasFor, drawParts, drawWall, jointAt, zoneAt, type Canvas, type Look } from "./wall2d";
import { makeScene, type Scene } from "./wall3d";
import {
  crackOf,
  fieldOf,
  fittingScale,
  isField,
  jointStress,
  kSteps,
  measuresOf,
  stressSteps,
  type Field,
  type Frames,
  type Measure,
  type Wall,
} from "./wall";

export interface FrameInfo {
  label: string;
  displacement: number;
  reaction: number;
}
export interface WallViewSpec {
  id: string;
  wall: Wall;
  frames: Frames;
  info: FrameInfo[];
  onFrame?: (frame: number) => void; // after the slider moved
  tallest?: number;
}

// The functions of a wall's view that pages use, in the plane or in space.
export interface View {
  readonly element: HTMLElement;
  readonly look: { readonly frame: number };
  readonly spec: { readonly info: FrameInfo[] };
  show(frame: number, quiet?: boolean): void;
  choose(first: number, last: number): void; // the states to step through
  picture(frame: number, width: number, tallest: number): HTMLElement; // for paper
}

export const kScales = [1, 2, 5, 10, 20, 50, 100, 200];

export const scaleWords = (scale: number): string =>
  scale === 1 ? say("wall.to_scale") : say("wall.scaled", { scale: num(scale) });

export class WallView implements View {
  readonly element: HTMLElement;
  readonly look: Look;
  private readonly stage = h("div", { class: "stage wall-stage" });
  private readonly key = h("div", { class: "wall-key" });
  private readonly caption = h("output", { class: "wall-caption" });
  private readonly player = new Player((frame) => this.show(frame));
  private canvas!: Canvas;
  private width = 0;
  private painter: Painter | null = null; // while the wall moves
  private explained = ""; // the content of the present legend
  private scene: Scene | null = null;
  private solid = false;

  constructor(readonly spec: WallViewSpec) {
    const last = Math.max(0, spec.frames.count - 1);
    this.look = {
      frame: last,
      scale: fittingScale(spec.wall, spec.frames),
      measure: "cracks",
      forces: false,
      numbers: spec.wall.parts.some((part) => part.kind === "spandrel"),
      lit: "",
      stressSteps: stressSteps(spec.wall, spec.frames),
    };
    this.choose(0, last);
    this.element = h(
      "figure",
      { id: spec.id, class: "wall-view" },
      h("div", { class: "figure-head" }, h("h3", {}, say("wall.title")), this.tools()),
      this.controls(),
      this.stage,
      this.key,
      this.player.element,
      this.caption,
    );
    this.stage.addEventListener("pointermove", (e) => this.point(e));
    this.stage.addEventListener("pointerleave", hideTip);
    later(() => {
      this.fit();
      new ResizeObserver(() => this.fit()).observe(this.stage);
    });
  }

  fit(): void {
    const width = Math.max(260, Math.round(this.stage.clientWidth));
    if (width === this.width) return;
    this.width = width;
    this.canvas = canvasFor(this.spec.wall, width, this.spec.tallest ?? 560);
    this.painter = null;
    if (this.solid) this.scene?.resize(width, this.canvas.height);
    this.redraw();
  }
  // Steps only through these frames: the states of one sample, in time.
  choose(first: number, last: number): void {
    this.player.choose(first, last);
  }
  show(frame: number, quiet = false): void {
    this.look.frame = this.player.put(frame);
    this.redraw(true);
    if (!quiet) this.spec.onFrame?.(this.look.frame);
  }
  // Highlights a part of the wall; "": none.
  light(name: string): void {
    if (this.look.lit === name) return;
    this.look.lit = name;
    this.redrawParts();
  }
  private redrawParts(): void {
    const layer = this.stage.querySelector("svg.wall g.parts");
    layer?.replaceWith(drawParts(this.spec.wall, this.spec.frames, this.look, this.canvas));
  }
  // While it moves, it is painted on a canvas; at rest, an SVG drawing follows, whose parts can be pointed at and exported.
  redraw(moves = false): void {
    if (this.width === 0 || this.spec.frames.count === 0) return;
    const info = this.spec.info[this.look.frame];
    const words = [info.label, qty(info.displacement, "mm"), qty(info.reaction, "kN")].filter(
      (w) => w !== "",
    );
    this.caption.textContent = [...words, scaleWords(this.look.scale)].join(" · ");
    this.player.tell(words.join(", "));
    this.explain();
    if (this.solid && this.scene) this.scene.draw(this.look);
    else if (moves) this.paint();
    else this.settle();
  }
  private paint(): void {
    const { wall, frames } = this.spec;
    this.painter ??= new Painter(this.stage, this.canvas.width, this.canvas.height);
    const above = drawWall(wall, frames, this.look, this.canvas, this.painter);
    if (this.painter.element.parentNode === this.stage) this.stage.lastChild!.replaceWith(above);
    else this.stage.replaceChildren(this.painter.element, above);
    atRest(this, () => this.settle());
  }
  private settle(): void {
    this.painter = null; // the theme may have changed when it moves again
    if (!this.solid) this.stage.replaceChildren(drawWall(this.spec.wall, this.spec.frames, this.look, this.canvas));
  }
  private explain(): void {
    const what = `${this.look.measure} ${this.look.forces} ${this.spec.wall.fields[0]?.sample}`;
    if (what === this.explained) return;
    this.explained = what;
    this.key.replaceChildren(this.legend());
  }
  // A figure for paper, with its legend below.
  picture(frame: number, width: number, tallest: number): HTMLElement {
    const scale = fittingScale(this.spec.wall, this.spec.frames, frame),
      info = this.spec.info[frame];
    const drawing = drawWall(
      this.spec.wall,
      this.spec.frames,
      { ...this.look, frame, scale, measure: "cracks", forces: false, lit: "" },
      canvasFor(this.spec.wall, width, tallest),
    );
    const words = [info.label, qty(info.displacement, "mm"), qty(info.reaction, "kN"), scaleWords(scale)];
    return h("figure", {}, drawing, h("figcaption", {}, words.filter((w) => w !== "").join(" · ")));
  }

  private tools(): HTMLElement {
    const drawing = (): SVGSVGElement => drawWall(this.spec.wall, this.spec.frames, this.look, this.canvas);
    const shown = (work: (d: SVGSVGElement) => void): void => {
      if (this.painter) this.settle();
      // the page's styles apply only to drawings within it
      const d = this.stage.querySelector<SVGSVGElement>("svg.wall") ?? drawing();
      work(d);
    };
    const button = (kind: string, act: () => void): HTMLElement =>
      h(
        "button",
        {
          type: "button",
          class: "tool",
          "data-export": kind.toLowerCase(),
          onclick: act,
          "aria-label": say("export.as", { what: say("wall.title"), kind }),
        },
        kind,
      );
    return h(
      "div",
      { class: "tools", role: "group", "aria-label": say("export") },
      button("SVG", () => shown((d) => download("wall.svg", "image/svg+xml", standalone(d)))),
      button("PNG", () =>
        this.solid && this.scene
          ? void this.scene.png().then((png) => download("wall.png", "image/png", png))
          : shown((d) => void toPng(d).then((png) => download("wall.png", "image/png", png))),
      ),
      button("CSV", () => download("wall.csv", "text/csv", toCsv(this.sheet()))),
    );
  }
  private sheet(): { head: string[]; rows: (string | number)[][] } {
    const frame = this.spec.frames.at(this.look.frame),
      wall = this.spec.wall;
    const rows: (string | number)[][] = [];
    for (let j = 0; j < wall.joints; ++j) {
      const b = wall.jointB[j];
      rows.push([
        j,
        wall.kind[j],
        wall.centroidX[b] + wall.armBX[j],
        wall.centroidY[b] + wall.armBY[j],
        frame.opening[j] * 1e3,
        frame.slip[j] * 1e3,
        frame.damage[j] / 255,
        frame.crushing[j] / 255,
        ...(frame.compression && frame.shear ? [frame.compression[j] / 1e3, frame.shear[j] / 1e3] : []),
        ...wall.fields.filter((f) => !f.onBlocks).map((f) => f.values[j] ?? NaN),
      ]);
    }
    return {
      head: [
        "joint",
        "kind",
        "x_m",
        "y_m",
        "opening_mm",
        "slip_mm",
        "damage",
        "crushing",
        ...(frame.compression ? ["compression_kN", "shear_kN"] : []),
        ...wall.fields.filter((f) => !f.onBlocks).map((f) => `${f.name}_${f.unit}`),
      ],
      rows,
    };
  }

  private words(m: Measure): string {
    return isField(m) ? say("measure.field", { name: fieldOf(this.spec.wall, m).name }) : say(`measure.${m}`);
  }

  private controls(): HTMLElement {
    const measure = h(
      "select",
      { "aria-label": say("wall.measure") },
      measuresOf(this.spec.frames).map((m) => h("option", { value: m }, this.words(m))),
    );
    measure.addEventListener("change", () => {
      this.look.measure = measure.value as Measure;
      this.redraw();
    });
    const shown = h("output", {}, `× ${num(this.look.scale)}`);
    const scale = h("input", {
      type: "range",
      min: 0,
      max: kScales.length - 1,
      step: 1,
      class: "scale",
      value: Math.max(0, kScales.indexOf(this.look.scale)),
      "aria-label": say("wall.scale"),
    });
    scale.addEventListener("input", () => {
      this.look.scale = kScales[Number(scale.value)];
      scale.setAttribute("aria-valuetext", `× ${num(this.look.scale)}`);
      shown.textContent = `× ${num(this.look.scale)}`;
      this.redraw();
    });
    const forces = h("input", { type: "checkbox" });
    forces.addEventListener("change", () => {
      this.look.forces = forces.checked;
      this.redraw();
    });
    const numbers = h("input", { type: "checkbox" });
    numbers.checked = this.look.numbers;
    numbers.addEventListener("change", () => {
      this.look.numbers = numbers.checked;
      this.redrawParts();
    });
    const flat = h("button", { type: "button", "aria-pressed": "true", class: "segment" }, "2D");
    const solid = h("button", { type: "button", "aria-pressed": "false", class: "segment" }, "3D");
    const choose = (want: boolean): void => {
      this.turnSolid(want);
      flat.setAttribute("aria-pressed", String(!this.solid));
      solid.setAttribute("aria-pressed", String(this.solid));
    };
    flat.addEventListener("click", () => choose(false));
    solid.addEventListener("click", () => choose(true));
    return h(
      "div",
      { class: "controls" },
      h("div", { class: "segments", role: "group", "aria-label": say("wall.view") }, flat, solid),
      h("label", {}, h("span", {}, say("wall.measure")), measure),
      h("label", {}, h("span", {}, say("wall.scale")), scale, shown),
      this.spec.frames.hasForces
        ? h("label", { class: "check" }, forces, h("span", {}, say("wall.forces")))
        : null,
      this.spec.wall.parts.length > 0
        ? h("label", { class: "numbers" }, numbers, h("span", {}, say("wall.numbers")))
        : null,
    );
  }

  private turnSolid(want: boolean): void {
    this.solid = want;
    this.stage.classList.toggle("solid", want);
    if (!want) return this.redraw();
    this.scene ??= makeScene(this.spec.wall, this.spec.frames);
    if (!this.scene) return this.withoutWebGl();
    this.stage.replaceChildren(this.scene.element);
    this.scene.resize(this.width, this.canvas.height);
    this.redraw();
  }
  private withoutWebGl(): void {
    this.solid = false;
    this.stage.classList.remove("solid");
    if (!this.element.querySelector(".no-webgl"))
      this.stage.after(h("p", { class: "note no-webgl", role: "status" }, say("wall.no_webgl")));
    this.redraw();
  }

  private legend(): HTMLElement {
    const { measure, forces } = this.look;
    const extra: [SVGSVGElement, string][] = forces ? [[swatch("thrust key"), say("wall.force_key")]] : [];
    if (measure === "cracks")
      return legend([
        [swatch("crack open w2"), say("crack.open")],
        [swatch("crack slip w2"), say("crack.slip")],
        [swatch("crack closed w0"), say("crack.closed")],
        [swatch("crack softening w0"), say("crack.softening")],
        [swatch("crushed", "dot"), say("crack.crushed")],
        ...extra,
      ]);
    if (measure === "stress") return h("div", {}, this.stressLegend(), legend(extra));
    if (isField(measure)) return this.fieldLegend(fieldOf(this.spec.wall, measure), extra);
    const bounds = kSteps[measure],
      unit = measure === "opening" || measure === "slip" ? "\u202fmm" : "";
    const items = bounds.map((from, i): [SVGSVGElement, string] => [
      swatch(`joint ${measure} r${i + 1}`),
      i + 1 < bounds.length ? `${num(from)}–${num(bounds[i + 1])}${unit}` : `> ${num(from, 4)}${unit}`,
    ]);
    return legend([...items, ...extra]);
  }

  // The steps from the smallest value in the wall to the largest, and the given mean.
  private fieldLegend(field: Field, extra: [SVGSVGElement, string][]): HTMLElement {
    const { steps, unit } = field,
      known = Array.from(field.values).filter((v) => !Number.isNaN(v));
    const end = (k: number): number => (k + 1 < steps.length ? steps[k + 1] : Math.max(...known));
    const items = steps.map((from, k): [SVGSVGElement, string] => [
      field.onBlocks ? swatch(`block-field r${k + 1}`, "box") : swatch(`joint field r${k + 1}`),
      steps.length > 1 ? `${num(from, 3)}–${num(end(k), 3)}` : num(from, 3),
    ]);
    const words = [
      say(field.follows ? "field.legend.follows" : "field.legend", { path: field.path, mean: qty(field.mean, unit, 3) }),
      field.note ? sentence(field.note) : "",
    ].join(" ");
    return h("div", { class: "field-key" }, h("b", {}, unit), legend([...items, ...extra]), h("p", { class: "soft small" }, words));
  }

  // Two rows with the same steps, and the names of their quantities.
  private stressLegend(): HTMLElement {
    const { stressSteps: bounds } = this.look,
      { frames } = this.spec;
    const row = (sign: string, word: string): HTMLElement =>
      h(
        "div",
        { class: "stress-key" },
        h("b", {}, word),
        legend(
          bounds.map((from, i): [SVGSVGElement, string] => [
            swatch(`zone-stress ${sign} r${i + 1}`, "box"),
            i + 1 < bounds.length ? `${num(from)}–${num(bounds[i + 1])}` : `> ${num(from)}\u202fMPa`,
          ]),
        ),
      );
    const what = [
      frames.hasZoneStress ? say("stress.zones") : "",
      frames.hasForces ? say("stress.joints") : "",
    ].filter((w) => w !== "");
    return h(
      "div",
      { class: "stress-keys" },
      row("c", say("stress.compression")),
      row("t", say("stress.tension")),
      h("p", { class: "soft small" }, `${what.join("; ")}.`),
    );
  }

  private point(event: PointerEvent): void {
    const drawing = this.stage.querySelector<SVGSVGElement>("svg.wall");
    if (!drawing || this.solid || this.painter) return;
    const { wall, frames } = this.spec;
    const j = jointAt(wall, frames, this.look, this.canvas, ...pointIn(drawing, event));
    drawing.querySelector(".pointed")?.remove();
    if (j < 0 || this.look.measure === "stress") {
      const z = zoneAt(wall, frames, this.look, this.canvas, ...pointIn(drawing, event));
      if (z >= 0) return this.tellZone(event, z);
    }
    if (j < 0) return hideTip();
    const frame = frames.at(this.look.frame);
    const lines: (string | [string, string])[] = [
      `${say(`joint.${wall.kind[j]}`)}, ${say(`crack.${crackOf(frame, j)}.short`)}`,
      [say("measure.opening"), qty(frame.opening[j] * 1e3, "mm", 2)],
      [say("measure.slip"), qty(frame.slip[j] * 1e3, "mm", 2)],
      [say("measure.damage"), num(frame.damage[j] / 255, 2)],
      [say("measure.crushing"), num(frame.crushing[j] / 255, 2)],
    ];
    if (frame.compression && frame.shear)
      lines.push(
        [say("joint.compression"), qty(frame.compression[j] / 1e3, "kN", 2)],
        [say("joint.shear"), qty(frame.shear[j] / 1e3, "kN", 2)],
        [say("stress.normal"), qty(jointStress(wall, frame, j), "MPa", 2)],
      );
    for (const field of wall.fields)
      if (!field.onBlocks && !Number.isNaN(field.values[j] ?? NaN))
        lines.push([field.name, qty(field.values[j], field.unit, 3)]);
    showTip(event, lines);
    drawing.appendChild(svg("g", { class: "pointed" }));
  }
  private tellZone(event: PointerEvent, z: number): void {
    const { greater, smaller } = this.spec.frames.at(this.look.frame);
    showTip(event, [
      say("stress.zone"),
      [say("stress.greater"), qty(1e-6 * greater![z], "MPa", 2)],
      [say("stress.smaller"), qty(1e-6 * smaller![z], "MPa", 2)],
    ]);
  }
}
