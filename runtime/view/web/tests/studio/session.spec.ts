// Requests that store a session.

import { expect, test } from "@playwright/test";
import { sendSession } from "../../src/studio/api.ts";

test("only a short session outlives its page, a long one is stored too", async () => {
  const sent: RequestInit[] = [];
  const original = globalThis.fetch;
  globalThis.fetch = async (_path, init) => {
    sent.push(init ?? {});
    return new Response(null, { status: 204 });
  };
  try {
    for (const length of [10, 100_000]) {
      await sendSession({ version: 1, params: { name: "x".repeat(length) }, view: {} });
    }
  } finally {
    globalThis.fetch = original;
  }
  expect(sent.map(({ keepalive }) => keepalive)).toEqual([true, false]);
  expect(sent.every(({ body }) => typeof body === "string" && JSON.parse(body).version === 1)).toBe(true);
});
