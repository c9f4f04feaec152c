// Activation and deactivation of the extension: creates and connects its parts.

import * as vscode from "vscode";
import { Commands } from "./commands";
import { PlanDocuments } from "./plan";
import { SELECTOR, Server } from "./server";
import { OF_THE_START } from "./settings";
import { Status } from "./status";

let running: Server | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const status = new Status(SELECTOR);
  const plans = new PlanDocuments();
  const commands = new Commands(plans, status);
  const server: Server = new Server(status, (command, args) => commands.fromLens(server, command, args));
  running = server;

  context.subscriptions.push(
    status,
    plans,
    server,
    ...commands.register(server),
    vscode.workspace.onDidGrantWorkspaceTrust(() => server.start()),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (OF_THE_START.some((setting) => change.affectsConfiguration(setting))) {
        void server.restart();
      }
    }),
  );
  await server.start();
}

export async function deactivate(): Promise<void> {
  await running?.stop();
}
