// Words and numbers in the page's language. The table is src/report/assets/texts.json, which the
// engine reads too (src/report/texts.h); phrases are what the engine says in English.
import table from "../../src/report/assets/texts.json";

type Row = string[];
const texts = table.texts as unknown as Record<string, Row>;
const phrases = table.phrases as unknown as Record<string, Row>;

let language = 0;
export function speak(code: string): void {
  language = Math.max(0, table.languages.indexOf(code));
}
export const isEnglish = (): boolean => language === 0;

export function say(key: string, places: Record<string, string | number> = {}): string {
  let text = texts[key]?.[language] ?? texts[key]?.[0] ?? key;
  for (const [name, value] of Object.entries(places)) text = text.split(`{${name}}`).join(String(value));
  return text;
}
export const knows = (key: string): boolean => key in texts;

const localised = (number: string): string => number.replace(".", table.decimal[language]);

// Significant digits, without exponent where sensible: rounded() of src/report/html.h.
export function num(value: number | null | undefined, digits = 3): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return say("unlimited");
  const size = Math.abs(value);
  if (size === 0) return "0";
  const sign = value < 0 ? "−" : "";
  if (size < 1e-4 || size >= 1e7) {
    const [mantissa, power] = size.toExponential(Math.max(0, digits - 2)).split("e");
    const raised = power.replace("+", "").replace(/./g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)]));
    return localised(`${sign}${mantissa}·10${raised}`);
  }
  const whole = Math.floor(Math.log10(size)) + 1;
  let text = size.toFixed(Math.min(8, Math.max(0, digits - whole)));
  if (text.includes(".")) text = text.replace(/0+$/, "").replace(/\.$/, "");
  return localised(sign + text);
}

// A number of so many decimals: correlations.
export const fixed = (value: number | null, decimals = 2): string =>
  value === null ? "–" : num(Number(value.toFixed(decimals)), 4);

export function qty(value: number | null | undefined, unit: string, digits = 3): string {
  const text = num(value, digits);
  return !Number.isFinite(value ?? NaN) || unit === "" ? text : `${text}\u202f${unit}`;
}

// One system of units on a page: kN, MPa, mm. What files say in others is shown in these, with a factor.
const kUnits: Record<string, [string, number]> = {
  N: ["kN", 1e-3],
  Pa: ["MPa", 1e-6],
  kPa: ["MPa", 1e-3],
  GPa: ["MPa", 1e3],
  "N/mm^2": ["MPa", 1],
  "Pa/m": ["MPa/mm", 1e-9],
  "MPa/m": ["MPa/mm", 1e-3],
  "GPa/m": ["MPa/mm", 1],
  "N/mm^3": ["MPa/mm", 1],
  "N/m": ["kN/m", 1e-3],
  "N/mm": ["kN/m", 1],
  "J/m^2": ["kN/m", 1e-3],
  "kg/m^3": ["kg/m³", 1],
  deg: ["°", 1],
  "1": ["", 1],
  "-": ["", 1],
};
export const pageUnit = (unit: string): [string, number] => kUnits[unit] ?? [unit, 1];

function escapedForPattern(text: string): string {
  return text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
}
// The most telling first: "{} mm" fits whatever ends in millimetres.
const letters = (pattern: string): number => pattern.replace(/\{\}/g, "").length;
const patterns = Object.keys(phrases)
  .filter((p) => p.includes("{}"))
  .sort((a, b) => letters(b) - letters(a))
  .map((p) => ({
    english: p,
    matcher: new RegExp("^" + p.split("{}").map(escapedForPattern).join("(.*?)") + "$", "s"),
  }));

// Signs as print has them: 3 × 4, −0.3, 10 → 12, 5 % with a narrow space.
const typeset = (text: string): string =>
  text
    .replace(/ x (?=[\d.])/g, " × ")
    .replace(/->/g, "→")
    .replace(/(^|[ (])-(?=\d)/g, "$1−")
    .replace(/(\d) %/g, "$1\u202f%");

// A phrase of the engine in the page's language; lists are taken apart, unknown words stay.
export function phrase(english: string): string {
  return typeset(language === 0 || english === "" ? english : translated(english));
}
function translated(english: string): string {
  if (/^[-+±]?[\d.]+(e[-+]?\d+)?$/.test(english)) return localised(english);
  const known = phrases[english];
  if (known) return known[language - 1];
  for (const { english: pattern, matcher } of patterns) {
    const found = matcher.exec(english);
    if (!found) continue;
    let at = 0;
    return phrases[pattern][language - 1].replace(/\{\}/g, () => translated(found[++at]));
  }
  for (const between of ["; ", ": ", ", ", " + "]) {
    const parts = english.split(between);
    if (parts.length > 1) return parts.map(translated).join(between);
  }
  return english;
}

export const capital = (text: string): string => text.charAt(0).toLocaleUpperCase() + text.slice(1);
export const sentence = (english: string): string => asSentence(phrase(english));
export function asSentence(words: string): string {
  const text = capital(words);
  return text === "" || /[.!?]$/.test(text) ? text : text + ".";
}

const kListed = 3;
// What happened to the parts of a wall ("pier 1: rocking; pier 2: rocking; ..."), the first of them and
// how many more.
export function shortened(english: string): string {
  const parts = english.split("; ").filter((p) => p.includes(": "));
  if (parts.length <= kListed || parts.length < english.split("; ").length) return phrase(english);
  const more = say("parts.more", { n: parts.length - kListed });
  return `${phrase(parts.slice(0, kListed).join("; "))}; ${more}`;
}
