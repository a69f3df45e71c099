// The page of a limit analysis. Most data are made here in the form of
// mechanisms.json, with the exact kinematics of three hinged bodies. The wall
// is that of a real run. The last test uses the page that the command wrote.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { deflateSync, inflateSync } from "node:zlib";
import { assertReadable, downloaded, folder, launch, open, pageOf, pdfPages, run, screenshot, viewerModule, violations } from "./helpers.mjs";
import { input, makeRun } from "./small_study.mjs";

const kHinges = [
  [0.62, 0],
  [0.31, 1.0],
  [1.55, 1.0],
  [1.86, 0],
];
const kBodies = [
  [
    "left pier",
    [
      [0, 0],
      [0.62, 0],
      [0.62, 0.88],
      [0.31, 1.0],
      [0, 1.32],
    ],
  ],
  [
    "spandrel",
    [
      [0, 1.32],
      [0.31, 1.0],
      [0.62, 0.88],
      [1.24, 0.88],
      [1.55, 1.0],
      [1.86, 1.32],
    ],
  ],
  [
    "right pier",
    [
      [1.24, 0],
      [1.86, 0],
      [1.86, 1.32],
      [1.55, 1.0],
      [1.24, 0.88],
    ],
  ],
];
const kWeights = [9, 4, 9]; // kN, at the middle of each body
const turned = ([x, y], [cx, cy], [nx, ny], t) => [
  nx + Math.cos(t) * (x - cx) - Math.sin(t) * (y - cy),
  ny + Math.sin(t) * (x - cx) + Math.cos(t) * (y - cy),
];

// Hinges and rotations of the closed chain when the first body has turned by t (clockwise: pushed to +x).
function pose(t) {
  const [c1, c12, c23, c3] = kHinges,
    long = Math.hypot(c23[0] - c12[0], c23[1] - c12[1]);
  const n12 = turned(c12, c1, c1, t);
  let turn = t;
  for (let k = 0; k < 40; ++k) {
    // Newton on the length of the middle body
    const gap = (a) => {
      const p = turned(c23, c3, c3, a);
      return Math.hypot(p[0] - n12[0], p[1] - n12[1]) - long;
    };
    turn -= gap(turn) / ((gap(turn + 1e-7) - gap(turn - 1e-7)) / 2e-7);
  }
  const n23 = turned(c23, c3, c3, turn);
  const middle = Math.atan2(n23[1] - n12[1], n23[0] - n12[0]) - Math.atan2(c23[1] - c12[1], c23[0] - c12[0]);
  return { hinges: [c1, n12, n23, c3], rotation: [t, middle, turn] };
}

function mechanism(mode, hypothesis, share) {
  const curve = {
    ends_where: "the force is zero",
    displacement_mm: [],
    force_kN: [],
    rotation_rad: [],
    rotation_ratio: [],
    hinges_m: [],
  };
  const load = [0, 1.1],
    middle = kBodies.map(([, o]) =>
      o.reduce((s, p) => [s[0] + p[0] / o.length, s[1] + p[1] / o.length], [0, 0]),
    );
  const heights = (p) =>
    middle.map((m, i) => turned(m, kHinges[i === 2 ? 3 : i], p.hinges[i === 2 ? 3 : i], p.rotation[i])[1]);
  for (let k = 0; k <= 120; ++k) {
    const t = (-0.3 * k) / 120,
      h = 1e-5,
      [a, b, p] = [pose(t - h), pose(t + h), pose(t)];
    const x = (q) => turned(load, kHinges[0], q.hinges[0], q.rotation[0])[0];
    const lift = heights(a).reduce((s, y, i) => s + kWeights[i] * (y - heights(b)[i]), 0) / (x(a) - x(b));
    if (k > 0 && lift < 0) break;
    curve.displacement_mm.push((x(p) - load[0]) * 1e3);
    curve.force_kN.push(share * lift);
    curve.rotation_rad.push(p.rotation);
    curve.rotation_ratio.push(p.rotation.map((r) => (t === 0 ? 1 : r / t)));
    curve.hinges_m.push(p.hinges);
  }
  return {
    name: `mechanism_${mode.toLowerCase().replace("-", "")}_${hypothesis}`,
    mode,
    hypothesis,
    force_at_rest_kN: curve.force_kN[0],
    displacement_without_force_mm: curve.displacement_mm.at(-1),
    rotation_ratios: curve.rotation_ratio[0],
    inputs: {
      compressive_strength: { value: hypothesis === "infinite" ? "unlimited" : 4, unit: "MPa" },
      thickness: { value: 0.31, unit: "m" },
    },
    hinge_names: ["C1", "C12", "C23", "C3"],
    hinges_m: kHinges,
    load_point_m: load,
    loaded_body: 0,
    direction: 1,
    curve,
    bodies: kBodies.map(([name, outline_m], i) => ({
      name,
      outline_m,
      loads: [{ kind: "self-weight", at_m: middle[i], fx_kN: 0, fy_kN: -kWeights[i] }],
    })),
    assessment: {
      clause: "Circolare 7/2019, C8.7.1.2.1",
      alpha0: 0.3,
      alpha0_by_weights: 0.28,
      participating_mass_kg: 2000,
      participating_mass_share: 0.9,
      acceleration0_m_per_s2: 3.1,
      displacement0_mm: 200,
      life_safety_displacement_mm: 80,
      near_collapse_displacement_mm: 120,
    },
  };
}

