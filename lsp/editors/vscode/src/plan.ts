// Shows the plan of a model as a read-only document next to it. A new plan replaces the old one.

import * as vscode from "vscode";

const SCHEME = "calyx-plan";

export class PlanDocuments implements vscode.TextDocumentContentProvider, vscode.Disposable {
  readonly #texts = new Map<string, string>();
  readonly #changed = new vscode.EventEmitter<vscode.Uri>();
  readonly #registrations: vscode.Disposable[];

  readonly onDidChange = this.#changed.event;

  constructor() {
    this.#registrations = [
      vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
      vscode.workspace.onDidCloseTextDocument((document) => this.#texts.delete(document.uri.toString())),
    ];
  }

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.#texts.get(uri.toString()) ?? "";
  }

  async show(model: vscode.Uri, text: string): Promise<void> {
    const name = model.path.replace(/^.*\//, "").replace(/\.cx$/, "");
    const uri = vscode.Uri.from({ scheme: SCHEME, path: `/${name}.plan`, query: model.toString() });
    this.#texts.set(uri.toString(), text);
    this.#changed.fire(uri);
    const document = await vscode.workspace.openTextDocument(uri);
    await vscode.window.showTextDocument(document, {
      viewColumn: vscode.ViewColumn.Beside,
      preserveFocus: true,
      preview: true,
    });
  }

  dispose(): void {
    this.#changed.dispose();
    for (const registration of this.#registrations) {
      registration.dispose();
    }
  }
}
