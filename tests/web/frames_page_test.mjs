// Frames on the page of a run, in the plane and in space: N, V, M and use drawn along their members, against frames.csv
// and closed forms.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { downloaded, folder, launch, open, pageOf, pdfPages, root, run, screenshot, violations } from "./helpers.mjs";

// The how-to's wall, fast and not pushed to its end, with slighter columns.
function howToWall() {
  const text = fs.readFileSync(path.join(root, "docs/howto/frame.md"), "utf8");
  const blocks = [...text.matchAll(/```toml\n([^]*?)```/g)].map((m) => m[1]);
  return blocks.slice(0, 2).join("\n").replace('until = "20 mm"', 'until = "3 mm"\nvelocity = "10 mm/s"').replace('profile = "HEB 120"', 'profile = "HEB 100"');
}

// The same along a line in plan that no axis of the model runs along.
const inSpace = () =>
  howToWall()
    .replace('length = "3.6 m"\n', "")
    .replace("[[wall.opening]]", '[[plan_wall]]\nname = "front"\nline = [["1 m", "2 m"], ["3.16 m", "4.88 m"]]\n\n[[plan_wall.opening]]')
    .replace('round = "shop"', 'round = "shop"\nwall = "front"')
    .replace('at = { x = "0 m", y = "2.7 m" }', 'at = { block = "front.c13*" }\nalong = [0.6, 0, 0.8]');

// A portal over a block that it does not touch, pushed at its left corner, under a larger one that nothing loads. The
// section is slender, so that neither shear nor axial force lengthens anything: HEB 200 with 40 times its areas.
const kSpan = 4,
  kHeight = 3;
const frame = (name, x0, x1, y, feet) => `[[frame]]
name = "${name}"
line = [["${x0} m", "0 m"], ["${x0} m", "${y} m"], ["${x1} m", "${y} m"], ["${x1} m", "0 m"]]
feet = "${feet}"
section = { height = "200 mm", width = "200 mm", area = "3124 cm^2", shear_area = "996 cm^2", second_moment = "5696 cm^4", plastic_modulus = "642.5 cm^3", mass = "61.3 kg/m" }
grade = "S235"
joint = "joint"
`;
const kPortal = `[wall]
length = "1 m"
height = "0.5 m"
thickness = "0.3 m"
unit = { length = "1 m", height = "0.5 m", split = "none", density = "2000 kg/m^3" }
[material.joint]
normal_stiffness = "60 GPa/m"
shear_stiffness = "30 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "26.6 deg"
residual_friction_angle = "26.6 deg"
compressive_strength = "unlimited"
${frame("F1", -1.5, 2.5, kHeight, "fixed")}${frame("F2", -2.5, 3.5, 4, "hinged")}
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { x = "-1.55 m", y = "2.95 m", width = "0.1 m", height = "0.1 m" }
velocity = "0.5 mm/s"
until = "1 mm"
[solve]
gravity = "0 m/s^2"
raise_light_inertia = false
`;

let browser;
const kWalls = { framed: howToWall, framed_in_space: inSpace },
  walls = {}; // of each: its table and its page
function make(name, text) {
  fs.mkdirSync(folder("inputs"), { recursive: true });
  fs.rmSync(folder(name), { recursive: true, force: true });
  const file = path.join(folder("inputs"), `${name}.toml`);
  fs.writeFileSync(file, text);
  run("run", file, "--out", folder(name), "--quiet", "--threads", "1");
  const [head, ...rows] = fs.readFileSync(path.join(folder(name), "frames.csv"), "utf8").trim().split("\n");
  const names = head.split(",");
  return rows.map((line) => Object.fromEntries(line.split(",").map((cell, i) => [names[i], Number.isNaN(Number(cell)) ? cell : Number(cell)])));
}

