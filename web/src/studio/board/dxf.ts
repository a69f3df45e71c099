// The lines of a DXF drawing as a picture to trace: its entities drawn into an image without ground, at the size that the
// drawing's unit says. Lines, polylines, circles and arcs; what else there is, is counted and said.
type Pair = [code: number, value: string];
type Point = [x: number, y: number];

export interface Lines {
  paths: Point[][];
  metre: number; // of one unit of the drawing; 0: it does not say
  skipped: number; // entities that are not drawn
}
const kUnits: Record<string, number> = { 1: 0.0254, 2: 0.3048, 4: 1e-3, 5: 0.01, 6: 1, 14: 0.1 }; // $INSUNITS
export const kMost = 200000; // points
const kWide = 3000; // of the picture, its longer side [px]
const kLine = 13; // of which some two are left on a screen [px]
const kArc = 32; // parts of a circle
const kRound = 2 * Math.PI;
const kStraight = 1e-9; // a smaller bulge is none

export const isDxf = (name: string, head: string): boolean => /\.dxf$/i.test(name) || /^\s*0\s*\r?\nSECTION/.test(head);

function pairs(text: string): Pair[] {
  const lines = text.split(/\r?\n/);
  const out: Pair[] = [];
  for (let k = 0; k + 1 < lines.length; k += 2) out.push([Number(lines[k]), lines[k + 1].trim()]);
  return out;
}
// Entities as lists of their pairs, without the first that names them.
function entities(all: Pair[]): { name: string; pairs: Pair[] }[] {
  const from = all.findIndex(([code, value], k) => code === 2 && value === "ENTITIES" && all[k - 1]?.[1] === "SECTION");
  const out: { name: string; pairs: Pair[] }[] = [];
  for (let k = from + 1; from >= 0 && k < all.length; ++k) {
    const [code, value] = all[k];
    if (code === 0 && value === "ENDSEC") break;
    if (code === 0) out.push({ name: value, pairs: [] });
    else out[out.length - 1]?.pairs.push(all[k]);
  }
  return out;
}
const number = (list: Pair[], code: number): number => Number(list.find(([c]) => c === code)?.[1] ?? 0);

function arc(x: number, y: number, r: number, from: number, to: number): Point[] {
  const rest = (to - from) % kRound; // from here to there against the clock, at most once around
  const turn = rest < 1e-9 ? rest + kRound : rest;
  const n = Math.max(2, Math.ceil((kArc * turn) / kRound));
  return Array.from({ length: n + 1 }, (_, k): Point => [x + r * Math.cos(from + (turn * k) / n), y + r * Math.sin(from + (turn * k) / n)]);
}
// Corners with their bulges: the tangent of a quarter of the angle of the arc to the next one.
function polyline(corners: { x: number; y: number; bulge: number }[], closed: boolean): Point[] {
  const out: Point[] = [];
  for (const [k, a] of corners.entries()) {
    if (out.length > kMost) return out;
    out.push([a.x, a.y]);
    const b = corners[k + 1] ?? (closed ? corners[0] : undefined);
    if (!b || Math.abs(a.bulge) < kStraight) continue;
    const dx = b.x - a.x,
      dy = b.y - a.y,
      chord = Math.hypot(dx, dy);
    if (chord === 0) continue;
    const angle = 4 * Math.atan(a.bulge);
    const sag = (1 / a.bulge - a.bulge) / 4; // of the centre from the chord, in chords, to the left
    const cx = a.x + dx / 2 - sag * dy,
      cy = a.y + dy / 2 + sag * dx;
    const r = Math.hypot(a.x - cx, a.y - cy),
      start = Math.atan2(a.y - cy, a.x - cx);
    const n = Math.max(2, Math.ceil((kArc * Math.abs(angle)) / kRound));
    for (let i = 1; i < n; ++i) out.push([cx + r * Math.cos(start + (angle * i) / n), cy + r * Math.sin(start + (angle * i) / n)]);
  }
  if (closed && corners.length > 0) out.push([corners[0].x, corners[0].y]);
  return out;
}

// null: more points than kMost.
export function readDxf(text: string): Lines | null {
  const all = pairs(text);
  const unit = all.findIndex(([code, value]) => code === 9 && value === "$INSUNITS");
  const out: Lines = { paths: [], metre: kUnits[all[unit + 1]?.[1] ?? ""] ?? 0, skipped: 0 };
  const deg = Math.PI / 180;
  let points = 0;
  const add = (path: Point[]): void => {
    if (path.length < 2 || !path.flat().every(Number.isFinite)) ++out.skipped;
    else {
      out.paths.push(path);
      points += path.length;
    }
  };
  let open: { corners: { x: number; y: number; bulge: number }[]; closed: boolean } | null = null;
  for (const { name, pairs: p } of entities(all)) {
    if (points > kMost) return null;
    if (name === "LINE") add([[number(p, 10), number(p, 20)], [number(p, 11), number(p, 21)]]);
    else if (name === "CIRCLE") add(arc(number(p, 10), number(p, 20), number(p, 40), 0, kRound));
    else if (name === "ARC") add(arc(number(p, 10), number(p, 20), number(p, 40), number(p, 50) * deg, number(p, 51) * deg));
    else if (name === "LWPOLYLINE") {
      const corners: { x: number; y: number; bulge: number }[] = [];
      for (const [code, value] of p) {
        const last = corners[corners.length - 1];
        if (code === 10) corners.push({ x: Number(value), y: 0, bulge: 0 });
        else if (code === 20 && last) last.y = Number(value);
        else if (code === 42 && last) last.bulge = Number(value);
      }
      add(polyline(corners, (number(p, 70) & 1) === 1));
    } else if (name === "POLYLINE") open = { corners: [], closed: (number(p, 70) & 1) === 1 };
    else if (name === "VERTEX" && open) open.corners.push({ x: number(p, 10), y: number(p, 20), bulge: number(p, 42) });
    else if (name === "SEQEND" && open) {
      add(polyline(open.corners, open.closed));
      open = null;
    } else ++out.skipped;
  }
  return points > kMost ? null : out;
}

// Its picture, and how long one pixel is [units of the drawing]; null: there is nothing in it.
export async function paintDxf({ paths }: Lines): Promise<{ bytes: ArrayBuffer; pixel: number } | null> {
  const points = paths.flat();
  if (points.length === 0) return null;
  const [xs, ys] = [0, 1].map((axis) => points.reduce(([low, high], p) => [Math.min(low, p[axis]), Math.max(high, p[axis])], [Infinity, -Infinity]));
  const pixel = Math.max(xs[1] - xs[0], ys[1] - ys[0]) / kWide;
  if (!(pixel > 0)) return null;
  const image = document.createElement("canvas");
  image.width = Math.max(1, Math.ceil((xs[1] - xs[0]) / pixel));
  image.height = Math.max(1, Math.ceil((ys[1] - ys[0]) / pixel));
  const to = image.getContext("2d");
  if (!to) return null;
  to.strokeStyle = "#e0218a"; // no stone's colour, light or dark
  to.lineWidth = kLine;
  for (const path of paths) {
    to.beginPath();
    path.forEach(([x, y], k) => to[k === 0 ? "moveTo" : "lineTo"]((x - xs[0]) / pixel, (ys[1] - y) / pixel));
    to.stroke();
  }
  const blob = await new Promise<Blob | null>((done) => image.toBlob(done, "image/png"));
  return blob && { bytes: await blob.arrayBuffer(), pixel };
}
