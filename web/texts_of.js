// Texts of one page out of the table of all, src/report/assets/texts.json: reports carry no word of the studio, and
// the studio of the reports only what it says.
const kShared = ["theme", "theme.auto", "theme.light", "theme.dark", "unlimited", "run.resists"];

// Failure modes as the engine names them.
const kModes = ["unclear", "rocking", "flexure", "flexural crack", "flexural cracks", "rocking or flexure", "shear", "pier shear", "spandrel shear", "diagonal shear crack",
  "sliding", "base sliding", "top sliding", "bed sliding", "pier sliding", "pier rocking", "crushing", "toe crushing", "breaking away", "part breaking away", "fallen", "collapsed"];

export function textsOf(page) {
  const wanted = (key) => (page === "studio" ? key.startsWith("studio.") || kShared.includes(key) : !key.startsWith("studio."));
  return {
    name: "texts-of-the-page",
    enforce: "pre",
    transform(code, id) {
      if (!id.endsWith("texts.json")) return null;
      const table = JSON.parse(code);
      table.texts = Object.fromEntries(Object.entries(table.texts).filter(([key]) => wanted(key)));
      if (page === "studio") table.phrases = Object.fromEntries(Object.entries(table.phrases).filter(([english]) => kModes.includes(english)));
      return { code: JSON.stringify(table, null, 0), map: null };
    },
  };
}
