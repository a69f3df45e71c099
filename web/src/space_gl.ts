// A wall in space on WebGL: shapes lie on the card once, a state is a texture of poses, so a body costs nothing
// of the page's own time but its pose. Blocks are one draw, their edges one, cracked faces two.
import {
  BufferAttribute,
  BufferGeometry,
  Camera as NoCamera,
  DataTexture,
  DoubleSide,
  FloatType,
  FrontSide,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LineSegments,
  Mesh,
  NearestFilter,
  RawShaderMaterial,
  RGBAFormat,
  Scene as Stage,
  UnsignedByteType,
  Vector2,
  Vector3,
  Vector4,
  WebGLRenderer,
  type Side,
  type Texture,
} from "three";
import { armOf, sectionsOf, sizeOf, type Solids, type Vec } from "./space";
import { kCapLight, sectionLines, type Marks, type Picture, type Scene } from "./space_paint";

const kRow = 1024; // texels in a row of a texture

function texture(data: Float32Array | Uint8Array, texels: number): DataTexture {
  const rows = Math.max(1, Math.ceil(texels / kRow)),
    isFloat = data instanceof Float32Array;
  const made = new DataTexture(data, kRow, rows, RGBAFormat, isFloat ? FloatType : UnsignedByteType);
  made.minFilter = made.magFilter = NearestFilter;
  made.needsUpdate = true;
  return made;
}
const roomFor = (texels: number): number => 4 * kRow * Math.max(1, Math.ceil(texels / kRow));

// What all shaders share: the pose of a body, and where a place is seen.
const kCommon = `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D poses;
uniform vec3 right, up, toward, target;
uniform vec2 half_size;
uniform float reach;
ivec2 texel(int i) { return ivec2(i & ${kRow - 1}, i >> 10); }
vec3 rotated(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
vec3 place(int body, vec3 arm) {
  return texelFetch(poses, texel(2 * body), 0).xyz + rotated(texelFetch(poses, texel(2 * body + 1), 0), arm);
}
vec4 seen(vec3 p, float lift) {
  vec3 v = p - target;
  return vec4(dot(v, right) / half_size.x, dot(v, up) / half_size.y, -(dot(v, toward) + lift) / reach, 1.0);
}
`;
const kCorners = `
uniform sampler2D corners;
vec3 between(int c) {
  vec4 a = texelFetch(corners, texel(2 * c), 0), b = texelFetch(corners, texel(2 * c + 1), 0);
  return 0.5 * (place(int(a.w), a.xyz) + place(int(b.w), b.xyz));
}
`;
const kBlock = `${kCommon}
uniform sampler2D tints;
in vec3 position, normal;
in float body;
out vec3 world, tint, facing;
void main() {
  int b = int(body);
  world = place(b, position);
  facing = rotated(texelFetch(poses, texel(2 * b + 1), 0), normal);
  tint = texelFetch(tints, texel(b), 0).rgb;
  gl_Position = seen(world, 0.0);
}`;
const kBlockColour = `
precision highp float;
uniform vec3 toward;
uniform vec4 cut;
uniform float opacity;
in vec3 world, tint, facing;
out vec4 colour;
void main() {
#ifdef CUT
  if (dot(cut.xyz, world) > cut.w) discard;
#endif
  vec3 n = normalize(facing);
  colour = vec4(tint * (0.62 + 0.3 * max(0.0, dot(n, toward)) + 0.14 * n.y), opacity);
}`;
const kEdge = `${kCommon}
uniform float lift;
in vec3 position;
in float body;
out vec3 world;
void main() {
  world = place(int(body), position);
  gl_Position = seen(world, lift);
}`;
const kFlat = `
precision highp float;
uniform vec4 cut, ink;
in vec3 world;
out vec4 colour;
void main() {
#ifdef CUT
  if (dot(cut.xyz, world) > cut.w) discard;
#endif
  colour = ink;
}`;
// A sheet between two blocks: corner 0, i and i + 1 of its polygon.
const kSheet = `${kCommon}${kCorners}
in vec3 position, at;
in vec4 look;
out vec3 world, tint;
void main() {
  world = between(int(position.x > 0.5 ? (position.x > 1.5 ? at.z : at.y) : at.x));
  tint = look.rgb;
  gl_Position = seen(world, 0.0);
}`;
// What closes a body that a cut opens, triangle by triangle.
const kCap = `${kCommon}
in vec3 position, from, to, middle;
in vec4 look;
out vec3 world, tint;
void main() {
  world = position.x > 0.5 ? (position.x > 1.5 ? to : from) : middle;
  tint = look.rgb;
  gl_Position = seen(world, 0.0);
}`;
// A line as wide as it should be, in pixels: WebGL's own are one.
const kStrip = (ends: string, read: string): string => `${kCommon}${kCorners}
uniform float lift, zoom;
in vec3 position;
${ends}
in vec4 look;
out vec3 world, tint;
void main() {
  ${read}
  vec4 a = seen(p, lift), b = seen(q, lift);
  vec2 pixels = half_size * zoom, way = (b.xy - a.xy) * pixels;
  float far = length(way);
  way = far > 0.01 ? way / far : vec2(1.0, 0.0);
  float wide = 8.0 * look.a;
  vec2 off = wide * (position.y * vec2(-way.y, way.x) + 0.8 * (2.0 * position.x - 1.0) * way);
  world = mix(p, q, position.x);
  tint = look.rgb;
  gl_Position = mix(a, b, position.x) + vec4(off / pixels, 0.0, 0.0);
}`;
// What lies in the plane of a cut stays.
const kTinted = `
precision highp float;
uniform vec4 cut;
uniform float near;
in vec3 world, tint;
out vec4 colour;
void main() {
#ifdef CUT
  if (dot(cut.xyz, world) > cut.w + near) discard;
#endif
  colour = vec4(tint, 1.0);
}`;

