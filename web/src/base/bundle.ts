// Unpacks the bytes of a page: a JSON header and typed arrays (src/report/bundle.h has the layout).
import type { PageHeader, Place } from "../headers/page";

export type Numbers = Float32Array | Int32Array | Uint8Array | Float64Array;

// The header type depends on the kind of page: main.ts checks the kind, and passes the bundle to its page.
export class Bundle<Header extends PageHeader = PageHeader> {
  constructor(
    readonly header: Header,
    private readonly bytes: ArrayBuffer,
    private readonly begin: number,
  ) {}

  has(name: string): boolean {
    return name in this.header.arrays;
  }

  // The values of an array; rounded ones are converted back.
  array(name: string): Numbers {
    const place = this.header.arrays[name] as Place | undefined;
    if (!place) throw new Error(`the data lack ${name}`);
    const at = this.begin + place.at;
    switch (place.type) {
      case "float32":
        return new Float32Array(this.bytes, at, place.count);
      case "int32":
        return new Int32Array(this.bytes, at, place.count);
      case "uint8":
        return new Uint8Array(this.bytes, at, place.count);
      case "int16":
        return unrounded(new Int16Array(this.bytes, at, place.count), place.steps ?? [place.step ?? 1]);
    }
    throw new Error(`the data hold ${name} in an unknown form`);
  }
}

function unrounded(numbers: Int16Array, steps: number[]): Float32Array {
  const values = new Float32Array(numbers.length),
    width = numbers.length / Math.max(1, steps.length);
  steps.forEach((step, row) => {
    for (let i = row * width; i < (row + 1) * width; ++i) values[i] = numbers[i] * step;
  });
  return values;
}

export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

const kMark = "WYTHE\0\0";
const kVersion = 2;
const kHead = 12;

// Throws an Error whose message names the fault of the bytes.
export async function unpack(packed: Uint8Array<ArrayBuffer>): Promise<Bundle> {
  let bytes: ArrayBuffer;
  try {
    bytes = await inflate(packed);
  } catch {
    throw new Error("the data are damaged: they cannot be unpacked");
  }
  if (bytes.byteLength < kHead) throw new Error("the data are damaged: they end early");
  const mark = String.fromCharCode(...new Uint8Array(bytes, 0, 7));
  const version = new Uint8Array(bytes)[7];
  if (mark !== kMark) throw new Error("the data are damaged: they are not a report's");
  if (version !== kVersion) throw new Error(`the data are of version ${version}, the page of ${kVersion}`);
  const length = new DataView(bytes).getUint32(8, true);
  const begin = kHead + length;
  if (bytes.byteLength < begin) throw new Error("the data are damaged: they end early");
  const header: PageHeader = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, kHead, length)));
  return new Bundle(header, bytes, begin);
}
