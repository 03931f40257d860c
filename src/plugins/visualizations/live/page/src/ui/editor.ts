// An editor of scripts in Lua.

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import {
  HighlightStyle,
  StreamLanguage,
  bracketMatching,
  indentOnInput,
  indentUnit,
  syntaxHighlighting,
} from "@codemirror/language";
import { lua } from "@codemirror/legacy-modes/mode/lua";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { EditorState } from "@codemirror/state";
import {
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";

const kColors = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--code-keyword)", fontWeight: "600" },
  { tag: [tags.string, tags.special(tags.string)], color: "var(--code-string)" },
  { tag: tags.comment, color: "var(--muted)", fontStyle: "italic" },
  { tag: [tags.number, tags.bool, tags.atom], color: "var(--code-number)" },
  { tag: [tags.standard(tags.variableName), tags.definition(tags.variableName)], color: "var(--accent)" },
]);

export interface EditorHost {
  /** By its keys. */
  apply(): void;
  /** The keyboard leaves it. */
  leave(): void;
  changed(): void;
}

export class LuaEditor {
  private readonly view: EditorView;

  constructor(parent: HTMLElement, text: string, host: EditorHost) {
    this.view = new EditorView({
      parent,
      state: EditorState.create({
        doc: text,
        extensions: [
          lineNumbers(),
          lintGutter(),
          history(),
          bracketMatching(),
          indentOnInput(),
          indentUnit.of("  "),
          highlightActiveLine(),
          highlightActiveLineGutter(),
          StreamLanguage.define(lua),
          syntaxHighlighting(kColors),
          EditorView.contentAttributes.of({ "aria-label": "Script in Lua" }),
          keymap.of([
            { key: "Mod-Enter", run: () => (host.apply(), true) },
            { key: "Mod-s", run: () => (host.apply(), true) },
            { key: "Escape", run: (view) => (view.contentDOM.blur(), host.leave(), true) },
            indentWithTab,
            ...defaultKeymap,
            ...historyKeymap,
          ]),
          EditorView.updateListener.of((change) => {
            if (change.docChanged) {
              host.changed();
            }
          }),
        ],
      }),
    });
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  /** Shows an error at a line, from 1 on; one that is not there: no error. */
  mark(text: string, line: number): void {
    const { view } = this;
    const isThere = line > 0 && line <= view.state.doc.lines;
    const place = isThere ? view.state.doc.line(line) : null;
    view.dispatch(
      setDiagnostics(
        view.state,
        place === null
          ? []
          : [{ from: place.from, to: Math.max(place.to, place.from), severity: "error", message: text }],
      ),
    );
    if (place !== null) {
      view.dispatch({ selection: { anchor: place.from }, effects: EditorView.scrollIntoView(place.from, { y: "center" }) });
    }
  }

  destroy(): void {
    this.view.destroy();
  }
}