type Uniforms = Record<string, { value: unknown }>;

function material(vertex: string, fragment: string, uniforms: Uniforms, side: Side): RawShaderMaterial {
  return new RawShaderMaterial({ vertexShader: vertex, fragmentShader: fragment, uniforms, side, glslVersion: GLSL3 });
}

// Triangles of all bodies with a flat normal each, and every edge once a part.
function shapesOf(s: Solids): { blocks: BufferGeometry; edges: BufferGeometry } {
  const place: number[] = [],
    normal: number[] = [],
    body: number[] = [],
    line: number[] = [],
    lineBody: number[] = [];
  for (let b = 0; b < s.count; ++b)
    for (let part = s.partBegin[b]; part < s.partBegin[b + 1]; ++part) {
      const arm = (i: number): Vec => armOf(s, b, s.vertexBegin[part] + s.corner[i]);
      for (let f = s.faceBegin[part]; f < s.faceBegin[part + 1]; ++f) {
        const from = s.cornerBegin[f],
          end = s.cornerBegin[f + 1],
          all = Array.from({ length: end - from }, (_, i) => arm(from + i)),
          n = normalOf(all);
        for (let i = 1; i + 1 < all.length; ++i)
          for (const p of [all[0], all[i], all[i + 1]]) place.push(...p), normal.push(...n), body.push(b);
        for (let i = 0; i < all.length; ++i) {
          const next = (i + 1) % all.length;
          // of both faces at an edge the one that runs it upwards
          if (s.corner[from + i] > s.corner[from + next]) continue;
          line.push(...all[i], ...all[next]), lineBody.push(b, b);
        }
      }
    }
  const blocks = new BufferGeometry(),
    edges = new BufferGeometry();
  blocks.setAttribute("position", new BufferAttribute(Float32Array.from(place), 3));
  blocks.setAttribute("normal", new BufferAttribute(Float32Array.from(normal), 3));
  blocks.setAttribute("body", new BufferAttribute(Float32Array.from(body), 1));
  edges.setAttribute("position", new BufferAttribute(Float32Array.from(line), 3));
  edges.setAttribute("body", new BufferAttribute(Float32Array.from(lineBody), 1));
  return { blocks, edges };
}
function normalOf(corners: Vec[]): Vec {
  const n: Vec = [0, 0, 0];
  corners.forEach((p, i) => {
    const q = corners[(i + 1) % corners.length];
    for (let k = 0; k < 3; ++k) n[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
  });
  const size = Math.hypot(...n) || 1;
  return [n[0] / size, n[1] / size, n[2] / size];
}

// Corners of all joints' polygons, seen from the centroids of both bodies, which are named beside.
function cornersOf(s: Solids): DataTexture {
  const n = s.outlineBegin[s.joints],
    data = new Float32Array(roomFor(2 * n));
  for (let j = 0; j < s.joints; ++j)
    for (let c = s.outlineBegin[j]; c < s.outlineBegin[j + 1]; ++c)
      [s.jointA[j], s.jointB[j]].forEach((body, side) => {
        for (let k = 0; k < 3; ++k) data[8 * c + 4 * side + k] = s.outline[3 * c + k] - s.centroid[3 * body + k];
        data[8 * c + 4 * side + 3] = body;
      });
  return texture(data, 2 * n);
}

const strip = (): InstancedBufferGeometry => {
  const made = new InstancedBufferGeometry();
  // along, and to which side
  made.setAttribute("position", new BufferAttribute(Float32Array.from([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0]), 3));
  made.setIndex([0, 1, 2, 2, 1, 3]);
  return made;
};
const triangle = (): InstancedBufferGeometry => {
  const made = new InstancedBufferGeometry();
  made.setAttribute("position", new BufferAttribute(Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0]), 3));
  return made;
};
// A shape drawn many times: `arrays` hold what differs, `look` a colour and a width. It grows by being made anew.
class Copies {
  arrays: Record<string, Float32Array | Uint8Array> = {};
  private room = 0;
  constructor(
    readonly mesh: Mesh,
    private readonly make: () => InstancedBufferGeometry,
    private readonly sizes: Record<string, number>,
  ) {
    mesh.visible = false;
  }
  reserve(room: number): void {
    if (room <= this.room) return;
    this.room = 2 * room;
    const geometry = this.make();
    for (const [name, size] of Object.entries({ ...this.sizes, look: 4 })) {
      const isLook = name === "look";
      this.arrays[name] = isLook ? new Uint8Array(size * this.room) : new Float32Array(size * this.room);
      geometry.setAttribute(name, new InstancedBufferAttribute(this.arrays[name], size, isLook));
    }
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }
  show(count: number): void {
    const geometry = this.mesh.geometry as InstancedBufferGeometry;
    for (const [name, size] of Object.entries({ ...this.sizes, look: 4 })) {
      const attribute = geometry.getAttribute(name) as InstancedBufferAttribute | undefined;
      if (!attribute || count === 0) continue;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, size * count);
      attribute.needsUpdate = true;
    }
    geometry.instanceCount = count;
    this.mesh.visible = count > 0;
  }
}

