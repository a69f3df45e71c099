// The model file beside the drawing, faults at their places, and that nothing is lost: autosave, links, files.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { folder, root } from "./helpers.mjs";
import { launch, openStudio, stonesOf, studioPage, textOf } from "./studio.mjs";

let browser, file, page;
before(async () => {
  file = studioPage();
  browser = await launch();
  page = await openStudio(browser, file);
});
after(async () => {
  assert.deepEqual(page.faults, []);
  await browser?.close();
});
const write = async (change) => {
  await page.locator('[data-pane="file"].tab').click();
  await page.locator(".file-text").fill(change(await textOf(page)));
  await stonesOf(page);
};
const begin = async (name) => {
  await page.locator(".starters").selectOption(name);
  await stonesOf(page);
};
const outline = () => page.locator(".outline").evaluate((e) => e.getBoundingClientRect().width / e.getBoundingClientRect().height);

test("what is written in the file is drawn, and undone as one step", async () => {
  await begin("portal");
  const before = await textOf(page);
  await write((t) => t.replace('length = "3.50 m"', 'length = "5.84 m"'));
  await page.keyboard.press("Escape");
  await page.keyboard.press("f");
  assert.ok(Math.abs((await outline()) - 2) < 0.01);
  await page.keyboard.press("Control+z");
  assert.equal(await textOf(page), before);
});

