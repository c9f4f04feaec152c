// Array files: a JSON header and the arrays it refers to. docs/view-files.md describes the format.

const MAGIC = "CALYXARR";
const VERSION = 5;
const PREFIX = 16;

/** A file that cannot be read. The message names the file and the reason. */
export class FileError extends Error {
  constructor(
    readonly file: string,
    readonly reason: string,
  ) {
    super(`${file}: ${reason}`);
    this.name = "FileError";
  }
}

/** Reference to an array, as written in the header. */
export interface ArrayReference {
  type: "f32" | "f64" | "u32";
  components: number;
  count: number;
  offset: number;
}

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** Header and arrays of a file. */
export class ArrayFile {
  private constructor(
    readonly name: string,
    readonly header: { [key: string]: Json },
    private readonly buffer: ArrayBuffer,
    private readonly start: number,
  ) {}

  /** Reads the header. Throws a `FileError` if the file is damaged or of another format. */
  static parse(name: string, buffer: ArrayBuffer): ArrayFile {
    if (buffer.byteLength < PREFIX) {
      throw new FileError(name, `the file is truncated: it has ${buffer.byteLength} bytes, the header needs ${PREFIX}`);
    }
    const view = new DataView(buffer);
    const magic = new TextDecoder("latin1").decode(new Uint8Array(buffer, 0, 8));
    if (magic !== MAGIC) throw new FileError(name, `not an array file: it does not begin with ${MAGIC}`);
    const version = view.getUint32(8, true);
    if (version < VERSION) throw new FileError(name, "written by an older version of Calyx: run the model again");
    if (version > VERSION) {
      throw new FileError(name, `version ${version} of the format is not supported; this viewer reads version ${VERSION}`);
    }
    const length = view.getUint32(12, true);
    const start = PREFIX + length;
    if (start > buffer.byteLength) {
      throw new FileError(name, `the file is truncated: it has ${buffer.byteLength} bytes, the header ends at ${start}`);
    }
    let header: Json;
    try {
      header = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(new Uint8Array(buffer, PREFIX, length)));
    } catch {
      throw new FileError(name, "the header is not valid JSON");
    }
    if (typeof header !== "object" || header === null || Array.isArray(header)) {
      throw new FileError(name, "the header is not a JSON object");
    }
    return new ArrayFile(name, header, buffer, start);
  }

  f32(reference: unknown, components: number, label: string): Float32Array {
    const { offset, length } = this.locate(reference, "f32", components, label);
    return new Float32Array(this.buffer, offset, length);
  }

  f64(reference: unknown, components: number, label: string): Float64Array {
    const { offset, length } = this.locate(reference, "f64", components, label);
    if (offset % 8 === 0) return new Float64Array(this.buffer, offset, length);
    return new Float64Array(this.buffer.slice(offset, offset + 8 * length));
  }

  u32(reference: unknown, components: number, label: string): Uint32Array {
    const { offset, length } = this.locate(reference, "u32", components, label);
    return new Uint32Array(this.buffer, offset, length);
  }

  private locate(reference: unknown, type: string, components: number, label: string) {
    const fail = (reason: string): never => {
      throw new FileError(this.name, `${label}: ${reason}`);
    };
    if (typeof reference !== "object" || reference === null) return fail("the array is missing");
    const array = reference as Partial<ArrayReference>;
    if (array.type !== type) return fail(`the array has type ${String(array.type)}, expected ${type}`);
    if (array.components !== components) {
      return fail(`the array has ${String(array.components)} components, expected ${components}`);
    }
    const { count, offset } = array;
    const valid = (n: unknown): n is number => Number.isSafeInteger(n) && (n as number) >= 0;
    if (!valid(count) || !valid(offset)) return fail("the size or the offset of the array is not a whole number");
    const size = type === "f64" ? 8 : 4;
    if (offset % size !== 0) return fail(`the offset ${offset} is not aligned`);
    const length = count * components;
    const end = this.start + offset + length * size;
    if (end > this.buffer.byteLength) {
      return fail(`the file is truncated: it has ${this.buffer.byteLength} bytes, the array ends at ${end}`);
    }
    const begin = this.start + offset;
    if (begin % size !== 0) return fail("the header's length is not a multiple of 8");
    return { offset: begin, length };
  }
}
