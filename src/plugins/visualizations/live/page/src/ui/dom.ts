// Helpers for elements of the page. All texts go through textContent.

type Child = Node | string | null | false;
type Attributes = Record<string, string | number | boolean | ((event: never) => void) | null>;

/** An element with attributes, listeners ("onclick": function) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") {
      element.addEventListener(name.slice(2), value as EventListener);
    } else if (typeof value === "boolean") {
      element.toggleAttribute(name, value);
    } else if (value !== null) {
      element.setAttribute(name, String(value));
    }
  }
  element.append(...children.filter((child): child is Node | string => Boolean(child)));
  return element;
}

// paths on a field of 20 x 20, stroked
const kIcons = {
  play: "M6 4l10 6-10 6z",
  pause: "M6.5 4v12M13.5 4v12",
  stepForward: "M5 4l8 6-8 6zM15.5 4v12",
  stepBack: "M15 4l-8 6 8 6zM4.5 4v12",
  toStart: "M16 4l-6 6 6 6zM10 4l-6 6 6 6z",
  reset: "M4.5 10a5.5 5.5 0 1 0 1.8-4.1M4 3v3.6h3.6",
  dice: "M4 4h12v12H4zM7.5 7.5h.01M12.5 12.5h.01M10 10h.01",
  stop: "M5 5h10v10H5z",
  open: "M3 6v9.5h14V7.5h-7L8.5 5H3z",
  camera: "M3 6.5h3L7.5 4.5h5L14 6.5h3v9H3zM10 8.2a2.7 2.7 0 1 0 .01 0",
  layers: "M10 3.5l7 3.7-7 3.7-7-3.7zM3 11l7 3.7 7-3.7",
  view: "M10 3.2l6 3.4v6.8l-6 3.4-6-3.4V6.6zM4 6.6l6 3.4 6-3.4M10 10v6.8",
  theme: "M10 3.5a6.5 6.5 0 1 0 0 13zM10 3.5a6.5 6.5 0 0 1 0 13",
  help: "M7.6 7.6a2.4 2.4 0 1 1 3.4 2.2c-.7.4-1 .8-1 1.7M10 14.4h.01M10 2.8a7.2 7.2 0 1 0 .01 0",
  close: "M5.5 5.5l9 9M14.5 5.5l-9 9",
  pin: "M7 3.5h6l-.8 5 2.3 2.5h-9L7.8 8.500zM10 11v5.5",
  follow: "M10 6.200a3.8 3.8 0 1 0 .01 0M10 2v3M10 15v3M2 10h3M15 10h3",
  eye: "M2.500 10s2.800-5 7.500-5 7.500 5 7.500 5-2.800 5-7.500 5-7.500-5-7.500-5zM10 7.800a2.2 2.2 0 1 0 .01 0",
  plot: "M3.500 3.500v13h13M6 12.500l3-3.500 2.500 2 4-5.500",
  fit: "M3.500 7.500v-4h4M12.500 3.500h4v4M16.500 12.500v4h-4M7.500 16.500h-4v-4",
  key: "M3 6.500h14v8H3zM6 9h.01M9 9h.01M12 9h.01M7 12h6",
  trash: "M4.500 6h11M8 6V4h4v2M6 6l.7 10.500h6.600L14 6",
  plus: "M10 4v12M4 10h12",
  hand: "M6.500 10V5.500a1.200 1.200 0 0 1 2.400 0V9M8.900 9V4.400a1.200 1.200 0 0 1 2.400 0V9M11.300 9V5.500a1.200 1.200 0 0 1 2.400 0v5.500c0 3.500-1.700 5.500-4.300 5.500-2.200 0-3.200-1-4.800-4.300-.5-1 .9-1.900 1.900-.9z",
} as const;

export type IconName = keyof typeof kIcons;

export function icon(name: IconName): SVGSVGElement {
  const namespace = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(namespace, "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(namespace, "path");
  path.setAttribute("d", kIcons[name]);
  svg.append(path);
  return svg;
}

export interface ButtonOptions {
  icon?: IconName;
  text?: string;
  /** Name for screen readers and title; by default the text. */
  title?: string;
  key?: string;
  className?: string;
  pressed?: boolean;
  onClick: () => void;
}

export function button(options: ButtonOptions): HTMLButtonElement {
  const title = options.title ?? options.text ?? "";
  const full = options.key === undefined ? title : `${title} (${options.key})`;
  const element = h(
    "button",
    {
      type: "button",
      class: options.className ?? "",
      title: full,
      "aria-label": title,
      onclick: options.onClick,
    },
    options.icon !== undefined && icon(options.icon),
    options.text !== undefined && h("span", {}, options.text),
  );
  element.dataset.title = full;
  if (options.pressed !== undefined) {
    element.setAttribute("aria-pressed", String(options.pressed));
  }
  return element;
}

/** Enables a button, or disables it with the reason as its title. */
export function setEnabled(element: HTMLButtonElement | HTMLSelectElement | HTMLInputElement, reason: string | null): void {
  element.disabled = reason !== null;
  element.title = reason ?? element.dataset.title ?? "";
}

export function setIcon(element: HTMLElement, name: IconName, title: string): void {
  element.querySelector("svg")?.replaceWith(icon(name));
  element.title = title;
  element.dataset.title = title;
  element.setAttribute("aria-label", title.replace(/ \(.*/, ""));
}

export function setText(element: Element, text: string): void {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

/** A button that opens a box of choices below it. */
export function menu(opener: HTMLButtonElement, content: HTMLElement): HTMLElement {
  content.classList.add("menu");
  content.hidden = true;
  opener.setAttribute("aria-haspopup", "true");
  opener.setAttribute("aria-expanded", "false");
  const close = (): void => {
    content.hidden = true;
    opener.setAttribute("aria-expanded", "false");
  };
  opener.addEventListener("click", () => {
    const willOpen = content.hidden;
    document.dispatchEvent(new CustomEvent("closemenus"));
    content.hidden = !willOpen;
    opener.setAttribute("aria-expanded", String(willOpen));
  });
  document.addEventListener("closemenus", close);
  document.addEventListener("pointerdown", (event) => {
    if (!wrapper.contains(event.target as Node)) {
      close();
    }
  });
  const wrapper = h("div", { class: "menu-holder" }, opener, content);
  wrapper.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !content.hidden) {
      close();
      opener.focus();
      event.stopPropagation();
    }
  });
  return wrapper;
}
