// Bundles the viewer and the studio into `dist/`. The bundles are committed: a machine that has only
// a Rust toolchain embeds them, and CI checks that they match the sources.
import { readFileSync } from "node:fs";
import { build } from "esbuild";

// Copies of the libraries must contain their licences.
const licences = ["three", "preact", "uplot"].map((name) => {
  const text = readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), "utf8").trim();
  return `/*! ${name}\n\n${text.replaceAll("*/", "* /")}\n*/`;
});

await build({
  entryPoints: { viewer: "src/viewer.tsx", studio: "src/studio.tsx" },
  outdir: "dist",
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  footer: { js: licences.join("\n") },
  jsx: "automatic",
  jsxImportSource: "preact",
  logLevel: "warning",
});
