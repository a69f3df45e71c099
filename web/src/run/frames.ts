// The forces of frames in a run: N, V, M and use drawn on the wall, in every state, and in a table. Paper has
// the three diagrams side by side. In a wall in space each frame is drawn in its own plane.
import type { Bundle } from "../base/bundle";
import { append, fresh, h, svg, type Child } from "../base/dom";
import { Figure, legend, swatch } from "../base/figure";
import type { RunHeader } from "../headers/run";
import { alongMembers, drawMembers, kUnitOf, kUseSteps, largestCarried, outlineOf, isFrameBlock } from "../wall/members";
import { aroundPrint } from "../page";
import { Player } from "../base/player";
import { hasCarried, SliceStates } from "../wall/space_slice";
import { SpaceView } from "../wall/spaceview";
import { table } from "../base/tables";
import { capital, fixed, num, phrase, qty, say, sentence } from "../base/texts";
import { BlockPose, bodyCss, fittingScale, isCutOut, kCarried, type Blocks, type Carried, type FramedStates } from "../wall/wall";
import type { Canvas } from "../wall/wall2d";
import { scaleWords, WallView, type FrameInfo, type View } from "../wall/wallview";

const kTallest = 460, // of a drawing [px]
  kReach = 56, // of the largest ordinate [px]
  kBeside = 52, // space beyond it for a number
  kBelow = 26, // space for the symbols of the feet
  kOnPaper: Carried[] = ["moment", "shear", "normal"];

const quantity = (value: number, what: Carried): string =>
  what === "use" ? fixed(value) : qty(value, kUnitOf[what][0], 3);

export class FramesView {
  private readonly names: string[];
  private readonly info: FrameInfo[];
  private frames!: FramedStates; // of the frame that is shown
  private scale = 1;
  private readonly player = new Player((frame) => this.show(frame));
  private readonly state = h("output", { class: "wall-caption" });
  private readonly numbers = h("div", { id: "frame-numbers" });
  private readonly key = h("div", {});
  private readonly words = h("span", {});
  private readonly figure: Figure;
  private what: Carried = "moment";
  private only = "";
  private frame: number;

  // null: no frame, or no state of one.
  static of(bundle: Bundle<RunHeader>, view: View | null): Child {
    if (!hasCarried(bundle)) return null;
    if (view instanceof WallView) return new FramesView(bundle, view, () => view.spec.frames).content();
    if (view instanceof SpaceView)
      return new FramesView(bundle, view, (name) => new SliceStates(bundle, view.spec.states, name)).content();
    return null;
  }

  private constructor(
    private readonly bundle: Bundle<RunHeader>,
    view: View,
    private readonly statesOf: (name: string) => FramedStates,
  ) {
    this.info = view.spec.info;
    this.names = [...new Set(bundle.header.wall!.members!.map((m) => m.frame))];
    this.choose(this.names[0]);
    this.figure = this.makeFigure();
    this.player.choose(0, this.frames.count - 1);
    this.frame = this.hardest();
    this.show(this.frame);
    aroundPrint(
      () => this.tell(true),
      () => this.tell(),
    );
  }
  private get wall(): Blocks {
    return this.frames.wall;
  }
  private choose(name: string): void {
    this.only = name;
    this.frames = this.statesOf(name);
    this.scale = fittingScale(this.wall, this.frames);
  }
  // The state with the largest use in the chosen frame.
  private hardest(): number {
    const mine = this.mine().map((k) => k.index);
    let best = 0,
      most = -1;
    for (let f = 0; f < this.frames.count; ++f) {
      const use = this.frames.carried("use", f),
        here = Math.max(...mine.map((k) => use[k]));
      if (here >= most) [best, most] = [f, here];
    }
    return best;
  }
  // Sections of the chosen frame, along its members.
  private mine(): { index: number; member: number; place: number }[] {
    return alongMembers(this.wall, this.only)
      .flat()
      .map((s) => ({ index: this.wall.sections.indexOf(s), member: s.member, place: s.place }));
  }

  private content(): Child {
    const said = this.bundle.header.frames_said ?? [];
    return [
      said.map((s) => h("p", {}, sentence(s.words))),
      h("div", { class: "pair" }, this.figure.element, this.numbers),
    ];
  }

  // --- controls ------------------------------------------------------------------------------------------

