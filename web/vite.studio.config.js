// The studio as one self-contained page: STUDIO_OUT/studio.html, or build/studio.html.
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";
import { textsOf } from "./texts_of.js";

const here = fileURLToPath(new URL(".", import.meta.url));

export default defineConfig({
  root: here,
  build: {
    outDir: process.env.STUDIO_OUT ?? `${here}../build`,
    emptyOutDir: false,
    target: "es2022",
    modulePreload: false,
    reportCompressedSize: false,
    rollupOptions: { input: `${here}studio.html` },
  },
  plugins: [textsOf("studio"), viteSingleFile({ removeViteModuleLoader: true })],
});
