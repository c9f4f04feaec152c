// Settings of the extension, read at each use so that changes take effect immediately.

import * as vscode from "vscode";

export const SECTION = "calyx";

/** Settings of the server's start: a change of one restarts the server. */
export const OF_THE_START = ["calyx.server.path", "calyx.server.arguments"] as const;

function section(scope?: vscode.Uri): vscode.WorkspaceConfiguration {
  return vscode.workspace.getConfiguration(SECTION, scope);
}

export function serverPath(): string {
  return section().get<string>("server.path", "").trim();
}

export function serverArguments(): string[] {
  return section().get<string[]>("server.arguments", []);
}

export function inlayHints(document: vscode.Uri): boolean {
  return section(document).get<boolean>("inlayHints.enabled", true);
}

export function codeLenses(document: vscode.Uri): boolean {
  return section(document).get<boolean>("codeLens.enabled", true);
}

export function saveBeforeRun(document: vscode.Uri): boolean {
  return section(document).get<boolean>("run.saveFirst", true);
}