// 5 and 95 % of the runs.
const band = (mean) => ({
  percentile_5_kN: mean.map((v) => 0.95 * v),
  percentile_95_kN: mean.map((v) => 1.05 * v),
});

function opinion(blocks, name = "run") {
  const mechanisms = ["FM-1", "FM-4"].flatMap((mode, i) =>
    [
      ["infinite", 1],
      ["macro_block_1", 0.86],
      ["macro_block_2", 0.8],
    ].map(([h, s]) => mechanism(mode, h, s * (1 - 0.12 * i))),
  );
  const d = Array.from({ length: 40 }, (_, i) => i * 0.4),
    mean = d.map((x) => 11 * Math.min(1, x / 2) - 0.05 * x);
  const limit = (label, load) => ({
    name: label,
    joints: "dry",
    friction: "peak",
    crushing: "none",
    static_kN: load,
    kinematic_kN: load * (1 + 1e-9),
    gap: 1e-9,
    rows: 400,
    columns: 900,
    seconds: 0.4,
    velocity_x: Array.from({ length: blocks }, (_, b) => b / blocks),
    velocity_y: Array.from({ length: blocks }, () => 0.1),
    spin_per_m: Array.from({ length: blocks }, () => 0.2),
  });
  return {
    wythe: "0.1.0",
    refused: [{ what: ["FM-1 Macro-Block 2", "FM-1 Macro-Blocco 2"], why: "the spandrel is <b>one course</b> high" }],
    notes: [
      [
        "FM-4 Macro-Block 2: 12.00 kN at rest, more than the 11.00 kN of infinite strength: its moved hinges change the lever arm, take the lower value",
        "FM-4 Macro-Blocco 2: 12,00 kN all’inizio, più dei 11,00 kN con resistenza infinita: le cerniere spostate danno un altro braccio di leva, prendere il valore minore",
      ],
    ],
    mechanisms,
    limit_loads: [limit("dry", 9.5), limit("bonded", 21.5)],
    comparison: {
      with: `/home/someone/${name} <script>alert(1)`,
      runs: 3,
      groups: [
        {
          mode: "FM-4",
          mechanism: "mechanism_fm4_macro_block_2",
          runs: 3,
          mean_peak_kN: 11,
          mean_peak_ratio: 1.04,
          mean_post_peak_gap_kN: 0.7,
          mean_post_peak_gap_share_of_peak: 0.06,
        },
      ],
      bounds: [
        { run: "sample 1", peak_kN: 12, bound_kN: 21.5, allowance: 0.02, holds: true },
        { run: "sample 2", peak_kN: 23, bound_kN: 21.5, allowance: 0.02, holds: false },
      ],
      bracket: {
        low_kN: 9.5,
        high_kN: 21.5,
        least_peak_kN: 8,
        most_peak_kN: 23,
        runs: 3,
        below: 1,
        above: 1,
        nominal: true,
      },
      without_bound: [{ run: "sample 3", why: "it has no states" }],
      curves: [
        {
          run: "sample 1",
          mechanism: "mechanism_fm4_macro_block_2",
          peak_ratio: 1.1,
          post_peak_gap_kN: 0.7,
          post_peak_gap_share_of_peak: 0.06,
        },
      ],
      envelopes: {
        "FM-4": {
          displacement_mm: d,
          low_kN: mean.map((v) => 0.9 * v),
          mean_kN: mean,
          high_kN: mean.map((v) => 1.1 * v),
          ...(name === "limit_alone" ? {} : band(mean)),
          runs: d.map(() => 3),
        },
      },
    },
  };
}

