// Bytes as text that a page or a link can hold: deflated, then base64. The browser's own streams do it.
import { fromBase64 } from "../bundle";

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

export async function unpacked(base64: string): Promise<ArrayBuffer> {
  if (base64.trim() === "" || base64.includes("<!--")) return new ArrayBuffer(0);
  const own = (Uint8Array as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> }).fromBase64; // of newer browsers: twice as fast
  return (await through(own ? own(base64) : fromBase64(base64.trim()), new DecompressionStream("deflate-raw"))).buffer;
}

// A text in the alphabet of links: - and _ for + and /, no padding.
export async function toLink(text: string): Promise<string> {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}
const kLongest = 1 << 20; // of a text that a link may unpack to [bytes]
export async function fromLink(link: string): Promise<string> {
  const bytes = await through(fromBase64(link.replace(/-/g, "+").replace(/_/g, "/")), new DecompressionStream("deflate-raw"), kLongest);
  return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
}