test("what the drawing does not know stays through all gestures", async () => {
  await begin("portal");
  await write((t) => t.replace("[masonry]", "[project]  # for the sheet\nauthor = 'me'\n\n[masonry]"));
  await page.locator('[data-pane="numbers"].tab').click();
  await page.getByLabel("Height", { exact: true }).fill("3.65");
  await page.getByLabel("Height", { exact: true }).press("Enter");
  assert.match(await textOf(page), /height = "3\.65 m"[^]*\[project\] {2}# for the sheet\nauthor = 'me'/);
});

test("faults stand at their lines and on the opening; the cure is a button", async () => {
  await begin("facade");
  await write((t) => t.replace('x = "7.00 m"', 'x = "9.40 m"'));
  const list = page.locator(".faults");
  assert.match(await list.innerText(), /One thing to mend[^]*Line 76[^]*outside the wall/);
  assert.match(await page.locator('[data-opening="2"]').getAttribute("class"), /faulty/);
  assert.equal(await page.locator(".lines .bad").innerText(), "76\n");
  assert.equal(await page.locator(".primary").isDisabled(), true);
  await list.locator(".fault").click();
  const chosen = await page.locator(".file-text").evaluate((e) => e.value.slice(e.selectionStart, e.selectionEnd));
  assert.equal(chosen, 'x = "9.40 m"');
  await list.getByRole("button", { name: "Apply correction" }).click();
  await stonesOf(page);
  assert.match(await textOf(page), /x = "8\.5 m"\ny = "0\.90 m"\nwidth = "0\.8 m"/);
});

test("a broken text leaves the drawing as it was, and says which line", async () => {
  await begin("portal");
  await write((t) => t.replace('length = "3.50 m"', 'length = "3.50 m'));
  assert.match(await page.locator(".faults").innerText(), /Line 15/);
  assert.equal(await page.locator('.tool-button:has-text("Door")').isDisabled(), true);
  assert.equal(await page.locator('[data-opening="0"]').count(), 1);
});

test("one edit is asked at once; of several the last one", async () => {
  await begin("portal");
  const asked = await page.evaluate(async () => {
    const area = document.querySelector(".file-text"),
      real = Worker.prototype.postMessage,
      asked = [];
    let heard;
    Worker.prototype.postMessage = function (question) {
      if (question.task === "check") asked.push(question.texts.model.split("\n").at(-2)), heard?.();
      return real.call(this, question);
    };
    const isAsked = () => new Promise((done) => (heard = done));
    const edit = (line) => ((area.value += `${line}\n`), area.dispatchEvent(new Event("blur")));
    const rest = [];
    const { setTimeout } = window;
    window.setTimeout = (does, ms, ...more) => (rest.push(ms), setTimeout(does, ms, ...more));
    const now = performance.now.bind(performance);
    const late = now() + 1e6; // long after the edit before, and then no time passes
    performance.now = () => late;
    let next = isAsked();
    edit("# one");
    await next;
    const waits = [rest.filter((ms) => ms === 60).length];
    next = isAsked();
    for (const line of ["# two", "# three", "# four"]) edit(line);
    await next;
    waits.push(rest.filter((ms) => ms === 60).length);
    window.setTimeout = setTimeout;
    performance.now = now;
    Worker.prototype.postMessage = real;
    return { asked, waits };
  });
  assert.deepEqual(asked, { asked: ["# one", "# four"], waits: [0, 3] });
  await stonesOf(page);
});

test("what cannot be drawn is told, and its text is open to change", async () => {
  await begin("portal");
  await write((t) => t.replace('width = "1.00 m"', 'width = "1.00 furlong"'));
  assert.match(await page.locator(".reason").innerText(), /wall\.opening\.0\.width/);
  assert.equal(await page.locator(".file-text").isEditable(), true);
  await write((t) => t.replace("1.00 furlong", "1.25 m"));
  assert.equal(await page.locator(".reason").isVisible(), false);
});

test("the wall is back after the page was closed", async () => {
  await begin("pier");
  await write((t) => t.replace('name = "brick pier"', 'name = "my pier"'));
  await page.reload();
  await page.waitForSelector("html[data-ready]");
  assert.match(await textOf(page), /name = "my pier"/);
  await page.locator(".notice", { hasText: /Your wall is back/ }).waitFor();
});

test("a link holds the wall", async () => {
  await begin("arch");
  await page.getByRole("button", { name: "Link" }).click();
  await page.waitForFunction(() => location.hash.startsWith("#w="));
  const other = await openStudio(browser, file, { hash: new URL(page.url()).hash });
  assert.equal(await textOf(other), await textOf(page));
  assert.deepEqual(other.faults, []);
  await other.end();
});

test("a hostile link is refused in words, and no word of a file becomes markup", async () => {
  for (const hash of ["#w=AAAA", "#w=%3Cscript%3E", `#w=${"A".repeat(5000)}`]) {
    const other = await openStudio(browser, file, { hash });
    await other.locator(".notice", { hasText: /holds no wall/ }).waitFor();
    assert.deepEqual(other.faults, []);
    await other.end();
  }
  await begin("portal");
  const evil = `<img src=x onerror="document.title='owned'"><script>document.title='owned'</script>`;
  await write((t) => t.replace('name = "door"', `name = ${JSON.stringify(evil)}\nx_${"y".repeat(9)} = 1`).replace('name = "brick wall with a door"', `name = ${JSON.stringify(evil)}`));
  assert.equal(await page.locator("img").count(), 0);
  assert.notEqual(await page.title(), "owned");
  assert.ok((await page.locator(".faults").innerText()).includes("x_yyyyyyyyy"));
});

test("files: saved with every byte, opened, dropped, and refused where they are none", async () => {
  await begin("ring");
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save" }).click()]);
  const saved = fs.readFileSync(await download.path(), "utf8");
  assert.equal(saved, await textOf(page));
  assert.match(download.suggestedFilename(), /^[a-z0-9_]+\.toml$/);
  fs.mkdirSync(folder("studio"), { recursive: true });
  const copy = path.join(folder("studio"), `copy_${process.pid}.toml`);
  fs.writeFileSync(copy, saved.replace(/^name = .*/m, 'name = "opened"'));
  await page.locator('input[type="file"]').setInputFiles(copy);
  await page.waitForFunction(() => document.querySelector(".file-text").value.includes('name = "opened"'));
  fs.writeFileSync(copy, Buffer.from([0xff, 0xfe, 0x00, 0x80]));
  await page.locator('input[type="file"]').setInputFiles(copy);
  await page.waitForFunction(() => /is no text/.test(document.querySelector(".notice").textContent));
  await page.locator('input[type="file"]').setInputFiles({ name: "long.toml", mimeType: "", buffer: Buffer.alloc((1 << 20) + 1, "#") });
  await page.waitForFunction(() => /^long\.toml/.test(document.querySelector(".notice").textContent));
  assert.match(await page.locator(".notice").innerText(), /^long\.toml has 1\s?049 kB\. .* at most 1\s?048 kB/);
  assert.match(await textOf(page), /name = "opened"/);
});

test("a file with line ends of Windows is opened as one step, and looking at it is none", async () => {
  await begin("pier");
  const before = await textOf(page);
  const opened = before.replace('name = "brick pier"', 'name = "of Windows"');
  const name = `windows_${process.pid}.toml`;
  await page.locator('input[type="file"]').first().setInputFiles({ name, mimeType: "", buffer: Buffer.from(opened.replaceAll("\n", "\r\n")) });
  await page.waitForFunction(() => document.querySelector(".file-text").value.includes('name = "of Windows"'));
  await page.locator('[data-pane="file"].tab').click();
  await page.locator(".file-text").click();
  await page.locator(".canvas").focus();
  assert.equal(await textOf(page), opened);
  await page.keyboard.press("Control+z");
  assert.equal(await textOf(page), before);
});

test("a model that wythe studio put into the page opens once, and what became of it is kept", async () => {
  const model = `${fs.readFileSync(path.join(root, "examples/brick_pier/model.toml"), "utf8")}# dà, größer, </script>\n`;
  const own = path.join(folder("studio"), "with_model.html");
  fs.writeFileSync(own, fs.readFileSync(file, "utf8").replace("<!--wythe:model-->", Buffer.from(model).toString("hex")));
  const other = await openStudio(browser, own);
  assert.equal(await textOf(other), model);
  await other.locator('[data-pane="file"].tab').click();
  await other.locator(".file-text").fill(`${model}# mine\n`);
  await stonesOf(other);
  await other.reload();
  await stonesOf(other);
  assert.equal(await textOf(other), `${model}# mine\n`);
  assert.deepEqual(other.faults, []);
  await other.end();
});

// Pages that `wythe studio` made of models, and the plain one, opened one after another in one browser: they share its storage.
const made = (name, model) => {
  const own = path.join(folder("studio"), `${name}_${process.pid}.html`);
  fs.writeFileSync(own, fs.readFileSync(file, "utf8").replace("<!--wythe:model-->", Buffer.from(model).toString("hex")));
  return own;
};
const visit = async (other, address) => {
  await other.goto("about:blank");
  await other.goto(address.startsWith("file:") ? address : pathToFileURL(address).href);
  await other.waitForSelector("html[data-ready]");
  return textOf(other);
};
const add = (other, line) =>
  other.locator(".file-text").evaluate((area, line) => {
    area.value += line;
    area.dispatchEvent(new Event("blur"));
  }, line);
const undo = (other) => other.getByRole("button", { name: "Undo" }).click();
const pier = fs.readFileSync(path.join(root, "examples/brick_pier/model.toml"), "utf8");

test("each page with a model keeps the work on its own, and undo brings the wall of the plain page back", async () => {
  const [a, b] = [made("a", `${pier}# a\n`), made("b", `${pier}# b\n`)];
  const other = await openStudio(browser, file, { impatient: true });
  await add(other, "# plain\n");
  const plain = await textOf(other);
  assert.equal(await visit(other, a), `${pier}# a\n`);
  await other.locator(".notice", { hasText: /Undo brings your last wall back/ }).waitFor();
  await undo(other);
  assert.equal(await textOf(other), plain);
  await other.getByRole("button", { name: "Redo" }).click();
  await add(other, "# work on a\n");
  assert.equal(await visit(other, b), `${pier}# b\n`);
  await add(other, "# work on b\n");
  assert.equal(await visit(other, a), `${pier}# a\n# work on a\n`);
  await other.locator(".notice", { hasText: /Your wall is back/ }).waitFor();
  assert.equal(await visit(other, b), `${pier}# b\n# work on b\n`);
  assert.equal(await visit(other, file), plain);
  await other.end();
});

test("an edit after a link was made outlives a reload", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  await other.getByRole("button", { name: "Link" }).click();
  await other.waitForFunction(() => location.hash.startsWith("#w="));
  await add(other, "# newer\n");
  assert.equal(new URL(other.url()).hash, "");
  const newer = await textOf(other);
  await other.reload();
  await other.waitForSelector("html[data-ready]");
  assert.equal(await textOf(other), newer);
  await other.end();
});

