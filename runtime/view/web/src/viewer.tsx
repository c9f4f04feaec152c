// Entry point of the self-contained page.

import { Viewer } from "./viewer/index.ts";

void Viewer;
