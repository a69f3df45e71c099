// Texts of one page out of the table of all, src/report/assets/texts.json: reports carry no word of the studio, and
// the studio of the reports only what it says.
const kShared = ["theme", "theme.auto", "theme.light", "theme.dark", "unlimited", "run.resists"];

export function textsOf(page) {
  const wanted = (key) => (page === "studio" ? key.startsWith("studio.") || kShared.includes(key) : !key.startsWith("studio."));
  return {
    name: "texts-of-the-page",
    enforce: "pre",
    transform(code, id) {
      if (!id.endsWith("texts.json")) return null;
      const table = JSON.parse(code);
      table.texts = Object.fromEntries(Object.entries(table.texts).filter(([key]) => wanted(key)));
      if (page === "studio") table.phrases = {};
      return { code: JSON.stringify(table, null, 0), map: null };
    },
  };
}
