// The committed page equals a fresh build; its size, its words, its packages.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";
import { textsOf } from "../../web/texts_of.js";
import { filesIn, folder, root } from "./helpers.mjs";

const assets = path.join(root, "src/report/assets");
const table = JSON.parse(fs.readFileSync(path.join(assets, "texts.json"), "utf8"));

test("the viewer's types are sound", () => {
  execFileSync("npx", ["tsc"], { cwd: path.join(root, "web"), stdio: "pipe" });
});

test("no type is left open", () => {
  const ts = createRequire(path.join(root, "web/package.json"))("typescript");
  const open = [];
  for (const name of filesIn(path.join(root, "web/src")).filter((f) => f.endsWith(".ts"))) {
    const file = ts.createSourceFile(name, fs.readFileSync(name, "utf8"), ts.ScriptTarget.Latest);
    const visit = (node) => {
      if (node.kind === ts.SyntaxKind.AnyKeyword)
        open.push(`${path.relative(root, name)}:${file.getLineAndCharacterOfPosition(node.pos).line + 1}`);
      ts.forEachChild(node, visit);
    };
    visit(file);
  }
  assert.deepEqual(open, [], "any");
});

test("the committed page equals a fresh build", () => {
  const out = folder("fresh");
  fs.mkdirSync(out, { recursive: true });
  execFileSync("npx", ["vite", "build"], {
    cwd: path.join(root, "web"),
    env: { ...process.env, VIEWER_OUT: out },
    stdio: "pipe",
  });
  const same = fs
    .readFileSync(path.join(out, "viewer.html"))
    .equals(fs.readFileSync(path.join(assets, "viewer.html")));
  assert.ok(same, "src/report/assets/viewer.html is not what web/ builds: run make web");
});

test("the page is within 1.2 MB and asks for nothing", () => {
  const page = fs.readFileSync(path.join(assets, "viewer.html"), "utf8");
  assert.ok(Buffer.byteLength(page) < 1.2e6, `${Buffer.byteLength(page)} bytes`);
  for (const door of [/<script[^>]+src=/, /<link[^>]+href="(?!data:)/, /@import/, /url\((?!#|"?data:)/])
    assert.doesNotMatch(page, door);
  assert.match(page, /default-src 'none'/);
  for (const mark of [
    "<!--wythe:headline-->",
    "<!--wythe:texts-->",
    "<!--wythe:data-->",
    "<title>wythe</title>",
    '<html lang="en"',
  ])
    assert.equal(page.split(mark).length, 2, mark);
});

test("no key stands twice in the table", () => {
  const [words, phrases] = fs.readFileSync(path.join(assets, "texts.json"), "utf8").split('\n"phrases": {');
  for (const part of [words, phrases]) {
    const keys = [...part.matchAll(/^("(?:[^"\\]|\\.)+"): \[/gm)].map((m) => m[1]);
    assert.ok(keys.length > 100);
    assert.deepEqual(keys.filter((key, k) => keys.indexOf(key) !== k), []);
  }
});

test("every text has all languages and the same places in each", () => {
  const places = (text) => (text.match(/\{\w*\}/g) ?? []).sort().join();
  for (const [key, row] of Object.entries(table.texts)) {
    assert.equal(row.length, table.languages.length, key);
    for (const text of row) {
      assert.notEqual(text.trim(), "", key);
      assert.equal(places(text), places(row[0]), key);
    }
  }
  for (const [english, others] of Object.entries(table.phrases)) {
    assert.equal(others.length, table.languages.length - 1, english);
    for (const text of others) assert.equal(places(text), places(english), english);
  }
});

test("every text that is asked for is in the table, and none is there for nothing", () => {
  const code = [...filesIn(path.join(root, "web/src")), ...filesIn(path.join(root, "src/report"))]
    .filter((f) => /\.(ts|cpp|h)$/.test(f))
    .map((f) => fs.readFileSync(f, "utf8"))
    .join("\n");
  const asked = [...code.matchAll(/say\(\s*"([^"]+)"/g)].map((m) => m[1]);
  assert.ok(asked.length > 150);
  for (const key of asked) if (!key.endsWith(".")) assert.ok(key in table.texts, `no text ${key}`);
  // keys put together at run time: `status.${...}`, "input." + key of model_inputs.cpp
  const prefixes = [
    ...code.matchAll(/say\(\s*[`"]([a-z_0-9.]+\.)(?:\$\{|")/g),
    ...code.matchAll(/say\([^)]*[?:]\s*"([a-z_0-9.]+)"/g),
    ...code.matchAll(/verdictWords\("([a-z_]+)"/g),
  ].map((m) => m[1]);
  for (const key of Object.keys(table.texts)) {
    const used =
      code.includes(`"${key}"`) ||
      prefixes.some((p) => key.startsWith(p)) ||
      /^(kind|untitled|assumption|measure|crack|curve|curves)\./.test(key);
    assert.ok(used, `${key} is never said`);
  }
});

test("in German a push is broken off or interrupted, two different words", () => {
  const german = (key) => table.texts[`studio.${key}`][table.languages.indexOf("de")];
  for (const key of ["button.stop", "do.stop", "stopped"]) assert.match(german(key), /abbrechen|abgebrochen/i, key);
  assert.match(german("do.pause"), /unterbrechen/);
});

test("the studio has the words of every failure mode that the engine names", () => {
  const code = fs.readFileSync(path.join(root, "src/judge/modes/mode_names.cpp"), "utf8");
  const all = (pattern) => [...code.matchAll(pattern)].map((m) => m[1]);
  const parts = all(/surest\("([^"]+)"/g); // of a wall, no modes
  const asked = all(/"((?:[^"\\]|\\.)*)"/g).filter((name) => name in table.phrases && !parts.includes(name));
  assert.ok(asked.length > 10);
  const made = JSON.parse(textsOf("studio").transform(JSON.stringify(table), "texts.json").code);
  assert.deepEqual([...new Set(asked.filter((name) => !(name in made.phrases)))], []);
});

test("the lock file names no registry", () => {
  const lock = fs.readFileSync(path.join(root, "web/package-lock.json"), "utf8");
  assert.doesNotMatch(lock, /"resolved"/);
  assert.doesNotMatch(lock, /https?:\/\/(?!opencollective|github|tidelift|www\.patreon)[^"]*registry/);
});
