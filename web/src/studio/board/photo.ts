// A photo, a scan or the lines of a DXF drawing under the lines of the drawing, to trace: opened or dropped, drawn over the stones as faintly as one
// likes, brought to scale by two points and the length between them. Where it lies can be undone; the wall knows nothing of it.
import { h, svg, type Child } from "../../base/dom";
import { say } from "../../base/texts";
import type { Canvas } from "./canvas";
import { isDxf, kMost, paintDxf, readDxf } from "./dxf";
import { forgetPhoto, keepPhoto, keptPhoto, type PhotoPlace } from "./photo_store";
import type { Project } from "../project";
import type { Point } from "./tools";
import { typedLength, writeQuantity } from "../file/units";
import { whole } from "../words";

const kLargest = 60 << 20; // of a file that is opened [bytes]
const kKept = 24 << 20; // of one that the browser keeps [bytes]
const kClick = 4; // a pointer that moved less was not dragged [px]
const kPause = 400; // after a change, before it is kept [ms]
const kSides = [1e-3, 1e4]; // least and greatest width of a photo [m]

interface Loaded {
  name: string;
  type: string;
  bytes: ArrayBuffer;
  url: string;
  width: number; // pixels
  height: number;
}

// What a file is by its first bytes, whatever it is called.
function typeOf(bytes: ArrayBuffer): string | null {
  const [a, b, c, d] = new Uint8Array(bytes.slice(0, 4));
  if (a === 0x89 && b === 0x50 && c === 0x4e && d === 0x47) return "image/png";
  return a === 0xff && b === 0xd8 && c === 0xff ? "image/jpeg" : null;
}
async function load(name: string, bytes: ArrayBuffer): Promise<Loaded | null> {
  const type = typeOf(bytes);
  if (type === null) return null;
  const url = URL.createObjectURL(new Blob([bytes], { type }));
  const image = new Image();
  image.src = url;
  try {
    await image.decode();
    if (image.naturalWidth > 0) return { name, type, bytes, url, width: image.naturalWidth, height: image.naturalHeight };
  } catch {
    // broken
  }
  URL.revokeObjectURL(url);
  return null;
}

export class Photo {
  readonly bar = h("div", { class: "photo-bar", role: "group", "aria-label": say("studio.photo"), hidden: true });
  private loaded: Loaded | null = null;
  private shown = true;
  private opacity = 0.6;
  private active = false; // its tool is chosen
  private place: PhotoPlace | null = null; // that is kept, or soon
  private points: Point[] = []; // that are measured, on the photo where it lies
  private dragged: { from: Point; client: Point; place: PhotoPlace; moved: boolean } | null = null;
  private timer = 0; // of a change that is not kept yet; 0: none
  private kept: Promise<boolean> = Promise.resolve(true); // of the newest change: whether the browser has it; also where there is no photo
  private shape = ""; // of the bar's controls: others are built anew
  private fresh: (() => void)[] = []; // what brings them up to date
  private readonly input = h("input", { type: "file", accept: "image/png,image/jpeg,.dxf", hidden: true, "aria-label": say("studio.photo.open"), tabindex: "-1" });

  constructor(
    private readonly canvas: Canvas,
    private readonly project: Project,
    private readonly tell: (words: string) => void,
  ) {
    this.input.addEventListener("change", () => {
      if (this.input.files?.[0]) void this.open(this.input.files[0]);
      this.input.value = "";
    });
    project.listen(() => {
      if (this.place !== project.photo && this.loaded) this.keepSoon(); // an undo put it back where it was, or it was moved
      this.place = project.photo;
      this.show();
    });
  }

