// Meshes of all viewers of a page. The name of a mesh file contains a hash of the shape of its part and of
// its connectivity, so that equal names mean equal meshes: positions, and viewers side by side, share them.

import { readMeshShape, type MeshShape } from "./run_data.ts";

interface Entry {
  shape: Promise<MeshShape>;
  users: Set<object>;
}

const entries = new Map<string, Entry>();

/** Returns a mesh, which `read` fetches on first use. It stays in memory until its last user releases it. */
export function acquireMesh(name: string, user: object, read: (name: string) => Promise<ArrayBuffer>): Promise<MeshShape> {
  let entry = entries.get(name);
  if (!entry) {
    const shape = read(name).then((buffer) => readMeshShape(name, buffer));
    const added = { shape, users: new Set<object>() };
    entries.set(name, added);
    // Another attempt may succeed, for instance after the server has returned.
    shape.catch(() => entries.get(name) === added && entries.delete(name));
    entry = added;
  }
  entry.users.add(user);
  return entry.shape;
}

/** Ends the use of all meshes by a user. */
export function releaseMeshes(user: object): void {
  for (const [name, { users }] of entries) {
    if (users.delete(user) && users.size === 0) entries.delete(name);
  }
}
