// A wall in space with its controls: camera, display of blocks and
// joints, a cut, magnification, time and play, and a picked body.
import type { Bundle } from "../base/bundle";
import { h, later } from "../base/dom";
import { download, toCsv, type Sheet } from "../base/export";
import { hideTip, showTip } from "../base/figure";
import { Player } from "../base/player";
import {
  boundsOf,
  Camera,
  crackOfFace,
  fittingSize,
  kLinkStates,
  Planes,
  Poses,
  readSolids,
  sizeOf,
  SolidStates,
  type Cut,
  type Vec,
} from "./space";
import { glPicture } from "./space_gl";
import { beginCanvas, drawOver, PaintedPicture, type Picture, type Scene } from "./space_paint";
import { kBodies, kFaces, Shown, Styles } from "./space_show";
import { num, qty, say } from "../base/texts";
import { Frames, readWall, roundSteps } from "./wall";
import { kScales, scaleWords, WallView, type FrameInfo, type View } from "./wallview";

export interface SpaceViewSpec {
  id: string;
  states: SolidStates;
  info: FrameInfo[];
  onFrame?: (frame: number) => void; // after the slider moved
  tallest?: number;
}

// The view of a page's wall, in its plane or in space; null if it has none.
export function viewOf(
  bundle: Bundle,
  spec: Omit<SpaceViewSpec, "states">,
  wall = readWall(bundle),
): View | null {
  const solids = readSolids(bundle);
  if (solids) return new SpaceView({ ...spec, states: new SolidStates(bundle, solids) });
  return wall && new WallView({ ...spec, wall, frames: new Frames(bundle, wall) });
}

const kCutSteps = 200;
const kMostLinks = 8; // with their forces in words
const kViews: Record<string, [number, number]> = {
  front: [0, 0],
  side: [Math.PI / 2, 0],
  top: [0, Math.PI / 2],
  oblique: [0.6, 0.42],
};

// A mechanism has no displacement and no force.
const wordsOf = (info: FrameInfo): string[] =>
  [info.label, Number.isFinite(info.displacement) ? qty(info.displacement, "mm") : "", Number.isFinite(info.reaction) ? qty(info.reaction, "kN") : ""].filter((w) => w !== "");

export class SpaceView implements View {
  readonly element: HTMLElement;
  readonly spec: SpaceViewSpec;
  readonly look = { frame: 0 };
  readonly player = new Player(
    (frame) => this.show(frame),
    (at) => this.move(at),
  );
  private readonly stage = h("div", { class: "stage wall-stage space-stage" });
  private readonly over = h("canvas", { class: "over", "aria-hidden": "true" });
  private readonly key = h("div", { class: "wall-key" });
  private readonly caption = h("output", { class: "wall-caption" });
  private readonly links = h("output", { class: "link-forces" });
  private readonly picked = h("output", { class: "picked-body", "aria-live": "polite" });
  private readonly camera = new Camera();
  private readonly planes: Planes;
  private readonly poses: Poses;
  private readonly drawn: Picture;
  private styles = new Styles();
  private scene: Scene | null = null; // as last drawn; null if its content has changed
  private readonly shown: Shown;
  private scale: number;
  private cut: Cut | null = null;
  private clear = false;
  private lit = -1;