  choose(): void {
    this.input.click();
  }
  async open(file: File): Promise<void> {
    try {
      await this.read(file);
    } catch {
      this.tell(say("studio.photo.unread", { name: file.name })); // gone since it was chosen, or more than there is room for
    }
  }
  private async read(file: File): Promise<void> {
    if (file.size > kLargest) return this.tell(say("studio.photo.large", { name: file.name }));
    const bytes = await file.arrayBuffer();
    const head = new TextDecoder().decode(bytes.slice(0, 200));
    const lines = isDxf(file.name, head) ? readDxf(new TextDecoder().decode(bytes)) : undefined;
    if (lines === null) return this.tell(say("studio.photo.many", { name: file.name, count: whole(kMost) }));
    const painted = lines && (await paintDxf(lines));
    const loaded = await load(file.name, painted?.bytes ?? bytes);
    if (!loaded) return this.tell(say("studio.photo.unread", { name: file.name }));
    this.take(loaded, true);
    const length = this.project.drawing?.length ?? 4;
    const metre = painted && lines && lines.metre > 0 ? lines.metre * painted.pixel : length / loaded.width;
    this.project.newPhoto({ x: 0, y: 0, metre });
    if (painted) this.opacity = 1;
    if (!(await this.keep())) this.tell(say("studio.photo.notkept"));
    else if (lines?.skipped) this.tell(say("studio.photo.skipped", { count: lines.skipped }));
    this.show();
  }
  // What was kept when the page was open before.
  async restore(shown: boolean): Promise<void> {
    const kept = await keptPhoto();
    const loaded = kept && !this.loaded ? await load(kept.name, kept.bytes) : null;
    if (!kept || !loaded) return;
    this.take(loaded, shown && kept.shown);
    this.opacity = kept.opacity;
    this.place = kept.place; // it is kept so, and shown again where it is hidden now
    this.project.restorePhoto(kept.place);
  }
  private take(loaded: Loaded, shown: boolean): void {
    if (this.loaded) URL.revokeObjectURL(this.loaded.url);
    this.loaded = loaded;
    this.shown = shown;
    this.points = [];
  }
  // Whether the browser has the photo as it is, or that there is none; known when its storage has answered.
  isKept(): Promise<boolean> {
    return this.timer !== 0 ? this.keep() : this.kept;
  }
  private keep(): Promise<boolean> {
    window.clearTimeout(this.timer);
    this.timer = 0;
    document.documentElement.dataset.keeping = "yes"; // until the browser has it
    const kept = (this.kept = this.store());
    void kept.then(() => {
      if (kept === this.kept && this.timer === 0) delete document.documentElement.dataset.keeping;
    });
    return kept;
  }
  private async store(): Promise<boolean> {
    const { loaded, opacity, shown } = this;
    const place = this.project.photo;
    if (!loaded || !place || loaded.bytes.byteLength > kKept) await forgetPhoto(); // not an older one either
    if (!loaded || !place) return true;
    const { name, type, bytes } = loaded;
    return bytes.byteLength <= kKept && keepPhoto({ name, type, bytes, place, opacity, shown });
  }
  private keepSoon(): void {
    window.clearTimeout(this.timer);
    document.documentElement.dataset.keeping = "yes";
    this.timer = window.setTimeout(() => void this.keep(), kPause);
  }
  private remove(): void {
    if (this.loaded) URL.revokeObjectURL(this.loaded.url);
    this.loaded = null;
    this.points = [];
    this.project.newPhoto(null);
    void this.keep();
  }
  toggle(): void {
    if (!this.loaded) return this.choose();
    this.shown = !this.shown;
    this.keepSoon();
    this.show();
  }

  // --- tool ---------------------------------------------------------------------------------------------

