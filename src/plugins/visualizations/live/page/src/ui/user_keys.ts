// Keys on the picture. The experiment's user functions get them first; the page acts on those that they leave to it.

export interface UserKeyHost {
  /** Resolves with whether user functions have used the key; null: there are none to tell. */
  tell(key: string, isDown: boolean): Promise<boolean> | null;
  /** What the key means in the page. */
  act(key: string): void;
}

interface HeldKey {
  key: string;
  /** What user functions have said; null: nothing yet. */
  isUsed: boolean | null;
}

export class UserKeys {
  // Keys by their places on the keyboard: with Shift, a key is released by another name.
  private readonly held = new Map<string, HeldKey>();

  constructor(private readonly host: UserKeyHost) {}

  /** Returns false if nothing was told: the page acts at once. */
  press(event: Pick<KeyboardEvent, "code" | "key" | "repeat">): boolean {
    const place = event.code || event.key;
    const known = this.held.get(place);
    if (known !== undefined && event.repeat) {
      if (known.isUsed === false) {
        this.host.act(event.key);
      }
      return true;
    }
    const answer = this.host.tell(event.key, true);
    if (answer === null) {
      return false;
    }
    const pressed: HeldKey = { key: event.key, isUsed: null };
    this.held.set(place, pressed);
    void answer.then((isUsed) => {
      pressed.isUsed = isUsed;
      if (!isUsed) {
        this.host.act(pressed.key);
      }
    });
    return true;
  }

  /** Returns false if it was not told that the key was pressed. */
  release(event: Pick<KeyboardEvent, "code" | "key">): boolean {
    const place = event.code || event.key;
    const pressed = this.held.get(place);
    if (pressed === undefined) {
      return false;
    }
    this.held.delete(place);
    void this.host.tell(pressed.key, false);
    return true;
  }

  /** The window has lost the keyboard, and does not hear that keys are released. */
  releaseAll(): void {
    for (const [code, { key }] of [...this.held]) {
      this.release({ code, key });
    }
  }
}
