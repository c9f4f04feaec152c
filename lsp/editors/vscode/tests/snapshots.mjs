// Compares the highlighting of the project's models, line by line, with `tests/snapshots/`;
// `--update` writes the snapshots. The library and the examples must have no invalid scopes and no
// scopes that are open at the end.

import { existsSync, readFileSync, readdirSync, unlinkSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import oniguruma from "vscode-oniguruma";
import textmate from "vscode-textmate";

const here = dirname(fileURLToPath(import.meta.url));
const project = join(here, "../../../..");
const kept = join(here, "snapshots");
const update = process.argv.includes("--update");

/** Ubiquitous scopes, which are omitted. */
const DULL = /^(source|meta|punctuation|keyword\.operator\.(arithmetic|comparison))(\.|$)/;

async function grammar() {
  const wasm = join(dirname(createRequire(import.meta.url).resolve("vscode-oniguruma")), "onig.wasm");
  await oniguruma.loadWASM(readFileSync(wasm).buffer);
  const registry = new textmate.Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: async () => {
      const file = join(here, "../syntaxes/calyx.tmLanguage.json");
      return textmate.parseRawGrammar(readFileSync(file, "utf8"), file);
    },
  });
  return registry.loadGrammar("source.calyx");
}

/** Formats each line, and below it the scopes of its tokens. */
function highlighted(grammar, text, complain) {
  const out = [];
  let state = textmate.INITIAL;
  for (const [index, line] of text.trimEnd().split("\n").entries()) {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, state);
    state = ruleStack;
    const pieces = [];
    for (const { startIndex, endIndex, scopes } of tokens) {
      const piece = line.slice(startIndex, endIndex).trim();
      const scope = scopes.at(-1).replace(/\.calyx$/, "");
      if (scope.startsWith("invalid.")) {
        complain(`line ${index + 1}: \`${piece}\` is shown as wrong`);
      }
      if (piece !== "" && !DULL.test(scope)) {
        pieces.push(`${piece} ${scope}`);
      }
    }
    out.push(line, ...pieces.map((piece) => `\t${piece}`));
  }
  if (state.depth !== 1) {
    complain("something is still open at the end");
  }
  return `${out.join("\n")}\n`;
}

function models(folder) {
  const files = readdirSync(join(project, folder), { recursive: true });
  return files.filter((file) => file.endsWith(".cx")).map((file) => join(project, folder, file));
}

const calyx = await grammar();
const complaints = [];
const names = new Set();
const examples = models("examples");
for (const model of [...examples, ...models("stdlib-gears/calyx")]) {
  const name = `${basename(model)}.snap`;
  const complain = (what) => complaints.push(`${model}: ${what}`);
  const found = highlighted(calyx, readFileSync(model, "utf8"), complain);
  if (!examples.includes(model)) {
    continue;
  }
  names.add(name);
  const snapshot = join(kept, name);
  if (update) {
    writeFileSync(snapshot, found);
  } else if (!existsSync(snapshot)) {
    complain("has no snapshot");
  } else {
    const expected = readFileSync(snapshot, "utf8").split("\n");
    const first = found.split("\n").findIndex((line, index) => line !== expected[index]);
    if (first >= 0) {
      complain(`differs from ${name}, line ${first + 1}:\n  - ${expected[first]}\n  + ${found.split("\n")[first]}`);
    }
  }
}
for (const name of readdirSync(kept).filter((name) => !names.has(name))) {
  if (update) {
    unlinkSync(join(kept, name));
  } else {
    complaints.push(`${name} has no example any more`);
  }
}
for (const complaint of complaints) {
  console.error(complaint);
}
if (complaints.length > 0) {
  console.error("If the highlighting is right: npm run test:snapshots -- --update");
  process.exit(1);
}
console.log(`${names.size} examples are highlighted as before`);