// report.data of the run, with another header around the same wall.
function writeLimit(name, change) {
  const bytes = inflateSync(fs.readFileSync(path.join(folder("limit_run"), "report.data")));
  const length = bytes.readUInt32LE(8),
    header = JSON.parse(bytes.subarray(12, 12 + length));
  const text = Buffer.from(
    JSON.stringify({
      kind: "limit",
      title: "small wall",
      note: "",
      opinion: change(opinion(header.wall.blocks, name)),
      inputs: header.inputs,
      model_text: header.model_text,
      provenance: header.summary.provenance,
      wall: header.wall,
      arrays: header.arrays,
    }),
  );
  const padded = Buffer.concat([text, Buffer.alloc((8 - ((12 + text.length) % 8)) % 8, " ")]),
    head = Buffer.from(bytes.subarray(0, 12));
  head.writeUInt32LE(padded.length, 8);
  fs.mkdirSync(folder(name), { recursive: true });
  fs.writeFileSync(
    path.join(folder(name), "report.data"),
    deflateSync(Buffer.concat([head, padded, bytes.subarray(12 + length)])),
  );
  run("report", folder(name));
}

let browser, page, o;
before(async () => {
  makeRun("limit_run");
  writeLimit("limit", (made) => (o = made));
  run("limit", input("model.toml"), "--out", folder("limit_named"));
  browser = await launch();
  page = await open(browser, pageOf("limit"));
});
after(() => browser?.close());

test("opens without errors, requests or dialogs", () => assert.deepEqual(page.faults, []));

test("headline names the weakest mechanism, the bracket and what breaks it", async () => {
  const words = await page.locator("#headline").innerText();
  const least = Math.min(...o.mechanisms.map((m) => m.force_at_rest_kN));
  assert.ok(words.includes(`${Number(least.toPrecision(3))}`), words);
  assert.match(words, /between 9\.5\skN and 21\.5\skN/);
  assert.match(words, /Of the runs that were compared, 1 pass/);
});

test("every mechanism has its curve, every mode its picture, the runs their envelope", async () => {
  assert.equal(await page.locator("[data-mechanism]").count(), 6);
  assert.equal(await page.locator("svg.mechanism path.body").count(), 6);
  assert.equal(await page.locator("svg.mechanism circle.hinge").count(), 8);
  assert.equal(await page.locator("[data-envelope]").count(), 1);
});

test("the slider turns the bodies, hinges stay joined, and the curve's mark follows", async () => {
  const state = () =>
    page
      .locator("#mechanism-FM-1")
      .evaluate((f) => ({
        d: [...f.querySelectorAll("path.body")].map((p) => p.getAttribute("d")),
        mark: document.querySelector("#overlay-FM-1 .cursor-dot")?.getAttribute("cx"),
      }));
  const before = await state();
  await page.locator("#mechanism-FM-1 input[type=range]").focus();
  await page.keyboard.press("End");
  const end = await state();
  end.d.forEach((d, i) => assert.notEqual(d, before.d[i]));
  await page.keyboard.press("Home");
  assert.notDeepEqual((await state()).mark, before.mark);
  // C12 is a corner of the first and of the second body: they meet in every state
  for (const key of ["Home", "PageUp", "PageUp", "End"]) {
    await page.keyboard.press(key);
    const corners = (await state()).d.map((d) => d.replace(/[MZ]/g, "").split("L"));
    const near = (a, b) => Math.hypot(...a.split(" ").map((v, i) => v - b.split(" ")[i])) < 0.3;
    assert.ok(near(corners[0][3], corners[1][1]), key);
    assert.ok(near(corners[1][4], corners[2][3]), key);
  }
});

