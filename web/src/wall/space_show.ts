// The display of a state of a wall in space: a style for each joint, a tint for
// each body, and their legend. Colours are those of the page's style, by class.
import { h } from "../base/dom";
import { legend, swatch } from "../base/figure";
import { crackOfFace, groupOf, kLinkStates, type SolidState, type SolidStates } from "./space";
import type { LinkMark, Marks, Rgb } from "./space_paint";
import { num, phrase, say } from "../base/texts";
import { kSteps, roundSteps, stepOf } from "./wall";

export const kFaces = ["cracks", "opening", "slip", "damage", "crushing", "stress"] as const;
export type OfFaces = (typeof kFaces)[number];
export const kBodies = ["stone", "moved", "turned", "damage", "material", "group"] as const;
export type OfBodies = (typeof kBodies)[number];
const kStones = ["stone0", "stone1", "stone2", "stone3"];
const kGroups = 7; // that have their own colour
const kLinkColours = { holds: "curve", slack: "soft", yielded: "open" }; // of the page's style
const kWider = [0.2, 1, 3, 10]; // openings and slips above which a crack is drawn thicker [mm]

// Colours and widths of the page's style, by class.
export class Styles {
  private readonly known = new Map<string, { fill: Rgb; stroke: Rgb; width: number }>();
  private readonly colours = new Map<string, Rgb>();
  private readonly dot = h("canvas", { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true })!;
  of(css: string): { fill: Rgb; stroke: Rgb; width: number } {
    let style = this.known.get(css);
    if (!style) {
      const probe = swatch(css, "line");
      probe.style.position = "absolute";
      document.body.appendChild(probe);
      const now = getComputedStyle(probe.firstElementChild!);
      style = { fill: this.rgb(now.fill), stroke: this.rgb(now.stroke), width: parseFloat(now.strokeWidth) || 1 };
      probe.remove();
      this.known.set(css, style);
    }
    return style;
  }
  variable(name: string): Rgb {
    let colour = this.colours.get(name);
    if (!colour) {
      colour = this.rgb(getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
      this.colours.set(name, colour);
    }
    return colour;
  }
  // Converts any colour notation of a browser by painting it.
  private rgb(colour: string): Rgb {
    if (colour === "none" || colour === "") return [128, 128, 128];
    this.dot.fillStyle = colour;
    this.dot.fillRect(0, 0, 1, 1);
    const [r, g, b] = this.dot.getImageData(0, 0, 1, 1).data;
    return [r, g, b];
  }
}

export class Shown {
  faces: OfFaces = "cracks";
  bodies: OfBodies = "stone";
  private readonly steps: { moved: number[]; turned: number[]; stress: number[] };
  private readonly groups: { names: string[]; of: Int32Array };
  private readonly materials: { names: string[]; of: Int32Array };

  constructor(private readonly states: SolidStates) {
    const { solids } = states;
    this.steps = this.stepsOfAll();
    this.materials = classes(Array.from(solids.material, (m) => solids.materials[m]));
    this.groups = classes(solids.names.map(groupOf));
  }

