// Short forms of the names of parts.

/** Words of a name, each with the separator before it. */
function words(name: string): string[] {
  return name.match(/[\s.:/]*[^\s.:/]+/g) ?? [name];
}

/** Number of words that all lists have in common at their start; each keeps one word. */
function common(lists: string[][]): number {
  let count = 0;
  while (lists.every((list) => count + 1 < list.length && list[count] === lists[0]![count])) count++;
  return count;
}

/** Short forms of names that are displayed together: without the words with which all of them begin or end. */
export function shortNames(names: readonly string[]): Map<string, string> {
  const all = [...new Set(names)];
  const short = new Map<string, string>();
  if (all.length < 2) return new Map(all.map((name) => [name, name]));
  const lists = all.map(words);
  const first = common(lists);
  const rest = lists.map((list) => list.slice(first).reverse());
  const last = common(rest);
  all.forEach((name, i) => short.set(name, rest[i]!.slice(last).reverse().join("").replace(/^[\s.:/]+/, "")));
  return short;
}

/** Number of characters at the end of a name that stay visible. */
const END = 12;

/** Parts of a name of which only the first one may be shortened, at its end. */
export function splitName(name: string): [string, string] {
  return name.length > END + 4 ? [name.slice(0, -END), name.slice(-END)] : ["", name];
}
