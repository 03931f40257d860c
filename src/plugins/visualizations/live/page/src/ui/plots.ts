// Numbers over time.

import type uPlot from "uplot";

import { part } from "../parts";
import { h } from "./dom";
import { formatNumber } from "./format";

const kMaxPoints = 4000;

/** Values of one name at times, which may come in any order: a later time replaces an earlier one. */
export class Series {
  times: number[] = [];
  values: number[] = [];

  add(time: number, value: number): void {
    const last = this.times.length - 1;
    if (last < 0 || time > this.times[last]!) {
      this.times.push(time);
      this.values.push(value);
    } else {
      const at = lowerBound(this.times, time);
      if (this.times[at] === time) {
        this.values[at] = value;
      } else {
        this.times.splice(at, 0, time);
        this.values.splice(at, 0, value);
      }
    }
    if (this.times.length > 2 * kMaxPoints) {
      // every second of the older half
      const keep = (_: number, i: number): boolean => i > kMaxPoints || i % 2 === 0;
      this.times = this.times.filter(keep);
      this.values = this.values.filter(keep);
    }
  }

  /** After a reset, what was later is gone. */
  cutAfter(time: number): void {
    const at = lowerBound(this.times, time);
    this.times.length = this.values.length = at;
  }
}

function lowerBound(sorted: number[], value: number): number {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle]! < value) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

const kColors = ["#2f7de1", "#e0663c", "#2c9c6a", "#a35bd0", "#c79a1b", "#d4477f"];

/** A plot of one series, with its name and last value above it. */
export class Plot {
  readonly element: HTMLElement;
  private readonly value = h("output", {});
  private readonly holder = h("div", { class: "plot-area" });
  private chart: uPlot | null = null;
  private shownLength = -1;
  private readonly observer: ResizeObserver;

  constructor(
    readonly name: string,
    unit: string,
    readonly series: Series,
    private readonly onSeek: ((time: number) => void) | null,
    number: number,
    close: HTMLElement | null = null,
  ) {
    this.element = h(
      "figure",
      { class: "plot" },
      h(
        "figcaption",
        {},
        h("span", { class: "name" }, name),
        this.value,
        h("span", { class: "unit" }, unit),
        close,
      ),
      this.holder,
    );
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.holder);
    this.color = kColors[number % kColors.length]!;
  }

  private readonly color: string;

  /** Draws what is new; now: the time shown. */
  update(now: number): void {
    const { times, values } = this.series;
    const at = Math.min(lowerBound(times, now + 1e-9), times.length) - 1;
    this.value.textContent = at >= 0 ? formatNumber(values[at]!) : "–";
    if (this.holder.clientWidth === 0) {
      return;
    }
    if (this.chart === null) {
      this.chart = this.make();
    }
    if (this.shownLength !== times.length || times.length === 0) {
      this.shownLength = times.length;
      this.chart.setData([times, values.map((value) => (Number.isFinite(value) ? value : null))]);
    }
    const left = this.chart.valToPos(now, "x");
    this.holder.style.setProperty("--now", Number.isFinite(left) ? `${left}px` : "-9px");
  }

  destroy(): void {
    this.observer.disconnect();
    this.chart?.destroy();
  }

  /** Colours have changed. */
  restyle(): void {
    this.chart?.destroy();
    this.chart = null;
    this.shownLength = -1;
  }

  private resize(): void {
    const width = this.holder.clientWidth;
    if (this.chart !== null && width > 0) {
      this.chart.setSize({ width, height: 110 });
    }
  }

  // null: there are no values
  private rangeOf(min: number | null, max: number | null): uPlot.Range.MinMax {
    if (min === null || max === null) {
      return [0, 1];
    }
    if (min === max) {
      return min === 0 ? [0, 1] : [min - 0.1 * Math.abs(min), min + 0.1 * Math.abs(min)];
    }
    return part("plots").uPlot.rangeNum(min, max, 0.1, true);
  }

  private make(): uPlot {
    const style = getComputedStyle(document.documentElement);
    const text = style.getPropertyValue("--muted").trim();
    const line = style.getPropertyValue("--line").trim();
    const font = "11px system-ui, sans-serif";
    const axis = { stroke: text, font, grid: { stroke: line, width: 1 }, ticks: { show: false } };
    const chart = new (part("plots").uPlot)(
      {
        width: this.holder.clientWidth,
        height: 110,
        padding: [6, 18, 0, 0],
        legend: { show: false },
        cursor: { y: false, points: { size: 6 }, drag: { x: false, y: false } },
        scales: { x: { time: false }, y: { range: (_, min, max) => this.rangeOf(min, max) } },
        axes: [
          { ...axis, size: 22, gap: 2, space: 60, values: (_, ticks) => ticks.map((t) => `${formatNumber(t, 4)} s`) },
          { ...axis, size: 48, gap: 4, space: 26, values: (_, ticks) => ticks.map((t) => formatNumber(t, 4)) },
        ],
        series: [{}, { stroke: this.color, width: 1.5, points: { show: false } }],
      },
      [[], []],
      this.holder,
    );
    if (this.onSeek !== null) {
      const { onSeek } = this;
      chart.over.style.cursor = "pointer";
      chart.over.title = "Click to go to this time";
      chart.over.addEventListener("click", (event) => {
        onSeek(chart.posToVal(event.offsetX, "x"));
      });
    }
    return chart;
  }
}
