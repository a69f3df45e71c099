// One sample of a campaign: its curve, its inputs, its wall in every stored state, and the command to run it alone.
import { h, svg, type Child } from "../base/dom";
import { Figure } from "../base/figure";
import type { SampleFrame } from "../headers/campaign";
import { aroundPrint } from "../page";
import { Plot, rangeOf, type Point } from "../base/plot";
import { table } from "../base/tables";
import { num, phrase, qty, say, sentence } from "../base/texts";
import { viewOf } from "../wall/spaceview";
import { readWall, takeFields, type Wall } from "../wall/wall";
import type { View } from "../wall/wallview";
import { atLeast, modeLabel, reactionAt, type Campaign, type Sample } from "./data";

export class SamplePanel {
  readonly element = h("div", { class: "sample-panel" });
  private readonly body = h("div");
  private readonly number = h("input", { type: "number", min: 1, step: 1, id: "sample-number" });
  private readonly wall: Wall | null; // in its plane
  private view: View | null = null;
  private readonly place = h("div");
  private plot: Plot | null = null;
  private cursor: SVGGElement | null = null;

  constructor(private readonly campaign: Campaign) {
    this.wall = readWall(campaign.bundle);
    const step = (by: number): void => {
      const all = campaign.samples,
        at = campaign.selected ? all.indexOf(campaign.selected) : -1;
      campaign.select(all[(at + by + all.length) % all.length]);
    };
    this.number.addEventListener("change", () => {
      const found = campaign.samples.find((s) => s.sample === Number(this.number.value));
      if (found) campaign.select(found);
      else
        this.body.replaceChildren(
          h(
            "p",
            { class: "note", role: "status" },
            say(campaign.thinned ? "sample.not_shown" : "sample.none", { n: this.number.value }),
          ),
        );
    });
    this.element.append(
      h(
        "div",
        { class: "controls" },
        h(
          "button",
          { type: "button", class: "button", onclick: () => step(-1), "aria-label": say("sample.previous") },
          "←",
        ),
        h("label", { for: "sample-number" }, say("sample")),
        this.number,
        h(
          "button",
          { type: "button", class: "button", onclick: () => step(1), "aria-label": say("sample.next") },
          "→",
        ),
        h("span", { class: "soft" }, say("sample.of", { n: campaign.header.drawn })),
      ),
      this.body,
      this.printStates(),
    );
    campaign.onSample(() => this.fill());
  }

  private fill(): void {
    const s = this.campaign.selected;
    if (!s) return;
    this.element.classList.toggle("picked", this.campaign.picked);
    this.number.value = String(s.sample);
    this.body.replaceChildren(...this.content(s));
  }

  private content(s: Sample): HTMLElement[] {
    const head = h(
      "p",
      { class: "lead" },
      h("b", {}, say("sample.n", { n: s.sample })),
      ": ",
      s.answered
        ? h(
            "span",
            {},
            h("b", { class: `tag-text ${this.campaign.css(s.mode)}` }, modeLabel(s.mode)),
            s.sentence ? `, ${phrase(s.sentence)}. ` : ". ",
            h("span", { class: "soft" }, this.readAt(s)),
          )
        : h("span", {}, `${say("sample.unanswered")} ${phrase(s.status)}. ${sentence(s.reason)}`),
    );
    return [
      head,
      h("div", { class: "hero" }, h("div", {}, this.curve(s), this.answers(s)), this.wallOf(s)),
      this.inputs(s),
      this.replay(s),
    ];
  }

