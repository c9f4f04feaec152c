// State of the server in the status bar of models.

import * as vscode from "vscode";

export class Status implements vscode.Disposable {
  readonly #item: vscode.LanguageStatusItem;

  constructor(selector: vscode.DocumentSelector) {
    this.#item = vscode.languages.createLanguageStatusItem("calyx.server", selector);
    this.#item.name = "Calyx";
    this.starting();
  }

  starting(): void {
    this.#show("Calyx", "Starting the server", vscode.LanguageStatusSeverity.Information, true);
  }

  ready(version: string | undefined): void {
    const detail = version === undefined ? "Ready" : `Ready, version ${version}`;
    this.#show("Calyx", detail, vscode.LanguageStatusSeverity.Information, false);
  }

  running(what: string): void {
    this.#show(what, "Cancel with the command Calyx: Cancel", vscode.LanguageStatusSeverity.Information, true);
    this.#item.command = { command: "calyx.cancelRun", title: "Cancel" };
  }

  failed(why: string): void {
    this.#show("Calyx", why, vscode.LanguageStatusSeverity.Error, false);
  }

  #show(text: string, detail: string, severity: vscode.LanguageStatusSeverity, busy: boolean): void {
    this.#item.text = text;
    this.#item.detail = detail;
    this.#item.severity = severity;
    this.#item.busy = busy;
    this.#item.command =
      severity === vscode.LanguageStatusSeverity.Error
        ? { command: "calyx.restartServer", title: "Restart" }
        : { command: "calyx.showOutput", title: "Output" };
  }

  dispose(): void {
    this.#item.dispose();
  }
}
