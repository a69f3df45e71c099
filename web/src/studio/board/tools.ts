// Gestures: drawing, moving and resizing by mouse, pen, finger and typed lengths. While one is under way only the
// preview changes; its end is one edit of the file.
import { h } from "../../base/dom";
import { addOpening, gaps, isDoor, setOpening } from "../parts/openings";
import { isRefusal, readDrawing } from "../reading";
import { setWallSize } from "../parts/storeys";
import { say } from "../../base/texts";
import type { Canvas, Handle } from "./canvas";
import { storeyAt, type Box, type Drawing, type Kind, type Selected } from "../drawing";
import { dragCrown, dragPart, kPlaces, nudgePart, placePart, type Offer, type PartGesture } from "../parts/part_gestures";
import type { Photo } from "./photo";
import type { Project } from "../project";
import { snapLine, snapMove, type Guide, type Snapping } from "./snap";
import { parse } from "../file/toml";
import { typedLength } from "../file/units";
import { metres } from "../words";

export type Tool = "select" | "wall" | "door" | "window" | "storey" | "floor" | "tie" | "photo";
export const kTools: Tool[] = ["select", "wall", "door", "window", "storey", "floor", "tie", "photo"];
const places = (tool: Tool): boolean => tool in kPlaces; // what goes along with the pointer before the click too

export interface Point {
  x: number;
  y: number;
}
export type FieldName = "width" | "height" | "length" | "left" | "below" | "rise" | "level";
interface Gesture {
  kind: "draw" | "move" | "resize" | "size" | "wall" | "pan" | "part";
  part?: PartGesture;
  held?: boolean; // the button, since the start
  button: number; // that is down for it; -1: none, it goes from click to click
  handle: Handle;
  start: Point; // in metres
  now: Point;
  box: Box; // at the start
  self: number;
  fields: FieldName[]; // that may be typed
  typed: Partial<Record<FieldName, string>>;
  field: number; // that is being typed
  clicks: boolean; // from click to click, not dragged
  moved: boolean;
  free: boolean; // without snapping, while Alt is held
  client: { clientX: number; clientY: number };
}
const kReach = 8; // of snapping [px]
const kClick = 4; // a pointer that moved less was not dragged [px]
const kSmallest = 0.05; // side of what is drawn [m]

// What a text says, if the drawing can show it.
function drawingOf(text: string): Drawing | null {
  try {
    const drawing = readDrawing(parse(text));
    return isRefusal(drawing) ? null : drawing;
  } catch {
    return null;
  }
}

export class Tools {
  tool: Tool = "select";
  snapping: Snapping = { masonry: true, objects: true };
  readonly typing = h("div", { class: "typing", role: "status", hidden: true });
  private gesture: Gesture | null = null;
  private readonly pointers = new Map<number, { clientX: number; clientY: number }>();
  private pinch = 0;

  constructor(
    private readonly canvas: Canvas,
    private readonly project: Project,
    private readonly changed: () => void,
    private readonly tell: (words: string) => void,
    readonly photo: Photo,
  ) {
    project.listen((why) => {
      if (why === "text" && this.gesture) this.forget(); // what it holds may be gone
    });
    const root = canvas.root;
    root.addEventListener("pointerdown", (e) => this.down(e));
    root.addEventListener("pointermove", (e) => this.move(e));
    root.addEventListener("pointerup", (e) => this.up(e));
    root.addEventListener("pointercancel", (e) => (this.pointers.delete(e.pointerId), this.cancel()));
    root.addEventListener("pointerleave", () => {
      const g = this.gesture;
      if (g?.part && g.clicks && Object.keys(g.typed).length === 0) this.cancel();
    });
    root.addEventListener("wheel", (e) => this.wheel(e), { passive: false });
    root.addEventListener("focusin", (e) => {
      const { opening, part } = (e.target as SVGElement).dataset;
      if (this.gesture || !(e.target as Element).matches(":focus-visible")) return;
      if (opening !== undefined) project.select(Number(opening));
      if (part !== undefined) project.choose({ kind: part.split(" ")[0] as Kind, k: Number(part.split(" ")[1]) });
    });
  }