export class GlPicture implements Picture {
  readonly element: HTMLCanvasElement;
  private readonly stage = new Stage();
  private readonly nobody = new NoCamera();
  private readonly poses: DataTexture;
  private readonly tints: DataTexture;
  private readonly shared: Uniforms;
  private readonly blocks: Mesh;
  private readonly edges: LineSegments;
  private readonly sheets: Copies;
  private readonly rims: Copies;
  private readonly sections: Copies;
  private readonly caps: Copies;
  private readonly materials: RawShaderMaterial[];
  private marks: Marks | null = null;
  private readonly size: number;

  constructor(
    private readonly solids: Solids,
    private readonly renderer: WebGLRenderer,
  ) {
    this.element = renderer.domElement;
    this.size = sizeOf(solids);
    this.poses = texture(new Float32Array(roomFor(2 * solids.count)), 2 * solids.count);
    this.tints = texture(new Uint8Array(roomFor(solids.count)), solids.count);
    this.shared = {
      poses: { value: this.poses },
      tints: { value: this.tints },
      corners: { value: cornersOf(solids) as Texture },
      right: { value: new Vector3() },
      up: { value: new Vector3() },
      toward: { value: new Vector3() },
      target: { value: new Vector3() },
      half_size: { value: new Vector2(1, 1) },
      zoom: { value: 1 },
      reach: { value: 1 },
      lift: { value: 0.0025 * this.size },
      near: { value: 1e-5 * this.size },
      cut: { value: new Vector4(0, 0, 0, 1) },
      opacity: { value: 1 },
      ink: { value: new Vector4(0, 0, 0, 1) },
    };
    const { blocks, edges } = shapesOf(solids);
    const above = { ...this.shared, lift: { value: 0.004 * this.size } };
    this.blocks = new Mesh(blocks, material(kBlock, kBlockColour, this.shared, FrontSide));
    this.edges = new LineSegments(edges, material(kEdge, kFlat, this.shared, FrontSide));
    const strips = (ends: string, read: string): Mesh =>
      new Mesh(strip(), material(kStrip(ends, read), kTinted, above, DoubleSide));
    const triangles = (vertex: string): Mesh =>
      new Mesh(triangle(), material(vertex, kTinted, this.shared, DoubleSide));
    this.sheets = new Copies(triangles(kSheet), triangle, { at: 3 });
    this.caps = new Copies(triangles(kCap), triangle, { from: 3, to: 3, middle: 3 });
    this.rims = new Copies(
      strips("in vec2 ends;", "vec3 p = between(int(ends.x)), q = between(int(ends.y));"),
      strip,
      { ends: 2 },
    );
    this.sections = new Copies(strips("in vec3 from, to;", "vec3 p = from, q = to;"), strip, { from: 3, to: 3 });
    const all = [this.sheets.mesh, this.caps.mesh, this.blocks, this.edges, this.rims.mesh, this.sections.mesh];
    all.forEach((one, order) => {
      one.frustumCulled = false;
      one.renderOrder = order;
    });
    this.materials = all.map((one) => one.material as RawShaderMaterial);
    this.stage.add(...all);
    renderer.sortObjects = false;
  }

