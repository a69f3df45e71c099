// The theme's script, as Debian packs it, asks for a module that a page from a file may not load, so it never runs.
// This one stands in its place and does what is needed: the button that goes from the system's colours to dark and light.
document.documentElement.classList.remove("no-js");
addEventListener("DOMContentLoaded", () => {
  const show = (theme) => {
    document.body.dataset.theme = theme;
    try {
      localStorage.setItem("theme", theme);
    } catch {
      // a browser that keeps nothing for files: the choice holds for this page
    }
  };
  for (const button of document.getElementsByClassName("theme-toggle"))
    button.addEventListener("click", () => {
      const system = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
      const now = document.body.dataset.theme === "auto" ? system : document.body.dataset.theme;
      show(now === "dark" ? "light" : "dark");
    });
});
