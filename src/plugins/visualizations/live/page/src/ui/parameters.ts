// Sliders for the numbers that a controller, or the loop functions, declare as changeable.

import type { Parameter, Session } from "../session";
import { h, setEnabled } from "./dom";
import { formatNumber } from "./format";

const kSteps = 200;

export class ParameterSliders {
  readonly element = h("div", { class: "parameters", hidden: true });
  private readonly list = h("div", {});
  private readonly all = h("input", { type: "checkbox", checked: true });
  private readonly sliders = new Map<string, { slider: HTMLInputElement; output: HTMLElement; unit: string }>();
  private reason: string | null = null;

  /** Entity: a robot; null: the loop functions. */
  constructor(
    private readonly session: () => Session | null,
    private readonly entity: string | null,
    private readonly notify: (text: string, kind: "info" | "error") => void,
  ) {
    this.element.append(
      h("h4", {}, entity === null ? "Parameters of the loop functions" : "Parameters of its controller"),
      this.list,
    );
    if (entity !== null) {
      this.element.append(h("label", { class: "row" }, this.all, h("span", {}, "for all robots with such a controller")));
    }
  }

  /** Asks the run for names and values. */
  async load(): Promise<void> {
    const session = this.session();
    if (session === null || session.kind !== "live" || session.times === "all") {
      return;
    }
    const answer = await session.request("parameters", this.entity === null ? {} : { entity: this.entity });
    const parameters = answer.parameters ?? [];
    this.element.hidden = parameters.length === 0;
    if (parameters.map(({ name }) => name).join() !== [...this.sliders.keys()].join()) {
      this.sliders.clear();
      this.list.replaceChildren(...parameters.map((parameter) => this.makeRow(parameter)));
    }
    for (const { name, value } of parameters) {
      this.show(name, value);
    }
    this.setReason(session.abilities.tune);
  }

  /** Null: they may be changed; otherwise why not. */
  setReason(reason: string | null): void {
    this.reason = reason;
    this.sliders.forEach(({ slider }) => setEnabled(slider, this.reason));
  }

  private makeRow({ name, min, max, unit }: Parameter): HTMLElement {
    const output = h("output", {});
    const slider = h("input", {
      type: "range",
      min,
      max,
      step: (max - min) / kSteps,
      "aria-label": unit === "" ? name : `${name}, ${unit}`,
      oninput: () => this.show(name, Number(slider.value)),
      onchange: () => void this.send(name, Number(slider.value)),
    });
    this.sliders.set(name, { slider, output, unit });
    return h("label", { class: "parameter" }, h("span", { class: "name" }, name), slider, output);
  }

  private show(name: string, value: number): void {
    const row = this.sliders.get(name);
    if (row !== undefined) {
      row.slider.value = String(value);
      row.output.textContent = row.unit === "" ? formatNumber(value) : `${formatNumber(value)} ${row.unit}`;
    }
  }

  private async send(name: string, value: number): Promise<void> {
    const more = this.entity === null ? {} : { entity: this.entity, all: this.all.checked };
    const answer = await this.session()?.request("set_parameter", { name, value, ...more });
    if (answer?.error !== undefined) {
      this.notify(answer.error, "error");
    }
    await this.load();
  }
}
