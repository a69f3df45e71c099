// Quantities as a model file writes them ("5.10 m"), and lengths as people type them ("1,25", "80 cm").
import { find, parse, quoted, setValue, valueAt, type Doc, type Path } from "./toml";

// How much of the base unit one of these is. Bases: m, m/s, m^2, N, Pa, N/m, kg/m, kg/m^2, kg/m^3.
const kFactors: Record<string, [base: string, factor: number]> = {
  m: ["m", 1], dm: ["m", 0.1], cm: ["m", 0.01], mm: ["m", 0.001], ft: ["m", 0.3048], in: ["m", 0.0254],
  "m/s": ["m/s", 1], "cm/s": ["m/s", 0.01], "mm/s": ["m/s", 0.001],
  N: ["N", 1], kN: ["N", 1e3], MN: ["N", 1e6],
  Pa: ["Pa", 1], kPa: ["Pa", 1e3], MPa: ["Pa", 1e6], GPa: ["Pa", 1e9],
  "N/mm^2": ["Pa", 1e6], "N/mm2": ["Pa", 1e6], "N/m^2": ["Pa", 1], "kN/m^2": ["Pa", 1e3],
  "kN/m2": ["Pa", 1e3], "daN/m^2": ["Pa", 10], "daN/m2": ["Pa", 10], "kgf/m^2": ["Pa", 9.80665], "kgf/m2": ["Pa", 9.80665],
  "N/m": ["N/m", 1], "kN/m": ["N/m", 1e3], "daN/m": ["N/m", 10], "kgf/m": ["N/m", 9.80665],
  "m^2": ["m^2", 1], m2: ["m^2", 1], "mm^2": ["m^2", 1e-6], mm2: ["m^2", 1e-6], "cm^2": ["m^2", 1e-4], cm2: ["m^2", 1e-4],
  "kg/m": ["kg/m", 1], "kg/m^2": ["kg/m^2", 1], "kg/m2": ["kg/m^2", 1], "kg/m^3": ["kg/m^3", 1], "kg/m3": ["kg/m^3", 1],
};

export interface Quantity {
  value: number; // in the base unit
  unit: string; // as it was written
  base: string;
}

export function readQuantity(text: unknown): Quantity | null {
  if (typeof text !== "string") return null;
  const match = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([A-Za-z][\w^/]*)\s*$/.exec(text);
  const known = match && kFactors[match[2]];
  return known ? { value: Number(match[1]) * known[1], unit: match[2], base: known[0] } : null;
}

// What stands in a place, in its base unit; null: it cannot be read, or is of another kind.
export function amountOf(text: unknown, base: string): number | null {
  const q = readQuantity(text);
  return q?.base === base ? q.value : null;
}
export const lengthOf = (text: unknown): number | null => amountOf(text, "m");

// A value in a unit, without tails of rounding: at most a tenth of a millimetre, and as many decimals as `like` has.
export function writeQuantity(value: number, unit: string, like = ""): string {
  const [base, factor] = kFactors[unit] ?? [unit, 1];
  const inUnit = value / factor;
  const most = base === "m" ? Math.max(0, Math.round(4 + Math.log10(factor))) : 6;
  const wanted = Math.min(2, /\.(\d+)/.exec(like)?.[1].length ?? 0);
  let text = Number(inUnit.toFixed(most)).toString();
  const has = text.split(".")[1]?.length ?? 0;
  if (has < wanted && !text.includes("e")) text = Number(text).toFixed(Math.min(wanted, most));
  return `${text} ${unit}`;
}

// A quantity times a factor, in its unit and with all its digits; null: it cannot be read.
export function times(text: unknown, factor: number): string | null {
  const q = readQuantity(text);
  return q && `${Number((parseFloat(text as string) * factor).toPrecision(12))} ${q.unit}`;
}

// What somebody types for a length: metres unless a unit follows; a comma is a point.
export function typedLength(text: string): number | null {
  const match = /^\s*([-+]?(?:\d+[.,]?\d*|[.,]\d+))\s*(m|dm|cm|mm|ft|in)?\s*$/.exec(text);
  if (!match) return null;
  const value = Number(match[1].replace(",", ".")) * kFactors[match[2] ?? "m"][1];
  return Number.isFinite(value) ? value : null;
}

// Any quantity of the same kind as `like`: its unit where none is typed. null if it is another kind.
export function typedQuantity(text: string, like: string): string | null {
  const plain = text.trim().replace(/^([-+]?\d*),(\d)/, "$1.$2");
  const unit = readQuantity(like)?.unit;
  if (unit && /^[-+]?(\d+\.?\d*|\.\d+)$/.test(plain)) return `${plain} ${unit}`;
  const q = readQuantity(plain);
  return q && q.base === readQuantity(like)?.base ? plain.replace(/\s*([A-Za-z][\w^/]*)$/, " $1") : null;
}

// A length in the unit and with the decimals that stand there already.
export function setLength(text: string, path: Path, value: number): string {
  const old = valueAt(parse(text), path);
  const unit = readQuantity(old)?.unit ?? "m";
  if (lengthOf(old) !== null && Math.abs(lengthOf(old)! - value) < 5e-5) return text;
  return setValue(text, path, quoted(writeQuantity(value, unit, typeof old === "string" ? old : "0.00")));
}

// Something else than a quantity stands there: "unlimited", "rule".
export const isWord = (doc: Doc, path: Path): boolean => find(doc, path) !== undefined && readQuantity(valueAt(doc, path)) === null;