test("another's link takes nothing away: undo brings the kept wall back, and it is kept until an edit", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  await other.getByRole("button", { name: "Link" }).click();
  await other.waitForFunction(() => location.hash.startsWith("#w="));
  const link = other.url(),
    linked = await textOf(other);
  await add(other, "# mine\n");
  assert.equal(await visit(other, link), linked);
  await other.locator(".notice", { hasText: /Undo brings your last wall back/ }).waitFor();
  assert.equal(await visit(other, file), `${linked}# mine\n`);
  await visit(other, link);
  await undo(other);
  assert.equal(await textOf(other), `${linked}# mine\n`);
  await other.end();
});

test("a link that is pasted into the open page opens its wall, and undo brings the own one back", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  await other.getByRole("button", { name: "Link" }).click();
  await other.waitForFunction(() => location.hash.startsWith("#w="));
  const { hash } = new URL(other.url()),
    linked = await textOf(other);
  await add(other, "# mine\n");
  await other.evaluate(() => (window.isBefore = true));
  await other.evaluate((hash) => (location.hash = hash), hash);
  await other.waitForFunction(() => !window.isBefore && document.documentElement.dataset.ready);
  assert.equal(await textOf(other), linked);
  await undo(other);
  assert.equal(await textOf(other), `${linked}# mine\n`);
  assert.deepEqual(other.faults, []);
  await other.end();
});

