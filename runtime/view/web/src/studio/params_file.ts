// Params files, which `calyx run --params` reads as well.

import { RequestError, send } from "./api.ts";
import { isPlainNumber } from "./format.ts";
import type { Studio, Values } from "./store.ts";

/** Reads a JSON or TOML file. The server parses it, as for `--params`. */
export async function readParamsFile(file: File): Promise<Values> {
  const text = await file.text();
  try {
    const { params } = await send<{ params: Values }>("POST", "/api/params", { name: file.name, text });
    return params;
  } catch (error) {
    if (!(error instanceof RequestError) || error.message.includes(file.name)) throw error;
    throw new RequestError(`${file.name}: ${error.message}`, error.status, error.help, error.body);
  }
}

/** Content of a params file: all params that do not follow others, and all changed ones. */
export function paramsFile(studio: Studio): string {
  const entries = (studio.model?.params ?? [])
    .filter((param) => param.independent || param.name in studio.values)
    .map((param) => {
      const text = studio.value(param).trim();
      if (param.kind === "boolean") return [param.name, text.toUpperCase() === "TRUE"];
      const isNumber = (param.kind === "number" || param.kind === "integer") && isPlainNumber(text);
      return [param.name, isNumber ? Number(text) : text];
    });
  return `${JSON.stringify(Object.fromEntries(entries), null, 2)}\n`;
}

/** Downloads the params file of the form. */
export function saveParamsFile(studio: Studio, name: string): void {
  const url = URL.createObjectURL(new Blob([paramsFile(studio)], { type: "application/json" }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  URL.revokeObjectURL(url);
}