  private makeFigure(): Figure {
    const buttons = kCarried.map((what) => {
      const button = h(
        "button",
        { type: "button", class: "segment", "aria-pressed": String(what === this.what), "data-carried": what },
        say(`frames.${what}.short`),
      );
      button.title = say(`frames.${what}`);
      button.setAttribute("aria-label", say(`frames.${what}`));
      button.addEventListener("click", () => {
        this.what = what;
        for (const b of buttons) b.setAttribute("aria-pressed", String(b === button));
        this.show(this.frame);
      });
      return button;
    });
    return new Figure({
      id: "frame-forces",
      title: say("frames.title"),
      wide: true, // on paper
      above: [
        h(
          "div",
          { class: "controls" },
          h("div", { class: "segments", role: "group", "aria-label": say("frames.what") }, buttons),
          this.chooser(),
        ),
        this.key,
        this.player.element,
        this.state,
      ],
      draw: (width, onPaper) => (onPaper ? this.drawAll(width) : this.drawOne(width)),
      caption: this.words,
      sheet: () => this.sheet(),
    });
  }
  // The choice of a frame, if there are several.
  private chooser(): Child {
    if (this.names.length < 2) return null;
    const which = h(
      "select",
      { "aria-label": say("frames.which") },
      this.names.map((name) => h("option", { value: name }, name)),
    );
    which.addEventListener("change", () => {
      this.choose(which.value);
      this.show(this.frame);
    });
    return h("label", {}, h("span", {}, say("frames.which")), which);
  }
  private show(frame: number): void {
    this.frame = this.player.put(frame);
    this.figure.redraw();
    this.tell();
  }
  private tell(onPaper = false): void {
    const words = this.stateWords();
    this.player.tell(`${words}: ${this.extremeWords(this.what)}`);
    this.state.textContent = [words, scaleWords(this.scale)].join(" · ");
    const signs = onPaper || this.what === "normal";
    this.key.replaceChildren(...(signs ? [signLegend()] : this.what === "use" ? [useLegend()] : []));
    const shown = onPaper ? kOnPaper : [this.what],
      onSections = shown.includes("use") ? [] : [say("frames.caption")];
    this.words.textContent = [...shown.map((what) => say(`frames.caption.${what}`)), ...onSections].join(" ");
    this.numbers.replaceChildren(this.extremes());
  }
  private stateWords(): string {
    const { label, displacement, reaction } = this.info[this.frame];
    return [label, qty(displacement, "mm"), qty(reaction, "kN")].filter((w) => w !== "").join(" · ");
  }

  // --- drawing ---------------------------------------------------------------------------------------------

  // The frame fills the drawing, with space for ordinates and labels around it.
  private canvasOf(width: number, tallest: number, reach: number): Canvas {
    const box = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
    const members = alongMembers(this.wall, this.only);
    const blocks = new Set(members.flatMap((m) => m.flatMap((s) => [s.a, s.b])));
    for (const b of blocks)
      for (let i = this.wall.outlineBegin[b]; b >= 0 && i < this.wall.outlineBegin[b + 1]; ++i) {
        box.x0 = Math.min(box.x0, this.wall.outlineX[i]);
        box.x1 = Math.max(box.x1, this.wall.outlineX[i]);
        box.y0 = Math.min(box.y0, this.wall.outlineY[i]);
        box.y1 = Math.max(box.y1, this.wall.outlineY[i]);
      }
    const wide = Math.max(box.x1 - box.x0, 0.1),
      high = Math.max(box.y1 - box.y0, 0.1);
    const stands = members.flat().some((s) => s.a < 0);
    const aside = Math.min(reach + kBeside, 0.25 * width),
      above = reach + 20,
      below = stands ? kBelow : above;
    const k = Math.min((width - 2 * aside) / wide, (tallest - above - below) / high);
    const height = Math.round(high * k + above + below),
      left = (width - wide * k) / 2;
    return { width, height, k, X: (x) => left + (x - box.x0) * k, Y: (y) => height - below - (y - box.y0) * k };
  }
  private draw(what: Carried, width: number, tallest: number): { canvas: Canvas; layer: SVGElement } {
    const reach = Math.min(kReach, 0.12 * width),
      canvas = this.canvasOf(width, tallest, reach),
      pose = new BlockPose(this.wall, this.frames.at(this.frame), this.scale);
    const clip = fresh("clip"),
      walls = svg("g", { class: "behind", "clip-path": `url(#${clip})` });
    for (let b = 0; b < this.wall.blocks; ++b)
      if (!isFrameBlock(this.wall, b) && !isCutOut(this.wall, b))
        walls.appendChild(
          svg("path", { class: bodyCss(this.wall.role[b]) || "stone stone2", d: outlineOf(pose, b, canvas) }),
        );
    return {
      canvas,
      layer: svg(
        "g",
        {},
        svg("defs", {}, svg("clipPath", { id: clip }, svg("rect", { width: canvas.width, height: canvas.height }))),
        walls,
        drawMembers(
          this.wall,
          this.frames,
          { name: this.only, state: this.frame, what, largest: largestCarried(this.frames, this.only, what) },
          pose,
          canvas,
          reach,
        ),
      ),
    };
  }
  private drawOne(width: number): SVGSVGElement {
    const { canvas, layer } = this.draw(this.what, width, kTallest);
    return this.picture(canvas.width, canvas.height, [this.what], [layer]);
  }
  private drawAll(width: number): SVGSVGElement {
    const each = width / kOnPaper.length;
    let tallest = 0;
    const layers = kOnPaper.map((what, i) => {
      const { canvas, layer } = this.draw(what, each - 8, each);
      tallest = Math.max(tallest, canvas.height);
      layer.setAttribute("transform", `translate(${i * each + 4} 18)`);
      return svg(
        "g",
        {},
        svg("text", { class: "strong", x: (i + 0.5) * each, y: 12, "text-anchor": "middle" }, say(`frames.${what}`)),
        layer,
      );
    });
    return this.picture(width, tallest + 18, kOnPaper, layers);
  }
  private picture(width: number, height: number, what: Carried[], layers: SVGElement[]): SVGSVGElement {
    const words = what.map((w) => this.extremeWords(w)).join("; ");
    const picture = svg("svg", {
      class: "plot frame-forces",
      viewBox: `0 0 ${width} ${height}`,
      width,
      height,
      role: "img",
      "aria-label": `${say("frames.title")}, ${this.stateWords()}: ${words}`,
    });
    append(picture, layers);
    return picture;
  }

