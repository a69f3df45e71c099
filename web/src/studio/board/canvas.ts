// The drawing: the engine's picture of the stones, over it the wall's outline, openings, dimensions and guides.
// Geometry in metres, shown by `view`. Everything but the stones is made anew when it changes: it is little.
import { svg, type Child } from "../../base/dom";
import { gaps, isDoor } from "../parts/openings";
import { say } from "../../base/texts";
import { crownOf, intrados, riseOf } from "../parts/arches";
import type { Box, Drawing, Selected } from "../drawing";
import { frameOf, membersOf } from "../parts/frames";
import { floorMarks, storeyMarks, tieMarks, type Shown } from "../parts/marks";
import { metres } from "../words";
import type { Picture } from "./picture";
import { photoMarks, type ShownPhoto } from "./photo";
import type { Guide } from "./snap";

export interface View {
  metre: number; // pixels
  left: number; // pixel of x = 0
  bottom: number; // pixel of y = 0
}
export type Handle = "move" | "n" | "s" | "e" | "w" | "ne" | "nw" | "se" | "sw" | "length" | "height" | "crown" | "part";

// What is under way: a box that is drawn or dragged, in the place of opening `self` (-1: a new one, or the wall).
export interface Preview {
  box: Box;
  self: number;
  wall: boolean;
  guides: Guide[];
}

const kPad = { left: 74, right: 60, top: 54, bottom: 86 };

export class Canvas {
  readonly root: SVGSVGElement;
  view: View = { metre: 100, left: 60, bottom: 400 };
  drawing: Drawing | null = null;
  selection: Selected | null = null;
  draft: { drawing: Drawing; selection: Selected | null; guides: Guide[] } | null = null; // what a gesture under way would make of it
  faulty = new Map<number, string>(); // openings that the engine refuses, and why
  faultyParts = new Map<string, string>(); // likewise, "storey 1"
  preview: Preview | null = null;
  picture: Picture | null = null;
  readOnly = false;
  showOpenings = true; // not over cracks
  private readonly stones = svg("g", { class: "stones" });
  private readonly traced = svg("g", { class: "traced" });
  private readonly over = svg("g", { class: "over" });
  private photo: ShownPhoto | null = null;

  constructor() {
    this.root = svg("svg", { class: "canvas", role: "application", "aria-label": say("studio.drawing"), tabindex: "0" });
    this.root.append(this.stones, this.traced, this.over);
  }

  x = (m: number): number => this.view.left + m * this.view.metre;
  y = (m: number): number => this.view.bottom - m * this.view.metre;
  at(event: { clientX: number; clientY: number }): { x: number; y: number } {
    const place = this.root.getBoundingClientRect();
    return {
      x: (event.clientX - place.left - this.view.left) / this.view.metre,
      y: (this.view.bottom - (event.clientY - place.top)) / this.view.metre,
    };
  }

  // The whole wall in the middle.
  fit(): void {
    const { clientWidth, clientHeight } = this.root;
    if (!this.drawing || clientWidth === 0) return;
    const { length, height } = this.drawing;
    const pad = clientWidth < 560 ? { left: 56, right: this.drawing.storeys.length > 1 ? 46 : 26, top: 40, bottom: 84 } : kPad;
    const wide = Math.max(40, clientWidth - pad.left - pad.right),
      high = Math.max(40, clientHeight - pad.top - pad.bottom);
    const metre = Math.min(wide / length, high / height);
    this.view = {
      metre,
      left: pad.left + (wide - length * metre) / 2,
      bottom: clientHeight - pad.bottom - (high - height * metre) / 2,
    };
    this.draw();
  }
  zoom(factor: number, at?: { clientX: number; clientY: number }): void {
    const place = this.root.getBoundingClientRect();
    const px = at ? at.clientX - place.left : place.width / 2,
      py = at ? at.clientY - place.top : place.height / 2;
    const metre = Math.min(5000, Math.max(2, this.view.metre * factor));
    const ratio = metre / this.view.metre;
    this.view = { metre, left: px - (px - this.view.left) * ratio, bottom: py - (py - this.view.bottom) * ratio };
    this.draw();
  }

  setPicture(picture: Picture | null): void {
    this.picture = picture;
    this.stones.replaceChildren(...(picture ? [picture.shapes] : []));
    this.place();
  }
  private place(): void {
    const p = this.picture;
    if (!p) return;
    const k = this.view.metre / p.metre;
    this.stones.setAttribute("transform", `translate(${this.view.left - p.left * k} ${this.view.bottom - p.bottom * k}) scale(${k})`);
  }

  setPhoto(photo: ShownPhoto | null): void {
    this.photo = photo;
    this.draw();
  }

