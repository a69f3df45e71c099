// Lines and polygons of a drawing by style class, in pixels. At rest they become one SVG path
// for each class. While the drawing moves they are painted on a canvas instead: a browser
// takes 2 ms for five thousand polygons there, and 40 ms for one path of all of them.
import { svg } from "./dom";

type Place = [number, number];

interface Lines {
  closed: boolean;
  at: number[]; // x, y of every corner
  end: number[]; // of each line, in `at`
  raw: string[]; // other SVG elements
}

const short = (v: number): number => Math.round(10 * v) / 10;

export class Paths {
  private readonly byClass = new Map<string, Lines>();

  constructor(
    private readonly X: (x: number) => number,
    private readonly Y: (y: number) => number,
  ) {}

  segment(css: string, a: Place, b: Place): void {
    const { at, end } = this.of(css);
    at.push(this.X(a[0]), this.Y(a[1]), this.X(b[0]), this.Y(b[1]));
    end.push(at.length);
  }
  polygon(css: string, points: Place[]): void {
    const lines = this.of(css);
    lines.closed = true;
    for (const [x, y] of points) lines.at.push(this.X(x), this.Y(y));
    lines.end.push(lines.at.length);
  }
  raw(css: string, d: string): void {
    this.of(css).raw.push(d);
  }

  elements(order: string[]): SVGPathElement[] {
    return this.sorted(order).map(([css, lines]) =>
      svg("path", { class: css, d: wordsOf(lines), "data-marks": lines.end.length + lines.raw.length }),
    );
  }
  paint(order: string[], painter: Painter): void {
    for (const [css, lines] of this.sorted(order)) painter.draw(css, lines);
  }

  private of(css: string): Lines {
    let lines = this.byClass.get(css);
    if (!lines) this.byClass.set(css, (lines = { closed: false, at: [], end: [], raw: [] }));
    return lines;
  }
  private sorted(order: string[]): [string, Lines][] {
    const rest = [...this.byClass.keys()].filter((css) => !order.includes(css));
    return [...order, ...rest].filter((css) => this.byClass.has(css)).map((css) => [css, this.byClass.get(css)!]);
  }
}

function wordsOf({ closed, at, end, raw }: Lines): string {
  const words: string[] = [];
  for (let line = 0, i = 0; line < end.length; ++line) {
    let d = "M";
    for (const from = i; i < end[line]; i += 2) d += `${i > from ? "L" : ""}${short(at[i])} ${short(at[i + 1])}`;
    words.push(closed ? d + "Z" : d);
  }
  return words.join("") + raw.join("");
}

const kUpright = 0.4; // slope of a side that counts as straight, over its length [px]

interface Style {
  fill: string;
  stroke: string;
  width: number;
  dash: number[];
  cap: CanvasLineCap;
  opacity: number;
}

// A canvas that uses the page's SVG styles.
export class Painter {
  readonly element = document.createElement("canvas");
  private readonly to = this.element.getContext("2d")!;
  private readonly styles = new Map<string, Style>();

  // For drawings within `place`, with its size.
  constructor(
    private readonly place: Element,
    width: number,
    height: number,
  ) {
    const fine = Math.min(2, window.devicePixelRatio || 1);
    this.element.width = Math.round(fine * width);
    this.element.height = Math.round(fine * height);
    this.element.style.width = `${width}px`;
    this.element.setAttribute("aria-hidden", "true");
    this.to.scale(fine, fine);
  }
  clear(): void {
    this.to.clearRect(0, 0, this.element.width, this.element.height);
  }
  draw(css: string, lines: Lines): void {
    const { to } = this,
      style = this.styleOf(css);
    to.globalAlpha = style.opacity;
    if (style.fill !== "none") {
      to.fillStyle = style.fill;
      this.fill(lines);
    }
    if (style.stroke === "none") return;
    to.strokeStyle = style.stroke;
    to.lineWidth = style.width;
    to.lineCap = style.cap;
    to.setLineDash(style.dash);
    to.beginPath();
    for (let line = 0, i = 0; line < lines.end.length; i = lines.end[line++]) this.trace(lines, i, lines.end[line]);
    to.stroke();
    for (const d of lines.raw) to.stroke(new Path2D(d));
  }

  // Fills polygons one by one: rectangles and convex polygons are fast, a path of a thousand polygons is not.
  private fill(lines: Lines): void {
    const { at, end } = lines,
      { to } = this;
    for (let line = 0, i = 0; line < end.length; i = end[line++]) {
      if (end[line] - i === 8 && this.fillUpright(at, i)) continue;
      to.beginPath();
      this.trace(lines, i, end[line]);
      to.fill();
    }
  }
  // Fills a nearly upright polygon as a rectangle; false if it leans.
  private fillUpright(at: number[], i: number): boolean {
    const [xa, ya, xb, yb, xc, yc, xd, yd] = [at[i], at[i + 1], at[i + 2], at[i + 3], at[i + 4], at[i + 5], at[i + 6], at[i + 7]];
    const near = (a: number, b: number): boolean => Math.abs(a - b) < kUpright;
    if (near(ya, yb) && near(yc, yd) && near(xb, xc) && near(xd, xa))
      this.to.fillRect((xa + xd) / 2, (ya + yb) / 2, (xb + xc - xa - xd) / 2, (yc + yd - ya - yb) / 2);
    else if (near(xa, xb) && near(xc, xd) && near(yb, yc) && near(yd, ya))
      this.to.fillRect((xa + xb) / 2, (ya + yd) / 2, (xc + xd - xa - xb) / 2, (yb + yc - ya - yd) / 2);
    else return false;
    return true;
  }
  private trace({ closed, at }: Lines, from: number, end: number): void {
    this.to.moveTo(at[from], at[from + 1]);
    for (let i = from + 2; i < end; i += 2) this.to.lineTo(at[i], at[i + 1]);
    if (closed) this.to.closePath();
  }
  private styleOf(css: string): Style {
    const known = this.styles.get(css);
    if (known) return known;
    const path = svg("path", { class: css }),
      probe = svg("svg", { class: "plot wall", display: "none" }, path);
    this.place.appendChild(probe);
    const now = getComputedStyle(path);
    const style: Style = {
      fill: now.fill,
      stroke: now.stroke,
      width: parseFloat(now.strokeWidth) || 1,
      dash: (now.strokeDasharray.match(/[\d.]+/g) ?? []).map(Number),
      cap: now.strokeLinecap as CanvasLineCap,
      opacity: Number(now.opacity),
    };
    probe.remove();
    this.styles.set(css, style);
    return style;
  }
}
