// A wall in space with WebGL: shapes are on the graphics card once, and a state is a texture of poses.
// So a body costs the page only its pose. Blocks are one draw call, their edges one, cracked faces two.
import {
  BufferAttribute,
  BufferGeometry,
  Camera as NoCamera,
  DataTexture,
  DoubleSide,
  FloatType,
  FrontSide,
  GLSL3,
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

// Code for all shaders: the pose of a body, and the projection of a place.
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
in vec3 position;
in float body;
out vec3 world, tint;
void main() {
  int b = int(body);
  world = place(b, position);
  tint = texelFetch(tints, texel(b), 0).rgb;
  gl_Position = seen(world, 0.0);
}`;
const kBlockColour = `
precision highp float;
uniform vec3 toward;
uniform vec4 cut;
uniform float opacity;
in vec3 world, tint;
out vec4 colour;
void main() {
#ifdef CUT
  if (dot(cut.xyz, world) > cut.w) discard;
#endif
  vec3 n = normalize(cross(dFdx(world), dFdy(world))); // of a flat face; so its corners are shared
  n *= sign(dot(n, toward));
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
// The following shaders read their items as rows of a texture, not as instances,
// because software renderers draw each instance separately, a hundred times slower.
const kRows = `
uniform sampler2D rows;
vec4 row(int i) { return texelFetch(rows, texel(i), 0); }
vec3 colour_of(float c) { return vec3(floor(c / 65536.0), mod(floor(c / 256.0), 256.0), mod(c, 256.0)) / 255.0; }
out vec3 world, tint;
`;
// A sheet between two blocks: three corners of its polygon, and its colour.
const kSheet = `${kCommon}${kCorners}${kRows}
void main() {
  vec4 of = row(gl_VertexID / 3);
  world = between(int(of[gl_VertexID % 3]));
  tint = colour_of(of.w);
  gl_Position = seen(world, 0.0);
}`;
// The surface that closes a body opened by a cut, triangle by triangle.
const kCap = `${kCommon}${kRows}
void main() {
  int item = gl_VertexID / 3;
  world = row(gl_VertexID).xyz;
  tint = colour_of(row(3 * item).w);
  gl_Position = seen(world, 0.0);
}`;
// A line of given width in pixels, because WebGL only has lines of one pixel.
const kStrip = (read: string): string => `${kCommon}${kCorners}${kRows}
uniform float lift, zoom;
void main() {
  int item = gl_VertexID / 6, k = gl_VertexID % 6;
  ${read}
  int corner = k < 3 ? k : k == 3 ? 2 : k == 4 ? 1 : 3;
  float along = float(corner >> 1), side = float(corner & 1) * 2.0 - 1.0;
  vec4 a = seen(p, lift), b = seen(q, lift);
  vec2 pixels = half_size * zoom, way = (b.xy - a.xy) * pixels;
  float far = length(way);
  way = far > 0.01 ? way / far : vec2(1.0, 0.0);
  vec2 off = wide * (side * vec2(-way.y, way.x) + 0.8 * (2.0 * along - 1.0) * way);
  world = mix(p, q, along);
  gl_Position = mix(a, b, along) + vec4(off / pixels, 0.0, 0.0);
}`;
const kRim = kStrip(`vec4 of = row(item);
  vec3 p = between(int(of.x)), q = between(int(of.y));
  float wide = of.w;
  tint = colour_of(of.z);`);
const kSection = kStrip(`vec4 from = row(2 * item), to = row(2 * item + 1);
  vec3 p = from.xyz, q = to.xyz;
  float wide = to.w;
  tint = colour_of(from.w);`);
// Parts in the plane of a cut are kept.
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

// Vertices of all bodies, shared by their triangles and edges.
function shapesOf(s: Solids): { blocks: BufferGeometry; edges: BufferGeometry } {
  const n = s.vertexBegin[s.vertexBegin.length - 1],
    place = new Float32Array(3 * n),
    body = new Float32Array(n),
    triangles: number[] = [],
    lines: number[] = [];
  for (let b = 0; b < s.count; ++b)
    for (let part = s.partBegin[b]; part < s.partBegin[b + 1]; ++part) {
      const first = s.vertexBegin[part];
      for (let v = first; v < s.vertexBegin[part + 1]; ++v) {
        place.set(armOf(s, b, v), 3 * v);
        body[v] = b;
      }
      for (let f = s.faceBegin[part]; f < s.faceBegin[part + 1]; ++f) {
        const from = s.cornerBegin[f],
          end = s.cornerBegin[f + 1];
        for (let i = from + 1; i + 1 < end; ++i)
          triangles.push(first + s.corner[from], first + s.corner[i], first + s.corner[i + 1]);
        for (let i = from; i < end; ++i) {
          const p = s.corner[i],
            q = s.corner[i + 1 < end ? i + 1 : from];
          if (p < q) lines.push(first + p, first + q); // each edge once: one of its two faces has p < q
        }
      }
    }
  const of = (index: number[]): BufferGeometry => {
    const made = new BufferGeometry();
    made.setAttribute("position", places);
    made.setAttribute("body", bodies);
    made.setIndex(index);
    return made;
  };
  const places = new BufferAttribute(place, 3),
    bodies = new BufferAttribute(body, 1);
  return { blocks: of(triangles), edges: of(lines) };
}

// Corners of all joints' polygons, relative to the centroids of both bodies, with the bodies' numbers.
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

// Items with `texels` texels each, drawn with a fixed number of vertices.
class Rows {
  readonly mesh: Mesh;
  data = new Float32Array();
  private room = 0;
  private readonly rows: { value: DataTexture | null } = { value: null };
  constructor(
    vertex: string,
    uniforms: Uniforms,
    private readonly texels: number,
    private readonly vertices: number,
  ) {
    this.mesh = new Mesh(new BufferGeometry(), material(vertex, kTinted, { ...uniforms, rows: this.rows }, DoubleSide));
    this.mesh.visible = false;
  }
  reserve(items: number): void {
    if (items <= this.room) return;
    this.room = 2 * items;
    this.data = new Float32Array(roomFor(this.texels * this.room));
    this.rows.value?.dispose();
    this.rows.value = texture(this.data, this.texels * this.room);
  }
  show(items: number): void {
    if (items > 0) this.rows.value!.needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, this.vertices * items);
    this.mesh.visible = items > 0;
  }
}
const packed = (look: ArrayLike<number>, i = 0): number => 65536 * look[i] + 256 * look[i + 1] + look[i + 2];
const wideOf = (look: ArrayLike<number>, i = 0): number => (8 * look[i + 3]) / 255;

export class GlPicture implements Picture {
  readonly element: HTMLCanvasElement;
  private readonly stage = new Stage();
  private readonly nobody = new NoCamera();
  private readonly poses: DataTexture;
  private readonly tints: DataTexture;
  private readonly shared: Uniforms;
  private readonly blocks: Mesh;
  private readonly edges: LineSegments;
  private readonly sheets: Rows;
  private readonly rims: Rows;
  private readonly sections: Rows;
  private readonly caps: Rows;
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
    this.sheets = new Rows(kSheet, this.shared, 1, 3);
    this.caps = new Rows(kCap, this.shared, 3, 3);
    this.rims = new Rows(kRim, above, 1, 6);
    this.sections = new Rows(kSection, above, 2, 6);
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

  // Faces with something to show: their rims as strips, their areas as sheets between the blocks.
  private mark({ count, joints, look }: Marks): void {
    const { outlineBegin } = this.solids;
    let corners = 0;
    for (let m = 0; m < count; ++m) corners += outlineBegin[joints[m] + 1] - outlineBegin[joints[m]];
    this.rims.reserve(corners);
    this.sheets.reserve(corners - 2 * count);
    const rim = this.rims.data,
      sheet = this.sheets.data;
    let r = 0,
      t = 0;
    for (let m = 0; m < count; ++m) {
      const from = outlineBegin[joints[m]],
        end = outlineBegin[joints[m] + 1],
        colour = packed(look, 4 * m),
        wide = wideOf(look, 4 * m);
      for (let c = from; c < end; ++c, r += 4) {
        rim[r] = c;
        rim[r + 1] = c + 1 < end ? c + 1 : from;
        rim[r + 2] = colour;
        rim[r + 3] = wide;
      }
      for (let c = from + 1; c + 1 < end; ++c, t += 4) {
        sheet[t] = from;
        sheet[t + 1] = c;
        sheet[t + 2] = c + 1;
        sheet[t + 3] = colour;
      }
    }
    this.rims.show(r / 4);
    this.sheets.show(t / 4);
  }

  // The section by a cut: bodies that it crosses, closed and outlined, and cracks.
  private section(scene: Scene): void {
    const { cut, tints } = scene,
      opened = cut ? sectionsOf(this.solids, scene.poses, cut) : [],
      lines = cut ? sectionLines(this.solids, scene, cut, opened) : [];
    this.caps.reserve(opened.length);
    this.sections.reserve(lines.length);
    const caps = this.caps.data,
      sections = this.sections.data;
    opened.forEach(({ body, line, centre }, i) => {
      const tint = [0, 1, 2].map((k) => Math.round(kCapLight * tints[4 * body + k]));
      [centre, ...line].forEach((place, k) => caps.set([...place, packed(tint)], 12 * i + 4 * k));
    });
    lines.forEach(({ line: [p, q], look }, i) => {
      sections.set([...p, packed(look), ...q, wideOf(look)], 8 * i);
    });
    this.caps.show(scene.clear ? 0 : opened.length);
    this.sections.show(lines.length);
  }
}
const scaleOf = (): number => Math.min(2, window.devicePixelRatio || 1);

const kFewBodies = 500; // that a software renderer can smooth in time

// null if the browser has no WebGL.
export function glPicture(solids: Solids): GlPicture | null {
  const contextOf = (more: WebGLContextAttributes): [HTMLCanvasElement, WebGL2RenderingContext | null] => {
    const canvas = document.createElement("canvas");
    return [canvas, canvas.getContext("webgl2", more)];
  };
  try {
    let [canvas, context] = contextOf({ antialias: true, failIfMajorPerformanceCaveat: true });
    if (!context) [canvas, context] = contextOf({ antialias: solids.count < kFewBodies });
    return context && new GlPicture(solids, new WebGLRenderer({ canvas, context }));
  } catch {
    return null;
  }
}