  // The possible styles of joints, and the style of joint j in a state; -1: none.
  private marker(state: SolidState): { looks: string[]; of: (j: number) => number } {
    const steps = (css: string): string[] => [1, 2, 3, 4, 5, 6].map((step) => `${css} r${step}`);
    if (this.faces === "cracks") {
      const wide = (css: string): string[] => [0, 1, 2, 3, 4].map((w) => `crack ${css} w${w}`);
      const looks = ["crack crush w2", "crack softening w0", "crack closed w0", ...wide("open"), ...wide("slip")];
      const place: Record<string, number> = { sound: -1, softening: 1, closed: 2 };
      return {
        looks,
        of: (j) => {
          if (state.crushing[j] / 255 >= 0.05) return 0;
          const crack = crackOfFace(state, j);
          if (crack !== "open" && crack !== "slip") return place[crack];
          const moved = Math.max(state.opening[j], Math.abs(state.slip[j])) * 1e3;
          return (crack === "open" ? 3 : 8) + stepOf(moved, kWider);
        },
      };
    }
    if (this.faces === "stress")
      return {
        looks: [...steps("joint stress t"), ...steps("joint stress c")],
        of: (j) => {
          const step = stepOf(1e-6 * Math.abs(state.stress[j]), this.steps.stress);
          return step === 0 ? -1 : step - 1 + (state.stress[j] > 0 ? 0 : 6);
        },
      };
    const measure = this.faces,
      unit = measure === "opening" || measure === "slip" ? 1e3 : 1 / 255,
      values = state[measure];
    return {
      looks: steps(`joint ${measure}`),
      of: (j) => stepOf(Math.abs(values[j]) * unit, kSteps[measure]) - 1,
    };
  }
  marks(state: SolidState, styles: Styles): Marks {
    const n = this.states.solids.joints,
      joints = new Int32Array(n),
      look = new Uint8Array(4 * n);
    const { looks, of } = this.marker(state),
      styled = looks.map((css) => styles.of(css));
    let count = 0;
    for (let j = 0; j < n; ++j) {
      const which = of(j);
      if (which < 0) continue;
      const { stroke, width } = styled[which];
      for (let k = 0; k < 3; ++k) look[4 * count + k] = stroke[k];
      look[4 * count + 3] = Math.min(255, (255 * width) / 16);
      joints[count++] = j;
    }
    return { count, joints, look };
  }
  // For each link the style as in the plane; yielded ones have the colour of open cracks.
  links(state: SolidState, styles: Styles): LinkMark[] {
    return this.states.solids.links.map((link, k) => {
      const how = kLinkStates[state.linkState[k]],
        width = link.kind === "diaphragm" ? 4 : 2.5;
      return { colour: styles.variable(kLinkColours[how]), width: how === "yielded" ? width + 1.5 : width, dash: how === "slack" ? [5, 4] : [] };
    });
  }
  tints(state: SolidState, styles: Styles, picked: number): Uint8Array {
    const { solids } = this.states;
    const classOf = this.tintOf(state);
    const tints = new Uint8Array(4 * solids.count);
    const lit = styles.variable("focus"),
      ground = styles.variable("ground");
    for (let b = 0; b < solids.count; ++b) {
      const tint = b === picked ? lit : b >= solids.free ? ground : styles.of(classOf(b)).fill;
      for (let k = 0; k < 3; ++k) tints[4 * b + k] = tint[k];
    }
    return tints;
  }
  private tintOf(state: SolidState): (b: number) => string {
    const ramp = (kind: string, value: (b: number) => number, steps: number[]): ((b: number) => string) => {
      const css = ["stone1", ...[1, 2, 3, 4, 5, 6].map((step) => `block-field ${kind} r${step}`)];
      return (b) => css[stepOf(value(b), steps)];
    };
    const long = (v: ArrayLike<number>, b: number): number => Math.hypot(v[3 * b], v[3 * b + 1], v[3 * b + 2]);
    switch (this.bodies) {
      case "moved":
        return ramp("moved", (b) => 1e3 * long(state.moved, b), this.steps.moved);
      case "turned":
        return ramp("turned", (b) => (180 / Math.PI) * long(state.turned, b), this.steps.turned);
      case "damage": {
        const worst = this.worstOf(state);
        return ramp("damaged", (b) => worst[b], kSteps.damage);
      }
      case "material":
        return (b) => groupCss(this.materials.of[b]);
      case "group":
        return (b) => groupCss(this.groups.of[b]);
      default:
        return (b) => kStones[((Math.imul(b, 2654435761) >>> 13) + b) % 4];
    }
  }
  // For each body the largest damage of its joints.
  private worstOf(state: SolidState): Float32Array {
    const { solids } = this.states,
      worst = new Float32Array(solids.count);
    for (let j = 0; j < solids.joints; ++j)
      for (const b of [solids.jointA[j], solids.jointB[j]]) worst[b] = Math.max(worst[b], state.damage[j] / 255);
    return worst;
  }
  private stepsOfAll(): { moved: number[]; turned: number[]; stress: number[] } {
    const { states } = this,
      most = { moved: 0, turned: 0, stress: 0 };
    for (let f = 0; f < states.count; ++f) {
      const { moved, turned, stress } = states.at(f);
      for (let i = 0; i < 3 * states.solids.free; i += 3) {
        most.moved = Math.max(most.moved, Math.hypot(moved[i], moved[i + 1], moved[i + 2]));
        most.turned = Math.max(most.turned, Math.hypot(turned[i], turned[i + 1], turned[i + 2]));
      }
      for (const s of stress) most.stress = Math.max(most.stress, Math.abs(s));
    }
    return {
      moved: roundSteps(1e3 * most.moved),
      turned: roundSteps((180 / Math.PI) * most.turned),
      stress: roundSteps(1e-6 * most.stress),
    };
  }