before(async () => {
  browser = await launch("--use-angle=swiftshader", "--enable-unsafe-swiftshader");
  for (const [name, text] of Object.entries(kWalls)) {
    const table = make(name, text());
    walls[name] = { table, page: await open(browser, pageOf(name)) };
  }
});
after(() => browser?.close());
const inBoth = (name, check) => {
  for (const wall of Object.keys(kWalls)) test(`${name} (${wall})`, () => check(walls[wall]));
};

const show = (p, what) => p.locator(`#frame-forces button[data-carried=${what}]`).click();
// Of each member: the values, and where the axis and the ends of the ordinates are [px].
const lines = (p) =>
  p.locator("#frame-forces").evaluate((figure) => {
    const points = (path) =>
      path
        .getAttribute("d")
        .slice(1)
        .split("L")
        .map((pair) => pair.split(" ").map(Number));
    const tips = [...figure.querySelectorAll(".ordinate-line")];
    const axes = [...figure.querySelectorAll(".member-axis")];
    return tips.map((line, i) => ({ values: line.dataset.values.split(" ").map(Number), tips: points(line), at: points(axes[i]) }));
  });
const atDisplacement = (table, mm) => {
  const off = table.map((row) => Math.abs(row.displacement_mm - mm)),
    least = Math.min(...off);
  assert.ok(least <= 1e-3 * mm + 1e-6, `no row at ${mm} mm`);
  const at = table[off.indexOf(least)].displacement_mm;
  return table.filter((row) => row.displacement_mm === at);
};

inBoth("every state has the values of frames.csv, with their signs", async ({ page, table }) => {
  const csv = (await downloaded(page, () => page.locator("#frame-forces [data-export=csv]").click())).toString().trim().split("\n");
  const head = csv[0].split(","),
    rows = csv.slice(1).map((line) => line.split(","));
  assert.deepEqual(head, Object.keys(table[0]));
  const largest = (column) => Math.max(...table.map((row) => Math.abs(row[column])));
  const displacements = [...new Set(rows.map((r) => Number(r[0])))];
  assert.ok(displacements.length > 20, `${displacements.length} states`);
  for (const mm of displacements.filter((d) => d > 0.01)) {
    const here = rows.filter((r) => Number(r[0]) === mm),
      wanted = atDisplacement(table, mm);
    assert.equal(here.length, wanted.length);
    here.forEach((r, k) => {
      assert.deepEqual([r[1], r[2]], [wanted[k].frame, wanted[k].member]);
      assert.ok(Math.abs(Number(r[3]) - wanted[k].place_m) < 1e-5);
      // rounded to 16 bits of the largest
      for (const [i, column] of [[4, "N_kN"], [5, "V_kN"], [6, "M_kNm"], [7, "use"]])
        assert.ok(Math.abs(Number(r[i]) - wanted[k][column]) < 1e-4 * largest(column), `${column} at ${mm} mm, ${k}: ${r[i]}, ${wanted[k][column]}`);
    });
  }
});

inBoth("ordinates are as long as their values, the moment on the side that is stretched", async ({ page, table }) => {
  const columns = { moment: "M_kNm", shear: "V_kN", normal: "N_kN" };
  const last = atDisplacement(table, table[table.length - 1].displacement_mm);
  await page.locator("#frame-forces .time input").focus();
  await page.keyboard.press("End");
  for (const [what, column] of Object.entries(columns)) {
    await show(page, what);
    const members = await lines(page);
    assert.equal(members.length, 3);
    const values = members.flatMap((m) => m.values);
    assert.equal(values.length, last.length);
    const largest = Math.max(...last.map((row) => Math.abs(row[column])));
    values.forEach((v, k) => assert.ok(Math.abs(v - last[k][column]) < 1e-3 * largest, `${what} ${k}: ${v}, ${last[k][column]}`));
    const scale = [];
    members.forEach((m, i) =>
      m.values.forEach((v, k) => {
        const [dx, dy] = [m.tips[k][0] - m.at[k][0], m.tips[k][1] - m.at[k][1]];
        if (Math.abs(v) < 0.2 * largest) return;
        scale.push(Math.hypot(dx, dy) / Math.abs(v));
        // outside: of the left column to the left, of the beam up, of the right column to the right; M + is inside
        const outside = [-dx, -dy, dx][i],
          positive = what === "moment" ? -1 : 1;
        assert.ok(Math.sign(outside) === positive * Math.sign(v), `${what}, member ${i}, section ${k}: ${v} at ${dx}, ${dy}`);
      }),
    );
    assert.ok(scale.length > 5 && Math.max(...scale) < 1.03 * Math.min(...scale), `${what}: ${scale}`);
  }
});

