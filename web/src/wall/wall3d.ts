// The wall in space: blocks as prisms with their thickness, joints as sheets coloured by
// their damage. Drawn only when something changes; rotated by pointer, wheel and arrow keys.
import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PerspectiveCamera,
  Scene as Space,
  ShapeUtils,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { say } from "../base/texts";
import type { Look } from "./wall2d";
import {
  bodyCss,
  crackOf,
  forcesOf,
  jointStress,
  fieldOf,
  isCutOut,
  isField,
  kSteps,
  Pose,
  stepOf,
  valueOf,
  zoneStress,
  type Frame,
  type Frames,
  type Wall,
} from "./wall";

export interface Scene {
  element: HTMLElement;
  draw(look: Look): void;
  resize(width: number, height: number): void;
  png(): Promise<Blob>;
}

const css = (name: string): Color =>
  new Color(getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim() || "#888");

// Corner indices of a prism's faces: both fronts and the sides; a front may be any simple polygon.
interface Prisms {
  geometry: BufferGeometry;
  block: Int32Array;
  corner: Int32Array;
  side: Int8Array; // of each vertex
  edges: BufferGeometry;
  edgeVertex: Int32Array; // vertices that the outline repeats
}

function makePrisms(wall: Wall): Prisms {
  const block: number[] = [],
    corner: number[] = [],
    side: number[] = [],
    edgeVertex: number[] = [];
  const vertex = (b: number, i: number, s: number): number =>
    block.push(b) && corner.push(i) && side.push(s) - 1;
  for (let b = 0; b < wall.blocks; ++b) {
    if (isCutOut(wall, b)) continue;
    const from = wall.outlineBegin[b],
      n = wall.outlineBegin[b + 1] - from;
    const outline = Array.from(
      { length: n },
      (_, i) => new Vector2(wall.outlineX[from + i], wall.outlineY[from + i]),
    );
    const turns = ShapeUtils.isClockWise(outline);
    for (const [p, q, r] of ShapeUtils.triangulateShape(outline, []))
      for (const s of [1, -1])
        for (const i of s > 0 !== turns ? [p, q, r] : [p, r, q]) vertex(b, from + i, s);
    for (let i = 0; i < n; ++i) {
      const a = from + (turns ? (i + 1) % n : i),
        c = from + (turns ? i : (i + 1) % n);
      for (const [k, s] of [
        [a, 1],
        [a, -1],
        [c, -1],
        [a, 1],
        [c, -1],
        [c, 1],
      ])
        vertex(b, k, s);
      const last = block.length - 6;
      edgeVertex.push(last, last + 5, last + 1, last + 2, last, last + 1);
    }
  }
  const geometry = new BufferGeometry(),
    edges = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * block.length), 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(3 * block.length), 3));
  edges.setAttribute("position", new BufferAttribute(new Float32Array(3 * edgeVertex.length), 3));
  return {
    geometry,
    block: Int32Array.from(block),
    corner: Int32Array.from(corner),
    side: Int8Array.from(side),
    edges,
    edgeVertex: Int32Array.from(edgeVertex),
  };
}

class WallScene implements Scene {
  readonly element: HTMLCanvasElement;
  private readonly space = new Space();
  private readonly camera = new PerspectiveCamera(32, 1, 0.01, 500);
  private readonly prisms: Prisms;
  private readonly sheets = new BufferGeometry();
  private readonly sheetMesh: Mesh;
  private readonly edgeMaterial = new LineBasicMaterial({ transparent: true, opacity: 0.35 });
  private readonly middle: Vector3;
  private turn = -0.55;
  private tilt = 0.22;
  private near: number;
  private look: Look | null = null;
  private sheetCount = 0; // vertices of the drawings on the face

