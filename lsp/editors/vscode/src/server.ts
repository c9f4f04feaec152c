// Life cycle of the server process, and the client side of its requests.

import * as vscode from "vscode";
import {
  CloseAction,
  ErrorAction,
  LanguageClient,
  RevealOutputChannelOn,
  State,
  type ExecuteCommandSignature,
  type LanguageClientOptions,
  type Middleware,
} from "vscode-languageclient/node";
import { locate, type Search } from "./locate";
import * as settings from "./settings";
import type { Status } from "./status";

/** Models on disk and untitled models. */
export const SELECTOR = [
  { language: "calyx", scheme: "file" },
  { language: "calyx", scheme: "untitled" },
];

/** Largest number of crashes within the interval after which the server is restarted. */
const ENDINGS = 4;
const ENDINGS_WITHIN_MS = 3 * 60 * 1000;

/** Handler of the server's commands from code lenses and fixes. */
export type OnCommand = (command: string, args: unknown[], next: ExecuteCommandSignature) => unknown;

export class Server implements vscode.Disposable {
  readonly output = vscode.window.createOutputChannel("Calyx", { log: true });
  readonly #trace = vscode.window.createOutputChannel("Calyx Trace", { log: true });
  readonly #status: Status;
  readonly #onCommand: OnCommand;
  #client: LanguageClient | undefined;
  /** Queue of starts and stops: a restart during a start waits for it. */
  #turn: Promise<void> = Promise.resolve();
  #endings: number[] = [];

  constructor(status: Status, onCommand: OnCommand) {
    this.#status = status;
    this.#onCommand = onCommand;
  }

  /** The client, if the server is running. */
  get client(): LanguageClient | undefined {
    return this.#client?.state === State.Running ? this.#client : undefined;
  }

  start(): Promise<void> {
    return this.#next(() => this.#start());
  }

  restart(): Promise<void> {
    return this.#next(async () => {
      await this.#stop();
      this.#endings = [];
      await this.#start();
    });
  }

  stop(): Promise<void> {
    return this.#next(() => this.#stop());
  }

  #next(step: () => Promise<void>): Promise<void> {
    this.#turn = this.#turn.then(step, step);
    return this.#turn;
  }

  async #start(): Promise<void> {
    if (this.#client !== undefined || !vscode.workspace.isTrusted) {
      return;
    }
    this.#status.starting();
    const search = await locate(settings.serverPath(), vscode.workspace.workspaceFolders?.[0]?.uri.fsPath);
    if (search.file === undefined) {
      this.#missing(search);
      return;
    }
    this.output.info(`starting ${search.file} lsp`);
    const command = { command: search.file, args: ["lsp", ...settings.serverArguments()] };
    const client = new LanguageClient("calyx", "Calyx", { run: command, debug: command }, this.#options());
    client.onDidChangeState(({ newState }) => void this.#stateChanged(client, newState));
    this.#client = client;
    try {
      await client.start();
    } catch (error) {
      this.#client = undefined;
      this.#failed(`The server \`${search.file} lsp\` did not start: ${said(error)}`);
    }
  }

  async #stop(): Promise<void> {
    const client = this.#client;
    this.#client = undefined;
    if (client !== undefined) {
      // A server that has crashed or hangs does not stop; disposing the client kills it.
      await client.dispose().catch((error: unknown) => this.output.warn(`stopping: ${said(error)}`));
    }
  }

  async #stateChanged(client: LanguageClient, state: State): Promise<void> {
    await vscode.commands.executeCommand("setContext", "calyx.running", state === State.Running);
    if (state === State.Running) {
      this.#status.ready(client.initializeResult?.serverInfo?.version);
    } else if (state === State.Starting) {
      this.#status.starting();
    } else {
      this.#status.failed("The server has stopped");
    }
  }

  #options(): LanguageClientOptions {
    return {
      documentSelector: SELECTOR,
      outputChannel: this.output,
      traceOutputChannel: this.#trace,
      revealOutputChannelOn: RevealOutputChannelOn.Never,
      markdown: { isTrusted: false, supportHtml: false },
      middleware: this.#middleware(),
      errorHandler: {
        error: () => ({ action: ErrorAction.Continue }),
        closed: () => this.#ended(),
      },
    };
  }

  #middleware(): Middleware {
    return {
      executeCommand: (command, args, next) => this.#onCommand(command, args, next) as ReturnType<typeof next>,
      provideInlayHints: (document, range, token, next) =>
        settings.inlayHints(document.uri) ? next(document, range, token) : [],
      provideCodeLenses: (document, token, next) =>
        settings.codeLenses(document.uri) ? next(document, token) : [],
    };
  }

  /** Handles a crash of the server process. */
  #ended(): { action: CloseAction; message?: string; handled?: boolean } {
    const now = Date.now();
    this.#endings = this.#endings.filter((then) => now - then < ENDINGS_WITHIN_MS);
    this.#endings.push(now);
    if (this.#endings.length <= ENDINGS) {
      return { action: CloseAction.Restart };
    }
    this.#failed(`The server ended ${this.#endings.length} times within three minutes and is left alone.`);
    return { action: CloseAction.DoNotRestart, handled: true };
  }

  #failed(message: string): void {
    this.output.error(message);
    this.#status.failed(message);
    void this.#offer(message, "Restart", "Show Output");
  }

  #missing(search: Search): void {
    const message =
      settings.serverPath() === ""
        ? "The `calyx` program was not found on the PATH. Install it with `cargo install --path compiler` in a copy of " +
          "Calyx, or say in the settings where it is."
        : `The setting calyx.server.path says \`${search.wanted}\`, but no such program can be run.`;
    this.output.error(`${message} Looked in: ${search.places.join(", ")}`);
    this.#status.failed("The `calyx` program was not found");
    void this.#offer(message, "Open Settings", "Try Again");
  }

  async #offer(message: string, ...choices: string[]): Promise<void> {
    switch (await vscode.window.showErrorMessage(message, ...choices)) {
      case "Open Settings":
        await vscode.commands.executeCommand("workbench.action.openSettings", "calyx.server.path");
        break;
      case "Try Again":
      case "Restart":
        await this.restart();
        break;
      case "Show Output":
        this.output.show();
        break;
    }
  }

  dispose(): void {
    this.output.dispose();
    this.#trace.dispose();
  }
}

/** Returns the message of an error. */
export function said(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