  draw(scene: Scene): void {
    this.look(scene);
    this.poses.image.data!.set(scene.poses.data);
    this.poses.needsUpdate = true;
    if (scene.marks !== this.marks) {
      this.marks = scene.marks;
      this.mark(scene.marks);
      this.tints.image.data!.set(scene.tints);
      this.tints.needsUpdate = true;
    }
    this.section(scene);
    this.renderer.render(this.stage, this.nobody);
  }

  private look({ camera, cut, palette, clear, farthest }: Scene): void {
    const set = this.shared;
    const [right, up, toward] = camera.axes();
    (set.right.value as Vector3).set(...right);
    (set.up.value as Vector3).set(...up);
    (set.toward.value as Vector3).set(...toward);
    (set.target.value as Vector3).set(...camera.target);
    (set.half_size.value as Vector2).set(camera.width / 2 / camera.zoom, camera.height / 2 / camera.zoom);
    set.zoom.value = camera.zoom;
    set.reach.value = 2 * this.size + farthest + Math.hypot(...camera.target);
    if (cut) {
      const normal: Vec = [0, 0, 0];
      normal[cut.axis] = cut.sense;
      (set.cut.value as Vector4).set(...normal, cut.sense * cut.at);
    }
    (set.ink.value as Vector4).set(palette.edge[0] / 255, palette.edge[1] / 255, palette.edge[2] / 255, 1);
    set.opacity.value = clear ? 0.16 : 1;
    for (const one of this.materials) {
      if ("CUT" in one.defines! === (cut !== null)) continue;
      if (cut) one.defines!.CUT = "";
      else delete one.defines!.CUT;
      one.needsUpdate = true;
    }
    const block = this.blocks.material as RawShaderMaterial;
    block.transparent = clear;
    block.depthWrite = !clear;
    const [r, g, b] = palette.paper;
    this.renderer.setClearColor((r << 16) | (g << 8) | b, 1);
    const fine = scaleOf();
    if (this.element.width !== Math.round(camera.width * fine) || this.element.height !== Math.round(camera.height * fine)) {
      this.renderer.setPixelRatio(fine);
      this.renderer.setSize(camera.width, camera.height);
    }
  }

  // Faces that show something: their rims as strips, their areas as sheets between the blocks.
  private mark({ count, joints, look }: Marks): void {
    const { outlineBegin } = this.solids;
    let corners = 0;
    for (let m = 0; m < count; ++m) corners += outlineBegin[joints[m] + 1] - outlineBegin[joints[m]];
    this.rims.reserve(corners);
    this.sheets.reserve(corners - 2 * count);
    const { ends, look: rim } = this.rims.arrays,
      { at, look: sheet } = this.sheets.arrays;
    let r = 0,
      t = 0;
    for (let m = 0; m < count; ++m) {
      const from = outlineBegin[joints[m]],
        end = outlineBegin[joints[m] + 1];
      for (let c = from; c < end; ++c, ++r) {
        ends[2 * r] = c;
        ends[2 * r + 1] = c + 1 < end ? c + 1 : from;
        for (let k = 0; k < 4; ++k) rim[4 * r + k] = look[4 * m + k];
      }
      for (let c = from + 1; c + 1 < end; ++c, ++t) {
        at[3 * t] = from;
        at[3 * t + 1] = c;
        at[3 * t + 2] = c + 1;
        for (let k = 0; k < 4; ++k) sheet[4 * t + k] = look[4 * m + k];
      }
    }
    this.rims.show(r);
    this.sheets.show(t);
  }

  // What a cut opens: the bodies it goes through, closed and outlined, and cracks it crosses.
  private section(scene: Scene): void {
    const { cut, tints } = scene,
      opened = cut ? sectionsOf(this.solids, scene.poses, cut) : [],
      lines = cut ? sectionLines(this.solids, scene, cut, opened) : [];
    this.caps.reserve(opened.length);
    this.sections.reserve(lines.length);
    opened.forEach(({ body, line, centre }, i) => {
      const { from, to, middle, look } = this.caps.arrays;
      from.set(line[0], 3 * i), to.set(line[1], 3 * i), middle.set(centre, 3 * i);
      for (let k = 0; k < 3; ++k) look[4 * i + k] = kCapLight * tints[4 * body + k];
    });
    lines.forEach(({ line, look }, i) => {
      const { arrays } = this.sections;
      arrays.from.set(line[0], 3 * i), arrays.to.set(line[1], 3 * i), arrays.look.set(look, 4 * i);
    });
    this.caps.show(scene.clear ? 0 : opened.length);
    this.sections.show(lines.length);
  }
}
const scaleOf = (): number => Math.min(2, window.devicePixelRatio || 1);

// null where the browser offers no WebGL.
export function glPicture(solids: Solids): GlPicture | null {
  try {
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: false });
    if (!context) return null;
    return new GlPicture(solids, new WebGLRenderer({ canvas, context, antialias: true }));
  } catch {
    return null;
  }
}
