// Takes a picture of a page of `calyx view`: node .ci/view_picture.mjs PAGE OUTPUT.png
import { createRequire } from "node:module";
import { resolve } from "node:path";

const require = createRequire(new URL("../runtime/view/web/package.json", import.meta.url));
const { chromium } = require("@playwright/test");
const [page, output] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CALYX_CHROMIUM || "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const view = await browser.newPage({ viewport: { width: 1280, height: 800 }, colorScheme: "light" });
await view.goto(`file://${resolve(page)}`);
await view.locator("canvas").first().waitFor();
await view.waitForTimeout(3000);
await view.screenshot({ path: output });
await browser.close();
