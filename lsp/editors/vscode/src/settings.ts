// The extension's settings, read where they are used so that a change holds at once.

import * as vscode from "vscode";

export const SECTION = "calyx";

/** Settings the server is started with: a change of one restarts it. */
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