  legend(): HTMLElement {
    const range = (bounds: number[], unit: string, mark: (i: number) => SVGSVGElement): HTMLElement =>
      legend(
        bounds.map((from, i): [SVGSVGElement, string] => [
          mark(i + 1),
          i + 1 < bounds.length ? `${num(from)}–${num(bounds[i + 1])}${unit}` : `> ${num(from, 4)}${unit}`,
        ]),
      );
    const faces = (): HTMLElement => {
      if (this.faces === "cracks")
        return legend([
          [swatch("crack open w2"), say("crack.open")],
          [swatch("crack slip w2"), say("crack.slip")],
          [swatch("crack closed w0"), say("crack.closed")],
          [swatch("crack softening w0"), say("crack.softening")],
          [swatch("crack crush w2"), say("crack.crushed.space")],
        ]);
      if (this.faces === "stress")
        return h(
          "div",
          { class: "stress-keys" },
          ...(["c", "t"] as const).map((sign) =>
            h(
              "div",
              { class: "stress-key" },
              h("b", {}, say(sign === "c" ? "stress.compression" : "stress.tension")),
              range(this.steps.stress, "\u202fMPa", (i) => swatch(`joint stress ${sign} r${i}`)),
            ),
          ),
        );
      const measure = this.faces,
        unit = measure === "opening" || measure === "slip" ? "\u202fmm" : "";
      return range(kSteps[measure], unit, (i) => swatch(`joint ${measure} r${i}`));
    };
    const bodies = (): HTMLElement | null => {
      const box = (kind: string) => (i: number) => swatch(`block-field ${kind} r${i}`, "box");
      switch (this.bodies) {
        case "moved":
          return range(this.steps.moved, "\u202fmm", box("moved"));
        case "turned":
          return range(this.steps.turned, "\u202f°", box("turned"));
        case "damage":
          return range(kSteps.damage, "", box("damaged"));
        case "material":
          return groupLegend(this.materials.names);
        case "group":
          return groupLegend(this.groups.names);
        default:
          return null;
      }
    };
    const row = (name: string, what: HTMLElement | null): HTMLElement | null =>
      what && h("div", { class: "key-row" }, h("b", {}, name), what);
    const links = (): HTMLElement | null =>
      this.states.solids.links.length === 0
        ? null
        : legend(kLinkStates.map((how): [SVGSVGElement, string] => [swatch(`link-mark ${how}`), say(`link.${how}`)]));
    return h("div", {}, row(say("space.faces"), faces()), row(say("space.bodies"), bodies()), row(say("space.links"), links()));
  }
}

// Names, the most frequent first; names beyond the last colour share it.
function classes(names: string[]): { names: string[]; of: Int32Array } {
  const counts = new Map<string, number>();
  for (const name of names) counts.set(name, (counts.get(name) ?? 0) + 1);
  const sorted = [...counts.keys()].sort((a, b) => counts.get(b)! - counts.get(a)!);
  const place = new Map(sorted.map((name, i) => [name, i]));
  return { names: sorted, of: Int32Array.from(names, (name) => place.get(name)!) };
}
const groupCss = (group: number): string => `block-group g${group < kGroups ? group + 1 : 0}`;
function groupLegend(names: string[]): HTMLElement {
  const items = names
    .slice(0, kGroups)
    .map((name, i): [SVGSVGElement, string] => [swatch(groupCss(i), "box"), phrase(name) || say("space.unnamed")]);
  if (names.length > kGroups) items.push([swatch(groupCss(kGroups), "box"), say("space.others", { n: names.length - kGroups })]);
  return legend(items);
}