test("the mechanism starts within its chart, and the chart follows it beyond", async () => {
  const other = await open(browser, pageOf("limit"));
  const mark = () =>
    other.locator("#overlay-FM-4").evaluate((f) => {
      const axis = f.querySelector("clipPath rect"),
        dot = f.querySelector(".cursor-dot");
      const x = (e, name) => Number(e.getAttribute(name));
      return dot && [x(dot, "cx") >= x(axis, "x"), x(dot, "cx") <= x(axis, "x") + x(axis, "width")];
    });
  const ends = () => other.locator("#overlay-FM-4 text.tick").allTextContents();
  const before = await ends();
  assert.deepEqual(await mark(), [true, true]);
  await other.locator("#mechanism-FM-4 input[type=range]").focus();
  await other.keyboard.press("End");
  assert.deepEqual(await mark(), [true, true]);
  assert.notDeepEqual(await ends(), before);
  await other.keyboard.press("Home");
  assert.deepEqual(await ends(), before);
  await other.context().close();
});

test("runs show as a band of 5 to 95 % between their extremes, or as the extremes alone", async () => {
  assert.equal(await page.locator("#overlay-FM-4 path.extreme").count(), 2);
  assert.match(await page.locator("#overlay-FM-4 .legend").innerText(), /5 to 95\s% of the runs/);
  const rows = (await downloaded(page, () => page.locator("#overlay-FM-4 [data-export=csv]").click())).toString();
  for (const curve of ["low", "percentile_5", "mean", "percentile_95", "high"])
    assert.equal(rows.split(`runs_${curve},`).length - 1, o.comparison.envelopes["FM-4"].mean_kN.length, curve);
  writeLimit("limit_alone", (made) => made);
  const other = await open(browser, pageOf("limit_alone"));
  assert.equal(await other.locator("#overlay-FM-4 path.extreme").count(), 0);
  assert.match(await other.locator("#overlay-FM-4 .legend").innerText(), /smallest to largest run/);
  await other.context().close();
});

test("what was left out, what to doubt, and runs without a bound are said", async () => {
  const doubts = await page.locator("#doubts li").allInnerTexts();
  assert.equal(doubts.length, 2);
  assert.match(doubts[0], /^Left out: FM-1 Macro-Block 2: the spandrel is <b>one course<\/b> high/);
  assert.match(doubts[1], /take the lower value$/);
  const verdict = await page.locator("#verdict").innerText();
  assert.match(verdict, /Compared with limit <script>alert\(1\)\. /);
  assert.doesNotMatch(verdict, /someone/);
  assert.match(verdict, /9\.5\skN to 21\.5\skN[^]*1 below[^]*1 above/);
  assert.match(verdict, /Runs without a limit load of their own: 1; it has no states/);
  assert.match(await page.locator("#headline").innerText(), /Macro-Block 2: foot hinges moved inwards/);
});

test("numbers of the mechanisms have names in both languages", async () => {
  const { speak, say, knows } = await viewerModule("base/texts");
  const made = JSON.parse(fs.readFileSync(path.join(folder("limit_named"), "mechanisms.json"), "utf8"));
  for (const m of made.mechanisms)
    for (const name of Object.keys(m.inputs)) {
      assert.ok(knows(`number.${name}`), name);
      const words = ["en", "it"].map((code) => (speak(code), say(`number.${name}`)));
      assert.ok(words.every((w) => !w.includes("_")) && words[0] !== words[1], name);
    }
});