  activate(on: boolean): void {
    if (on === this.active) return;
    this.active = on;
    this.points = [];
    this.dragged = null;
    if (on && this.loaded) this.shown = true;
    this.show();
  }
  // Whether a gesture of the pointer is the photo's.
  down(at: Point, client: Point): boolean {
    const place = this.project.photo;
    if (!this.active || !this.loaded || !place || this.canvas.readOnly) return false;
    this.dragged = { from: at, client, place, moved: false };
    return true;
  }
  move(at: Point, client: Point): void {
    const g = this.dragged;
    if (!g) return;
    g.moved ||= Math.hypot(client.x - g.client.x, client.y - g.client.y) > kClick;
    if (g.moved) this.draw({ ...g.place, x: g.place.x + at.x - g.from.x, y: g.place.y + at.y - g.from.y }, { x: at.x - g.from.x, y: at.y - g.from.y });
  }
  up(at: Point): void {
    const g = this.dragged;
    this.dragged = null;
    if (!g) return;
    if (g.moved) {
      const by = { x: at.x - g.from.x, y: at.y - g.from.y };
      this.points = this.points.map((p) => ({ x: p.x + by.x, y: p.y + by.y }));
      return this.put({ ...g.place, x: g.place.x + by.x, y: g.place.y + by.y });
    }
    this.points = this.points.length === 2 ? [g.from] : [...this.points, g.from];
    this.show();
    this.bar.querySelector<HTMLInputElement>("input[data-measure]")?.focus();
  }
  cancel(): void {
    this.dragged = null;
    this.draw();
  }
  // Whether there was something to give up.
  escape(): boolean {
    if (this.points.length === 0) return false;
    this.points = [];
    this.show();
    return true;
  }
  nudge(dx: number, dy: number, fine: boolean): void {
    const place = this.project.photo;
    const step = fine ? 0.01 : 0.1;
    if (place && this.loaded) this.put({ ...place, x: place.x + dx * step, y: place.y + dy * step }, "nudge photo");
  }
  // So long is the line between the two points: the photo grows about the first.
  private scale(length: number): boolean {
    const [a, b] = this.points;
    const place = this.project.photo;
    const measured = a && b ? Math.hypot(b.x - a.x, b.y - a.y) : 0;
    if (!place || measured <= 0 || !this.fits((place.metre * length) / measured)) return false;
    const by = length / measured;
    this.points = [];
    this.put({ x: a.x - by * (a.x - place.x), y: a.y - by * (a.y - place.y), metre: place.metre * by });
    return true;
  }
  private fits(metre: number): boolean {
    const width = metre * (this.loaded?.width ?? 1);
    return width >= kSides[0] && width <= kSides[1];
  }
  private put(place: PhotoPlace, join = ""): void {
    this.project.placePhoto(place, join);
  }

  // --- what is shown -----------------------------------------------------------------------------------------

