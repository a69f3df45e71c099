// What the drawing shows of a wall beside its outline and openings: lines of storeys, floors, ties. Each is an element that can be
// selected, focused and dragged (data-part, data-handle).
import { svg, type Attributes, type Child } from "../../base/dom";
import { say } from "../../base/texts";
import type { Drawing, Kind, Selected } from "../drawing";
import { amount, metres } from "../words";

const kArrow = 18; // length of a load's arrows [px]

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
  const laden = (y: number): boolean => d.floors.some((f) => Math.abs(f.y - y) < 0.011 && f.x < 0.5);
  return d.storeys.map((s, k) => {
    const y = scale.y(s.foot);
    const name = say("studio.storey.called", { name: s.name, height: metres(s.height), foot: metres(s.foot) });
    return part(
      shown, "storey", k, "storey", name,
      k > 0 && line(scale.x(0) - 10, y, scale.x(d.length) + 10, y),
      label(scale.x(0) + 6, y - (laden(s.foot) ? kArrow + 12 : 6), "start", s.name),
    );
  });
}

// A bar on the wall under the arrows of its load; where it is a diaphragm, with the points that it holds.
export function floorMarks(shown: Shown): Child {
  const { d, scale } = shown;
  return d.floors.map((f, k) => {
    if (!Number.isFinite(f.y)) return null;
    const x0 = scale.x(f.x),
      x1 = scale.x(f.x + f.width),
      y = scale.y(f.y),
      top = y - 4 - kArrow;
    const load = amount(f.load, 1e-3, "kN/m");
    const name = say("studio.floor.called", { name: f.name, load, y: metres(f.y) });
    const count = Math.max(2, Math.round((x1 - x0) / 46));
    const arrows = Array.from({ length: count }, (_, i) => {
      const x = x0 + ((i + 0.5) / count) * (x1 - x0);
      return `M${x} ${top}V${y - 5}M${x - 3.5} ${y - 10}L${x} ${y - 5}L${x + 3.5} ${y - 10}`;
    });
    const held = f.diaphragm < 0 ? [] : d.diaphragms[f.diaphragm].x.filter(Number.isFinite);
    return part(
      shown, "floor", k, "floor", name,
      svg("rect", { class: "reach", x: x0, y: top - 6, width: Math.max(0, x1 - x0), height: kArrow + 8 }),
      (f.load ?? 1) > 0 && svg("path", { class: "arrows", d: `M${x0} ${top}H${x1}${arrows.join("")}` }),
      svg("rect", { class: "bar", x: x0, y: y - 4, width: Math.max(0, x1 - x0), height: 5 }),
      held.map((x) => svg("circle", { class: "held", cx: scale.x(x), cy: y - 1.5, r: 4.5 })),
      label(x1 - 4, top - 6, "end", x1 - x0 > 330 ? `${f.name} · ${load}` : load),
    );
  });
}

// A line between two anchor plates.
export function tieMarks(shown: Shown): Child {
  const { d, scale } = shown;
  return d.ties.map((t, k) => {
    if (!t.from || !t.to) return null;
    const [x1, y1, x2, y2] = [scale.x(t.from.x), scale.y(t.from.y), scale.x(t.to.x), scale.y(t.to.y)];
    const name = say("studio.tie.called", { name: t.name, area: amount(t.area, 1e6, "mm²"), y: metres(t.from.y) });
    const plate = (x: number, y: number): SVGElement => svg("g", {}, svg("circle", { class: "reach", cx: x, cy: y, r: 14 }), svg("rect", { class: "plate-end", x: x - 2.5, y: y - 9, width: 5, height: 18, rx: 1.5 }));
    const selected = shown.selection?.kind === "tie" && shown.selection.k === k;
    return part(shown, "tie", k, "tie", name, line(x1, y1, x2, y2), plate(x1, y1), plate(x2, y2), selected && label((x1 + x2) / 2, (y1 + y2) / 2 - 8, "middle", `${t.name} · ${amount(t.area, 1e6, "mm²")}`));
  });
}
