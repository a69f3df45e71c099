// Eight walls beside a push: which of them count, and the words for them. The engine's answers are given, so that every status comes.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import { viewerModule } from "./helpers.mjs";
import { standInForPage } from "./studio.mjs";

let Beside, bandOf, parse;
before(async () => {
  standInForPage();
  ({ Beside } = await viewerModule("studio/push/beside"));
  ({ bandOf } = await viewerModule("studio/push/curve"));
  ({ parse } = await viewerModule("studio/file/toml"));
});

const wall = (status, peak, states = 3) => ({
  code: 0,
  texts: { summary: JSON.stringify({ status, peak_reaction_kN: peak }) },
  tables: { curve: { displacement_mm: Float64Array.from({ length: states }, (_, k) => k), reaction_kN: Float64Array.from({ length: states }, (_, k) => (peak * k) / states) } },
});
const kFile = '[masonry]\nuse = "tuff_wall"\n';
async function pushed(walls, text = kFile, meanwhile = () => undefined) {
  const project = { text, doc: parse(text), drawable: false };
  let asked = 0;
  const engine = { ask: async () => (meanwhile(project, asked), walls[asked++ % walls.length]), stop() {}, rest() {} };
  const beside = new Beside(project, engine, () => undefined);
  await beside.pushWalls();
  return { beside, words: beside.root.text };
}

test("runs without a result are told and not counted; the legend counts what the sentence counts", async () => {
  const walls = [wall("completed", 10), wall("unstable", 99), wall("collapsed", 20), wall("not_settled", 1)];
  const { beside, words } = await pushed(walls);
  assert.match(words, /^4 walls, .*: half of them carry more than 15 kN; the weakest 10 kN, the strongest 20 kN\. 4 of 8 failed/);
  assert.equal(beside.walls.length, 4);
});

test("a wall that fell under its own weight carries nothing, in words and in the band", async () => {
  const { beside, words } = await pushed([wall("completed", 10), wall("collapsed", 0, 0)]);
  assert.match(words, /^8 walls, .*the weakest 0 kN, the strongest 10 kN\.$/);
  assert.equal(beside.walls.length, 8);
  const band = bandOf(beside.walls);
  assert.ok(band.length > 0 && band.every((b) => b.low === 0));
});

test("of an odd number of walls the median is said", async () => {
  const walls = [5, 10, 15, 20, 25, 30, 35].map((force) => wall("completed", force));
  const { words } = await pushed([...walls, wall("unstable", 1)]);
  assert.match(words, /^7 walls, .*: median 20 kN; .* 1 of 8 failed/);
});

test("the words for the scatter are those of the file that was pushed", async () => {
  const edit = (project) => (project.doc = parse("[scatter]\nseed = 3\n"));
  assert.match((await pushed([wall("completed", 10)], kFile, edit)).words, /as in tuff/);
  assert.match((await pushed([wall("completed", 10)], '[scatter]\nuse = "stone"\n')).words, /scatter of the file/);
  const formula = `${kFile}[field.strong]\nformula = "x"\n`;
  assert.match((await pushed([wall("completed", 10)], formula)).words, /as in tuff/);
  assert.match((await pushed([wall("completed", 10)], `${kFile}[field.strong]\nseed = 1\n`)).words, /scatter of the file/);
});
