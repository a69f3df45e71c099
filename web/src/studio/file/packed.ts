// Bytes as text that a page or a link can hold: deflated, then base64. The browser's own streams do it.
import { fromBase64 } from "../../base/bundle";

// One write and a reader: a stream out of a Blob takes four times as long.
async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream, most = Infinity): Promise<Uint8Array<ArrayBuffer>> {
  const writer = stream.writable.getWriter();
  for (const written of [writer.write(bytes as BufferSource), writer.close()]) written.catch(() => undefined); // the reader tells
  const reader = (stream as ReadableWritablePair<Uint8Array, BufferSource>).readable.getReader();
  const parts: Uint8Array[] = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) throw new Error("too long");
    parts.push(value);
  }
  const out = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

// The browser has no such streams: it is of before 2023.
export class TooOld extends Error {}
function made<T>(stream: () => T): T {
  try {
    return stream();
  } catch (error) {
    throw new TooOld(error instanceof Error ? error.message : String(error));
  }
}
const inflate = (): DecompressionStream => made(() => new DecompressionStream("deflate-raw"));

export async function unpacked(base64: string): Promise<ArrayBuffer> {
  if (base64.trim() === "" || base64.includes("<!--")) return new ArrayBuffer(0);
  const own = (Uint8Array as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> }).fromBase64; // of newer browsers: twice as fast
  return (await through(own ? own(base64) : fromBase64(base64.trim()), inflate())).buffer;
}

// A text in the alphabet of links: - and _ for + and /, no padding. A browser that cannot deflate makes a longer link.
const kPlain = "~"; // begins one that is not deflated
export async function toLink(text: string): Promise<string> {
  const bytes = new TextEncoder().encode(text);
  try {
    return inLetters(await through(bytes, made(() => new CompressionStream("deflate-raw"))));
  } catch (error) {
    if (!(error instanceof TooOld)) throw error;
    return kPlain + inLetters(bytes);
  }
}
function inLetters(bytes: Uint8Array): string {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}
const kLongest = 1 << 20; // of a text that a link may unpack to [bytes]
export async function fromLink(link: string): Promise<string> {
  const isPlain = link.startsWith(kPlain);
  const read = fromBase64((isPlain ? link.slice(kPlain.length) : link).replace(/-/g, "+").replace(/_/g, "/"));
  const bytes = isPlain ? read : await through(read, inflate(), kLongest);
  if (bytes.length > kLongest) throw new Error("too long");
  return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
}
