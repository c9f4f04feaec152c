import { defineConfig } from "@playwright/test";
import { CHROMIUM, FIREFOX } from "./tests/browsers.ts";

export default defineConfig({
  testDir: "tests",
  timeout: 120_000,
  // The software renderer uses all cores.
  workers: 1,
  reporter: [["list"]],
  expect: { timeout: 20_000, toHaveScreenshot: { maxDiffPixelRatio: 0.005 } },
  // Both browsers have the same reference pictures.
  snapshotPathTemplate: "{testDir}/{testFileDir}/{testFileName}-snapshots/{arg}{-snapshotSuffix}{ext}",
  use: {
    viewport: { width: 1280, height: 800 },
    // Movements of the camera would make tests wait.
    contextOptions: { reducedMotion: "reduce" },
  },
  projects: [
    { name: "chromium", use: { browserName: "chromium", launchOptions: CHROMIUM } },
    ...(FIREFOX
      ? [{
          name: "firefox",
          use: { browserName: "firefox" as const, launchOptions: FIREFOX },
          // Controls and the positions of letters differ from those of Chromium, by 0.009 of the pixels.
          expect: { timeout: 20_000, toHaveScreenshot: { maxDiffPixelRatio: 0.012 } },
        }]
      : []),
  ],
});
