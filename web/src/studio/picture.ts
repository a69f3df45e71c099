// The engine's picture of a wall (SVG) of a known length as elements of the page, placed in the wall's metres. Only shapes that the
// engine draws come through, and of those only what says where and how they are.
import { svg } from "../dom";

const kElements = new Set(["path", "line", "circle", "polygon"]);
const kAttributes: Record<string, RegExp> = {
  class: /^[a-z0-9 _-]{1,40}$/,
  d: /^[MLZ\d\s.,e-]*$/,
  points: /^[\d\s.,e-]*$/,
  "stroke-width": /^[\d.]+$/,
  opacity: /^[\d.]+$/,
};
for (const name of ["x1", "x2", "y1", "y2", "cx", "cy", "r"]) kAttributes[name] = /^-?[\d.]+$/;
const kOutside = new Set(["rest", "scale"]); // frame and scale bar: the page has its own

export interface Picture {
  shapes: SVGGElement; // in pixels of the picture
  left: number; // pixel of x = 0
  bottom: number; // pixel of y = 0
  metre: number; // pixels
  width: number; // of the whole picture
  height: number;
}

export function readPicture(text: string, length: number): Picture | null {
  const doc = new DOMParser().parseFromString(text, "image/svg+xml");
  const root = doc.documentElement;
  if (root.localName !== "svg" || doc.querySelector("parsererror")) return null;
  const size = (root.getAttribute("viewBox") ?? "").split(" ").map(Number);
  const shapes = svg("g", { class: "picture" });
  let frame: number[] | null = null;
  for (const from of root.querySelectorAll("*")) {
    if (!kElements.has(from.localName)) continue;
    const css = from.getAttribute("class") ?? "";
    // the wall at rest: (0, 0), (0, height), (length, height), (length, 0)
    if (css === "rest") frame = (from.getAttribute("d") ?? "").split(/[ML ]/).filter(Boolean).map(Number);
    if (kOutside.has(css)) continue;
    const to = svg(from.localName as "path");
    for (const { name, value } of from.attributes) if (kAttributes[name]?.test(value)) to.setAttribute(name, value);
    const title = [...from.children].find((c) => c.localName === "title")?.textContent;
    if (title) to.append(svg("title", {}, title));
    shapes.append(to);
  }
  if (!frame || frame.length < 8 || !frame.every(Number.isFinite)) return null;
  return { shapes, left: frame[0], bottom: frame[1], metre: (frame[4] - frame[0]) / length, width: size[2], height: size[3] };
}
