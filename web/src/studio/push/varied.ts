// A number of the wall that may take other values: what it is called, what it is now, and the file with another one. A field of
// the panel makes one for its number; the file pane makes one for the number at its cursor.
import { qty } from "../../base/texts";
import type { Project } from "../project";
import { find, quoted, setValue, type Doc, type Node, type Path } from "../file/toml";

export interface Varied {
  name: string; // as the page calls it
  unit: string;
  whole: boolean; // a count
  now: () => number; // in `unit`; NaN where it is no longer there
  text: (value: number) => string | null; // the file with that value; null: it cannot be so
}
export const shown = (value: number, { unit }: Varied): string => qty(value, unit, 4);

// As many values from low to high, at equal steps or, over a wide range, at equal ratios. The one nearest to the number as it is
// gives way to it.
export function valuesBetween(low: number, high: number, count: number, now: number, whole: boolean): number[] {
  const ratio = high / low;
  const place = (k: number): number => (low > 0 && ratio > 1.5 ? low * ratio ** (k / (count - 1)) : low + ((high - low) * k) / (count - 1));
  const values = Array.from({ length: count }, (_, k) => place(k)).map((v) => (whole ? Math.round(v) : Number(v.toPrecision(3))));
  values[0] = whole ? values[0] : low;
  values[count - 1] = whole ? values[count - 1] : high;
  if (now >= low && now <= high) values[nearest(values, now)] = now;
  return [...new Set(values)].sort((a, b) => a - b);
}
export function nearest(values: number[], to: number): number {
  let best = 0;
  values.forEach((v, k) => (best = Math.abs(v - to) < Math.abs(values[best] - to) ? k : best));
  return best;
}
// From half to twice a number.
export const rangeOf = (now: number, whole: boolean): [number, number] => {
  const [low, high] = now < 0 ? [2 * now, now / 2] : [now / 2, 2 * now];
  return whole ? [Math.max(1, Math.floor(low)), Math.max(Math.ceil(high), Math.floor(low) + 2)] : [low, high];
};

// "0.4 m", "20 GPa/m", or a plain number: its value and its unit.
const kNumber = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([^\s\d].*)?$/;
function numberIn(doc: Doc | null, path: Path): { value: number; unit: string; plain: boolean } | null {
  const node = doc && find(doc, path);
  if (!doc || node?.kind !== "value") return null;
  if (typeof node.data === "number") return { value: node.data, unit: "", plain: true };
  const match = typeof node.data === "string" ? kNumber.exec(node.data) : null;
  return match?.[2] ? { value: Number(match[1]), unit: match[2].trim(), plain: false } : null;
}
// The number at a place of the file; of a line without one there, its first.
export function numberAt(project: Project, at: number): Varied | null {
  const { doc, text } = project;
  if (!doc || project.broken) return null;
  const from = text.lastIndexOf("\n", at - 1) + 1,
    end = text.indexOf("\n", at);
  const all: { path: Path; from: number; to: number }[] = [];
  const walk = (node: Node, path: Path): void => {
    if (node.kind === "value") {
      if (node.from >= from && (end < 0 || node.from <= end) && numberIn(doc, path)) all.push({ path, from: node.from, to: node.to });
    } else if (node.kind === "table") for (const [key, entry] of node.keys) walk(entry.node, [...path, key]);
    else node.items.forEach((item, k) => walk(item, [...path, k]));
  };
  walk(doc.root, []);
  const found = all.find((n) => at >= n.from && at <= n.to) ?? all.sort((a, b) => a.from - b.from)[0];
  return found ? numberOf(project, found.path) : null;
}
function numberOf(project: Project, path: Path): Varied {
  const { unit, plain, value } = numberIn(project.doc, path)!;
  return {
    name: path.join("."),
    unit,
    whole: plain && Number.isInteger(value) && !/[.e]/i.test(literalAt(project, path)),
    now: () => numberIn(project.doc, path)?.value ?? NaN,
    text: (v) => setValue(project.text, path, plain ? String(v) : quoted(`${v} ${unit}`)),
  };
}
function literalAt(project: Project, path: Path): string {
  const node = find(project.doc!, path);
  return node?.kind === "value" ? project.text.slice(node.from, node.to) : "";
}
