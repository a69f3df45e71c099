// Where a page has its texts from. A report reads those of its language from an element that the engine fills
// (texts_for_page, src/report/texts.h). The studio carries all languages of what it says, out of src/report/assets/texts.json.
const kStrengths = ["unit_strength", "mortar_strength", "masonry_strength", "initial_shear_strength", "friction_tan", "youngs_modulus", "vertical_stress"];
const kShared = [...kStrengths.map((key) => `input.${key}`), "theme", "theme.auto", "theme.light", "theme.dark", "unlimited", "run.resists", "origin.title", "origin.typical", "origin.derived"];

// Failure modes as the engine names them.
const kModes = ["unclear", "rocking", "flexure", "flexural crack", "flexural cracks", "rocking or flexure", "shear", "pier shear", "spandrel shear", "diagonal shear crack",
  "sliding", "sliding at the base", "sliding at the top", "base sliding", "top sliding", "bed sliding", "pier sliding", "pier rocking", "crushing", "toe crushing", "arch hinges", "breaking away", "part breaking away", "fallen", "collapsed"];

export function textsOf(page) {
  const wanted = (key) => key.startsWith("studio.") || kShared.includes(key);
  if (page !== "studio")
    return {
      name: "texts-of-the-page",
      enforce: "pre",
      resolveId: (id) => (id.endsWith("texts.json") ? "\0texts" : null),
      load: (id) => (id === "\0texts" ? 'export default JSON.parse(document.getElementById("wythe-texts").textContent);' : null),
    };
  return {
    name: "texts-of-the-page",
    enforce: "pre",
    transform(code, id) {
      if (!id.endsWith("texts.json")) return null;
      const table = JSON.parse(code);
      table.texts = Object.fromEntries(Object.entries(table.texts).filter(([key]) => wanted(key)));
      table.phrases = Object.fromEntries(Object.entries(table.phrases).filter(([english]) => kModes.includes(english)));
      return { code: JSON.stringify(table, null, 0), map: null };
    },
  };
}