  constructor(spec: SpaceViewSpec) {
    this.spec = spec;
    const { solids } = spec.states;
    this.planes = new Planes(solids);
    this.poses = new Poses(spec.states);
    const gl = glPicture(solids);
    this.drawn = gl ?? new PaintedPicture(solids, this.planes);
    this.player.choose(0, Math.max(0, spec.states.count - 1));
    this.look.frame = this.player.last;
    this.scale = fittingSize(spec.states, this.player.last);
    this.shown = new Shown(spec.states);
    const canvas = this.drawn.element;
    canvas.setAttribute("tabindex", "0");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${say("wall.alt")}. ${say("space.turn")}`);
    canvas.title = say("space.turn");
    this.stage.append(canvas, this.over);
    this.element = h(
      "figure",
      { id: spec.id, class: "wall-view" },
      h("div", { class: "figure-head" }, h("h3", {}, say("wall.title")), this.tools()),
      this.controls(),
      this.cutControls(),
      this.stage,
      gl ? null : h("p", { class: "note small no-webgl", role: "status" }, say("space.no_webgl")),
      this.picked,
      this.links,
      this.key,
      this.player.element,
      this.caption,
    );
    this.listen();
    this.stand("oblique");
    window.addEventListener("themechange", () => {
      this.styles = new Styles();
      this.redraw();
    });
    later(() => {
      this.fit();
      new ResizeObserver(() => this.fit()).observe(this.stage);
    });
  }

  show(frame: number, quiet = false): void {
    this.look.frame = this.player.put(frame);
    this.redraw();
    if (!quiet) this.spec.onFrame?.(this.look.frame);
  }
  choose(first: number, last: number): void {
    this.player.choose(first, last);
  }

  // While it plays, only places change until the next stored state.
  private move(at: number): void {
    const frame = Math.floor(at);
    if (frame !== this.look.frame || !this.scene) {
      this.look.frame = this.player.put(frame);
      this.spec.onFrame?.(frame);
      this.tell();
      this.scene = this.compose(frame, this.styles);
    }
    this.poses.set(at, this.scale);
    this.draw(this.scene);
  }
  private fit(): void {
    const width = Math.max(260, Math.round(this.stage.clientWidth));
    if (width === this.camera.width) return;
    const before = this.camera.width;
    this.camera.width = width;
    this.camera.height = Math.round(Math.max(280, Math.min(this.spec.tallest ?? 620, 0.72 * width)));
    if (before <= 1) this.fitAll();
    else this.camera.zoom *= width / before;
    this.redraw();
  }
  private fitAll(): void {
    this.camera.fit(...boundsOf(this.spec.states.solids));
  }
  // One of the standard views; the oblique one is from the side to which the wall moves.
  private stand(name: string): void {
    [this.camera.turn, this.camera.tilt] = kViews[name];
    if (name === "oblique" && this.wayOut() < 0) this.camera.turn += Math.PI;
    this.fitAll();
  }
  private wayOut(): number {
    const { states } = this.spec;
    if (states.count === 0) return 0;
    const { moved } = states.at(states.count - 1);
    let sum = 0;
    for (let i = 2; i < 3 * states.solids.free; i += 3) sum += moved[i];
    return sum;
  }

  redraw(): void {
    if (this.camera.width <= 1 || this.spec.states.count === 0) return;
    this.poses.set(this.look.frame, this.scale);
    this.scene = this.compose(this.look.frame, this.styles);
    this.tell();
    this.key.replaceChildren(this.shown.legend());
    this.draw(this.scene);
  }
  private turned(): void {
    if (this.scene) this.draw(this.scene);
  }
  private draw(scene: Scene): void {
    scene.cut = this.cut;
    this.drawn.draw(scene);
    const to = beginCanvas(this.over, this.camera.width, this.camera.height);
    this.above(to, scene);
  }
  private above(to: CanvasRenderingContext2D, scene: Scene): void {
    const metres = roundSteps((0.25 * scene.camera.width) / scene.camera.zoom, 1).pop() ?? 1;
    drawOver(to, this.spec.states.solids, scene, { metres, words: metres < 0.1 ? qty(1e3 * metres, "mm") : qty(metres, "m") });
  }

  // --- display -------------------------------------------------------------------------------------

  private compose(frame: number, styles: Styles): Scene {
    const state = this.spec.states.at(frame);
    let farthest = 0;
    for (let i = 0; i < state.moved.length; ++i) farthest = Math.max(farthest, Math.abs(state.moved[i]));
    return {
      camera: this.camera,
      poses: this.poses,
      tints: this.shown.tints(state, styles, this.lit),
      marks: this.shown.marks(state, styles),
      links: this.shown.links(state, styles),
      cut: this.cut,
      clear: this.clear,
      farthest: 2 * this.scale * farthest,
      palette: {
        paper: styles.variable("paper"),
        edge: styles.of("mortar").stroke,
        ink: styles.variable("soft"),
        load: styles.variable("ink"),
      },
    };
  }
  private tell(): void {
    const info = this.spec.info[this.look.frame];
    const words = wordsOf(info);
    this.caption.textContent = [...words, scaleWords(this.scale)].join(" · ");
    this.player.tell(words.join(", "));
    this.picked.replaceChildren(...(this.lit >= 0 ? this.bodyLines(this.lit).map((l) => h("span", {}, l)) : []));
    this.links.replaceChildren(...this.linkLines().map((l) => h("span", {}, l)));
  }
  // Force and state of each link, yielded ones first; of many only the first few.
  private linkLines(): string[] {
    const { solids } = this.spec.states,
      state = this.spec.states.at(this.look.frame);
    const order = solids.links.map((_, k) => k).sort((a, b) => Number(state.linkState[b] === 2) - Number(state.linkState[a] === 2) || a - b);
    const lines = order.slice(0, kMostLinks).map((k) => {
      const how = kLinkStates[state.linkState[k]];
      const words = `${solids.links[k].name}: ${qty(state.linkForce[k] / 1e3, "kN", 3)}`;
      return how === "holds" ? words : `${words}, ${say(`link.${how}`)}`;
    });
    if (order.length > kMostLinks) lines.push(say("space.links.more", { n: order.length - kMostLinks }));
    return lines;
  }
  private bodyLines(b: number): string[] {
    const { solids } = this.spec.states,
      state = this.spec.states.at(this.look.frame);
    const three = (v: ArrayLike<number>): Vec => [v[3 * b], v[3 * b + 1], v[3 * b + 2]];
    const moved = three(state.moved),
      turned = three(state.turned);
    let open = 0,
      slid = 0,
      all = 0;
    for (let j = 0; j < solids.joints; ++j)
      if (solids.jointA[j] === b || solids.jointB[j] === b) {
        const crack = crackOfFace(state, j);
        ++all;
        open += crack === "open" ? 1 : 0;
        slid += crack === "slip" ? 1 : 0;
      }
    return [
      solids.names[b] + (b >= solids.free ? `, ${say("space.support")}` : ""),
      say("space.moved", {
        all: qty(1e3 * Math.hypot(...moved), "mm"),
        x: num(1e3 * moved[0]),
        y: num(1e3 * moved[1]),
        z: num(1e3 * moved[2]),
      }),
      say("space.turned", { angle: qty((180 / Math.PI) * Math.hypot(...turned), "°") }),
      say("space.joints", { all, open, slid }),
      say("space.material", { name: solids.materials[solids.material[b]] }),
    ];
  }

  // --- controls ------------------------------------------------------------------------------------

  private controls(): HTMLElement {
    const select = <T extends string>(name: string, list: readonly T[], words: (one: T) => string, take: (one: T) => void): HTMLElement => {
      const made = h("select", {}, list.map((one) => h("option", { value: one }, words(one))));
      made.addEventListener("change", () => {
        take(made.value as T);
        this.redraw();
      });
      return h("label", {}, h("span", {}, name), made);
    };
    const shown = h("output", {}, `× ${num(this.scale)}`);
    const scale = h("input", {
      type: "range",
      min: 0,
      max: kScales.length - 1,
      step: 1,
      class: "scale",
      value: Math.max(0, kScales.indexOf(this.scale)),
      "aria-label": say("wall.scale"),
    });
    scale.addEventListener("input", () => {
      this.scale = kScales[Number(scale.value)];
      scale.setAttribute("aria-valuetext", `× ${num(this.scale)}`);
      shown.textContent = `× ${num(this.scale)}`;
      this.redraw();
    });
    const clear = h("input", { type: "checkbox" });
    clear.addEventListener("change", () => {
      this.clear = clear.checked;
      this.redraw();
    });
    return h(
      "div",
      { class: "controls" },
      h(
        "div",
        { class: "segments", role: "group", "aria-label": say("wall.view") },
        Object.keys(kViews).map((name) =>
          h(
            "button",
            {
              type: "button",
              class: "segment",
              "data-view": name,
              onclick: () => {
                this.stand(name);
                this.turned();
              },
            },
            say(`view.${name}`),
          ),
        ),
      ),
      select(say("space.faces"), kFaces, (m) => say(`measure.${m}`), (m) => (this.shown.faces = m)),
      select(say("space.bodies"), kBodies, (m) => say(`shown.${m}`), (m) => (this.shown.bodies = m)),
      h("label", {}, h("span", {}, say("wall.scale")), scale, shown),
      h("label", { class: "check" }, clear, h("span", {}, say("space.clear"))),
    );
  }

  private cutControls(): HTMLElement {
    const { solids } = this.spec.states;
    const where = h("input", { type: "range", min: 0, max: kCutSteps, value: kCutSteps / 2, class: "cut-at", "aria-label": say("space.cut.at") }),
      told = h("output", { class: "cut-told" }),
      other = h("button", { type: "button", class: "segment lone" }, say("space.cut.other"));
    const which = h(
      "select",
      { class: "cut-axis" },
      ["", "x", "y", "z"].map((name) => h("option", { value: name }, name ? say("space.cut.across", { axis: name }) : say("space.cut.none"))),
    );
    const air = 0.02 * sizeOf(solids);
    const place = (axis: number): number => {
      const from = solids.low[axis] - air;
      return from + (Number(where.value) / kCutSteps) * (solids.high[axis] + air - from);
    };
    const tell = (): void => {
      for (const one of [where, other, told]) one.hidden = this.cut === null;
      if (!this.cut) return;
      const words = say("space.cut.told", {
        axis: "xyz"[this.cut.axis],
        at: qty(this.cut.at + solids.middle[this.cut.axis], "m", 4),
        n: this.planes.hidden(this.poses, this.cut),
        all: solids.free,
      });
      told.textContent = words;
      where.setAttribute("aria-valuetext", words);
    };
    const update = (sense?: number): void => {
      const axis = "xyz".indexOf(which.value);
      // at first the part nearer to the eye is removed
      const toward = this.camera.axes()[2][axis] < 0 ? -1 : 1;
      this.cut = which.value === "" ? null : { axis, at: place(axis), sense: sense ?? this.cut?.sense ?? toward };
      tell();
      this.redraw();
    };
    which.addEventListener("change", () => {
      this.cut = null;
      update();
    });
    where.addEventListener("input", () => update());
    other.addEventListener("click", () => update(-(this.cut?.sense ?? 1)));
    tell();
    return h(
      "div",
      { class: "controls" },
      h("label", {}, h("span", {}, say("space.cut")), which),
      where,
      other,
      told,
      this.finder(),
    );
  }

  // A search field for the name of a body, for use without the pointer.
  private finder(): HTMLElement {
    const { names } = this.spec.states.solids;
    const list = h("datalist", { id: `${this.spec.id}-names` });
    const field = h("input", { type: "search", class: "find-body", list: list.id, autocomplete: "off", size: 12 });
    field.addEventListener(
      "focus",
      () => list.replaceChildren(...names.slice(0, 400).map((name) => h("option", { value: name }))),
      { once: true },
    );
    field.addEventListener("input", () => this.pick(names.indexOf(field.value.trim())));
    return h("label", {}, h("span", {}, say("space.find")), field, list);
  }
  private pick(body: number): void {
    if (body === this.lit) return;
    this.lit = body;
    this.redraw();
  }

  private tools(): HTMLElement {
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
      button("PNG", () =>
        this.copyOf(this.scene!, this.camera.width, this.camera.height).toBlob((png) => png && download("wall.png", "image/png", png)),
      ),
      button("CSV", () => download("wall.csv", "text/csv", toCsv(this.sheet()))),
    );
  }
  private sheet(): Sheet {
    const { solids } = this.spec.states,
      state = this.spec.states.at(this.look.frame);
    const rows: (string | number)[][] = [];
    for (let j = 0; j < solids.joints; ++j) {
      const middle: Vec = [0, 0, 0],
        corners = solids.outlineBegin[j + 1] - solids.outlineBegin[j];
      for (let c = solids.outlineBegin[j]; c < solids.outlineBegin[j + 1]; ++c)
        for (let k = 0; k < 3; ++k) middle[k] += solids.outline[3 * c + k] / corners;
      rows.push([
        j,
        solids.names[solids.jointA[j]],
        solids.names[solids.jointB[j]],
        ...middle.map((m, k) => m + solids.middle[k]),
        solids.area[j],
        state.opening[j] * 1e3,
        state.slip[j] * 1e3,
        state.damage[j] / 255,
        state.crushing[j] / 255,
        state.stress[j] * 1e-6,
      ]);
    }
    const head = "joint,block_a,block_b,x_m,y_m,z_m,area_m2,opening_mm,slip_mm,damage,crushing,stress_MPa".split(",");
    return { head, rows };
  }

  // --- pictures ------------------------------------------------------------------------------------

  // The present drawing with its overlay, on a canvas of its own.
  private copyOf(scene: Scene, width: number, height: number): HTMLCanvasElement {
    const canvas = h("canvas", {}),
      to = beginCanvas(canvas, width, height);
    this.drawn.draw(scene);
    to.drawImage(this.drawn.element, 0, 0, width, height);
    this.above(to, scene);
    return canvas;
  }
  // A figure for paper with its legend, in light colours for any theme.
  picture(frame: number, width: number, tallest: number): HTMLElement {
    const root = document.documentElement,
      theme = root.dataset.theme,
      kept = { scale: this.scale, lit: this.lit },
      faces = this.shown.faces;
    const info = this.spec.info[frame],
      camera = Object.assign(new Camera(), { turn: this.camera.turn, tilt: this.camera.tilt, width, height: tallest });
    camera.fit(...boundsOf(this.spec.states.solids));
    root.dataset.theme = "light";
    this.scale = fittingSize(this.spec.states, frame);
    this.lit = -1;
    this.shown.faces = "cracks";
    const words = [...wordsOf(info), scaleWords(this.scale)];
    this.poses.set(frame, this.scale);
    const scene = { ...this.compose(frame, new Styles()), camera };
    const canvas = this.copyOf(scene, width, tallest);
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", say("wall.alt"));
    Object.assign(this, kept);
    this.shown.faces = faces;
    if (theme) root.dataset.theme = theme;
    this.redraw();
    return h("figure", {}, canvas, h("figcaption", {}, words.join(" · ")));
  }

  // --- pointer and keys ----------------------------------------------------------------------------

  private listen(): void {
    const canvas = this.drawn.element,
      pointers = new Map<number, [number, number]>();
    let pressed: [number, number] | null = null;
    canvas.addEventListener("pointerdown", (e) => {
      pointers.set(e.pointerId, [e.clientX, e.clientY]);
      pressed = pointers.size === 1 ? [e.clientX, e.clientY] : null;
      canvas.setPointerCapture(e.pointerId);
      hideTip();
    });
    const drop = (e: PointerEvent): void => void pointers.delete(e.pointerId);
    canvas.addEventListener("pointerup", (e) => {
      drop(e);
      if (pressed && Math.hypot(e.clientX - pressed[0], e.clientY - pressed[1]) < 4) this.pick(this.bodyAt(e));
      pressed = null;
    });
    canvas.addEventListener("pointercancel", drop);
    canvas.addEventListener("pointerleave", hideTip);
    canvas.addEventListener("pointermove", (e) => {
      const before = pointers.get(e.pointerId);
      if (!before) return this.point(e);
      const other = [...pointers].find(([id]) => id !== e.pointerId)?.[1];
      const [dx, dy] = [e.clientX - before[0], e.clientY - before[1]];
      if (other) {
        this.zoom(
          Math.max(1, Math.hypot(e.clientX - other[0], e.clientY - other[1])) /
            Math.max(1, Math.hypot(before[0] - other[0], before[1] - other[1])),
        );
        this.shift(dx / 2, dy / 2);
      } else if (e.shiftKey || (e.buttons & 6) !== 0) this.shift(dx, dy);
      else this.rotate(-dx * 0.008, dy * 0.008);
      pointers.set(e.pointerId, [e.clientX, e.clientY]);
    });
    canvas.addEventListener("contextmenu", (e) => e.preventDefault());
    canvas.addEventListener("wheel", (e) => (e.preventDefault(), this.zoom(Math.exp(-e.deltaY * 0.001))), { passive: false });
    canvas.addEventListener("keydown", (e) => this.press(e));
  }
  private press(e: KeyboardEvent): void {
    const step = 0.12,
      far = 24;
    const acts: Record<string, () => void> = {
      ArrowLeft: () => (e.shiftKey ? this.shift(far, 0) : this.rotate(-step, 0)),
      ArrowRight: () => (e.shiftKey ? this.shift(-far, 0) : this.rotate(step, 0)),
      ArrowUp: () => (e.shiftKey ? this.shift(0, far) : this.rotate(0, step)),
      ArrowDown: () => (e.shiftKey ? this.shift(0, -far) : this.rotate(0, -step)),
      "+": () => this.zoom(1.1),
      "-": () => this.zoom(0.9),
      Escape: () => this.pick(-1),
      Enter: () => this.pick(this.planes.pick(this.camera, this.poses, this.cut, this.camera.width / 2, this.camera.height / 2)),
    };
    if (!acts[e.key]) return;
    e.preventDefault();
    acts[e.key]();
  }
  private rotate(turn: number, tilt: number): void {
    this.camera.turn += turn;
    this.camera.tilt = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, this.camera.tilt + tilt));
    this.turned();
  }
  private zoom(factor: number): void {
    const least = 0.2 * (this.camera.width / sizeOf(this.spec.states.solids));
    this.camera.zoom = Math.min(400 * least, Math.max(least, this.camera.zoom * factor));
    this.turned();
  }
  private shift(x: number, y: number): void {
    this.camera.shift(x, y);
    this.turned();
  }
  private bodyAt(e: PointerEvent): number {
    const box = this.drawn.element.getBoundingClientRect(),
      scale = this.camera.width / (box.width || 1);
    const [x, y] = [(e.clientX - box.left) * scale, (e.clientY - box.top) * scale];
    return this.planes.pick(this.camera, this.poses, this.cut, x, y);
  }
  private point(e: PointerEvent): void {
    const b = e.pointerType === "mouse" ? this.bodyAt(e) : -1;
    if (b < 0) return hideTip();
    showTip(e, this.bodyLines(b).slice(0, 3));
  }
}
