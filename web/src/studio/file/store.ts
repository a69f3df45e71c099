// Nothing is lost: the text is kept in the browser after each edit, stands in a link, and goes to and from files.
import { download } from "../../base/export";
import { fromLink, toLink } from "./packed";

export const kLongest = 1 << 20; // of a file that is opened [bytes]

// The field of the text knows one kind of line end: with another it would differ from the file for ever.
const plain = (text: string): string => text.replace(/\r\n?/g, "\n");

// The model that `wythe studio MODEL.toml` put into this page, in hexadecimal digits; null where there is none.
function modelOfPage(): string | null {
  const digits = document.getElementById("wythe-model")?.textContent?.trim() ?? "";
  if (!/^([0-9a-f]{2})+$/.test(digits)) return null;
  return plain(new TextDecoder().decode(Uint8Array.from(digits.match(/../g)!, (pair) => parseInt(pair, 16))));
}
// 64 bits of a text, so that pages of different models have different places.
function hashOf(text: string): string {
  let a = 0x811c9dc5,
    b = text.length;
  for (let k = 0; k < text.length; ++k) {
    a = Math.imul(a ^ text.charCodeAt(k), 0x01000193);
    b = Math.imul(b ^ text.charCodeAt(k), 0x5bd1e995) ^ (b >>> 15);
  }
  return [a, b].map((half) => (half >>> 0).toString(16).padStart(8, "0")).join("");
}

// Two places in the browser: one for the wall of a plain page, one for the work on each model that came with its page.
const kPlain = "wythe.studio.text";
export const given = modelOfPage();
const kHere = given === null ? kPlain : `${kPlain}.${hashOf(given)}`;

const read = (from: () => Storage, key: string): string | null => {
  try {
    return from().getItem(key);
  } catch {
    return null;
  }
};
// All tabs of a page share the browser's storage, and the last edit of any stands there. A tab's own comes back when it is loaded again.
const all = (): Storage => localStorage,
  own = (): Storage => sessionStorage;
function keepIn(to: () => Storage, text: string | null): boolean {
  try {
    if (text === null) to().removeItem(kHere);
    else to().setItem(kHere, text);
    return true;
  } catch {
    return false;
  }
}
// What this tab shows, edited or not.
export const keepOwn = (text: string): boolean => keepIn(own, text);
// false: the browser keeps nothing (no room, or not allowed).
export function keep(text: string): boolean {
  keepOwn(text);
  return keepIn(all, text === given ? null : text); // the page itself has that one
}
export const kept = (): string | null => read(own, kHere) ?? read(all, kHere);
export const keptByAnother = (): string | null => read(all, kHere);
export const keptPlain = (): string | null => read(all, kPlain);

// What a page that is loaded anew takes along beside its text; it is there once. false: there is no room for it.
export function handOver(what: object): boolean {
  try {
    own().setItem(`${kHere}.along`, JSON.stringify(what));
    return true;
  } catch {
    return false;
  }
}
export function handedOver(): unknown {
  const what = read(own, `${kHere}.along`);
  takeNothing();
  return what === null ? null : JSON.parse(what);
}
export function takeNothing(): void {
  try {
    own().removeItem(`${kHere}.along`);
  } catch {
    // nor is there anything
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

// A text of a file; throws where it is none.
export async function readFile(file: File): Promise<string> {
  return plain(new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer()));
}
