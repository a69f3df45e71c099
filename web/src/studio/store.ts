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