  get busy(): boolean {
    return this.gesture !== null;
  }
  choose(tool: Tool): void {
    this.cancel();
    this.tool = tool;
    this.photo.activate(tool === "photo");
    this.changed();
  }
  cancel(): void {
    this.forget();
    this.photo.cancel();
    this.canvas.draw();
  }
  private forget(): void {
    this.gesture = null;
    this.canvas.preview = null;
    this.canvas.draft = null;
    this.typing.hidden = true;
  }

  // --- pointers ------------------------------------------------------------------------------------------

  private down(e: PointerEvent): void {
    this.pointers.set(e.pointerId, e);
    if (this.pointers.size === 2) {
      this.cancel();
      this.pinch = this.spread();
      return;
    }
    if (e.button > 1) return;
    if (this.tool === "photo" && e.button === 0 && this.photo.down(this.canvas.at(e), { x: e.clientX, y: e.clientY })) return this.canvas.root.setPointerCapture(e.pointerId);
    if (this.gesture && e.button === 1) this.cancel(); // the view moves in its place
    if (this.gesture?.clicks) {
      this.gesture.button = e.button;
      if (this.gesture.part) [this.gesture.start, this.gesture.held] = [this.canvas.at(e), true];
      return; // this click ends what the one before began
    }
    const target = (e.target as Element).closest<SVGElement>("[data-handle]");
    const handle = target?.dataset.handle as Handle | undefined;
    const opening = target?.dataset.opening;
    const [kind, k] = target?.dataset.part?.split(" ") ?? [];
    this.begin(e, handle, opening === undefined ? -1 : Number(opening), kind ? { kind: kind as Kind, k: Number(k) } : null);
    this.canvas.root.setPointerCapture(e.pointerId);
  }
  private begin(e: PointerEvent, handle: Handle | undefined, opening: number, part: Selected | null): void {
    const { project, canvas } = this;
    const d = project.drawing;
    const at = canvas.at(e);
    const base = { start: at, now: at, self: -1, typed: {}, field: 0, clicks: false, moved: false, button: e.button, free: e.altKey, client: { clientX: e.clientX, clientY: e.clientY } };
    const none: Box = { x: 0, y: 0, width: 0, height: 0 };
    const pan: Gesture = { ...base, kind: "pan", handle: "move", box: { ...none, x: canvas.view.left, y: canvas.view.bottom }, fields: [] };
    const partly = (part: PartGesture): Gesture => ({ ...base, kind: "part", part, handle: "move", box: none, fields: part.fields });
    if (!d || e.button === 1) this.gesture = pan;
    else if (this.tool === "select") {
      if (opening >= 0) project.select(opening);
      if (part && !canvas.readOnly) project.choose(part);
      const dragged = part && project.drawable ? dragPart(project.text, d, part, at, this.reach) : null;
      if (part && !dragged && !canvas.readOnly) return; // selected, and not to be dragged
      if (!project.drawable || canvas.readOnly || !handle) this.gesture = pan;
      else if (handle === "part") this.gesture = dragged ? partly(dragged) : pan;
      else if (handle === "crown") this.gesture = partly(dragCrown(project.text, d, project.selected));
      else if (handle === "length" || handle === "height")
        this.gesture = { ...base, kind: "size", handle, box: { ...none, width: d.length, height: d.height }, fields: [handle] };
      else {
        const self = opening >= 0 ? opening : project.selected;
        const fields: FieldName[] = handle === "move" ? ["left", "below"] : /[ew]/.test(handle) ? ["width", "height"] : ["height"];
        this.gesture = { ...base, kind: handle === "move" ? "move" : "resize", handle, box: { ...d.openings[self] }, self, fields };
      }
    } else if (this.tool === "photo") this.gesture = pan;
    else if (places(this.tool)) {
      if (project.drawable && !canvas.readOnly) this.follow(e, false);
      else this.gesture = pan;
    } else if (project.drawable) {
      const start = this.tool === "wall" ? at : this.corner(d, at, e.altKey).at;
      this.gesture = { ...base, kind: this.tool === "wall" ? "wall" : "draw", handle: "move", start, box: { ...start, width: 0, height: 0 }, fields: this.tool === "wall" ? ["length", "height"] : ["width", "height"] };
    } else this.gesture = pan;
  }
  // What the tool places goes along with the pointer: from now on, or since before the button was pressed.
  private follow(e: PointerEvent, hovers: boolean): void {
    const part = kPlaces[this.tool](this.project.text, this.project.drawing!);
    const at = this.canvas.at(e);
    const box: Box = { x: 0, y: 0, width: 0, height: 0 };
    this.gesture = { kind: "part", part, handle: "move", start: at, now: at, box, self: -1, fields: part.fields, typed: {}, field: 0, clicks: hovers, held: !hovers, button: hovers ? -1 : e.button, moved: true, free: e.altKey, client: { clientX: e.clientX, clientY: e.clientY } };
    this.show(this.gesture);
    this.placeTyping(e);
  }
  private move(e: PointerEvent): void {
    if (this.pointers.has(e.pointerId)) this.pointers.set(e.pointerId, e);
    if (this.pointers.size === 2) {
      const spread = this.spread();
      if (this.pinch > 0) this.canvas.zoom(spread / this.pinch, this.middle());
      this.pinch = spread;
      return;
    }
    this.photo.move(this.canvas.at(e), { x: e.clientX, y: e.clientY });
    const g = this.gesture;
    if (!g) {
      const { drawing, drawable } = this.project;
      if (places(this.tool) && e.pointerType === "mouse" && e.buttons === 0 && drawing && drawable && !this.canvas.readOnly) this.follow(e, true);
      return;
    }
    if (Math.hypot(e.clientX - g.client.clientX, e.clientY - g.client.clientY) > kClick) g.moved = true;
    if (!g.moved) return;
    g.now = this.canvas.at(e);
    g.free = e.altKey;
    if (g.kind === "pan") {
      this.canvas.view.left = g.box.x + e.clientX - g.client.clientX;
      this.canvas.view.bottom = g.box.y + e.clientY - g.client.clientY;
      this.canvas.draw();
    } else {
      this.show(g);
      this.placeTyping(e);
    }
  }
  private up(e: PointerEvent): void {
    this.pointers.delete(e.pointerId);
    this.photo.up(this.canvas.at(e));
    const g = this.gesture;
    if (!g) return;
    if (g.button !== e.button) return g.button < 0 ? undefined : this.cancel(); // another button was let go last
    if (g.kind === "pan") {
      if (!g.moved) this.project.select(-1);
      return this.cancel();
    }
    if ((g.kind === "draw" || g.kind === "wall") && !g.moved && !g.clicks) {
      [g.clicks, g.button] = [true, -1]; // the second corner comes with the next click
      this.show(g);
      return this.placeTyping(e);
    }
    if (!g.moved && !g.clicks) return this.cancel();
    this.finish();
  }
  private wheel(e: WheelEvent): void {
    e.preventDefault();
    if (e.shiftKey || Math.abs(e.deltaX) > Math.abs(e.deltaY)) {
      this.canvas.view.left -= e.deltaX || e.deltaY;
      this.canvas.draw();
    } else this.canvas.zoom(Math.exp(-e.deltaY / (e.ctrlKey ? 150 : 500)), e);
  }
  private spread(): number {
    const [a, b] = [...this.pointers.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  }
  private middle(): { clientX: number; clientY: number } {
    const [a, b] = [...this.pointers.values()];
    return { clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2 };
  }

  // --- what a gesture means ---------------------------------------------------------------------------------

  private get reach(): number {
    return kReach / this.canvas.view.metre;
  }
  private how(free: boolean): Snapping {
    return free ? { masonry: false, objects: false } : this.snapping;
  }
  // A corner of an opening that is drawn: on the lines nearby; a door stands on its floor.
  private corner(d: Drawing, at: Point, free: boolean): { at: Point; guides: Guide[] } {
    const x = snapLine(d, "x", Math.min(d.length, Math.max(0, at.x)), -1, this.reach, this.how(free));
    if (this.tool === "door" && this.gesture === null) {
      const y = storeyAt(d, Math.max(0, at.y))?.foot ?? 0;
      return { at: { x: x.at, y }, guides: x.guides };
    }
    const y = snapLine(d, "y", Math.min(d.height, Math.max(0, at.y)), -1, this.reach, this.how(free));
    return { at: { x: x.at, y: y.at }, guides: [...x.guides, ...y.guides] };
  }

  private outcome(g: Gesture): { box: Box; guides: Guide[] } {
    const d = this.project.drawing!;
    const how = this.how(g.free);
    const typed = (name: FieldName): number | null => typedLength(g.typed[name] ?? "");
    if (g.kind === "wall" || g.kind === "size") {
      const grid = (v: number, step: number): number => (how.masonry ? Math.max(1, Math.round(v / step)) * step : Math.round(v * 100) / 100);
      const drawn = g.kind === "wall";
      const length = drawn ? Math.abs(g.now.x - g.start.x) : g.handle === "length" ? g.now.x : g.box.width;
      const height = drawn ? Math.abs(g.now.y - g.start.y) : g.handle === "height" ? g.now.y : g.box.height;
      return {
        box: {
          x: 0,
          y: 0,
          width: typed("length") ?? (drawn || g.handle === "length" ? grid(length, d.half) : length),
          height: typed("height") ?? (drawn || g.handle === "height" ? grid(height, d.course) : height),
        },
        guides: [],
      };
    }
    if (g.kind === "draw") {
      const end = this.corner(d, g.now, g.free);
      const width = typed("width"),
        height = typed("height");
      const x1 = width !== null ? g.start.x + (g.now.x < g.start.x ? -width : width) : end.at.x;
      const down = this.tool === "window" && g.now.y < g.start.y;
      const y1 = height !== null ? g.start.y + (down ? -height : height) : end.at.y;
      return {
        box: { x: Math.min(g.start.x, x1), y: Math.min(g.start.y, y1), width: Math.abs(x1 - g.start.x), height: Math.abs(y1 - g.start.y) },
        guides: end.guides,
      };
    }
    if (g.kind === "move") {
      const door = isDoor(d.openings[g.self]);
      const dy = g.now.y - g.start.y;
      const wanted = { ...g.box, x: g.box.x + g.now.x - g.start.x, y: door && Math.abs(dy) < 0.25 ? g.box.y : g.box.y + dy };
      const { box, guides } = snapMove(d, g.self, wanted, this.reach, how);
      const inside = { ...box, x: Math.min(d.length - box.width, Math.max(0, box.x)), y: Math.min(d.height - box.height, Math.max(0, box.y)) };
      const left = typed("left"),
        below = typed("below");
      const gap = gaps(d, inside, g.self);
      if (left !== null) inside.x += left - gap.left;
      if (below !== null) inside.y += below - gap.below;
      return { box: inside, guides };
    }
    let { x, y, width, height } = g.box;
    const guides: Guide[] = [];
    const line = (axis: "x" | "y", value: number): number => {
      const limit = axis === "x" ? d.length : d.height;
      const snapped = snapLine(d, axis, Math.min(limit, Math.max(0, value)), g.self, this.reach, how);
      guides.push(...snapped.guides);
      return snapped.at;
    };
    if (g.handle.includes("e")) width = Math.max(kSmallest, (typed("width") ?? line("x", g.now.x) - x));
    if (g.handle.includes("w")) {
      const right = x + width;
      width = Math.max(kSmallest, typed("width") ?? right - line("x", g.now.x));
      x = right - width;
    }
    if (g.handle.includes("n")) height = Math.max(kSmallest, typed("height") ?? line("y", g.now.y) - y);
    if (g.handle.includes("s")) {
      const top = y + height;
      height = Math.max(kSmallest, typed("height") ?? top - line("y", g.now.y));
      y = top - height;
    }
    return { box: { x, y, width, height }, guides };
  }
  private offer(g: Gesture): Offer {
    return g.part!.at({ start: g.start, now: g.now, typed: (name) => typedLength(g.typed[name] ?? ""), how: this.how(g.free), reach: this.reach, drawn: g.held });
  }
  private show(g: Gesture): void {
    if (g.kind === "part") {
      const offer = this.offer(g);
      const drawing = drawingOf(offer.text);
      if (drawing) this.canvas.draft = { drawing, selection: offer.selection, guides: offer.guides ?? [] };
      return this.canvas.draw();
    }
    const { box, guides } = this.outcome(g);
    this.canvas.preview = { box, guides, self: g.self, wall: g.kind === "wall" || g.kind === "size" };
    this.canvas.draw();
  }

  finish(): void {
    const g = this.gesture;
    const d = this.project.drawing;
    if (!g || !d) return;
    if (g.kind === "part") return this.finishPart(this.offer(g));
    const { box } = this.outcome(g);
    this.cancel();
    const { project } = this;
    project.endStep();
    if (g.kind === "wall" || g.kind === "size") {
      if (box.width < kSmallest || box.height < kSmallest) return;
      project.change(setWallSize(project.text, d, box.width, box.height));
      this.tool = "select";
      this.canvas.fit();
    } else if (g.kind === "draw") {
      if (box.width < kSmallest || box.height < kSmallest) return;
      this.add(d, box);
    } else if (g.kind === "move" || g.kind === "resize") {
      project.change(setOpening(project.text, g.self, box, d.openings[g.self].foot), g.self);
    }
    this.changed();
  }
  private finishPart(offer: Offer): void {
    this.cancel();
    if (offer.hinder || !drawingOf(offer.text)) return this.tell(offer.hinder ?? say("studio.hinder.file"));
    this.tool = "select";
    this.project.endStep();
    this.project.change(offer.text, offer.selection);
    this.changed();
  }
  private add(d: Drawing, box: Box): void {
    const word = say(this.tool === "door" ? "studio.a.door" : "studio.a.window");
    this.project.change(addOpening(this.project.text, d, box, word), d.openings.length);
    this.tool = "select";
    this.changed();
    this.canvas.focusOpening(d.openings.length);
  }
  // Without a pointer: in the middle of the widest free length at that height.
  place(): void {
    const d = this.project.drawing;
    if (d && this.project.drawable && places(this.tool)) return this.finishPart(placePart(this.tool, this.project.text, d));
    if (!d || !this.project.drawable || (this.tool !== "door" && this.tool !== "window")) return;
    const grid = (v: number, step: number): number => Math.max(1, Math.round(v / step)) * step;
    const y = this.tool === "door" ? 0 : grid(0.9, d.course);
    const height = Math.min(grid(this.tool === "door" ? 2.1 : 1.2, d.course), d.height - y - 2 * d.course);
    const free: [number, number][] = [];
    let from = 0;
    for (const o of d.openings.filter((o) => o.y < y + height && o.y + o.height > y).sort((a, b) => a.x - b.x)) {
      free.push([from, o.x]);
      from = Math.max(from, o.x + o.width);
    }
    free.push([from, d.length]);
    const [a, b] = free.reduce((best, f) => (f[1] - f[0] > best[1] - best[0] ? f : best));
    const width = Math.min(grid(1, d.half), grid((b - a) / 3, d.half));
    if (height < kSmallest || width < kSmallest || width > b - a) return;
    this.add(d, { x: grid((a + b - width) / 2, d.half), y, width, height });
  }
  // The selected opening by one step: half a unit, a course, or a centimetre.
  nudge(dx: number, dy: number, fine: boolean): void {
    if (this.tool === "photo") return this.photo.nudge(dx, dy, fine);
    const { project } = this;
    const d = project.drawing;
    if (!d || !project.drawable || project.selection === null) return;
    if (project.selected < 0) {
      const step = { x: dx * (fine ? 0.01 : d.half), y: dy * (fine ? 0.01 : d.course) };
      const offer = nudgePart(project.text, d, project.selection, step);
      if (offer?.hinder) this.tell(offer.hinder);
      else if (offer) project.change(offer.text, offer.selection, `nudge ${project.selection.kind} ${project.selection.k}`);
      return;
    }
    const o = d.openings[project.selected];
    const x = Math.min(d.length - o.width, Math.max(0, o.x + dx * (fine ? 0.01 : d.half)));
    const y = Math.min(d.height - o.height, Math.max(o.foot, o.y + dy * (fine ? 0.01 : d.course)));
    project.change(setOpening(project.text, project.selected, { ...o, x, y }, o.foot), project.selected, `nudge ${project.selected}`);
  }

  // --- lengths that are typed while something is drawn ----------------------------------------------------------

  // Whether a key belonged to the gesture under way.
  key(e: KeyboardEvent): boolean {
    const g = this.gesture;
    if (!g || g.kind === "pan") return false;
    const name = g.fields[g.field];
    const text = g.typed[name] ?? "";
    if (e.key === "Escape") {
      if (g.part && g.clicks) this.choose("select"); // else it would go on with the next move
      this.cancel();
      return true;
    }
    if (e.key === "Enter") this.finish();
    else if (e.key === "Tab") g.field = (g.field + 1) % g.fields.length;
    else if (e.key === "Backspace") g.typed[name] = text.slice(0, -1);
    else if (/^[\d.,cm ]$/.test(e.key) && !e.ctrlKey && !e.metaKey) g.typed[name] = text + e.key;
    else return false;
    if (this.gesture) {
      g.moved = true;
      this.show(g);
      this.placeTyping();
    }
    return true;
  }
  private placeTyping(at?: { clientX: number; clientY: number }): void {
    const g = this.gesture;
    const preview = this.canvas.preview;
    if (!g || (!preview && !g.part)) return;
    const offer = g.part && this.offer(g);
    let value: Partial<Record<FieldName, number>> = offer?.values ?? {};
    if (preview) {
      const gap = gaps(this.project.drawing!, preview.box, g.self);
      value = { width: preview.box.width, length: preview.box.width, height: preview.box.height, left: gap.left, below: gap.below };
    }
    this.typing.hidden = false;
    this.typing.classList.toggle("hindered", offer?.hinder !== undefined);
    this.typing.replaceChildren(
      ...g.fields.map((name, k) =>
        h("span", { class: k === g.field ? "field now" : "field" }, `${say(`studio.field.${name}`)} `, h("b", {}, g.typed[name] ? `${g.typed[name]}▏` : metres(value[name] ?? 0))),
      ),
      ...(offer?.hinder ? [h("span", { class: "hinder" }, offer.hinder)] : []),
    );
    if (!at) return;
    const place = this.canvas.root.parentElement!.getBoundingClientRect();
    const x = Math.min(at.clientX - place.left + 18, place.width - this.typing.offsetWidth - 8);
    const y = Math.min(at.clientY - place.top + 18, place.height - this.typing.offsetHeight - 8);
    this.typing.style.transform = `translate(${Math.max(4, x)}px, ${Math.max(4, y)}px)`;
  }
}
