// Messages of the compiler: names between backticks are code.

import type { JSX } from "preact";

export function Text({ text }: { text: string }): JSX.Element {
  return <>{text.split("`").map((part, index) => (index % 2 === 1 ? <code key={index}>{part}</code> : part))}</>;
}
