// In the place of the theme's script, which Debian packs as a module that a page from a file may not load. It follows the
// system's light or dark until somebody presses the button, and keeps what was pressed.
const dark = matchMedia("(prefers-color-scheme: dark)");
const root = document.documentElement;
root.classList.remove("no-js");
const kept = (theme) => {
  try {
    if (theme) localStorage.setItem("theme", theme);
    return localStorage.getItem("theme");
  } catch {
    return theme; // a browser that keeps nothing for files: the choice holds for this page
  }
};
const show = (theme) => {
  document.body.dataset.theme = theme ?? (dark.matches ? "dark" : "light");
};
show(kept());
dark.addEventListener("change", () => show(kept()));
for (const button of document.getElementsByClassName("theme-toggle"))
  button.addEventListener("click", () => {
    const theme = document.body.dataset.theme === "dark" ? "light" : "dark";
    kept(theme);
    show(theme);
  });
