// SPDX-License-Identifier: MIT
// Every animal that posepack makes is valid glTF by the official validator, without a warning.
//
//   node validate_menagerie.mjs --posepack EXE
//
// Looks at the thirty animals, others made from a seed, the birds and the toy; in a damaged one the validator has to
// find the fault. The test is skipped (exit code 77) without the modules of tests/node, but fails where
// CI=true. It fails when nothing was looked at.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { runPosepack, withScratchFolder } from './posepack.mjs';

const SKIPPED = 77;
const ANIMALS = 60; // the thirty, and one other of each kind
const MODULES = path.join(path.dirname(fileURLToPath(import.meta.url)), '..', 'node');

const { values: options } = parseArgs({ options: { posepack: { type: 'string' } } });

if (!fs.existsSync(path.join(MODULES, 'node_modules', 'gltf-validator'))) {
    console.log('gltf-validator is not installed: run npm ci in tests/node, or ./dev test');
    process.exit(process.env.CI ? 1 : SKIPPED);
}
const validator = createRequire(path.join(MODULES, 'package.json'))('gltf-validator');

// Errors and warnings of a GLB, one line each; information about it is left out.
async function findingsIn(glb) {
    const { issues } = await validator.validateBytes(new Uint8Array(glb), { maxIssues: 0 });
    return issues.messages.filter(({ severity }) => severity <= 1)
        .map(({ code, pointer, message }) => `${code} ${pointer ?? ''} ${message}`);
}

// A good animal whose skin names a joint twice.
function damaged(glb) {
    const text = Buffer.from(glb).toString('latin1');
    const place = text.indexOf('"joints":[') + '"joints":['.length;
    const out = Buffer.from(glb);
    out.write('9', place + text.slice(place).search(/[0-9]/), 'latin1');
    return out;
}

async function validateFolder(folder) {
    const names = fs.readdirSync(folder).filter((name) => name.endsWith('.glb')).sort();
    let faulty = 0;
    for (const name of names) {
        const findings = await findingsIn(fs.readFileSync(path.join(folder, name)));
        if (findings.length === 0) continue;
        ++faulty;
        console.log(`${name}: ${findings.length} findings, the first: ${findings[0]}`);
    }
    return { files: names.length, faulty };
}

await withScratchFolder(async (scratch) => {
    const total = { files: 0, faulty: 0 };
    for (const extra of [['--animals', String(ANIMALS)], ['--birds'], ['--toy']]) {
        const folder = path.join(scratch, extra[0]);
        runPosepack(options.posepack, ['menagerie', folder, ...extra]);
        const { files, faulty } = await validateFolder(folder);
        total.files += files;
        total.faulty += faulty;
    }
    const goat = fs.readFileSync(path.join(scratch, '--animals', 'goat.glb'));
    const found = await findingsIn(damaged(goat));
    const isSharp = found.length > 0;
    console.log(`damaged goat: ${found[0] ?? 'nothing found'}`);
    console.log(`validated ${total.files} files, ${total.faulty} with errors or warnings (${validator.version()})`);
    process.exitCode = total.files > ANIMALS && total.faulty === 0 && isSharp ? 0 : 1;
});
