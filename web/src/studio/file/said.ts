// What the engine says of a faulty file, in the page's language. The engine has its faults in English; fault_words.json has the same
// sentences in all languages, with places for what differs: {1} anything, {o1} an opening, {n1} its number, {c1} text of a file, {l1} a line of it,
// {w1} a name, {k1} names, {d1} a number, {s1} a sign, {p1} parts that may have rows of their own, {r1} one that has. What is not in the table
// stays English and is marked so.
import { h, type Child } from "../../base/dom";
import { languageNow, say } from "../../base/texts";
import type { Answer } from "../push/engine";
import table from "./fault_words.json";
import type { Fault } from "../project";

const kLanguages = ["en", "it", "de", "fr", "es", "pt"]; // of the rows
const kToken = '(?:"[^"]*"|\\[(?:[^\\[\\]]|\\[[^\\]]*\\])*\\]|\\{(?:[^{}]|\\{[^}]*\\})*\\}|[\\w.-]+ *=|[-+]?\\d[\\w.+-]*|true|false)';
const kNumbered = "\\d+(?: \\((?:[^()]|\\([^()]*\\))*\\))?"; // an opening's number, and its name
const kPlaces: Record<string, string> = {
  "": ".+?",
  o: `opening ${kNumbered}`,
  n: kNumbered,
  c: `${kToken}(?:[ ,]+${kToken})*`,
  l: "(?:#|\\[|[\"'\\w.-]+ *=)(?:(?!, (?:or|if|say|one|on|in|its) | (?:or|and|beside|to|where) |; ).)*",
  w: "[\\w.<>*-]+",
  k: "[\\w.<>\\[\\]*/, +-]+",
  d: "[-+.\\de]+",
  s: "\\S{1,3}",
  p: ".+",
  r: ".+?",
};
const kLongest = 1000; // of a sentence: the time of a search grows with the square [characters]
interface Row {
  pattern: RegExp;
  kinds: string[]; // of its places, in the order of the English
  places: string[]; // their names
  words: string[];
}
const literal = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
function rowOf(words: string[]): Row {
  const parts = words[0].split(/\{([a-z]?)(\d)\}/);
  const kinds = parts.filter((_, k) => k % 3 === 1),
    places = parts.filter((_, k) => k % 3 === 2);
  const pattern = parts.map((part, k) => (k % 3 === 0 ? literal(part) : k % 3 === 1 ? `(${kPlaces[part]})` : "")).join("");
  return { pattern: new RegExp(`^${pattern}$`), kinds, places, words };
}
// The one that says the most in words of its own goes first.
let rows: Row[] | null = null;
const all = (): Row[] =>
  (rows ??= [...table].sort((a, b) => b[0].replace(/\{\w+\}/g, "").length - a[0].replace(/\{\w+\}/g, "").length).map(rowOf));

export const isKnown = (english: string): boolean => inWords(english, kLanguages[1]) !== null;

function partInWords(kind: string, part: string, language: string): string | null {
  if (kind === "r") return inWords(part, language);
  if (kind === "o") return inWords(part, language) ?? part;
  if (kind === "p") return part.split(", ").map((one) => inWords(one, language) ?? one).join(", ");
  return part;
}
// null: it is not in the table.
export function inWords(english: string, language = languageNow()): string | null {
  const at = kLanguages.indexOf(language);
  if (at <= 0 || english === "") return english;
  if (english.length > kLongest) return null;
  for (const { pattern, kinds, places, words } of all()) {
    const found = pattern.exec(english);
    if (!found) continue;
    const parts = kinds.map((kind, k) => partInWords(kind, found[k + 1], language));
    if (!parts.includes(null)) return words[at].replace(/\{(\d)\}/g, (_, place: string) => parts[places.indexOf(place)]!);
  }
  return null;
}
// Why an answer is none; what the browser says of itself stays in its own words.
export function whyOf({ browser, texts }: Answer, fault?: Fault): string {
  if (browser) return `${say(`studio.browser.${browser}`)}${texts.error ? ` (${texts.error})` : ""}`;
  return saidOf(fault?.problem ?? texts.error ?? "");
}
// For a place that takes text alone.
export const saidOf = (english: string): string => inWords(english) ?? `${say("studio.english")} ${english}`;
export function said(english: string): Child {
  const words = inWords(english);
  return words ?? [`${say("studio.english")} `, h("span", { lang: "en" }, english)];
}
