// Overlay with the shortcuts.

import { useLayoutEffect, useRef } from "preact/hooks";
import type { Core } from "../core.ts";
import { SHORTCUTS } from "../controls.ts";
import { Tool } from "./ui.tsx";

export function Help({ core }: { core: Core }) {
  const dialog = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => {
    dialog.current!.showModal();
  }, []);
  const close = () => {
    core.help = false;
    core.changed(false);
  };
  return (
    <dialog class="cv-help" ref={dialog} aria-labelledby="cv-help-title" onClose={close} onClick={(event) => event.target === dialog.current && close()}>
      <div class="cv-help-head">
        <h2 id="cv-help-title">Shortcuts</h2>
        <Tool icon="close" label="Close" onClick={close} />
      </div>
      <div class="cv-help-grid">
        {SHORTCUTS.map(([title, shortcuts]) => (
          <section key={title}>
            <h3>{title}</h3>
            <dl>
              {shortcuts.map(({ keys, label }) => (
                <div key={keys}>
                  <dt>
                    <kbd>{keys}</kbd>
                  </dt>
                  <dd>{label}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </dialog>
  );
}
