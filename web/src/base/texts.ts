// Words and numbers in the page's language. The table is src/report/assets/texts.json, which the
// engine reads too (src/report/texts.h). Texts of the engine come in all languages with the data.
import table from "../../../src/report/assets/texts.json";

type Row = string[];
const texts = table.texts as unknown as Record<string, Row>;
const phrases = table.phrases as unknown as Record<string, Row>;

let language = 0;
export function speak(code: string): void {
  language = Math.max(0, table.languages.indexOf(code));
}
export const languageNow = (): string => table.languages[language];

export function say(key: string, places: Record<string, string | number> = {}): string {
  let text = texts[key]?.[language] ?? texts[key]?.[0] ?? key;
  for (const [name, value] of Object.entries(places)) text = text.split(`{${name}}`).join(String(value));
  return text;
}
export const knows = (key: string): boolean => key in texts;

const localised = (number: string): string => number.replace(".", table.decimal[language]);

// Significant digits, without exponent where possible: rounded() of src/report/html.h.
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

// A number with a fixed count of decimals, for correlations.
export const fixed = (value: number | null, decimals = 2): string =>
  value === null ? "–" : num(Number(value.toFixed(decimals)), 4);

export function qty(value: number | null | undefined, unit: string, digits = 3): string {
  const text = num(value, digits);
  return !Number.isFinite(value ?? NaN) || unit === "" ? text : `${text}\u202f${unit}`;
}

// Both ends of a span, with as many digits as tell them apart.
export function ends(from: number | null, to: number | null, unit: string): [string, string] {
  const both = (digits: number): [string, string] => [qty(from, unit, digits), qty(to, unit, digits)];
  for (let digits = 3; digits < 9; ++digits) if (both(digits)[0] !== both(digits)[1]) return both(digits);
  return both(3);
}

// One system of units on a page: kN, MPa, mm. Values of files in other units are converted with a factor.
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

// Typographic signs: 3 × 4, −0.3, 10 → 12, 5 % with a narrow space.
const typeset = (text: string): string =>
  text
    .replace(/ x (?=[\d.])/g, " × ")
    .replace(/->/g, "→")
    .replace(/(^|[ (])-(?=\d)/g, "$1−")
    .replace(/(\d) %/g, "$1\u202f%");

// A text of the engine: a list with one text for each language
// (src/report/translation.h), or one word or name, which `phrases` translates.
export type Said = string | string[];

// Names of the parts of this page's wall.
let names: Record<string, Said> = {};
export function learn(known: Record<string, Said> = {}): void {
  names = known;
}

export function phrase(said: Said): string {
  return typeset(Array.isArray(said) ? (said[language] ?? said[0]) : translated(said));
}
function translated(english: string): string {
  if (language === 0 || english === "") return english;
  if (/^[-+±]?[\d.]+(e[-+]?\d+)?$/.test(english)) return localised(english);
  const known = names[english];
  if (known !== undefined) return Array.isArray(known) ? known[language] : known;
  // a mode may have two names: "pier shear + pier rocking"
  return english
    .split(" + ")
    .map((word) => phrases[word]?.[language - 1] ?? word)
    .join(" + ");
}

export const capital = (text: string): string => text.charAt(0).toLocaleUpperCase() + text.slice(1);
export const sentence = (said: Said): string => asSentence(phrase(said));
export function asSentence(words: string): string {
  const text = capital(words);
  return text === "" || /[.!?]$/.test(text) ? text : text + ".";
}