test("a model that the browser has no room to keep opens again, not another wall", async () => {
  const a = made("full", `${pier}# full\n`);
  const other = await openStudio(browser, file, { impatient: true });
  await add(other, "# plain\n");
  await other.evaluate(() => {
    for (let length = 1 << 22; length > 0; length >>= 1)
      for (let k = 0; k < 8; ++k)
        try {
          localStorage.setItem(`room ${length} ${k}`, "x".repeat(length));
        } catch {
          break;
        }
  });
  assert.equal(await visit(other, a), `${pier}# full\n`);
  await add(other, "# more\n");
  await other.locator(".notice", { hasText: /keeps nothing/ }).waitFor();
  assert.equal(await visit(other, a), `${pier}# full\n# more\n`); // the tab's own
  const second = await other.context().newPage();
  assert.equal(await visit(second, a), `${pier}# full\n`);
  await other.end();
});

test("a number that was typed and not entered is there after a reload", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  await other.getByLabel("Thickness", { exact: true }).fill("0.38");
  await other.reload();
  await other.waitForSelector("html[data-ready]");
  assert.match(await textOf(other), /thickness = "0\.38 m"/);
  await other.end();
});

// Answers the question that the page asks next, and gives its words.
const answered = (other, does) => new Promise((done) => other.once("dialog", (dialog) => (done(dialog.message()), dialog[does]())));

test("where the browser keeps nothing, closing asks and another language takes the wall along", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  await other.evaluate(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await other.locator(".canvas").click(); // a page that nobody touched asks nothing
  await add(other, "# mine\n");
  const mine = await textOf(other);
  const [dialog] = await Promise.all([other.waitForEvent("dialog"), other.close({ runBeforeUnload: true })]);
  assert.equal(dialog.type(), "beforeunload");
  await dialog.dismiss();
  const stays = answered(other, "dismiss"); // there is no room for the steps of undo
  await other.locator(".language").selectOption("it");
  assert.match(await stays, /would be lost: the steps of undo/);
  assert.equal(await other.locator(".language").inputValue(), "en");
  const goes = answered(other, "accept");
  await other.locator(".language").selectOption("it");
  await goes;
  await other.waitForSelector('html[data-ready][lang="it"]');
  assert.equal(await textOf(other), mine);
  await other.end();
});

