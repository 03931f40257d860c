// Parts of the page: scripts in it that are run when they are needed. The first picture needs only that of the page itself.

interface Parts {
  page: typeof import("./main");
  editor: typeof import("./ui/editor");
  plots: typeof import("./ui/charts");
}

/** Runs the part if it was not run before. */
export function part<NAME extends keyof Parts>(name: NAME): Parts[NAME] {
  const global = window as unknown as Record<string, Parts[NAME] | undefined>;
  const key = `argosPart_${name}`; // so build.mjs names what it exports
  if (global[key] === undefined) {
    const script = document.createElement("script");
    script.textContent = document.getElementById(`part-${name}`)!.textContent;
    document.head.append(script); // runs it
    script.remove();
  }
  return global[key]!;
}