  draw(): void {
    this.place();
    const photo = this.photo && this.showOpenings ? photoMarks(this.photo, this.x, this.y, this.view.metre) : null;
    this.traced.replaceChildren(...(photo ? [photo.image] : []));
    const d = this.draft?.drawing ?? this.drawing;
    const active = (document.activeElement as SVGElement | null)?.dataset;
    if (!d) return this.over.replaceChildren();
    const wall = this.preview?.wall ? { length: this.preview.box.width, height: this.preview.box.height } : d;
    this.over.replaceChildren(
      ...flat([
        this.ground(wall.length),
        svg("rect", { class: this.preview?.wall ? "outline moving" : "outline", ...this.rect({ x: 0, y: 0, width: wall.length, height: wall.height }) }),
        this.showOpenings && floorMarks(this.shown(d)),
        this.showOpenings && storeyMarks(this.shown(d)),
        this.showOpenings && d.openings.map((_, k) => this.opening(d, k)),
        this.showOpenings && tieMarks(this.shown(d)),
        this.preview && !this.preview.wall && this.preview.self < 0 && svg("rect", { class: "opening moving", ...this.rect(this.preview.box) }),
        (this.preview?.guides ?? this.draft?.guides ?? []).map((g) => this.guide(g)),
        this.dimensions(d, wall),
        !this.readOnly && this.showOpenings && this.handles(d, wall),
        photo?.points,
      ]),
    );
    if (active?.opening !== undefined) this.focusOpening(Number(active.opening));
    else if (active?.part !== undefined) this.focusPart(active.part);
  }
  focusOpening(k: number): void {
    (this.over.querySelector(`[data-opening="${k}"]`) as SVGElement | null)?.focus({ preventScroll: true });
  }
  focusPart(name: string): void {
    (this.over.querySelector(`[data-part="${name}"]`) as SVGElement | null)?.focus({ preventScroll: true });
  }
  private shown(d: Drawing): Shown {
    const scale = { x: this.x, y: this.y, metre: this.view.metre };
    return { scale, d, selection: this.draft ? this.draft.selection : this.selection, moving: this.draft !== null, faulty: this.faultyParts };
  }

  // The opening that is selected, or -1.
  private get selected(): number {
    const s = this.draft ? this.draft.selection : this.selection;
    return s?.kind === "opening" ? s.k : -1;
  }

  private rect(box: Box): { x: number; y: number; width: number; height: number } {
    return { x: this.x(box.x), y: this.y(box.y + box.height), width: Math.max(0, box.width * this.view.metre), height: Math.max(0, box.height * this.view.metre) };
  }
  private ground(length: number): SVGElement {
    const y = this.y(0);
    return svg("line", { class: "base", x1: this.x(0) - 26, x2: this.x(length) + 26, y1: y, y2: y });
  }
  private opening(d: Drawing, k: number): SVGElement {
    const o = d.openings[k];
    const moved = this.preview?.self === k;
    const box = moved ? this.preview!.box : o;
    const css = ["opening", k === this.selected && "selected", (moved || (this.draft && k === this.selected)) && "moving", this.faulty.has(k) && "faulty"].filter(Boolean).join(" ");
    const what = say(isDoor(o) ? "studio.a.door" : "studio.a.window");
    const name = say("studio.opening.name", { what, name: o.name, width: metres(o.width), height: metres(o.height), x: metres(o.x), y: metres(o.y) });
    const why = this.faulty.get(k);
    const shown = svg("path", { class: css, "data-opening": k, "data-handle": "move", tabindex: "0", role: "button", "aria-label": why ? `${name}. ${why}` : name, "aria-pressed": String(k === this.selected), d: this.hole(d, k, box) });
    if (why) shown.append(svg("title", {}, why));
    const place = this.rect(box);
    const frame = d.frames[frameOf(d, k)];
    const steel = frame ? membersOf(frame, box).map((member) => svg("rect", { class: "steel", ...this.rect(member) })) : [];
    const group = svg("g", {}, shown, steel);
    if (place.width > 60 && place.height > 34) group.append(svg("text", { class: "opening-name", x: place.x + place.width / 2, y: place.y + place.height / 2 + 4, "aria-hidden": "true" }, o.name));
    if (why) group.append(svg("text", { class: "fault-mark", x: place.x + place.width - 4, y: place.y + 18, "aria-hidden": "true" }, "⚠"));
    return group;
  }
  // What the engine leaves open, in pixels: a rectangle, or up to the intrados of an arch.
  private hole(d: Drawing, k: number, box: Box): string {
    const { arch } = d.openings[k];
    const over: [number, number][] = arch ? intrados(arch, box, d.course) : [[box.x, box.y + box.height], [box.x + box.width, box.y + box.height]];
    const points = [[box.x, box.y], ...over, [box.x + box.width, box.y]];
    return `M${points.map(([x, y]) => `${this.x(x)} ${this.y(y)}`).join("L")}Z`;
  }
  private guide(g: Guide): SVGElement {
    const d = this.drawing!;
    return g.axis === "x"
      ? svg("line", { class: "guide", x1: this.x(g.at), x2: this.x(g.at), y1: this.y(Math.min(g.from, 0)) + 12, y2: this.y(Math.max(g.to, d.height)) - 12 })
      : svg("line", { class: "guide", x1: this.x(Math.min(g.from, 0)) - 12, x2: this.x(Math.max(g.to, d.length)) + 12, y1: this.y(g.at), y2: this.y(g.at) });
  }

