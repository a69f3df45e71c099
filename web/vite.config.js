// One self-contained page, the same bytes on every machine: src/report/assets/viewer.html.
import { fileURLToPath } from "node:url";
import { rename } from "node:fs/promises";
import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";
import { textsOf } from "./texts_of.js";

const here = fileURLToPath(new URL(".", import.meta.url));
const folder = process.env.VIEWER_OUT ?? `${here}../src/report/assets`;

export default defineConfig({
  root: here,
  build: {
    outDir: folder,
    emptyOutDir: false,
    target: "es2022",
    modulePreload: false,
    reportCompressedSize: false,
    chunkSizeWarningLimit: 2000,
  },
  plugins: [
    textsOf("reports"),
    viteSingleFile({ removeViteModuleLoader: true }),
    {
      name: "viewer-name",
      closeBundle: () => rename(`${folder}/index.html`, `${folder}/viewer.html`),
    },
  ],
});