  private readAt(s: Sample): string {
    if (s.readAt === null) return "";
    const asked = this.campaign.statistics.read_modes_at_mm ?? 0;
    return s.readEarly
      ? say("sample.read_early", { at: qty(s.readAt, "mm"), asked: qty(asked, "mm") })
      : say("sample.read_at", { at: qty(s.readAt, "mm") });
  }
  private curve(s: Sample): HTMLElement | null {
    if (s.displacement.length < 2) return null;
    return new Figure({
      id: "sample-curve",
      title: say("curve.force.title"),
      draw: (width) => {
        const x = Array.from(s.displacement),
          y = Array.from(s.reaction),
          drift = this.campaign.driftPerMillimetre;
        const plot = new Plot({
          width,
          height: Math.max(250, Math.min(340, 0.6 * width)),
          x: rangeOf([0, ...x]),
          y: [Math.min(0, ...y), 1.08 * Math.max(1e-3, ...y)],
          xLabel: say("axis.displacement"),
          yLabel: say("axis.reaction"),
          title: say("sample.n", { n: s.sample }),
          topAxis: drift > 0 ? { label: say("drift"), unit: "%", factor: drift } : undefined,
        });
        plot.line(
          x.map((d, i): Point => [d, y[i]]),
          `selected ${this.campaign.css(s.mode)}`,
        );
        const [peak, atPeak, at80] = s.response;
        if (s.answered && peak != null && atPeak != null) plot.dot(atPeak, peak, 4.5, "peak");
        if (s.answered && peak != null && at80 != null && !s.censored[2])
          plot.dot(at80, 0.8 * peak, 4.5, "peak");
        this.cursor = svg("g", { class: "cursor" });
        plot.over.appendChild(this.cursor);
        this.plot = plot;
        this.moveCursor(s);
        return plot.svg;
      },
      sheet: () => ({
        head: ["displacement_mm", "reaction_kN"],
        rows: Array.from(s.displacement).map((d, i) => [d, s.reaction[i]]),
      }),
    }).element;
  }
  // Marks the displacement of the shown wall on the curve.
  private moveCursor(s: Sample): void {
    if (!this.plot || !this.cursor) return;
    const frame = this.framesOf(s).find((f) => f.at === this.view?.look.frame);
    if (!frame) return this.cursor.replaceChildren();
    const { plot } = this,
      x = plot.X(frame.displacement_mm),
      force = reactionAt(s, frame.displacement_mm);
    this.cursor.replaceChildren(
      svg("line", { class: "cursor-line", x1: x, x2: x, y1: plot.top, y2: plot.bottom }),
      ...(Number.isFinite(force) ? [svg("circle", { class: "cursor-dot", cx: x, cy: plot.Y(force), r: 5 })] : []),
    );
  }
  private answers(s: Sample): Child {
    if (!s.answered) return null;
    return table(
      [{ head: "", left: true }, { head: "" }],
      this.campaign.quantities.map((q, i) => [
        h("span", { title: say(`quantity.${q.name}.means`) }, say(`quantity.${q.name}`)),
        atLeast(s.censored[i]) + qty(s.response[i], q.unit),
      ]),
      "",
      "facts",
    );
  }
  // The stored states of a sample in the page, with their indices among all frames.
  private framesOf(s: Sample): (SampleFrame & { at: number })[] {
    const all = this.campaign.header.frames ?? [];
    return all.map((f, at) => ({ ...f, at })).filter((f) => f.sample === s.sample);
  }
  private wallOf(s: Sample): HTMLElement {
    const all = this.campaign.header.frames ?? [],
      frames = this.framesOf(s);
    if (this.wall) takeFields(this.wall, s.sample);
    if (frames.length > 0) this.view ??= this.viewOfAll(all);
    if (!this.view || frames.length === 0)
      return h("p", { class: "note" }, say(all.length > 0 ? "sample.no_wall" : "sample.no_walls"));
    const last = frames[frames.length - 1];
    this.view.choose(frames[0].at, last.at);
    const left = (last.stored ?? frames.length) - frames.length;
    this.place.replaceChildren(
      this.view.element,
      left > 0 ? h("p", { class: "note small" }, say("sample.states_left", { n: left })) : "",
    );
    this.view.show(last.at);
    return this.place;
  }
  // Its wall with its damage, in the state nearest to the displacement of its failure mode; null if the page has no state.
  pictureOf(s: Sample, width: number, tallest: number): HTMLElement | null {
    const frames = this.framesOf(s);
    if (frames.length > 0) this.view ??= this.viewOfAll(this.campaign.header.frames ?? []);
    if (!this.view || frames.length === 0) return null;
    const off = frames.map((f) => Math.abs(f.displacement_mm - (s.readAt ?? Infinity)));
    const at = s.readAt === null ? frames[frames.length - 1].at : frames[off.indexOf(Math.min(...off))].at;
    return this.view.picture(at, width, tallest);
  }
  private viewOfAll(all: SampleFrame[]): View | null {
    const info = all.map((f) => ({
      // "20 mm" would repeat the displacement
      label: [say("sample.n", { n: f.sample }), f.asked_mm != null ? "" : phrase(f.label ?? "")]
        .filter((w) => w !== "")
        .join(", "),
      displacement: f.displacement_mm,
      reaction: f.reaction_kN,
    }));
    const onFrame = (): void => void (this.campaign.selected && this.moveCursor(this.campaign.selected));
    return viewOf(this.campaign.bundle, { id: "sample-wall", tallest: 520, info, onFrame }, this.wall);
  }
  // The wall in every stored state, only for paper.
  private printStates(): HTMLElement {
    const place = h("div", { class: "print-only pictures" });
    aroundPrint(
      () => {
        const { selected, picked } = this.campaign,
          { view } = this;
        if (!selected || !picked || !view) return;
        place.replaceChildren(...this.framesOf(selected).map((f) => view.picture(f.at, 400, 250)));
      },
      () => place.replaceChildren(),
    );
    return place;
  }
  private inputs(s: Sample): HTMLElement {
    return h(
      "details",
      { open: true },
      h("summary", {}, say("sample.inputs")),
      h(
        "div",
        { class: "input-grid" },
        this.campaign.inputs.map((i) => {
          const value = i.values[s.sample - 1];
          const below =
            Array.from(i.values as Float32Array).filter((v) => v < value).length /
            Math.max(1, i.values.length);
          return h(
            "div",
            { class: i.random ? "input-item random" : "input-item" },
            h("span", { class: "input-name", title: i.path || i.formula }, i.name),
            h("b", {}, qty(value, i.unit, 4)),
            i.random
              ? h(
                  "span",
                  { class: "meter", title: say("sample.percentile", { p: num(100 * below, 2) }) },
                  h("span", { style: `inline-size:${(100 * below).toFixed(0)}%` }),
                )
              : null,
          );
        }),
      ),
    );
  }
  private replay(s: Sample): HTMLElement {
    const command = `wythe replay DIR --sample ${s.sample} --out sample_${s.sample}`;
    const copy = h("button", { type: "button", class: "button" }, say("copy"));
    copy.addEventListener(
      "click",
      () =>
        void navigator.clipboard?.writeText(command).then(() => {
          copy.textContent = say("copied");
        }),
    );
    return h(
      "div",
      {},
      h("p", { class: "soft small" }, say("sample.replay")),
      h("div", { class: "command" }, h("code", { class: "replay" }, command), copy),
    );
  }
}