  // --- numbers -----------------------------------------------------------------------------------------------

  // "moment M −12.3 kNm, left column, foot"
  private extremeWords(what: Carried): string {
    const at = this.extreme(what, this.mine());
    return `${say(`frames.${what}`)} ${quantity(at.value, what)}, ${phrase(this.wall.members[at.member].words)}, ${this.placeWords(at)}`;
  }
  // An end, or the distance from the foot of a column or from the left end of a beam.
  private placeWords({ member, place }: { member: number; place: number }): string {
    const { way, length } = this.wall.members[member],
      upright = Math.abs(way[1]) > Math.abs(way[0]);
    const from = (upright ? way[1] : way[0]) > 0 ? place : length - place,
      ends = upright ? ["foot", "head"] : ["left", "right"];
    if (from < 1e-6 * length) return say(`element.${ends[0]}`);
    if (from > (1 - 1e-6) * length) return say(`element.${ends[1]}`);
    return qty(from, "m");
  }
  // The largest absolute value of some sections, with its sign.
  private extreme(
    what: Carried,
    of: { index: number; member: number; place: number }[],
  ): { value: number; member: number; place: number } {
    const values = this.frames.carried(what, this.frame);
    const at = of.reduce((a, b) => (Math.abs(values[b.index]) > Math.abs(values[a.index]) ? b : a));
    return { ...at, value: values[at.index] / kUnitOf[what][1] };
  }
  private extremes(): HTMLElement {
    const members = alongMembers(this.wall, this.only).map((m) => m[0].member);
    const list = table(
      [
        { head: say("frames.member"), left: true },
        ...kCarried.map((what) => ({ head: `${say(`frames.${what}.short`)}${kUnitOf[what][0] ? ` [${kUnitOf[what][0]}]` : ""}` })),
      ],
      members.map((m) => [
        capital(phrase(this.wall.members[m].words)),
        ...kCarried.map((what) => {
          const at = this.extreme(
            what,
            this.mine().filter((s) => s.member === m),
          );
          return h(
            "span",
            {},
            what === "use" ? fixed(at.value) : num(at.value),
            h("span", { class: "pm" }, this.placeWords(at)),
          );
        }),
      ]),
      say("frames.table", { frame: this.only, at: this.stateWords() }),
    );
    return h("div", {}, list, h("p", { class: "soft small" }, say("frames.places")));
  }
  // The columns of frames.csv, for the states in the page.
  private sheet(): { head: string[]; rows: (string | number)[][] } {
    const order = ["normal", "shear", "moment", "use"] as const;
    return {
      head: ["displacement_mm", "frame", "member", "place_m", "N_kN", "V_kN", "M_kNm", "use"],
      rows: this.info.flatMap(({ displacement }, f) => {
        const columns = order.map((what) => this.frames.carried(what, f));
        return this.wall.sections.map((s, k) => {
          const member = this.wall.members[s.member];
          return [
            displacement,
            member.frame,
            phrase(member.words),
            s.place,
            ...order.map((what, c) => columns[c][k] / kUnitOf[what][1]),
          ];
        });
      }),
    };
  }
}

const useLegend = (): HTMLElement =>
  legend([
    [swatch("member-use r0", "box"), `< ${num(kUseSteps[0])}`],
    ...kUseSteps.map((from, i): [SVGSVGElement, string] => [
      swatch(`member-use r${i + 1}`, "box"),
      i + 1 < kUseSteps.length ? `${num(from)}–${num(kUseSteps[i + 1])}` : `≥ ${num(from)}`,
    ]),
  ]);
const signLegend = (): HTMLElement =>
  legend([
    [swatch("ordinate normal plus", "box"), say("frames.pulled")],
    [swatch("ordinate normal minus", "box"), say("frames.pressed")],
  ]);
