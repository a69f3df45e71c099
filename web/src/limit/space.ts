// The collapse mechanism of a limit analysis of a wall in space, in the same
// view as a run: velocities times small times, as states that can be animated.
import type { Bundle, Numbers } from "../base/bundle";
import { h } from "../base/dom";
import type { LimitHeader, LimitLoad } from "../headers/limit";
import { SolidStates, dot, readSolids, sizeOf, type Solids, type Vec } from "../wall/space";
import { SpaceView } from "../wall/spaceview";
import { phrase, say } from "../base/texts";

const kStates = 13;
const kFarthest = 0.08; // displacement of the fastest block, over the wall's size

interface Motion {
  moved: Float32Array; // velocities of bodies, three each
  turned: Float32Array; // their spins [1/m]
}

// Motion of blocks in the page's order: blocks of the model, then its supports, which do not move.
function motionOf(limit: LimitLoad, s: Solids): Motion {
  const moved = new Float32Array(3 * s.count),
    turned = new Float32Array(3 * s.count);
  limit.velocity_x.forEach((v, b) => {
    moved.set([v, limit.velocity_y[b], limit.velocity_z![b]], 3 * b);
    turned.set([limit.spin_x_per_m![b], limit.spin_y_per_m![b], limit.spin_per_m[b]], 3 * b);
  });
  return { moved, turned };
}
const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const of = (v: Numbers, b: number): Vec => [v[3 * b], v[3 * b + 1], v[3 * b + 2]];

// For each joint the largest opening and slip of its corners, per unit velocity of the load.
function jumps(s: Solids, m: Motion): { opening: Float32Array; slip: Float32Array } {
  const opening = new Float32Array(s.joints),
    slip = new Float32Array(s.joints);
  for (let j = 0; j < s.joints; ++j) {
    const from = s.outlineBegin[j],
      corner = (i: number): Vec => of(s.outline, i);
    const minus = (p: Vec, q: Vec): Vec => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    const sum = cross(minus(corner(from + 1), corner(from)), minus(corner(from + 2), corner(from))),
      size = Math.hypot(...sum) || 1,
      n: Vec = [sum[0] / size, sum[1] / size, sum[2] / size];
    const velocity = (b: number, p: Vec): Vec => {
      const turn = cross(of(m.turned, b), minus(p, of(s.centroid, b))),
        v = of(m.moved, b);
      return [v[0] + turn[0], v[1] + turn[1], v[2] + turn[2]];
    };
    for (let i = from; i < s.outlineBegin[j + 1]; ++i) {
      const jump = minus(velocity(s.jointB[j], corner(i)), velocity(s.jointA[j], corner(i))),
        open = dot(jump, n);
      opening[j] = Math.max(opening[j], Math.abs(open));
      slip[j] = Math.max(slip[j], Math.hypot(...minus(jump, [open * n[0], open * n[1], open * n[2]])));
    }
  }
  return { opening, slip };
}

// States of all limit loads in sequence, in the same arrays as states of a run.
function statesOf(bundle: Bundle, s: Solids, limits: LimitLoad[]): Bundle {
  const frames = limits.length * kStates,
    arrays: Record<string, Numbers> = {};
  for (const name of ["moved", "turned"]) arrays[name] = new Float32Array(3 * s.count * frames);
  for (const name of ["opening", "slip", "stress", "damage", "crushing"]) arrays[name] = new Float32Array(s.joints * frames);
  for (const name of ["link_force", "link_state"]) arrays[name] = new Float32Array(s.links.length * frames);
  limits.forEach((limit, l) => {
    const motion = motionOf(limit, s),
      jump = jumps(s, motion);
    let fastest = 0;
    for (let i = 0; i < motion.moved.length; i += 3) fastest = Math.max(fastest, Math.hypot(motion.moved[i], motion.moved[i + 1], motion.moved[i + 2]));
    const far = (kFarthest * sizeOf(s)) / (fastest || 1);
    for (let k = 0; k < kStates; ++k) {
      const frame = l * kStates + k,
        size = (far * k) / (kStates - 1);
      for (const name of ["moved", "turned"] as const)
        motion[name].forEach((v, i) => ((arrays[name] as Float32Array)[3 * s.count * frame + i] = v * size));
      for (let j = 0; j < s.joints; ++j) {
        const at = s.joints * frame + j;
        for (const name of ["opening", "slip"] as const) (arrays[name] as Float32Array)[at] = jump[name][j] * size;
        // a joint in the mechanism is shown as a crack
        (arrays.damage as Float32Array)[at] = Math.max(jump.opening[j], jump.slip[j]) > 1e-4 * fastest && k > 0 ? 255 : 0;
      }
    }
  });
  return {
    header: { ...bundle.header, frames: Array.from({ length: frames }) },
    array: (name: string): Numbers => arrays[name.slice("frame.".length)],
  } as unknown as Bundle;
}

export function collapseInSpace(bundle: Bundle<LimitHeader>, all: LimitLoad[]): HTMLElement | null {
  const solids = readSolids(bundle);
  // limit analysis counts deformable blocks as rigid, and this page does not draw that
  const limits = solids ? all.filter((l) => l.velocity_z?.length === solids.free) : [];
  if (!solids || limits.length === 0) return null;
  const info = limits.flatMap((l) => Array.from({ length: kStates }, () => ({ label: phrase(l.name), displacement: NaN, reaction: NaN })));
  const view = new SpaceView({ id: "collapse", states: new SolidStates(statesOf(bundle, solids, limits), solids), info });
  const pick = h(
    "select",
    {},
    limits.map((l, i) => h("option", { value: i }, phrase(l.name))),
  );
  const choose = (i: number): void => {
    view.choose(i * kStates, (i + 1) * kStates - 1);
    view.show((i + 1) * kStates - 1);
  };
  pick.addEventListener("change", () => choose(Number(pick.value)));
  choose(0);
  return h(
    "div",
    { class: "collapse-in-space" },
    h("h3", {}, say("collapse.title")),
    limits.length > 1 ? h("div", { class: "controls" }, h("label", {}, h("span", {}, say("collapse.joints")), pick)) : null,
    view.element,
    h("p", { class: "soft small" }, say("collapse.caption")),
  );
}
