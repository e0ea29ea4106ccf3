// validate.mjs FOLDER FILE...: prints a line per message of the validator in FOLDER; the exit status is 1 if there
// is one. What it only informs of (an empty scene, a node without a mesh) is no fault.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(folder + '/')('gltf-validator');
for (const file of files) {
  const {issues} = await validator.validateBytes(new Uint8Array(readFileSync(file)), {maxIssues: 20});
  for (const {severity, code, message, pointer} of issues.messages) {
    if (severity === 2) continue;
    console.log(`${file}: ${pointer ?? ''} ${code}: ${message}`);
    process.exitCode = 1;
  }
}
