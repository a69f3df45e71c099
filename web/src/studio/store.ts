// Nothing is lost: the text is kept in the browser after each edit, stands in a link, and goes to and from files.
import { download } from "../export";
import { fromLink, toLink } from "./packed";

const kKey = "wythe.studio.text";
const kLongest = 1 << 20; // of a file that is opened [bytes]

// false: the browser keeps nothing (no room, or not allowed).
export function keep(text: string): boolean {
  try {
    localStorage.setItem(kKey, text);
    return true;
  } catch {
    return false;
  }
}
export function kept(): string | null {
  try {
    return localStorage.getItem(kKey);
  } catch {
    return null;
  }
}

// The model that `wythe studio MODEL.toml` put into this page, in hexadecimal digits; null where there is none, or where it was
// opened before: what became of it is kept.
const kGiven = "wythe.studio.given";
export function given(): string | null {
  const digits = document.getElementById("wythe-model")?.textContent?.trim() ?? "";
  if (!/^([0-9a-f]{2})+$/.test(digits)) return null;
  const text = new TextDecoder().decode(Uint8Array.from(digits.match(/../g)!, (pair) => parseInt(pair, 16)));
  try {
    if (localStorage.getItem(kGiven) === text) return null;
    localStorage.setItem(kGiven, text);
  } catch {
    // a browser that keeps nothing opens it each time
  }
  return text;
}

const kMark = "#w=";
export const hasLink = (): boolean => location.hash.startsWith(kMark);
export async function textOfLink(): Promise<string> {
  return fromLink(location.hash.slice(kMark.length));
}
export async function linkTo(text: string): Promise<string> {
  return `${location.href.split("#")[0]}${kMark}${await toLink(text)}`;
}
// The address shows no wall that has changed since.
export function forgetLink(): void {
  if (hasLink()) history.replaceState(null, "", location.href.split("#")[0]);
}

export const save = (name: string, text: string): void => download(`${name}.toml`, "application/toml", text);
export const fileName = (title: string): string =>
  title.normalize("NFKD").replace(/[^A-Za-z0-9]+/g, "_").replace(/^_+|_+$/g, "").slice(0, 60).toLowerCase() || "model";

// A text of a file; throws where it is none or too long.
export async function readFile(file: File): Promise<string> {
  if (file.size > kLongest) throw new Error("too long");
  return new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
}