inBoth("the largest value of each diagram is written beside it, with its unit", async ({ page, table }) => {
  const last = atDisplacement(table, table[table.length - 1].displacement_mm);
  for (const [what, column, unit] of [["moment", "M_kNm", "kNm"], ["shear", "V_kN", "kN"], ["normal", "N_kN", "kN"]]) {
    await show(page, what);
    const most = last.reduce((a, b) => (Math.abs(b[column]) > Math.abs(a[column]) ? b : a));
    const bold = page.locator("#frame-forces svg text.strong");
    assert.equal(await bold.count(), 1);
    const words = (await bold.textContent()).replace("−", "-");
    assert.ok(words.endsWith(`\u202f${unit}`), words);
    assert.ok(Math.abs(parseFloat(words) - most[column]) < 0.006 * Math.abs(most[column]), `${words}, ${most[column]}`);
    assert.equal(Number(await bold.getAttribute("data-section")), last.indexOf(most));
    // no number lies on another
    const boxes = await page.locator("#frame-forces svg text").evaluateAll((all) => all.map((t) => t.getBoundingClientRect().toJSON()));
    boxes.forEach((a, i) =>
      boxes.slice(i + 1).forEach((b) => {
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left),
          up = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        assert.ok(across < 1 || up < 4, `${what}: ${JSON.stringify([a, b])}`);
      }),
    );
    const alt = await page.locator("#frame-forces svg[role=img]").getAttribute("aria-label");
    assert.ok(alt.replace("−", "-").includes(words), alt);
  }
});

inBoth("use colours the segments, and the table has the largest of each member", async ({ page, table }) => {
  await show(page, "use");
  const last = atDisplacement(table, table[table.length - 1].displacement_mm);
  const bounds = [0.1, 0.25, 0.5, 0.75, 0.9, 1];
  const classes = await page.locator("svg.frame-forces .member-use").evaluateAll((all) => all.map((e) => e.classList[1]));
  const most = Math.max(...last.map((row) => row.use));
  const top = bounds.filter((b) => most >= b).length;
  assert.ok(classes.includes(`r${top}`) && !classes.includes(`r${top + 1}`), classes.join());
  const rows = await page.locator("#frame-numbers tbody tr").allInnerTexts();
  assert.deepEqual(rows.length, 3);
  ["left column", "beam", "right column"].forEach((member, i) => {
    const mine = last.filter((row) => row.member === member);
    const cells = rows[i].replaceAll("−", "-").match(/-?\d+(\.\d+)?(?=\s*\n|\s+(foot|head|left|right|[\d.]+\s*m))/g).map(Number);
    for (const column of ["M_kNm", "V_kN", "N_kN", "use"]) {
      const wanted = mine.reduce((a, b) => (Math.abs(b[column]) > Math.abs(a[column]) ? b : a))[column];
      assert.ok(cells.some((c) => Math.abs(c - wanted) <= 0.006 * Math.abs(wanted) + 0.005), `${member} ${column}: ${wanted} in ${rows[i]}`);
    }
  });
});

