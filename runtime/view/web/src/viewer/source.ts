// Sources of data for the viewer.

/** A position in the list of positions of a run. */
export interface PositionEntry {
  /** Index of the position from 0, as in the name of its file. */
  position: number;
  /** Time in s. */
  time: number;
}

/** A column of `steps.csv`. */
export interface OutputColumn {
  name: string;
  /** SI unit, empty for numbers without a unit. */
  unit: string;
  /** One value per row; NaN or null where there is none. */
  values: (number | null)[];
}

/** Outputs over the positions: columns of equal length. */
export interface OutputTable {
  columns: OutputColumn[];
}

/** Origin of the data that a viewer displays: data embedded in a page, or a server. */
export interface ViewSource {
  title: string;
  /** Returns the content of `parts.bin`. */
  parts(): Promise<ArrayBuffer>;
  /** Returns the positions that are written. The list may grow during a run. */
  positions(): Promise<PositionEntry[]>;
  /** Returns the content of a position's file. `index` is the place in the list of positions. */
  position(index: number): Promise<ArrayBuffer>;
  /** Returns the content of a file `mesh-*.bin`. Needed if the positions refer to meshes. */
  mesh?(name: string): Promise<ArrayBuffer>;
  /** Labels and values: model, params, version, date. */
  provenance?: [string, string][];
  /** Outputs to plot over the positions. */
  outputs?: OutputTable | null;
}

/** Data of a self-contained page, as `calyx view --html` writes them. */
export interface EmbeddedData {
  title: string;
  provenance?: [string, string][];
  outputs?: OutputTable | null;
  /** `parts.bin`, compressed by gzip, in base64. */
  parts: string;
  positions: { position: number; time: number; data: string }[];
  /** Files `mesh-*.bin` by name, likewise. */
  meshes?: Record<string, string>;
}

/** Decodes base64 and decompresses gzip. */
async function decompress(text: string, name: string): Promise<ArrayBuffer> {
  try {
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return await new Response(stream).arrayBuffer();
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    throw new Error(`${name}: the compressed data are damaged (${reason})`);
  }
}

/** Creates a source from the data embedded in a page. */
export function embeddedSource(data: EmbeddedData): ViewSource {
  const list = data.positions ?? [];
  return {
    title: data.title,
    provenance: data.provenance,
    outputs: data.outputs,
    parts: () => decompress(data.parts, "parts.bin"),
    positions: async () => list.map(({ position, time }) => ({ position, time })),
    position: (index) => {
      const entry = list[index];
      if (!entry) return Promise.reject(new Error(`position ${index} does not exist`));
      return decompress(entry.data, positionFileName(entry.position));
    },
    mesh: (name) => {
      const text = data.meshes?.[name];
      if (text === undefined) return Promise.reject(new Error(`${name}: the page does not contain this file`));
      return decompress(text, name);
    },
  };
}

/** Name of a position's file in the folder `view/`. */
export function positionFileName(position: number): string {
  return `position-${String(position).padStart(4, "0")}.bin`;
}