test("of two tabs each has its own wall back, and undo brings that of the other", async () => {
  const one = await openStudio(browser, file, { impatient: true });
  const two = await one.context().newPage();
  await visit(two, file);
  await add(one, "# one\n");
  await add(two, "# two\n");
  const [first, second] = [await textOf(one), await textOf(two)];
  await one.reload();
  await one.waitForSelector("html[data-ready]");
  assert.equal(await textOf(one), first);
  await undo(one);
  assert.equal(await textOf(one), second);
  await one.end();
});

test("a tab that was never edited shows after a reload what it showed, and undo brings the other tab's wall", async () => {
  const model = `${pier}# given\n`;
  for (const address of [file, made("two_tabs", model)]) {
    const looks = await openStudio(browser, file, { impatient: true });
    const shown = await visit(looks, address);
    const works = await looks.context().newPage();
    await visit(works, address);
    await add(works, "# another's\n");
    for (let times = 0; times < 2; ++times) {
      await looks.reload();
      await looks.waitForSelector("html[data-ready]");
      assert.equal(await textOf(looks), shown);
      await looks.locator(".notice", { hasText: /Undo brings your last wall back/ }).waitFor();
    }
    await undo(looks);
    assert.equal(await textOf(looks), `${shown}# another's\n`);
    await looks.end();
  }
});

test("a tab that opens a link keeps its own wall: undo brings it back, and then that of the other tab", async () => {
  const one = await openStudio(browser, file, { impatient: true });
  await one.getByRole("button", { name: "Link" }).click();
  await one.waitForFunction(() => location.hash.startsWith("#w="));
  const link = one.url(),
    linked = await textOf(one);
  const two = await one.context().newPage();
  await visit(two, file);
  await add(one, "# one\n");
  await add(two, "# two\n");
  assert.equal(await visit(one, link), linked);
  await add(one, "# edited\n");
  for (const wall of [linked, `${linked}# one\n`, `${linked}# two\n`]) {
    await undo(one);
    assert.equal(await textOf(one), wall);
  }
  assert.equal(await visit(one, `${pathToFileURL(file).href}#w=AAAA`), `${linked}# two\n`); // what was shown last
  await add(two, "# more\n");
  await visit(one, `${pathToFileURL(file).href}#w=AAAA`);
  await one.locator(".notice", { hasText: /holds no wall/ }).waitFor();
  await one.end();
});

test("a browser that cannot pack makes a longer link, which any browser opens, and says that it cannot open a packed one", async () => {
  const other = await openStudio(browser, file, { impatient: true });
  await add(other, "# größer\n");
  const wall = await textOf(other);
  const link = async () => {
    await other.getByRole("button", { name: "Link" }).click();
    await other.waitForFunction(() => location.hash.startsWith("#w="));
    return other.url();
  };
  const packed = await link();
  await add(other, "# longer\n");
  for (const [name, stream] of Object.entries({ none: "undefined", "not of this kind": 'class { constructor(kind) { throw new TypeError(kind); } }' })) {
    await other.evaluate((stream) => (window.CompressionStream = eval(`(${stream})`)), stream);
    const long = await link();
    assert.ok(long.length > packed.length, name);
    const old = await other.context().newPage();
    await old.addInitScript((stream) => (window.CompressionStream = window.DecompressionStream = eval(`(${stream})`)), stream);
    for (const reader of [other, old]) assert.equal(await visit(reader, long), `${wall}# longer\n`, name);
    assert.equal(await visit(old, packed), `${wall}# longer\n`, name);
    await old.locator(".notice", { hasText: /too old to open the link/ }).waitFor();
    assert.equal(old.url(), packed, name);
    await old.close();
    assert.equal(await visit(other, packed), wall, name);
    await add(other, "# longer\n");
  }
  assert.deepEqual(other.faults, []);
  await other.end();
});

test("a page that nobody edited opens without a word, however often", async () => {
  const looks = await openStudio(browser, file, { impatient: true });
  await looks.reload();
  await looks.waitForSelector("html[data-ready]");
  assert.equal(await looks.locator(".notice").isVisible(), false);
  await looks.end();
});
