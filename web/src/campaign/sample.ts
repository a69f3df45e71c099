// One sample of a campaign: its curve, its inputs, its wall where the push ended, how to run it alone.
import { h, type Child } from "../dom";
import { Figure } from "../figure";
import { Plot, rangeOf, type Point } from "../plot";
import { table } from "../tables";
import { num, phrase, qty, say, sentence } from "../texts";
import { Frames, readWall, type Wall } from "../wall";
import { WallView } from "../wallview";
import { atLeast, modeLabel, type Campaign, type Sample } from "./data";

export class SamplePanel {
  readonly element = h("div", { class: "sample-panel" });
  private readonly body = h("div");
  private readonly number = h("input", { type: "number", min: 1, step: 1, id: "sample-number" });
  private readonly wall: Wall | null;
  private readonly frames: Frames | null;
  private view: WallView | null = null;
  private readonly place = h("div");

  constructor(private readonly campaign: Campaign) {
    this.wall = readWall(campaign.bundle);
    this.frames = this.wall ? new Frames(campaign.bundle, this.wall) : null;
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
          h("p", { class: "note", role: "status" }, say("sample.none", { n: this.number.value })),
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
          y: [Math.min(0, ...y), 1.08 * Math.max(...y)],
          xLabel: say("axis.displacement"),
          yLabel: say("axis.reaction"),
          title: say("sample.n", { n: s.sample }),
          topAxis: drift > 0 ? { label: say("drift"), unit: "%", factor: drift } : undefined,
        });
        plot.line(
          x.map((d, i): Point => [d, y[i]]),
          `selected ${this.campaign.css(s.mode)}`,
        );
        if (s.answered) plot.dot(s.response[1]!, s.response[0]!, 4.5, "peak");
        if (s.answered && !s.censored[2]) plot.dot(s.response[2]!, 0.8 * s.response[0]!, 4.5, "peak");
        return plot.svg;
      },
      sheet: () => ({
        head: ["displacement_mm", "reaction_kN"],
        rows: Array.from(s.displacement).map((d, i) => [d, s.reaction[i]]),
      }),
    }).element;
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
  private wallOf(s: Sample): HTMLElement {
    const frames = this.campaign.header.frames as any[] | undefined;
    const at = frames?.findIndex((f) => f.sample === s.sample) ?? -1;
    if (!this.wall || !this.frames || at < 0)
      return h(
        "p",
        { class: "note" },
        say(frames && frames.length > 0 ? "sample.no_wall" : "sample.no_walls"),
      );
    this.view ??= new WallView({
      id: "sample-wall",
      wall: this.wall,
      frames: this.frames,
      player: false,
      tallest: 520,
      info: frames!.map((f) => ({
        label: say("sample.n", { n: f.sample }),
        displacement: f.displacement_mm,
        reaction: f.reaction_kN,
      })),
    });
    this.place.replaceChildren(this.view.element);
    this.view.show(at, true);
    return this.place;
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
