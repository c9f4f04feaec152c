// Settings with which Chromium and Firefox draw WebGL in software, without a display of their own.
//
// Firefox is that of the distribution. Playwright's own build of Firefox would be a download that
// continuous integration cannot make, and it is patched; users have the stock browser. The channel
// "moz-firefox" drives a stock Firefox by WebDriver BiDi, so the tests of Chromium run unchanged.
//
// Playwright stays at 1.64: later versions send the command emulation.setMediaFeaturesOverride when
// they open a page, which the current ESR of Firefox rejects.

import { existsSync } from "node:fs";
import { join } from "node:path";
import type { LaunchOptions } from "@playwright/test";

export const CHROMIUM: LaunchOptions = {
  executablePath: process.env.CALYX_CHROMIUM || "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
};

/** Folder in which Firefox saves files. */
export const DOWNLOADS = join(process.cwd(), "test-results", "downloads");

const firefoxPath = process.env.CALYX_FIREFOX || "/usr/bin/firefox-esr";

/** Null if there is no Firefox. */
export const FIREFOX: LaunchOptions | null = existsSync(firefoxPath)
  ? {
      channel: "moz-firefox",
      executablePath: firefoxPath,
      downloadsPath: DOWNLOADS,
      firefoxUserPrefs: {
        // Firefox accepts Mesa's llvmpipe only on request. It needs an X server for its OpenGL
        // context also with --headless: run the tests by xvfb-run.
        "webgl.force-enabled": true,
        // Playwright cannot emulate these through BiDi.
        "ui.prefersReducedMotion": 1,
      },
    }
  : null;