  constructor(
    private readonly wall: Wall,
    private readonly frames: Frames,
    private readonly renderer: WebGLRenderer,
  ) {
    this.element = renderer.domElement;
    this.element.setAttribute("tabindex", "0");
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", `${say("wall.alt")}. ${say("wall.turn")}`);
    this.element.title = say("wall.turn");
    const { x0, x1, y0, y1 } = wall.bounds;
    this.middle = new Vector3((x0 + x1) / 2, (y0 + y1) / 2, 0);
    this.near = 1.85 * Math.max(0.9 * (x1 - x0), 1.15 * (y1 - y0));
    this.prisms = makePrisms(wall);
    const most = 2 * wall.joints + (wall.mesh ? wall.mesh.zone.length / 4 : 0); // joints, forces, zones
    this.sheets.setAttribute("position", new BufferAttribute(new Float32Array(18 * most), 3));
    this.sheets.setAttribute("color", new BufferAttribute(new Float32Array(18 * most), 3));
    this.sheetMesh = new Mesh(
      this.sheets,
      new MeshBasicMaterial({
        vertexColors: true,
        side: DoubleSide,
        polygonOffset: true,
        polygonOffsetFactor: -2,
        polygonOffsetUnits: -2,
      }),
    );
    const walls = new Mesh(this.prisms.geometry, new MeshLambertMaterial({ vertexColors: true }));
    const sun = new DirectionalLight(0xffffff, 2.1);
    sun.position.set(0.5, 0.8, 1).multiplyScalar(10);
    this.space.add(
      new AmbientLight(0xffffff, 1.6),
      sun,
      walls,
      new LineSegments(this.prisms.edges, this.edgeMaterial),
      this.sheetMesh,
    );
    for (const o of this.space.children) o.frustumCulled = false;
    this.listen();
    window.addEventListener("themechange", () => {
      if (this.look) this.draw(this.look);
    });
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.render();
  }

  draw(look: Look): void {
    this.look = look;
    const pose = new Pose(this.wall, this.frames.at(look.frame), look.scale);
    this.placeBlocks(pose);
    this.sheetCount = 0;
    if (look.measure === "stress") this.placeZones(pose, look);
    this.placeJoints(pose, look);
    if (look.forces) this.placeForces(pose);
    this.sheets.setDrawRange(0, this.sheetCount);
    for (const name of ["position", "color"]) this.sheets.getAttribute(name).needsUpdate = true;
    this.render();
  }

  png(): Promise<Blob> {
    this.render();
    return new Promise((done, fail) =>
      this.element.toBlob((b) => (b ? done(b) : fail(new Error("no image"))), "image/png"),
    );
  }

  private placeBlocks(pose: Pose): void {
    const { geometry, block, corner, side, edges, edgeVertex } = this.prisms;
    const position = geometry.getAttribute("position") as BufferAttribute,
      colour = geometry.getAttribute("color") as BufferAttribute;
    const tints = [0, 1, 2, 3].map((i) => css(`stone${i}`)),
      timber = css("timber"),
      plate = css("plate");
    for (let v = 0; v < block.length; ++v) {
      const b = block[v],
        [x, y] = pose.corner(b, corner[v]),
        role = this.wall.role[b];
      position.setXYZ(v, x, y, (side[v] * this.wall.blockThickness[b]) / 2);
      const body = bodyCss(role);
      const c =
        body === "timber" ? timber : body === "plate" ? plate : tints[((Math.imul(b, 2654435761) >>> 13) + b) % 4];
      colour.setXYZ(v, c.r, c.g, c.b);
    }
    const outline = edges.getAttribute("position") as BufferAttribute;
    for (let k = 0; k < edgeVertex.length; ++k)
      outline.setXYZ(
        k,
        position.getX(edgeVertex[k]),
        position.getY(edgeVertex[k]),
        position.getZ(edgeVertex[k]),
      );
    this.edgeMaterial.color = css("mortar");
    position.needsUpdate = colour.needsUpdate = outline.needsUpdate = true;
    geometry.computeVertexNormals();
  }