  // --- dimensions ----------------------------------------------------------------------------------

  private dimensions(d: Drawing, wall: { length: number; height: number }): Child {
    const out: Child[] = [
      this.level(0, wall.length, this.y(0) + 32, "dim"),
      this.upright(0, wall.height, this.x(0) - 36, "dim"),
    ];
    if (d.storeys.length > 1 && !this.preview?.wall)
      for (const s of d.storeys) out.push(this.upright(s.foot, s.foot + s.height, this.x(wall.length) + 30, "dim"));
    const box = this.preview && !this.preview.wall ? this.preview.box : this.selected >= 0 && this.showOpenings ? d.openings[this.selected] : null;
    if (!box) return out;
    const self = this.preview ? this.preview.self : this.selected;
    const g = gaps(d, box, self);
    const rise = self >= 0 ? riseOf(d.openings[self].arch, box.width) : 0;
    const crown = box.y + box.height + rise;
    const low = this.y(box.y + 0.25 * box.height),
      axis = this.x(box.x + 0.25 * box.width);
    const high = this.y(crown) - (rise > 0 ? 26 : 14); // clear of the handle at the crown
    out.push(this.level(box.x, box.x + box.width, high, "dim strong"), this.upright(box.y, box.y + box.height, this.x(box.x + box.width) + 14, "dim strong"));
    if (g.left > 1e-6) out.push(this.level(box.x - g.left, box.x, low, "dim gap"));
    if (g.right > 1e-6) out.push(this.level(box.x + box.width, box.x + box.width + g.right, low, "dim gap"));
    if (g.below > 1e-6) out.push(this.upright(box.y - g.below, box.y, axis, "dim gap"));
    if (g.above > rise + 1e-6) out.push(this.upright(crown, box.y + box.height + g.above, axis, "dim gap"));
    if (rise > 1e-6) out.push(this.upright(crown - rise, crown, this.x(box.x + box.width) + 14, "dim strong"));
    return out;
  }
  private level(a: number, b: number, y: number, css: string): SVGElement {
    const x1 = this.x(a),
      x2 = this.x(b);
    return svg(
      "g", { class: css, "aria-hidden": "true" },
      svg("path", { d: `M${x1} ${y - 5}V${y + 5}M${x1} ${y}H${x2}M${x2} ${y - 5}V${y + 5}` }),
      label((x1 + x2) / 2, y - 5, metres(b - a)),
    );
  }
  private upright(a: number, b: number, x: number, css: string): SVGElement {
    const y1 = this.y(a),
      y2 = this.y(b);
    return svg(
      "g", { class: css, "aria-hidden": "true" },
      svg("path", { d: `M${x - 5} ${y1}H${x + 5}M${x} ${y1}V${y2}M${x - 5} ${y2}H${x + 5}` }),
      upright(css.includes("strong") ? x + 14 : x - 5, css.includes("strong") ? y1 + 0.7 * (y2 - y1) : (y1 + y2) / 2, metres(b - a)),
    );
  }

  private handles(d: Drawing, wall: { length: number; height: number }): Child {
    const dot = (x: number, y: number, handle: Handle): SVGElement =>
      svg(
        "g", { class: "handle", "data-handle": handle },
        svg("circle", { class: "reach", cx: x, cy: y, r: 14 }),
        svg("circle", { class: "dot", cx: x, cy: y, r: 5 }),
      );
    const out: Child[] = [dot(this.x(wall.length), this.y(0.3 * wall.height), "length"), dot(this.x(wall.length / 2), this.y(wall.height), "height")];
    const k = this.selected;
    if (k < 0 || (this.preview && this.preview.self !== k)) return out;
    const b = this.preview?.box ?? d.openings[k];
    const xs = { w: b.x, e: b.x + b.width },
      ys = { s: b.y, n: b.y + b.height };
    const o = d.openings[k];
    const rise = riseOf(o.arch, b.width) * this.view.metre;
    for (const v of ["n", "s"] as const) {
      if (v === "s" || rise === 0 || rise > 24) out.push(dot(this.x(b.x + b.width / 2), this.y(ys[v]), v));
      for (const h of ["e", "w"] as const) out.push(dot(this.x(xs[h]), this.y(ys[v]), `${v}${h}`));
    }
    for (const h of ["e", "w"] as const) out.push(dot(this.x(xs[h]), this.y(b.y + b.height / 2), h));
    if (o.arch && o.arch.kind !== "flat") out.push(dot(this.x(b.x + b.width / 2), this.y(crownOf(o, b)), "crown"));
    return out;
  }
}

const label = (x: number, y: number, text: string): SVGElement => svg("text", { x, y }, text);
const upright = (x: number, y: number, text: string): SVGElement => svg("text", { x, y, transform: `rotate(-90 ${x} ${y})` }, text);
const flat = (children: Child[]): Node[] => children.flatMap((c) => (Array.isArray(c) ? flat(c) : c instanceof Node ? [c] : []));
