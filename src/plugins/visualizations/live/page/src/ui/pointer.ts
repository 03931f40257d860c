// Mouse, pen and fingers on the picture.

import type { Vector } from "../decode/types";
import type { View } from "../view/view";

export interface PointerHost {
  /** The entity -1: nothing was hit. */
  picked(entity: number, withShift: boolean): void;
  /** Whether the entity may be dragged now. */
  canDrag(entity: number): boolean;
  /** While it is dragged and, with isDone, when it is let go. */
  dragged(entity: number, place: Vector, isDone: boolean): void;
  /** The same for turning it; yaw in the world, rad. */
  turned(entity: number, yaw: number, isDone: boolean): void;
  moved(): void;
}

const kClickPixels = 5;

export class PointerControl {
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private start: { x: number; y: number; time: number } | null = null;
  private isClick = false;
  private dragEntity = -1;
  private isTurning = false;
  private pinch = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly view: View,
    private readonly host: PointerHost,
  ) {
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("pointercancel", (event) => this.up(event));
    canvas.addEventListener("pointerleave", () => {
      view.hovered = -1;
    });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("dblclick", (event) => {
      if (this.view.pick(event.offsetX, event.offsetY) < 0) {
        this.view.camera.frameHome();
        this.host.moved();
      }
    });
  }

  private down(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus({ preventScroll: true });
    document.dispatchEvent(new CustomEvent("closemenus"));
    this.pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    this.pinch = 0;
    if (this.pointers.size > 1) {
      this.isClick = false;
      this.dragEntity = -1;
      return;
    }
    this.start = { x: event.offsetX, y: event.offsetY, time: event.timeStamp };
    this.isClick = event.button === 0;
    this.dragEntity = -1;
    if (event.button === 0) {
      const entity = this.view.pick(event.offsetX, event.offsetY);
      if (entity >= 0 && this.host.canDrag(entity)) {
        this.dragEntity = entity;
        this.isTurning = event.ctrlKey || event.altKey || event.metaKey;
      }
    }
  }

  private move(event: PointerEvent): void {
    const last = this.pointers.get(event.pointerId);
    if (last === undefined) {
      if (event.pointerType === "mouse") {
        this.view.hover(event.offsetX, event.offsetY);
        this.canvas.style.cursor = this.view.hovered >= 0 ? "pointer" : "";
      }
      return;
    }
    const dx = event.offsetX - last.x;
    const dy = event.offsetY - last.y;
    this.pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (this.pointers.size === 2) {
      this.movePinch(dx, dy);
      return;
    }
    const { start } = this;
    if (start !== null && Math.hypot(event.offsetX - start.x, event.offsetY - start.y) > kClickPixels) {
      this.isClick = false;
    }
    if (this.isClick) {
      return;
    }
    if (this.dragEntity >= 0) {
      this.drag(event, false);
    } else if ((event.buttons & 6) !== 0 || event.shiftKey || event.ctrlKey) {
      this.view.camera.pan(dx, dy);
      this.host.moved();
    } else {
      this.view.camera.orbit(dx, dy);
      if (this.view.camera.mode === "top") {
        this.host.moved();
      }
    }
  }

  private up(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    this.pinch = 0;
    if (event.type === "pointercancel") {
      return;
    }
    if (this.isClick) {
      this.host.picked(this.view.pick(event.offsetX, event.offsetY), event.shiftKey);
    } else if (this.dragEntity >= 0) {
      this.drag(event, true);
    }
    this.isClick = false;
    this.dragEntity = -1;
  }

  private drag(event: PointerEvent, isDone: boolean): void {
    const height = this.view.poseOf(this.dragEntity).position[2];
    const place = this.view.camera.groundPoint(event.offsetX, event.offsetY, height);
    if (place !== null && this.isTurning) {
      const { position } = this.view.poseOf(this.dragEntity);
      const [x, y] = [place[0] - position[0], place[1] - position[1]];
      if (Math.hypot(x, y) > 1e-6) {
        this.host.turned(this.dragEntity, Math.atan2(y, x), isDone);
      }
    } else if (place !== null) {
      this.host.dragged(this.dragEntity, place, isDone);
    }
  }

  // two fingers: zoom and pan
  private movePinch(dx: number, dy: number): void {
    const [a, b] = [...this.pointers.values()] as [{ x: number; y: number }, { x: number; y: number }];
    const apart = Math.hypot(a.x - b.x, a.y - b.y);
    if (this.pinch > 0) {
      this.view.camera.zoom(apart / this.pinch, 0.5 * (a.x + b.x), 0.5 * (a.y + b.y));
    }
    this.pinch = apart;
    this.view.camera.pan(0.5 * dx, 0.5 * dy);
    this.host.moved();
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 30 : 1);
    const factor = Math.exp(-Math.min(Math.max(pixels, -300), 300) * 0.0016);
    this.view.camera.zoom(factor, event.offsetX, event.offsetY);
    if (this.view.followed < 0) {
      this.host.moved();
    }
  }
}