  // Only joints with something to show, as strips on the visible face.
  private placeJoints(pose: Pose, look: Look): void {
    const frame = this.frames.at(look.frame),
      thin = 0.0032 * Math.max(this.wall.length, this.wall.height),
      colour = this.jointColours(look);
    for (let j = 0; j < this.wall.joints; ++j) {
      const shown = colour(frame, j, thin);
      if (shown)
        this.strip(pose.joint(j, -1), pose.joint(j, 1), Math.min(shown.wide, 4 * thin), shown.colour, {
          depth: this.wall.blockThickness[this.wall.jointB[j]],
          lift: 1,
        });
    }
  }
  private jointColours(
    look: Look,
  ): (frame: Frame, j: number, thin: number) => { colour: Color; wide: number } | null {
    const quiet = css("mortar");
    const step = (hue: Color, k: number, thin: number): { colour: Color; wide: number } | null =>
      k === 0
        ? null
        : { colour: quiet.clone().lerp(hue, 0.2 + (0.8 * k) / 6), wide: thin * (0.4 + 0.25 * k) };
    const { measure } = look;
    if (measure === "cracks") {
      const hues = { open: css("open"), slip: css("slip"), closed: css("closed") };
      return (frame, j, thin) => {
        const crack = crackOf(frame, j);
        if (crack === "sound" || crack === "softening") return null;
        const wide = thin * (crack === "closed" ? 0.5 : 1) + 0.5 * Math.max(frame.opening[j], 0);
        return { colour: hues[crack], wide };
      };
    }
    if (measure === "stress") {
      const [tension, compression] = [css("open"), css("slip")];
      return (frame, j, thin) => {
        const stress = jointStress(this.wall, frame, j);
        return step(stress > 0 ? tension : compression, stepOf(Math.abs(stress), look.stressSteps), thin);
      };
    }
    if (isField(measure)) {
      const { onBlocks, values, steps } = fieldOf(this.wall, measure);
      const hue = css("damage");
      return (_, j, thin) =>
        onBlocks || Number.isNaN(values[j] ?? NaN) ? null : step(hue, stepOf(values[j], steps), thin);
    }
    const hue = css(measure === "crushing" ? "crush" : measure === "opening" ? "open" : measure);
    return (frame, j, thin) => step(hue, stepOf(valueOf(frame, j, measure), kSteps[measure]), thin);
  }
  private placeZones(pose: Pose, look: Look): void {
    const { mesh } = this.wall;
    if (!mesh) return;
    const [tension, compression, paper] = [css("open"), css("slip"), css("timber")];
    const depth = this.wall.blockThickness[mesh.rigid];
    for (let z = 0; z < mesh.zone.length; z += 4) {
      const stress = zoneStress(pose.frame, z / 4),
        step = stepOf(Math.abs(stress), look.stressSteps);
      if (step === 0) continue;
      this.quad(
        [0, 1, 2, 3].map((k) => pose.node(mesh, mesh.zone[z + k])),
        paper.clone().lerp(stress > 0 ? tension : compression, 0.15 + (0.85 * step) / 6),
        { depth, lift: 0 },
      );
    }
  }
  private placeForces(pose: Pose): void {
    const colour = css("thrust"),
      size = Math.max(this.wall.length, this.wall.height),
      depth = Math.max(...Array.from(this.wall.blockThickness));
    for (const { from, to, share } of forcesOf(this.wall, pose.frame, pose))
      this.strip(from, to, size * (0.0012 + 0.0058 * Math.sqrt(share)), colour, { depth, lift: 2 });
  }
  private strip(
    a: [number, number],
    b: [number, number],
    wide: number,
    colour: Color,
    place: { depth: number; lift: number },
  ): void {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
    const nx = ((-(b[1] - a[1]) / length) * wide) / 2,
      ny = (((b[0] - a[0]) / length) * wide) / 2;
    this.quad(
      [
        [a[0] - nx, a[1] - ny],
        [b[0] - nx, b[1] - ny],
        [b[0] + nx, b[1] + ny],
        [a[0] + nx, a[1] + ny],
      ],
      colour,
      place,
    );
  }
  // A quadrilateral on the visible face; a larger `lift` is drawn above.
  private quad(corners: [number, number][], colour: Color, place: { depth: number; lift: number }): void {
    const position = this.sheets.getAttribute("position") as BufferAttribute,
      colours = this.sheets.getAttribute("color") as BufferAttribute;
    const z = (place.depth / 2) * (1.004 + 0.006 * place.lift) + 0.001 * (1 + place.lift),
      face = Math.cos(this.turn) >= 0 ? z : -z;
    for (const k of [0, 1, 2, 0, 2, 3]) {
      position.setXYZ(this.sheetCount, corners[k][0], corners[k][1], face);
      colours.setXYZ(this.sheetCount, colour.r, colour.g, colour.b);
      ++this.sheetCount;
    }
  }

