// Diagnostics of the model, and messages of runs.

import type { JSX } from "preact";
import type { Message } from "./api.ts";
import { fileName } from "./format.ts";
import { Text } from "./text.tsx";

/** Diagnostics with excerpts of the source, as the command line prints them. */
export function Rendered({ text, isError }: { text: string; isError: boolean }): JSX.Element {
  return (
    <pre class={`rendered ${isError ? "error" : "warning"}`} role={isError ? "alert" : undefined} tabIndex={0} aria-label="Diagnostics of the model">
      {text.trim()}
    </pre>
  );
}

export function Messages({ messages }: { messages: Message[] }): JSX.Element | null {
  if (messages.length === 0) return null;
  return (
    <ul class="messages">
      {messages.map((message, index) => (
        <li key={index} class={message.severity}>
          {message.code && <code>{message.code}</code>} <Text text={message.message} />
          {message.primary && (
            <span class="place"> {fileName(message.primary.file)}:{message.primary.line}</span>
          )}
          {message.help && <span class="help"><Text text={message.help} /></span>}
        </li>
      ))}
    </ul>
  );
}
