// The editor: a tree file in YAML, completed by the schema, with what the program said where it said it.
import {autocompletion, completionKeymap} from '@codemirror/autocomplete';
import {defaultKeymap, history, historyKeymap, indentWithTab} from '@codemirror/commands';
import {yaml} from '@codemirror/lang-yaml';
import {bracketMatching, defaultHighlightStyle, indentOnInput, syntaxHighlighting} from '@codemirror/language';
import {lintGutter, setDiagnostics} from '@codemirror/lint';
import {EditorState} from '@codemirror/state';
import {drawSelection, EditorView, highlightActiveLine, highlightSpecialChars, keymap, lineNumbers} from '@codemirror/view';
import {completeBy} from './completion.js';

/** An editor in `holder`; `changed` is called after each change. */
export function makeEditor(holder, schema, changed) {
  const extensions = [
    lineNumbers(), highlightSpecialChars(), history(), drawSelection(), indentOnInput(), bracketMatching(), highlightActiveLine(), lintGutter(),
    syntaxHighlighting(defaultHighlightStyle, {fallback: true}), yaml(), autocompletion({override: [completeBy(schema)]}),
    keymap.of([...defaultKeymap, ...historyKeymap, ...completionKeymap, indentWithTab]), EditorView.lineWrapping,
    EditorView.contentAttributes.of({'aria-label': 'The tree file', tabindex: '0', title: 'Escape, then Tab leaves the editor'}),
    EditorView.updateListener.of((update) => update.docChanged && changed()),
  ];
  const view = new EditorView({parent: holder, state: EditorState.create({extensions})});
  return {
    view,
    get text() { return view.state.doc.toString(); },
    set text(text) { view.dispatch({changes: {from: 0, to: view.state.doc.length, insert: text}}); },
    /** Messages `{line, column, severity, message}` at their places. */
    tell(messages) {
      const {doc} = view.state;
      view.dispatch(setDiagnostics(view.state, messages.map(({line, column, severity, message}) => {
        const at = doc.line(Math.min(Math.max(line, 1), doc.lines)), from = Math.min(at.from + Math.max(column - 1, 0), at.to);
        const word = /^[\w.-]+|^./u.exec(doc.sliceString(from, at.to));
        return {from, to: from + (word ? word[0].length : 0), severity, message};
      })));
    },
    goTo(line, column) {
      const at = view.state.doc.line(Math.min(line, view.state.doc.lines));
      view.dispatch({selection: {anchor: Math.min(at.from + column - 1, at.to)}, scrollIntoView: true});
      view.focus();
    },
  };
}