test("the keyboard chooses what is drawn and steps through the push", async () => {
  const { page } = walls.framed;
  const moment = page.locator("#frame-forces button[data-carried=moment]");
  await moment.focus();
  await page.keyboard.press("Enter");
  assert.equal(await moment.getAttribute("aria-pressed"), "true");
  const drawn = () => page.locator("#frame-forces .ordinate-line").first().getAttribute("d");
  const words = () => page.locator("#frame-forces .wall-caption").innerText();
  const end = [await drawn(), await words(), await page.locator("#frame-numbers").innerText()];
  await page.locator("#frame-forces .time input").focus();
  await page.keyboard.press("Home");
  const start = [await drawn(), await words(), await page.locator("#frame-numbers").innerText()];
  end.forEach((v, i) => assert.notEqual(v, start[i]));
  await page.keyboard.press("End");
  assert.equal(await drawn(), end[0]);
  assert.match(await page.locator("#frame-forces .time input").getAttribute("aria-valuetext"), /mm.*moment M/);
  assert.deepEqual(page.faults, []);
});

test("the drawing exports as SVG and PNG with its own colours", async () => {
  const { page } = walls.framed;
  const press = (kind) => downloaded(page, () => page.locator(`#frame-forces [data-export=${kind}]`).click());
  for (const what of ["moment", "use"]) {
    await show(page, what);
    const svg = (await press("svg")).toString();
    const colours = new Set([...svg.matchAll(/(?:fill|stroke)="([^"]*)"/g)].map((m) => m[1].replace(/\(.*/, "")));
    assert.deepEqual([...colours].filter((c) => !/^(none|rgba?|#.*)$/.test(c)), [], what);
    assert.equal(svg.includes("data-values"), what === "moment");
    assert.equal((await press("png")).subarray(1, 4).toString(), "PNG");
  }
});

test("no fault of accessibility; a phone scrolls nothing sideways; paper has all three diagrams", async () => {
  const { page } = walls.framed;
  for (const [width, scheme] of [[1440, "light"], [1440, "dark"], [390, "light"]]) {
    const other = await open(browser, pageOf("framed"), { width, scheme });
    assert.deepEqual(await violations(other), []);
    assert.equal(await other.evaluate(() => document.documentElement.scrollWidth), width);
    for (const what of ["moment", "normal", "use"]) {
      await show(other, what);
      await screenshot(other, `frame_${what}_${width}_${scheme}`, "#frames");
    }
    assert.deepEqual(other.faults, []);
    await other.context().close();
  }
  const drawings = await page.evaluate(() => {
    window.dispatchEvent(new Event("beforeprint"));
    const layers = [...document.querySelectorAll("#frame-forces .members")].map((e) => e.dataset.carried);
    window.dispatchEvent(new Event("afterprint"));
    return { layers, after: document.querySelectorAll("#frame-forces .members").length };
  });
  assert.deepEqual(drawings, { layers: ["moment", "shear", "normal"], after: 1 });
  assert.ok(pdfPages(await page.pdf({ format: "A4" })) <= 7);
});

test("a page in Italian has Italian words", async () => {
  run("report", folder("framed"), "--lang", "it");
  const other = await open(browser, pageOf("framed"));
  const words = await other.locator("#frames").innerText();
  for (const word of ["Telaio", "Lungo il telaio", "impegno", "asta", "Montante sinistro", "piede", "teso"]) assert.ok(words.includes(word), word);
  for (const word of ["frame", "column", "stretched", "member", "foot"]) assert.ok(!new RegExp(`\\b${word}\\b`).test(words), word);
  await screenshot(other, "frame_it", "#frames");
  await other.context().close();
  run("report", folder("framed"), "--lang", "en");
});

// Fixed feet, both sections alike, k = height / span: M at the feet is H h/2 (3k + 1)/(6k + 1), at the tops H h/2 3k/(6k + 1).
// Pushed to the right, the left column is stretched outside at its foot and inside at its top.
test("the moment of a portal is drawn on the right side, as large as the textbook has it", async () => {
  const rows = make("portal", kPortal);
  const curve = fs.readFileSync(path.join(folder("portal"), "force_displacement.csv"), "utf8").trim().split("\n");
  const force = Number(curve[curve.length - 1].split(",")[curve[0].split(",").indexOf("base_shear_kN")]);
  const other = await open(browser, pageOf("portal"));
  await other.locator("#frame-forces .time input").focus();
  await other.keyboard.press("End");
  await show(other, "moment");
  const [left, beam, right] = await lines(other);
  const k = kHeight / kSpan,
    foot = ((force * kHeight) / 2) * ((3 * k + 1) / (6 * k + 1)),
    top = ((force * kHeight) / 2) * ((3 * k) / (6 * k + 1));
  const end = (m) => m.values.length - 1;
  const reach = (m, i) => [m.tips[i][0] - m.at[i][0], m.tips[i][1] - m.at[i][1]];
  const unit = Math.hypot(...reach(left, 0)) / foot; // pixels of a kNm
  assert.ok(unit > 0);
  // [member, section, value, direction on the screen]
  for (const [m, i, value, [sx, sy]] of [
    [left, 0, -foot, [-1, 0]],
    [left, end(left), top, [1, 0]],
    [beam, 0, top, [0, 1]],
    [beam, end(beam), -top, [0, -1]],
    [right, 0, -top, [1, 0]],
    [right, end(right), foot, [-1, 0]],
  ]) {
    // 1 %: axial and shear flexibility of the section left, and the swing of the push
    assert.ok(Math.abs(m.values[i] - value) < 0.01 * foot, `${m.values[i]} for ${value}`);
    const [dx, dy] = reach(m, i);
    assert.ok(Math.abs(dx * sx + dy * sy - unit * Math.abs(value)) < 0.02 * unit * foot, `${dx}, ${dy} for ${value}`);
  }
  // straight between, for nothing loads a member
  const half = left.values[4];
  assert.ok(Math.abs(half - (top - foot) / 2) < 0.01 * foot, `${half}`);
  assert.ok(rows.length > 0);
  assert.equal(await other.locator("#frame-forces .foot-hinge").count(), 0);
  await screenshot(other, "frame_portal", "#frames");
  assert.match(await other.locator("#frames").innerText(), /Frame F2 carries nothing\./);
  // the other one carries nothing, and stands on hinges
  await other.locator("#frame-forces select").selectOption("F2");
  assert.equal(await other.locator("#frame-forces .foot-hinge").count(), 2);
  assert.equal(await other.locator("#frame-forces svg text").count(), 0);
  for (const m of await lines(other)) assert.deepEqual(new Set(m.values), new Set([0]));
  assert.deepEqual(other.faults, []);
  await other.context().close();
});

// Masonry round the frame is what its plane cuts; where the wall was cut out there is none.
test("a frame in space stands among the units of its wall", async () => {
  const { page } = walls.framed_in_space;
  await show(page, "moment");
  const { units, inside } = await page.locator("svg.frame-forces").evaluate((picture) => {
    const box = (path) => path.getBBox(),
      members = [...picture.querySelectorAll(".member-axis")].map(box);
    const [left, , right] = members,
      behind = [...picture.querySelectorAll(".behind path")].map(box);
    const middle = (b) => [b.x + b.width / 2, b.y + b.height / 2];
    const holds = ([x, y]) => x > left.x + 15 && x < right.x - 15 && y > left.y + 15;
    return { units: behind.length, inside: behind.filter((b) => holds(middle(b))).length };
  });
  assert.ok(units > 100, `${units} outlines`);
  assert.equal(inside, 0);
  assert.deepEqual(page.faults, []);
  for (const what of ["moment", "use"]) {
    await show(page, what);
    await screenshot(page, `frame_in_space_${what}`, "#frames");
  }
  assert.deepEqual(await violations(page), []);
  const phone = await open(browser, pageOf("framed_in_space"), { width: 390 });
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  await screenshot(phone, "frame_in_space_390", "#frames");
  await phone.context().close();
});
