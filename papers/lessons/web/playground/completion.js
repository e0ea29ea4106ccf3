// What may stand at a place of a tree file, by the schema of `cnrg schema` and the names in the text.
import {syntaxTree} from '@codemirror/language';

const KEYED = new Set(['Pair', 'BlockSequence', 'FlowSequence', 'Item']);

/** The keys and items around a place, outermost first: texts, and null for an item of a list. */
export function pathAt(state, node) {
  const path = [];
  for (let up = node; up; up = up.parent) {
    if (!KEYED.has(up.name)) continue;
    if (up.name !== 'Pair') path.unshift(null);
    else {
      const key = up.getChild('Key');
      // A place in a key is beside its pair, not below it.
      if (key && !(key.from <= node.from && node.to <= key.to)) path.unshift(state.sliceDoc(key.from, key.to).replace(/^["']|["']$/g, ''));
    }
  }
  return path.filter((step, i) => step !== null || path[i - 1] !== null);
}

/** A schema with what it refers to in its place: all that it may be. */
function alternatives(schema, root) {
  if (!schema || schema === true) return [];
  const out = [];
  const add = (one) => {
    if (!one || one === true) return;
    if (one.$ref) add(root.$defs[one.$ref.replace('#/$defs/', '')]);
    for (const other of [...(one.anyOf ?? []), ...(one.oneOf ?? []), ...(one.allOf ?? [])]) add(other);
    out.push(one);
  };
  add(schema);
  return out;
}

function below(schemas, step, root) {
  return schemas.flatMap((schema) => {
    if (step === null) return [...(schema.prefixItems ?? []), schema.items].flatMap((s) => alternatives(s, root));
    const found = schema.properties?.[step] ?? (typeof schema.additionalProperties === 'object' ? schema.additionalProperties : null);
    return alternatives(found, root);
  });
}

/** All schemas that hold at a path. */
export const schemasAt = (root, path) => path.reduce((schemas, step) => below(schemas, step, root), alternatives(root, root));

/** Names that stand in a map at the top of the text. */
function namesIn(state, section) {
  const names = [];
  syntaxTree(state).iterate({enter: (node) => {
    if (node.name !== 'Pair') return;
    const path = pathAt(state, node.node);
    const key = node.node.getChild('Key');
    if (key && path.length === 2 && path[0] === section) names.push(path[1]);
  }});
  return [...new Set(names)];
}

const described = (schema, root) => alternatives(schema, root).map((s) => s.description).find(Boolean) ?? '';

/** The completion of CodeMirror for a schema. */
export const completeBy = (root) => (context) => {
  const {state, pos} = context, word = context.matchBefore(/[\w-]*/);
  if (word.from === word.to && !context.explicit) return null;
  const line = state.doc.lineAt(pos), before = line.text.slice(0, word.from - line.from);
  const inValue = /[:[,]\s*$/.test(before) && !/[{]\s*[\w-]*$/.test(before) && !/^\s*$/.test(before);
  const path = pathAt(state, syntaxTree(state).resolveInner(word.from + (word.to > word.from ? 1 : 0), -1));
  const schemas = schemasAt(root, path), options = new Map();
  for (const schema of schemas) {
    for (const [key, value] of Object.entries(schema.properties ?? {})) {
      options.set(key, {label: key, type: 'property', info: described(value, root), apply: `${key}: `});
    }
    for (const value of schema.enum ?? []) options.set(String(value), {label: String(value), type: 'enum'});
    if (schema.type === 'boolean') for (const value of ['true', 'false']) options.set(value, {label: value, type: 'enum'});
  }
  if (inValue || path.at(-1) === null) {
    for (const name of namesIn(state, path.at(-1) === 'material' ? 'materials' : 'nodes')) {
      options.set(name, {label: name, type: 'variable', boost: 1});
    }
  }
  return options.size ? {from: word.from, options: [...options.values()], validFor: /^[\w-]*$/} : null;
};
