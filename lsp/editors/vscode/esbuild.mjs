// Bundles the extension to one file: it loads faster, and its package contains no node_modules.
import { build } from "esbuild";

await build({
  entryPoints: ["src/extension.ts"],
  outfile: "out/extension.js",
  bundle: true,
  platform: "node",
  format: "cjs",
  target: "node20",
  external: ["vscode"],
  sourcemap: process.argv.includes("--minify") ? false : "inline",
  minify: process.argv.includes("--minify"),
  logLevel: "warning",
});
