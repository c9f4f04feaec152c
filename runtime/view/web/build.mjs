// Bundles the viewer and the studio into `dist/`. The bundles are committed: a machine that has only
// a Rust toolchain embeds them, and CI checks that they match the sources.
import { build } from "esbuild";

await build({
  entryPoints: { viewer: "src/viewer.tsx", studio: "src/studio.tsx" },
  outdir: "dist",
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  // The licences of the libraries stay in the bundle.
  legalComments: "eof",
  jsx: "automatic",
  jsxImportSource: "preact",
  logLevel: "warning",
});