test("the Italian page has no English left in its numbers", async () => {
  run("report", folder("limit_named"), "--lang", "it");
  const other = await open(browser, pageOf("limit_named"));
  const words = await other.locator("#numbers").innerText();
  assert.match(words, /spalla sinistra dell’apertura[^]*verso della spinta/);
  assert.doesNotMatch(words, /opening|push|wall|block|inwards|weight/);
  assert.doesNotMatch(words, /\d\.\d/);
  assert.deepEqual(other.faults, []);
  await other.context().close();
});

test("the hypothesis can be chosen", async () => {
  const before = await page.locator("#mechanism-FM-4 .wall-caption").innerText();
  await page.locator("#mechanism-FM-4 select").selectOption({ index: 0 });
  assert.notEqual(await page.locator("#mechanism-FM-4 .wall-caption").innerText(), before);
});

test("limit loads, verdict and numbers have their rows", async () => {
  assert.equal(await page.locator("#limit-loads tbody tr").count(), 2);
  assert.ok((await page.locator("#collapse path.stone").count()) > 0);
  assert.match(await page.locator("#verdict").innerText(), /sample 2[^]*no/);
  assert.equal(await page.locator("#numbers table").first().locator("tbody tr").count(), 2);
});

test("figures export what can be read", async () => {
  for (const id of ["overlay-FM-4", "mechanism-FM-4", "collapse"]) {
    const svg = (
      await downloaded(page, () => page.locator(`[id="${id}"] [data-export=svg]`).click())
    ).toString();
    assert.equal(
      await page.evaluate(
        (t) =>
          new DOMParser().parseFromString(t, "image/svg+xml").querySelector("parsererror")?.textContent ?? "",
        svg,
      ),
      "",
    );
    assert.ok(
      (await downloaded(page, () => page.locator(`[id="${id}"] [data-export=csv]`).click()))
        .toString()
        .split("\n").length > 20,
    );
  }
});

test("without mechanisms, loads or runs the page says so", async () => {
  writeLimit("limit_nothing", (made) => ({
    ...made,
    mechanisms: [],
    limit_loads: [],
    comparison: null,
    refused: [],
    notes: [],
  }));
  const other = await open(browser, pageOf("limit_nothing"));
  assert.match(await other.locator("main").innerText(), /Nothing was asked for[^]*No runs were compared/);
  assert.deepEqual(other.faults, []);
  await other.context().close();
});

test("axe finds nothing, in light and dark, wide and narrow", () => assertReadable(browser, "limit"));

test("prints as an appendix of A4 pages", async () => {
  const pages = pdfPages(await page.pdf({ preferCSSPageSize: true }));
  assert.ok(pages >= 3 && pages <= 5, `${pages} pages`);
});

test("the command's own page has its mechanisms, loads, picture and comparison", async () => {
  run("limit", input("model.toml"), "--out", folder("limit_real"), "--with", folder("limit_run"), "--assessment");
  const made = JSON.parse(fs.readFileSync(path.join(folder("limit_real"), "mechanisms.json"), "utf8"));
  const modes = new Set(made.mechanisms.map((m) => m.mode));
  assert.ok(made.mechanisms.length >= 4 && modes.size === 2 && made.limit_loads.length >= 2);
  const other = await open(browser, pageOf("limit_real"));
  assert.deepEqual(other.faults, []);
  const least = Math.min(...made.mechanisms.map((m) => m.force_at_rest_kN));
  assert.ok((await other.locator("#headline").innerText()).includes(`${Number(least.toPrecision(3))}`));
  assert.equal(await other.locator("[data-mechanism]").count(), made.mechanisms.length);
  assert.equal(await other.locator("svg.mechanism").count(), modes.size);
  assert.equal(await other.locator("#limit-loads tbody tr").count(), made.limit_loads.length);
  const stones = await other.locator("#collapse path.stone").evaluateAll((e) => e.map((p) => p.getAttribute("d")));
  assert.ok(stones.length > 0 && stones.every((d) => !d.includes("NaN")));
  const verdict = await other.locator("#verdict").innerText();
  for (const b of made.comparison.bounds) assert.ok(verdict.includes(b.run), verdict);
  assert.deepEqual(await violations(other), []);
  await screenshot(other, "limit_real_1440_light");
  await other.context().close();
});
