// One file for the extension host: an extension loads faster, and its package holds no node_modules.
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
