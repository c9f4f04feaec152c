// The commands of the palette, the title bar and the code lenses. Each has two names: `calyx.run`
// etc. are the commands of the server, which code lenses contain and the language client
// registers; `calyx.runModel` etc. are the commands of the editor, which exist before the server
// starts.

import * as vscode from "vscode";
import { ExecuteCommandRequest, type LanguageClient } from "vscode-languageclient/node";
import type { PlanDocuments } from "./plan";
import { said, type Server } from "./server";
import * as settings from "./settings";
import type { Status } from "./status";

/** Commands that the server executes. Their first argument is the model's URI. */
const RUN = "calyx.run";
const PLAN = "calyx.plan";
const CANCEL = "calyx.cancel";
/** Server command whose second argument is the test's name. */
const TEST = "calyx.test";

/** Status text during commands that take long. */
const DOING: Readonly<Record<string, string>> = { [RUN]: "Running", [PLAN]: "Planning", [TEST]: "Testing" };

export class Commands {
  readonly #plans: PlanDocuments;
  readonly #status: Status;

  constructor(plans: PlanDocuments, status: Status) {
    this.#plans = plans;
    this.#status = status;
  }

  register(server: Server): vscode.Disposable[] {
    const command = vscode.commands.registerCommand;
    return [
      command("calyx.runModel", (uri?: vscode.Uri) => this.#ask(server, RUN, uri)),
      command("calyx.showPlan", (uri?: vscode.Uri) => this.#ask(server, PLAN, uri)),
      command("calyx.cancelRun", (uri?: vscode.Uri) => this.#ask(server, CANCEL, uri)),
      command("calyx.restartServer", () => server.restart()),
      command("calyx.format", () => vscode.commands.executeCommand("editor.action.formatDocument")),
      command("calyx.showOutput", () => server.output.show()),
    ];
  }

  /** Executes a command of the server from a code lens or a fix. */
  async fromLens(server: Server, command: string, args: unknown[]): Promise<unknown> {
    const client = server.client;
    if (client === undefined) {
      return undefined;
    }
    const first = args[0];
    const model = typeof first === "string" ? client.protocol2CodeConverter.asUri(first) : undefined;
    if (model === undefined || DOING[command] === undefined) {
      return send(client, command, args);
    }
    return this.#carryOut(client, command, model, args);
  }

  async #ask(server: Server, command: string, uri: vscode.Uri | undefined): Promise<void> {
    const client = server.client;
    if (client === undefined) {
      void vscode.window.showWarningMessage("Calyx: the server is not running.");
      return;
    }
    const active = vscode.window.activeTextEditor?.document;
    const model = uri ?? (active?.languageId === "calyx" ? active.uri : undefined);
    if (model === undefined) {
      void vscode.window.showInformationMessage("Calyx: open a model (a file that ends in .cx) first.");
      return;
    }
    const args = [client.code2ProtocolConverter.asUri(model)];
    if (command === CANCEL) {
      await send(client, command, args);
    } else {
      await this.#carryOut(client, command, model, args);
    }
  }

  async #carryOut(client: LanguageClient, command: string, model: vscode.Uri, args: unknown[]): Promise<unknown> {
    const document = vscode.workspace.textDocuments.find((open) => open.uri.toString() === model.toString());
    if (command !== PLAN && document?.isDirty === true && settings.saveBeforeRun(model)) {
      // If the save fails or is cancelled, the command is not executed.
      if (!(await document.save())) {
        return undefined;
      }
    }
    const name = vscode.workspace.asRelativePath(model);
    this.#status.running(`${DOING[command]} ${name}`);
    try {
      const answer = await send(client, command, args);
      if (command === PLAN && typeof answer === "string") {
        await this.#plans.show(model, answer);
      }
      return answer;
    } catch (error) {
      void vscode.window.showErrorMessage(`Calyx: ${said(error)}`);
      return undefined;
    } finally {
      this.#status.ready(client.initializeResult?.serverInfo?.version);
    }
  }
}

function send(client: LanguageClient, command: string, args: unknown[]): Promise<unknown> {
  return client.sendRequest(ExecuteCommandRequest.type, { command, arguments: args });
}
