// What the drawing shows of a wall beside its outline and openings: lines of storeys. Each is an element that can be
// selected, focused and dragged (data-part, data-handle).
import { svg, type Attributes, type Child } from "../dom";
import { say } from "../texts";
import type { Drawing, Kind, Selected } from "./drawing";
import { metres } from "./words";

export interface Scale {
  x(m: number): number; // pixels
  y(m: number): number;
  metre: number;
}
export interface Shown {
  scale: Scale;
  d: Drawing;
  selection: Selected | null;
  moving: boolean; // what is selected is under way
  faulty: Map<string, string>; // "tie 0": why the engine refuses it
}

// A part with the attributes that all of them have.
function part(shown: Shown, kind: Kind, k: number, css: string, name: string, ...children: Child[]): SVGElement {
  const selected = shown.selection?.kind === kind && shown.selection.k === k;
  const why = shown.faulty.get(`${kind} ${k}`);
  const classes = ["part", css, selected && "selected", selected && shown.moving && "moving", why && "faulty"].filter(Boolean).join(" ");
  const about: Attributes = { class: classes, "data-part": `${kind} ${k}`, "data-handle": "part", tabindex: "0", role: "button", "aria-label": why ? `${name}. ${why}` : name, "aria-pressed": String(selected) };
  return svg("g", about, svg("title", {}, why ?? name), children);
}
// A line that a finger can hit.
function line(x1: number, y1: number, x2: number, y2: number): SVGElement[] {
  const at = { x1, y1, x2, y2 };
  return [svg("line", { class: "reach", ...at }), svg("line", { class: "line", ...at })];
}
const label = (x: number, y: number, anchor: "start" | "middle" | "end", text: string): SVGElement =>
  svg("text", { class: "part-name", x, y, "data-anchor": anchor, "aria-hidden": "true" }, text);

// A line below each storey but the lowest, with its name; and its height at the right.
export function storeyMarks(shown: Shown): SVGElement[] {
  const { d, scale } = shown;
  return d.storeys.map((s, k) => {
    const y = scale.y(s.foot);
    const name = say("studio.storey.called", { name: s.name, height: metres(s.height), foot: metres(s.foot) });
    return part(
      shown, "storey", k, "storey", name,
      k > 0 && line(scale.x(0) - 10, y, scale.x(d.length) + 10, y),
      label(scale.x(0) + 6, y - 6, "start", s.name),
    );
  });
}
