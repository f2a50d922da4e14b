// SPDX-License-Identifier: MIT
// What the scripts of this folder share: the models they read, and containers baked from them.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const SOME_FAILED = 9; // exit code
const PROJECT = fileURLToPath(new URL('../..', import.meta.url));

// Folder of model files from outside: $POSEPACK_ASSETS, else shared/assets beside the checkout.
export function assetsFolder(name) {
    return path.join(process.env.POSEPACK_ASSETS || path.join(PROJECT, '..', 'shared', 'assets'), name);
}

// Runs the compiler at `exe`; throws an Error with what it said when it ends with another exit code than `good`.
export function runPosepack(exe, args, good = [0]) {
    const child = spawnSync(exe, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
    if (!good.includes(child.status))
        throw new Error(
            `${exe} ${args.join(' ')}: exit code ${child.status}\n${child.stderr}${child.error ?? ''}`,
        );
}

// Bakes a catalog in RGBA32F, without measuring.
//   options  encoding, texelOrder, and perhaps space, rate (Hz), only (ids, comma-separated) and keepGoing: what
//            cannot be baked is left out
export function bakeFloats(exe, catalog, models, folder, options) {
    const args = ['bake', catalog, '--models', models, '-o', folder, '--encoding', options.encoding];
    args.push('--texel-order', options.texelOrder, '--texel-format', 'rgba32f', '--caps', 'desktop');
    args.push('--no-measure', '--no-fsync');
    if (options.space) args.push('--space', options.space);
    if (options.rate) args.push('--rate', options.rate);
    if (options.only) args.push('--only', options.only);
    if (options.keepGoing) args.push('--keep-going');
    runPosepack(exe, args, options.keepGoing ? [0, SOME_FAILED] : [0]);
}

// The animals of a catalog, all or those of `only`: [{id, model}].
export function animalsOf(catalog, only) {
    const all = JSON.parse(fs.readFileSync(catalog, 'utf8')).animals;
    return (only ? only.split(',') : Object.keys(all)).map((id) => ({ id, model: all[id].model }));
}

// Runs `work` with a folder that is removed afterwards, and returns what it returns.
export async function withScratchFolder(work) {
    const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'posepack-oracle-'));
    try {
        return await work(scratch);
    } finally {
        fs.rmSync(scratch, { recursive: true, force: true });
    }
}
