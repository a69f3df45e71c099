// The family of curves of one number: which values, in which order, what ends it, what it says. The engine's answers are given;
// studio_live_test.mjs has it with the engine itself.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import { viewerModule } from "./helpers.mjs";
import { standInForPage } from "./studio.mjs";

let Family, valuesBetween, rangeOf, numberAt, parse, setValue;
before(async () => {
  standInForPage();
  ({ Family } = await viewerModule("studio/push/family"));
  ({ valuesBetween, rangeOf, numberAt } = await viewerModule("studio/push/varied"));
  ({ parse, setValue } = await viewerModule("studio/file/toml"));
});

test("values go from half to twice by equal ratios, close ones at equal steps, and the present one is among them", () => {
  assert.deepEqual(rangeOf(0.4, false), [0.2, 0.8]);
  assert.deepEqual(valuesBetween(0.2, 0.8, 5, 0.4, false), [0.2, 0.283, 0.4, 0.566, 0.8]);
  assert.deepEqual(valuesBetween(10, 12, 5, 11.1, false), [10, 10.5, 11.1, 11.5, 12]);
  assert.deepEqual(valuesBetween(-2, 2, 5, 7, false), [-2, -1, 0, 1, 2]);
  assert.deepEqual(rangeOf(1, true), [1, 2]);
  assert.deepEqual(valuesBetween(1, 4, 7, 2, true), [1, 2, 3, 4]);
  assert.deepEqual(rangeOf(-4, false), [-8, -2]);
});

const numbered = (text) => ({ text, doc: parse(text), broken: null });
test("the number at the cursor of the file, in any unit, in lists and in braces", () => {
  const text = 'name = "0.4 walls"\n[wall]\nsize = { length = "2 m", count = 3 } # 4 m\nat = ["1 m", "5e-1 m"]\nstrength = "20 GPa/m"\nshare = 0.5\nopen = true\n';
  const at = (word, more = 0) => numberAt(numbered(text), text.indexOf(word) + more);
  assert.equal(at("0.4 walls").unit, "walls"); // who wants that may
  assert.equal(at("[wall]"), null);
  assert.equal(at("open"), null);
  assert.equal(at("count", 8).name, "wall.size.count");
  assert.equal(at("count", 8).whole, true);
  assert.equal(at("size").name, "wall.size.length"); // the first of the line
  assert.equal(at("5e-1", 2).name, "wall.at.1");
  assert.equal(at("5e-1", 2).now(), 0.5);
  assert.equal(at("strength").unit, "GPa/m");
  assert.equal(at("strength").text(12.5), setValue(text, ["wall", "strength"], '"12.5 GPa/m"'));
  assert.equal(at("share").whole, false);
  assert.equal(at("share").text(0.25), text.replace("share = 0.5", "share = 0.25"));
});

// A family of thicknesses in metres; `answer` is the engine's to each.
function family(answer, known = () => null) {
  const project = { text: "0.4", broken: null, endStep() {}, change: (text) => (project.text = text) };
  const asked = [];
  let stopped = 0;
  const engine = { ask: async ({ texts }) => (asked.push(texts.model), answer(texts.model)), stop: () => ++stopped, rest() {} };
  const made = new Family(project, engine, known, () => false, () => made.refresh());
  made.count.value = "5";
  made.open({ name: "Thickness", unit: "m", whole: false, now: () => Number(project.text), text: (v) => (v > 0.7 ? null : String(v)) }, null);
  const pushed = async () => {
    const before = made.push();
    await before;
    return made.root.text;
  };
  return { family: made, project, asked, pushed, stops: () => stopped };
}
const wall = (text, status = "completed") => ({
  code: 0,
  texts: { summary: JSON.stringify({ status, peak_reaction_kN: 100 * text, initial_stiffness_kN_per_mm: 7, failure_mode: { name: "rocking" } }), reason: status === "completed" ? "" : "it flew away" },
  tables: { curve: { displacement_mm: Float64Array.of(0, 1), reaction_kN: Float64Array.of(0, 100 * text) } },
});

test("the nearest to the present value is pushed first, and what is known already is not pushed again", async () => {
  const { family: made, asked, pushed } = family((text) => wall(text), (text) => (text === "0.4" ? { name: "", summary: JSON.parse(wall(0.4).texts.summary), points: [[0, 0], [1, 40]] } : null));
  const words = await pushed();
  assert.deepEqual(asked, ["0.283", "0.566", "0.2"]); // 0.8 cannot be
  assert.match(words, /peak 40 kN stiffness 7 kN\/mm failure mode rocking/);
  assert.deepEqual(made.lines.map((l) => l.share), [0, 0.25, 0.75, 0.5]); // the chosen one above the others
});

test("the slider shows the nearest curve that there is; taking it is an edit after which the family stays", async () => {
  const { family: made, project, pushed } = family((text) => (text === "0.283" ? wall(text, "unstable") : wall(text)));
  await pushed();
  made.slide(3);
  assert.match(made.root.text, /peak 56.6 kN/);
  made.slide(1);
  assert.match(made.root.text, /0.283 m: it flew away/);
  made.slide(4);
  assert.match(made.root.text, /0.8 m: the drawing cannot take this value/);
  made.slide(3);
  made.takeIt();
  assert.equal(project.text, "0.566");
  made.edited();
  assert.equal(made.lines.length, 4);
  project.text = "another";
  made.edited();
  assert.equal(made.lines.length, 0);
  assert.match(made.root.text, /has changed since/);
});

test("an edit, a stop and closing end it: nothing more is asked and nothing is shown", async () => {
  for (const end of ["stop", "close", "edited"]) {
    const one = family((text) => {
      if (one.asked.length < 2) return wall(text);
      if (end === "edited") one.project.text = "another";
      one.family[end]();
      return { code: 3, texts: {}, tables: {} };
    });
    await one.pushed();
    assert.equal(one.asked.length, 2, end);
    assert.equal(one.family.running, false, end);
    assert.equal(one.stops(), 1, end);
    assert.equal(one.family.lines.length, end === "stop" ? 1 : 0, end);
  }
});

test("a wall that the engine refuses says why, and the others go on", async () => {
  const { family: made, pushed, asked } = family((text) => (text === "0.2" ? { code: 2, texts: { faults: JSON.stringify([{ problem: "is too thin" }]) }, tables: {} } : wall(text)));
  await pushed();
  assert.equal(asked.length, 4);
  made.slide(0);
  assert.match(made.root.text, /0.2 m: cannot be built: is too thin/);
});