  private show(): void {
    this.draw();
    this.bar.hidden = !this.active;
    if (!this.active) return;
    const shape = `${this.loaded?.url} ${this.points.length}`;
    if (shape !== this.shape) this.rebuild(shape);
    else for (const refresh of this.fresh) refresh();
  }
  // Other controls: the focus goes to the one of the same name, or to the drawing.
  private rebuild(shape: string): void {
    const had = this.bar.contains(document.activeElement) ? document.activeElement! : null;
    this.shape = shape;
    this.fresh = [];
    this.bar.replaceChildren(...this.controls());
    const name = had?.getAttribute("aria-label");
    if (had) (name ? this.bar.querySelector<HTMLElement>(`input[aria-label="${CSS.escape(name)}"]:not([hidden])`) ?? this.canvas.root : this.canvas.root).focus();
  }
  private draw(place = this.project.photo, by: Point = { x: 0, y: 0 }): void {
    const { loaded } = this;
    const points = this.active ? this.points.map((p) => ({ x: p.x + by.x, y: p.y + by.y })) : [];
    this.canvas.setPhoto(loaded && place && this.shown ? { url: loaded.url, opacity: this.opacity, x: place.x, y: place.y, width: loaded.width * place.metre, height: loaded.height * place.metre, points } : null);
  }
  private controls(): HTMLElement[] {
    const { loaded } = this;
    const button = (words: string, does: () => void): HTMLElement => h("button", { class: "button small", type: "button", onclick: does }, words);
    if (!loaded) return [h("span", { class: "words" }, say("studio.photo.none")), button(say("studio.photo.open"), () => this.choose()), this.input];
    const faint = h("input", { type: "range", min: "0.1", max: "1", step: "0.05", value: String(this.opacity), "aria-label": say("studio.photo.opacity") });
    faint.addEventListener("input", () => {
      this.opacity = Number(faint.value);
      this.keepSoon();
      this.draw();
    });
    const seen = h("input", { type: "checkbox", checked: this.shown, onchange: () => this.toggle() });
    this.fresh.push(() => {
      seen.checked = this.shown;
      faint.value = String(this.opacity);
    });
    return [
      h("div", { class: "row" }, this.points.length === 2 ? this.measure() : h("span", { class: "words" }, say(`studio.photo.step.${this.points.length}`))),
      h("div", { class: "row" },
        h("label", { class: "check" }, seen, say("studio.photo.shown")),
        h("label", { class: "check" }, say("studio.photo.opacity"), faint),
        this.width(loaded),
        button(say("studio.photo.other"), () => this.choose()),
        button(say("studio.delete"), () => this.remove()),
        this.input),
    ];
  }
  private field(label: string, value: () => number, take: (v: number) => boolean, data: Record<string, string> = {}): HTMLInputElement {
    const written = (): string => writeQuantity(value(), "m", "0.00").split(" ")[0];
    const field = h("input", { type: "text", class: "length", autocomplete: "off", inputmode: "decimal", "aria-label": label, value: written(), ...data });
    const refresh = (): void => {
      field.value = written();
      field.removeAttribute("aria-invalid");
    };
    this.fresh.push(() => document.activeElement !== field && refresh()); // not while somebody types
    field.addEventListener("change", () => {
      const length = typedLength(field.value);
      const good = length !== null && length > 0 && take(length);
      if (good) refresh();
      else field.setAttribute("aria-invalid", "true");
    });
    return field;
  }
  private measure(): Child[] {
    const measured = (): number => {
      const [a, b] = this.points;
      return a && b ? Math.round(1000 * Math.hypot(b.x - a.x, b.y - a.y)) / 1000 : 0;
    };
    const field = this.field(say("studio.photo.length"), measured, (v) => this.scale(v), { "data-measure": "" });
    field.addEventListener("focus", () => field.select());
    return [h("label", { class: "check" }, say("studio.photo.length"), field, "m"), h("button", { class: "button small", type: "button", onclick: () => field.dispatchEvent(new Event("change")) }, say("studio.photo.set"))];
  }
  // For those who cannot point: the whole photo's width.
  private width(loaded: Loaded): HTMLElement {
    const field = this.field(say("studio.photo.width"), () => (this.project.photo?.metre ?? 0) * loaded.width, (v) => {
      const place = this.project.photo;
      if (!place || !this.fits(v / loaded.width)) return false;
      this.put({ ...place, metre: v / loaded.width });
      return true;
    });
    return h("label", { class: "check" }, say("studio.photo.width"), field, "m");
  }
}
export type ShownPhoto = { url: string; opacity: number; x: number; y: number; width: number; height: number; points: Point[] };
export const photoMarks = (photo: ShownPhoto, x: (m: number) => number, y: (m: number) => number, metre: number): { image: SVGElement; points: SVGElement } => ({
  image: svg("image", { class: "photo", href: photo.url, preserveAspectRatio: "none", opacity: photo.opacity, x: x(photo.x), y: y(photo.y + photo.height), width: photo.width * metre, height: photo.height * metre }),
  points: svg("g", { class: "measured" },
    photo.points.length === 2 && svg("line", { x1: x(photo.points[0].x), y1: y(photo.points[0].y), x2: x(photo.points[1].x), y2: y(photo.points[1].y) }),
    photo.points.map((p) => svg("path", { d: `M${x(p.x) - 8} ${y(p.y)}h16M${x(p.x)} ${y(p.y) - 8}v16` }))),
});
