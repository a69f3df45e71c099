// The engine's picture of a wall (SVG) of a known length as elements of the page, placed in the wall's metres. Only shapes that the
// engine draws come through, and of those only what says where and how they are. A wall of thousands of stones has thousands of
// cracks: those that look alike become one path, and what a crack says of itself is looked up under the pointer. It is read in
// slices of equal length, so that gestures and frames come in between.
import { svg } from "../../base/dom";

const kAttributes: Record<string, RegExp> = {
  class: /^[a-z0-9 _-]{1,40}$/,
  d: /^[MLZ\d\s.,e-]*$/,
  points: /^[\d\s.,e-]*$/,
  "stroke-width": /^[\d.]+$/,
  opacity: /^[\d.]+$/,
};
for (const name of ["x1", "x2", "y1", "y2", "cx", "cy", "r"]) kAttributes[name] = /^-?[\d.]+$/;
const kOutside = new Set(["rest", "scale"]); // frame and scale bar: the page has its own
const kOver = ["softening", "closed", "slip", "open"]; // what a crack does, from below to above
export const kSlice = 50_000; // characters that are read or drawn before others have their turn: some 5 ms
const kMostAlike = 1000; // cracks of one path

export interface Picture {
  shapes: SVGGElement; // in pixels of the picture
  left: number; // pixel of x = 0
  bottom: number; // pixel of y = 0
  metre: number; // pixels
  width: number; // of the whole picture
  height: number;
}

interface Crack {
  x1: number;
  y1: number;
  x2: number;
  y2: number;
  says: string;
}
interface Alike {
  css: string;
  width: string;
  opacity: string;
  d: string[];
  cracks: Crack[];
}

const kEntities: Record<string, string> = { amp: "&", lt: "<", gt: ">", quot: '"', "#39": "'", apos: "'" };
const plain = (text: string): string => text.replace(/&(#?\w+);/g, (all, name: string) => kEntities[name] ?? all);

// Attributes of one element, those alone that may come through.
function attributesOf(text: string): Record<string, string> {
  const found: Record<string, string> = {};
  for (const [, name, value] of text.matchAll(/([a-z0-9-]+)="([^"]*)"/g)) if (kAttributes[name]?.test(value)) found[name] = value;
  return found;
}

// Lets the browser do what waits.
const breathe = (): Promise<void> => new Promise((done) => setTimeout(done));

// null: the text is no picture, or nobody wants it any more.
export async function readPicture(text: string, length: number, isWanted: () => boolean = () => true, pause: () => Promise<void> = breathe): Promise<Picture | null> {
  const reader = read(text, length);
  let slice = 0;
  for (;;) {
    const step = reader.next();
    if (step.done) return step.value;
    if ((slice += step.value) < kSlice) continue;
    slice = 0;
    await pause();
    if (!isWanted()) return null;
  }
}

// Step by step: how many characters each had.
function* read(text: string, length: number): Generator<number, Picture | null> {
  const box = /<svg\s[^>]*?viewBox="([\d. -]+)"/.exec(text);
  if (!box) return null;
  const size = box[1].split(" ").map(Number);
  const shapes = svg("g", { class: "picture" });
  const alike = new Map<string, Alike>();
  const groups: Alike[] = [];
  let crushed = "";
  let frame: number[] | null = null;
  for (const [all, tag, inside, says] of text.matchAll(/<(path|line|circle|polygon)\s([^<>]*?)\/?>(?:<title>([^<]*)<\/title>)?/g)) {
    yield all.length;
    const a = attributesOf(inside);
    const css = a.class ?? "";
    // the wall at rest: (0, 0), (0, height), (length, height), (length, 0)
    if (css === "rest") frame = (a.d ?? "").split(/[ML ]/).filter(Boolean).map(Number);
    if (kOutside.has(css)) continue;
    if (tag === "line" && css.startsWith("crack ")) addCrack(groups, alike, css, a, says);
    else if (tag === "circle" && css === "crushed") crushed += disc(Number(a.cx), Number(a.cy), Number(a.r));
    else if (a.d === undefined) shapes.append(svg(tag as "path", a));
    else yield* drawPath(shapes, a, a.d);
  }
  if (!frame || frame.length < 8 || !frame.every(Number.isFinite)) return null;
  const order = (group: Alike): number => kOver.findIndex((does) => group.css.includes(does));
  for (const group of groups.sort((a, b) => order(a) - order(b))) {
    const d = group.d.join("");
    shapes.append(pathOf(group, d));
    yield d.length;
  }
  yield* drawPath(shapes, { class: "crushed" }, crushed);
  return { shapes, left: frame[0], bottom: frame[1], metre: (frame[4] - frame[0]) / length, width: size[2], height: size[3] };
}

// A long path becomes several, each of whole lines (M ...).
function* drawPath(shapes: SVGElement, a: Record<string, string>, d: string): Generator<number> {
  for (let at = 0, end = 0; at < d.length; at = end) {
    const cut = d.length - at > kSlice ? d.lastIndexOf("M", at + kSlice) : d.length;
    end = cut > at ? cut : d.length;
    shapes.append(svg("path", { ...a, d: d.slice(at, end) }));
    yield end - at;
  }
}
function addCrack(groups: Alike[], alike: Map<string, Alike>, css: string, a: Record<string, string>, says = ""): void {
  const width = Number(a["stroke-width"] ?? 1).toFixed(1),
    opacity = Number(a.opacity ?? 1).toFixed(1);
  const key = `${css} ${width} ${opacity}`;
  let group = alike.get(key);
  if (!group || group.cracks.length === kMostAlike) {
    group = { css, width, opacity, d: [], cracks: [] };
    alike.set(key, group);
    groups.push(group);
  }
  group.d.push(`M${a.x1} ${a.y1}L${a.x2} ${a.y2}`);
  group.cracks.push({ x1: Number(a.x1), y1: Number(a.y1), x2: Number(a.x2), y2: Number(a.y2), says: plain(says) });
}
const disc = (x: number, y: number, r: number): string => `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;

function pathOf({ css, width, opacity, cracks }: Alike, d: string): SVGElement {
  const title = svg("title");
  const path = svg("path", { class: css, "stroke-width": width, opacity, d }, title);
  path.addEventListener("pointermove", (e) => {
    const matrix = path.getScreenCTM();
    if (!matrix) return;
    const at = new DOMPoint(e.clientX, e.clientY).matrixTransform(matrix.inverse());
    title.textContent = nearest(cracks, at).says;
  });
  return path;
}
function nearest(cracks: Crack[], at: { x: number; y: number }): Crack {
  let best = cracks[0],
    least = Infinity;
  for (const crack of cracks) {
    const dx = crack.x2 - crack.x1,
      dy = crack.y2 - crack.y1;
    const along = Math.min(1, Math.max(0, ((at.x - crack.x1) * dx + (at.y - crack.y1) * dy) / (dx * dx + dy * dy || 1)));
    const away = Math.hypot(at.x - crack.x1 - along * dx, at.y - crack.y1 - along * dy);
    if (away < least) [best, least] = [crack, away];
  }
  return best;
}
