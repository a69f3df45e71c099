// Force against displacement while the wall is pushed and after it.
import { svg } from "../dom";
import { thinned, ticks, type Point } from "../plot";
import { num, say } from "../texts";

const kPad = { left: 52, right: 16, top: 14, bottom: 36 };

export class Curve {
  readonly root = svg("svg", { class: "curve", role: "img", "aria-label": say("studio.curve") });
  points: Point[] = [];
  until = 20; // where the push ends [mm]
  cursor: number | null = null; // displacement of the state that is shown [mm]
  peak: Point | null = null;
  pick: (displacement: number) => void = () => undefined;
  private scale = { x0: 0, perMm: 1 };

  constructor() {
    const at = (e: PointerEvent): void => this.pick((e.clientX - this.root.getBoundingClientRect().left - this.scale.x0) / this.scale.perMm);
    this.root.addEventListener("pointerdown", (e) => {
      this.root.setPointerCapture(e.pointerId);
      at(e);
    });
    this.root.addEventListener("pointermove", (e) => {
      if (this.root.hasPointerCapture(e.pointerId)) at(e);
    });
    new ResizeObserver(() => this.draw()).observe(this.root);
  }

  draw(): void {
    const wide = this.root.clientWidth,
      high = this.root.clientHeight;
    if (wide < 80 || high < 60) return;
    const xs = this.points.map((p) => p[0]);
    const x1 = Math.max(this.until, ...(xs.length ? [xs[xs.length - 1]] : [])) || 1,
      x0 = Math.min(0, ...(xs.length ? [xs[0]] : []));
    let y1 = 1,
      y0 = 0;
    for (const [, y] of this.points) (y1 = Math.max(y1, y)), (y0 = Math.min(y0, y));
    y1 *= 1.08;
    const sx = (wide - kPad.left - kPad.right) / (x1 - x0),
      sy = (high - kPad.top - kPad.bottom) / (y1 - y0);
    this.scale = { x0: kPad.left - x0 * sx, perMm: sx };
    const px = (x: number): number => kPad.left + (x - x0) * sx,
      py = (y: number): number => high - kPad.bottom - (y - y0) * sy;
    const line = thinned(this.points.map(([x, y]) => [px(x), py(y)]), 0.3);
    this.root.replaceChildren(
      ...(this.points.length === 0 ? [] : ticks([y0, y1], high / 44)).flatMap((y) => [
        svg("line", { class: "grid", x1: px(x0), x2: wide - kPad.right, y1: py(y), y2: py(y) }),
        svg("text", { class: "tick", x: kPad.left - 8, y: py(y) + 4, "text-anchor": "end" }, num(y)),
      ]),
      ...ticks([x0, x1], wide / 80).flatMap((x) => [
        svg("line", { class: "grid", x1: px(x), x2: px(x), y1: kPad.top, y2: py(y0) }),
        svg("text", { class: "tick", x: px(x), y: high - kPad.bottom + 16, "text-anchor": "middle" }, num(x)),
      ]),
      svg("text", { class: "tick", x: wide - kPad.right, y: high - 4, "text-anchor": "end" }, say("studio.curve.x")),
      svg("text", { class: "tick", x: kPad.left + 6, y: kPad.top + 8 }, say("studio.curve.y")),
      svg("path", { class: "force", d: line.map(([x, y], k) => `${k ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("") }),
      ...(this.peak ? [svg("circle", { class: "peak", cx: px(this.peak[0]), cy: py(this.peak[1]), r: 5 })] : []),
      ...(this.cursor === null ? [] : [svg("line", { class: "cursor", x1: px(this.cursor), x2: px(this.cursor), y1: kPad.top, y2: py(y0) })]),
    );
  }
}
