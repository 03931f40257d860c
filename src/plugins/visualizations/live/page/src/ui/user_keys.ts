// Keys on the picture. The experiment's user functions get them first; the page acts on those that they leave to it.

import type { Modifiers } from "../session";

export interface UserKeyHost {
  /** Resolves with whether user functions have used the key; null: there are none to tell. */
  tell(key: string, isDown: boolean, modifiers: Modifiers): Promise<boolean> | null;
  /** What the key means in the page. */
  act(key: string): void;
}

export type KeyEvent = Pick<
  KeyboardEvent,
  "code" | "key" | "shiftKey" | "ctrlKey" | "altKey" | "metaKey" | "getModifierState"
>;

interface HeldKey {
  key: string;
  /** What user functions have said; null: nothing yet. */
  isUsed: boolean | null;
}

// with Ctrl or Meta, what would be missed: copy, find, reload, tabs, windows, zoom, printing, the developer's tools
const kShortcutsOfBrowsers = /^[-+=0cfijlnpqrtvw]$/i;
const kNone: Modifiers = { shift: false, control: false, alt: false, meta: false };

/** AltGr, which is Control and Alt where the system says so, only chooses the character. */
export function modifiersOf(event: KeyEvent): Modifiers {
  const isCharacter = event.key.length === 1 && event.getModifierState("AltGraph");
  return {
    shift: event.shiftKey,
    control: event.ctrlKey && !isCharacter,
    alt: event.altKey && !isCharacter,
    meta: event.metaKey,
  };
}

/** With such a modifier, keys are none of the page. */
export function isCommand({ control, alt, meta }: Modifiers): boolean {
  return control || alt || meta;
}

export class UserKeys {
  // Keys by their places on the keyboard: with Shift, a key is released by another name.
  private readonly held = new Map<string, HeldKey>();

  constructor(private readonly host: UserKeyHost) {}

  /** Returns false if nothing was told: the page acts at once. */
  press(event: KeyEvent & Pick<KeyboardEvent, "repeat">): boolean {
    const place = event.code || event.key;
    const known = this.held.get(place);
    const modifiers = modifiersOf(event);
    if (known !== undefined && event.repeat) {
      if (known.isUsed === false && !isCommand(modifiers)) {
        this.host.act(event.key);
      }
      return true;
    }
    if ((modifiers.control || modifiers.meta) && kShortcutsOfBrowsers.test(event.key)) {
      return false;
    }
    const answer = this.host.tell(event.key, true, modifiers);
    if (answer === null) {
      return false;
    }
    const pressed: HeldKey = { key: event.key, isUsed: null };
    this.held.set(place, pressed);
    void answer.then((isUsed) => {
      pressed.isUsed = isUsed;
      if (!isUsed && !isCommand(modifiers)) {
        this.host.act(pressed.key);
      }
    });
    return true;
  }

  /** Returns false if it was not told that the key was pressed. */
  release(event: KeyEvent): boolean {
    const isReleased = this.releasePlace(event.code || event.key, modifiersOf(event));
    if (event.key === "Meta") {
      this.releaseAll(); // some systems do not tell of keys that are released while it is down
    }
    return isReleased;
  }

  /** The window has lost the keyboard, and does not hear that keys are released. */
  releaseAll(): void {
    for (const place of [...this.held.keys()]) {
      this.releasePlace(place, kNone);
    }
  }

  private releasePlace(place: string, modifiers: Modifiers): boolean {
    const pressed = this.held.get(place);
    if (pressed === undefined) {
      return false;
    }
    this.held.delete(place);
    void this.host.tell(pressed.key, false, modifiers);
    return true;
  }
}
