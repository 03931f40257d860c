// The script of the selected robot's controller, in an editor.

import type { LogLine, Session } from "../session";
import { part } from "../parts";
import { button, h, setEnabled, setText } from "./dom";
import type { LuaEditor } from "./editor";
import { plural } from "./format";

export interface ScriptHost {
  session(): Session | null;
  /** Null: no robot is selected. */
  selectedId(): string | null;
  notify(text: string, kind: "info" | "error"): void;
}

export class ScriptPanel {
  readonly element: HTMLElement;
  private readonly title = h("h3", {}, "Script");
  private readonly file = h("span", { class: "tag" });
  private readonly hint = h("p", { class: "empty" });
  private readonly holder = h("div", { class: "editor" });
  private readonly message = h("pre", { class: "script-message", role: "status", hidden: true });
  private readonly apply = button({
    text: "Apply",
    title: "Restart all robots of this script with it",
    key: "Ctrl+Enter",
    className: "primary",
    onClick: () => void this.send(),
  });
  private readonly undo = button({
    icon: "reset",
    text: "Discard",
    title: "Show what the robots run",
    onClick: () => void this.open(),
  });
  private editor: LuaEditor | null = null;
  private robot: string | null = null;
  private path = "";
  private running = "";
  private isBusy = false;
  private isShown = false;

  constructor(private readonly host: ScriptHost) {
    this.element = h(
      "div",
      { class: "script" },
      h("header", { class: "row" }, h("div", { class: "script-title" }, this.title, this.file), this.undo, this.apply),
      this.hint,
      this.holder,
      this.message,
    );
  }

  /** A new session. */
  clear(): void {
    this.robot = null;
    this.path = this.running = "";
    this.editor?.destroy();
    this.editor = null;
    this.say("", "info");
    this.update();
  }

  /** Its tab is shown, or not. */
  show(isShown: boolean): void {
    this.isShown = isShown;
    this.update();
  }

  /** The selection, or what may be done, has changed. */
  update(): void {
    const session = this.host.session();
    const id = this.host.selectedId();
    const reason = this.reason(session, id);
    setEnabled(this.apply, reason ?? (this.hasChanges ? null : "Nothing was changed"));
    setEnabled(this.undo, reason ?? (this.hasChanges ? null : "Nothing was changed"));
    const hasEditor = this.editor !== null;
    this.hint.hidden = hasEditor && reason === null;
    setText(this.hint, reason ?? "Reading the script …");
    if (this.isShown && reason === null && id !== this.robot && !this.isBusy) {
      void this.openOther(id!);
    }
  }

  /** Marks the line of an error of the robots' script. */
  addLog(lines: LogLine[]): void {
    if (this.path === "" || this.editor === null) {
      return;
    }
    for (const { level, text } of lines) {
      const at = text.indexOf(`${this.path}:`);
      const line = level === "error" && at >= 0 ? parseInt(text.slice(at + this.path.length + 1), 10) : NaN;
      if (line > 0 && !this.hasChanges) {
        this.showError(text, line);
      }
    }
  }

  private get text(): string {
    return this.editor?.text ?? "";
  }
  private get hasChanges(): boolean {
    return this.editor !== null && this.text !== this.running;
  }

  private reason(session: Session | null, id: string | null): string | null {
    if (session === null || session.kind === "recording") {
      return "Scripts are edited in a run; a recording does not have them";
    }
    return session.abilities.edit ?? (id === null && this.robot === null ? "Select a robot first: click it" : null);
  }

  // another robot of the same script keeps what was typed
  private async openOther(id: string): Promise<void> {
    if (this.hasChanges) {
      return;
    }
    await this.open(id);
  }

  private async open(id = this.robot): Promise<void> {
    const session = this.host.session();
    if (session === null || id === null || this.isBusy) {
      return;
    }
    this.isBusy = true;
    this.robot = id;
    const answer = await session.request("open_script", { entity: id });
    this.isBusy = false;
    if (answer.error !== undefined || answer.text === undefined) {
      this.editor?.destroy();
      this.editor = null;
      this.path = this.running = "";
      setText(this.title, "Script");
      setText(this.file, "");
      this.say(capitalize(answer.error ?? ""), "error");
    } else {
      this.path = answer.file ?? "";
      this.running = answer.text;
      setText(this.title, this.path.split("/").pop() ?? "");
      setText(this.file, `${plural(answer.robots ?? 0, "robot")}${answer.changed === true ? " · not the file's text" : ""}`);
      this.fill(answer.text);
      this.say("", "info");
    }
    this.update();
  }

  private fill(text: string): void {
    this.editor?.destroy();
    this.editor = new (part("editor").LuaEditor)(this.holder, text, {
      apply: () => void this.send(),
      leave: () => this.apply.focus(),
      changed: () => this.update(),
    });
  }

  private async send(): Promise<void> {
    const session = this.host.session();
    if (session === null || this.robot === null || this.apply.disabled || this.isBusy) {
      return;
    }
    this.isBusy = true;
    const { text } = this;
    const answer = await session.request("script", { entity: this.robot, text });
    this.isBusy = false;
    if (answer.error !== undefined) {
      this.showError(answer.error, answer.line ?? 0);
    } else {
      this.running = text;
      const failed = answer.failed ?? 0;
      const count = plural((answer.robots ?? 0) - failed, "robot");
      setText(this.file, `${plural(answer.robots ?? 0, "robot")} · not the file's text`);
      this.say(
        `Applied: ${count} started again${failed > 0 ? `, ${failed} kept the former script: see the log` : ""}. The file is as before.`,
        failed > 0 ? "error" : "info",
      );
      this.editor?.mark("", 0);
    }
    this.update();
  }

  private showError(text: string, line: number): void {
    this.say(capitalize(text), "error");
    this.editor?.mark(text, line);
  }

  private say(text: string, kind: "info" | "error"): void {
    this.message.hidden = text === "";
    this.message.className = `script-message ${kind}`;
    setText(this.message, text);
  }
}

function capitalize(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
