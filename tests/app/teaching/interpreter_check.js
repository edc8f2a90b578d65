// SPDX-License-Identifier: GPL-3.0-or-later
// node interpreter_check.js INTERPRETER DATA: compares the interpreter of the pages with the library. DATA is a list
// of forms: name, code, kinds, comparesLess, and runs with line, window, outcome, visible, counts. Prints the number of
// runs and, of each form, the first run that differs.
'use strict';
const [interpreter, file] = process.argv.slice(2);
const interpret = require(interpreter);
const forms = JSON.parse(require('fs').readFileSync(file, 'utf8'));
const equal = (a, b) => typeof b === 'string' ? String(a) === b : a === b; // JSON has no NaN and no Infinity
let runs = 0;
for (const { name, code, kinds, comparesLess, runs: all } of forms)
  for (const { line, window, outcome, visible, counts } of all) {
    ++runs;
    let found = null, why = '';
    try { found = interpret(code, line, window, kinds); } catch (error) { why = error.message; }
    if (found && found.outcome !== outcome) why = found.outcome + ' for ' + outcome;
    if (found && !why && visible && !visible.every((v, i) => equal(found.visible[i], v)))
      why = String(found.visible) + ' for ' + visible;
    if (found && !why) for (const kind of Object.keys(counts))
      if (found.counts[kind] !== counts[kind] && !(comparesLess && kind === 'comparisons'))
        why = found.counts[kind] + ' ' + kind + ' for ' + counts[kind];
    if (!why) continue;
    console.log(name + ', line ' + line + ', window ' + window + ': ' + why);
    break;
  }
console.log(runs);
