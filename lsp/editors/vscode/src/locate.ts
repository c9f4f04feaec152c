// Finds the `calyx` program: the path of the setting, else `calyx` in the PATH, else in the folder
// of `cargo install`. If an editor is not started from a shell, its PATH often lacks that folder.

import { constants } from "node:fs";
import { access, stat } from "node:fs/promises";
import { homedir } from "node:os";
import * as path from "node:path";

const PROGRAM = "calyx";

/** Result of the search; `file` is undefined if the program was not found. */
export interface Search {
  readonly file: string | undefined;
  /** Display name: the text of the setting, or `calyx`. */
  readonly wanted: string;
  readonly places: readonly string[];
}

/** Searches for the program. `folder` is the workspace folder, if there is one. */
export async function locate(setting: string, folder: string | undefined): Promise<Search> {
  const wanted = setting === "" ? PROGRAM : expand(setting, folder);
  if (path.isAbsolute(wanted) || wanted.includes("/") || wanted.includes(path.sep)) {
    const file = path.resolve(folder ?? homedir(), wanted);
    return { file: await firstProgram([file]), wanted, places: [file] };
  }
  const places = (process.env["PATH"] ?? "").split(path.delimiter).filter((place) => place !== "");
  places.push(path.join(process.env["CARGO_HOME"] ?? path.join(homedir(), ".cargo"), "bin"));
  const file = await firstProgram(places.map((place) => path.join(place, wanted)));
  return { file, wanted, places };
}

function expand(setting: string, folder: string | undefined): string {
  const withFolder = folder === undefined ? setting : setting.replaceAll("${workspaceFolder}", folder);
  return withFolder.replace(/^~(?=$|[\\/])/, homedir());
}

async function firstProgram(candidates: readonly string[]): Promise<string | undefined> {
  const endings = process.platform === "win32" ? [".exe", ""] : [""];
  for (const candidate of candidates) {
    for (const ending of endings) {
      if (await isProgram(candidate + ending)) {
        return candidate + ending;
      }
    }
  }
  return undefined;
}

async function isProgram(file: string): Promise<boolean> {
  try {
    await access(file, constants.X_OK);
    return (await stat(file)).isFile();
  } catch {
    return false;
  }
}