  private render(): void {
    const r = this.near,
      c = Math.cos(this.tilt);
    this.camera.position.set(
      this.middle.x + r * c * Math.sin(this.turn),
      this.middle.y + r * Math.sin(this.tilt),
      r * c * Math.cos(this.turn),
    );
    this.camera.lookAt(this.middle);
    this.camera.updateProjectionMatrix();
    this.renderer.setClearColor(css("paper"));
    this.renderer.render(this.space, this.camera);
  }
  private rotate(turn: number, tilt: number): void {
    const front = Math.cos(this.turn) >= 0;
    this.turn += turn;
    this.tilt = Math.min(1.45, Math.max(-0.6, this.tilt + tilt));
    if (this.look && front !== Math.cos(this.turn) >= 0) this.draw(this.look);
    else this.render();
  }
  private zoom(factor: number): void {
    const size = Math.max(this.wall.length, this.wall.height) || 1;
    this.near = Math.min(8 * size, Math.max(0.5 * size, this.near * factor));
    this.render();
  }

  private listen(): void {
    const pointers = new Map<number, [number, number]>();
    this.element.addEventListener("pointerdown", (e) => {
      pointers.set(e.pointerId, [e.clientX, e.clientY]);
      this.element.setPointerCapture(e.pointerId);
    });
    const drop = (e: PointerEvent): void => {
      pointers.delete(e.pointerId);
    };
    this.element.addEventListener("pointerup", drop);
    this.element.addEventListener("pointercancel", drop);
    this.element.addEventListener("pointermove", (e) => {
      const before = pointers.get(e.pointerId);
      if (!before) return;
      const other = [...pointers].find(([id]) => id !== e.pointerId)?.[1];
      if (other)
        this.zoom(
          Math.hypot(before[0] - other[0], before[1] - other[1]) /
            Math.max(1, Math.hypot(e.clientX - other[0], e.clientY - other[1])),
        );
      else this.rotate(-(e.clientX - before[0]) * 0.008, (e.clientY - before[1]) * 0.006);
      pointers.set(e.pointerId, [e.clientX, e.clientY]);
    });
    this.element.addEventListener(
      "wheel",
      (e) => {
        e.preventDefault();
        this.zoom(Math.exp(e.deltaY * 0.001));
      },
      { passive: false },
    );
    this.element.addEventListener("keydown", (e) => {
      const step = 0.12;
      const turns: Record<string, () => void> = {
        ArrowLeft: () => this.rotate(step, 0),
        ArrowRight: () => this.rotate(-step, 0),
        ArrowUp: () => this.rotate(0, step),
        ArrowDown: () => this.rotate(0, -step),
        "+": () => this.zoom(0.9),
        "-": () => this.zoom(1.1),
      };
      if (!turns[e.key]) return;
      e.preventDefault();
      turns[e.key]();
    });
  }
}

// null if the browser has no WebGL.
export function makeScene(wall: Wall, frames: Frames): Scene | null {
  try {
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    if (!context) return null;
    return new WallScene(wall, frames, new WebGLRenderer({ canvas, context, antialias: true }));
  } catch {
    return null;
  }
}
