// wythe studio: the page for drawing walls, made of the engine in this package, with a model in it if one is named.
import { spawn } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { isSamePlace } from "./host.mjs";
import { builtOfPackage, pageOf } from "./page.mjs";
import { Refused, put } from "./refused.mjs";

const inPackage = (name) => fileURLToPath(new URL(name, import.meta.url));
const kMark = "<!--wythe:model-->";
const kTitle = "<title>wythe studio</title>";
const kLongest = 1 << 20; // of a file, as in web/src/studio/file/store.ts [bytes]

function modelText(file) {
  let bytes;
  try {
    bytes = fs.readFileSync(file);
  } catch (error) {
    throw new Refused(2, `${file}: cannot be read (${error.code}); name a model file`);
  }
  if (bytes.length > kLongest) throw new Refused(2, `${file}: is longer than 1 MB; name a model file`);
  let text;
  try {
    text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    throw new Refused(2, `${file}: holds bytes that are no UTF-8; name a model file`);
  }
  if (/^[ \t]*\[[ \t]*study[ \t]*\]/m.test(text)) throw new Refused(2, `${file}: is a study; name its base model`);
  return bytes;
}

// Opens the page if a user is at this terminal; returns whether a browser was started.
function openInBrowser(page) {
  if (!process.stdout.isTTY) return false;
  const [program, ...words] = { win32: ["explorer", page], darwin: ["open", page] }[process.platform] ?? ["xdg-open", page];
  if (program === "xdg-open" && !process.env.DISPLAY && !process.env.WAYLAND_DISPLAY) return false;
  spawn(program, words, { detached: true, stdio: "ignore" }).on("error", () => undefined).unref();
  return true;
}

/** Writes the page to `out` and opens it. */
export function studio(model, out) {
  const built = builtOfPackage();
  if (built === null) throw new Refused(2, "wythe studio: this package has no studio; in the sources, make studio puts it in");
  if (model && isSamePlace(model, out)) throw new Refused(2, `${out}: is what this command reads, and would be lost; name another file`);
  if (fs.existsSync(out)) {
    const earlier = fs.statSync(out).isFile() ? fs.readFileSync(out, "utf8") : "a folder";
    if (earlier !== "" && !earlier.slice(0, 400).includes(kTitle))
      throw new Refused(2, `${out}: is there, and is no earlier answer of this command; name another file, or remove this one`);
  }
  const text = model ? modelText(model).toString("hex") : ""; // in digits, so that no text of the model can end its element
  const page = pageOf(built, inPackage("wythe.cjs"), inPackage("wythe.wasm"));
  put(out, page.replace(kMark, text));
  const whole = path.resolve(out);
  console.log(`${openInBrowser(whole) ? "opens" : "open in a browser:"} ${whole}`);
}
