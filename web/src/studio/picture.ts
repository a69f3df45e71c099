// The engine's picture of a wall (SVG) of a known length as elements of the page, placed in the wall's metres. Only shapes that the
// engine draws come through, and of those only what says where and how they are. A wall of thousands of stones has thousands of
// cracks: those that look alike become one path, and what a crack says of itself is looked up under the pointer.
import { svg } from "../dom";

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

export function readPicture(text: string, length: number): Picture | null {
  const box = /<svg\s[^>]*?viewBox="([\d. -]+)"/.exec(text);
  if (!box) return null;
  const size = box[1].split(" ").map(Number);
  const shapes = svg("g", { class: "picture" });
  const alike = new Map<string, Alike>();
  let crushed = "";
  let frame: number[] | null = null;
  for (const [, tag, inside, says] of text.matchAll(/<(path|line|circle|polygon)\s([^<>]*?)\/?>(?:<title>([^<]*)<\/title>)?/g)) {
    const a = attributesOf(inside);
    const css = a.class ?? "";
    // the wall at rest: (0, 0), (0, height), (length, height), (length, 0)
    if (css === "rest") frame = (a.d ?? "").split(/[ML ]/).filter(Boolean).map(Number);
    if (kOutside.has(css)) continue;
    if (tag === "line" && css.startsWith("crack ")) addCrack(alike, css, a, says);
    else if (tag === "circle" && css === "crushed") crushed += disc(Number(a.cx), Number(a.cy), Number(a.r));
    else shapes.append(svg(tag as "path", a));
  }
  if (!frame || frame.length < 8 || !frame.every(Number.isFinite)) return null;
  const order = (group: Alike): number => kOver.findIndex((does) => group.css.includes(does));
  for (const group of [...alike.values()].sort((a, b) => order(a) - order(b))) shapes.append(pathOf(group));
  if (crushed !== "") shapes.append(svg("path", { class: "crushed", d: crushed }));
  return { shapes, left: frame[0], bottom: frame[1], metre: (frame[4] - frame[0]) / length, width: size[2], height: size[3] };
}

function addCrack(alike: Map<string, Alike>, css: string, a: Record<string, string>, says = ""): void {
  const width = Number(a["stroke-width"] ?? 1).toFixed(1),
    opacity = Number(a.opacity ?? 1).toFixed(1);
  const key = `${css} ${width} ${opacity}`;
  let group = alike.get(key);
  if (!group) alike.set(key, (group = { css, width, opacity, d: [], cracks: [] }));
  group.d.push(`M${a.x1} ${a.y1}L${a.x2} ${a.y2}`);
  group.cracks.push({ x1: Number(a.x1), y1: Number(a.y1), x2: Number(a.x2), y2: Number(a.y2), says: plain(says) });
}
const disc = (x: number, y: number, r: number): string => `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;

function pathOf({ css, width, opacity, d, cracks }: Alike): SVGElement {
  const title = svg("title");
  const path = svg("path", { class: css, "stroke-width": width, opacity, d: d.join("") }, title);
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
