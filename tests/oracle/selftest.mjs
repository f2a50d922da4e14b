// SPDX-License-Identifier: MIT
// Shows that the comparison with three.js would find faults: a good container passes; with one number moved
// by 2e-5 of the radius, two bones exchanged, or rows late by one, it is seen, and at the right place.
//
//   node selftest.mjs --posepack EXE --catalog FILE
import fs from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { compareAnimal } from './compare.mjs';
import { readContainer } from './container.mjs';
import { bakeFloats, runPosepack, withScratchFolder } from './posepack.mjs';
import { ThreeAnimal } from './three_animal.mjs';

const LIMIT = 1e-5;
const ANIMAL = 'goat';
const { values: options } = parseArgs({
    options: { posepack: { type: 'string' }, catalog: { type: 'string' } },
});

// Each changes what a container answers; `at` is where the largest difference must be found.
function faults(good) {
    const row = good.clips[1].firstRow + 3;
    const bone = good.boneOfJoint(5);
    const shift = (2e-5 * good.radiusM) / good.metresPerUnit;
    const nudged = (r, b, out) => {
        good.readBoneRow(r, b, out);
        if (r === row && b === bone) out[7] += shift;
    };
    const exchange = {
        [good.boneOfJoint(4)]: good.boneOfJoint(6),
        [good.boneOfJoint(6)]: good.boneOfJoint(4),
    };
    const last = good.layout.rowCount - 1;
    return [
        {
            name: 'a translation off by 2e-5 R',
            readBoneRow: nudged,
            at: { clip: good.clips[1].name, row: 3, joint: 5 },
        },
        {
            name: 'two bones exchanged',
            readBoneRow: (r, b, out) => good.readBoneRow(r, exchange[b] ?? b, out),
        },
        {
            name: 'rows late by one',
            readBoneRow: (r, b, out) => good.readBoneRow(Math.min(r + 1, last), b, out),
        },
    ];
}

function isFound(animal, good, fault) {
    const { worst } = compareAnimal(animal, { ...good, readBoneRow: fault.readBoneRow });
    const placed = Object.entries(fault.at ?? {}).every(([key, value]) => worst[key] === value);
    console.log(
        `${fault.name}: ${worst.error.toExponential(2)} R at ${worst.clip} row ${worst.row} joint ${worst.joint}`,
    );
    return worst.error > LIMIT && placed;
}

process.exitCode = await withScratchFolder(async (scratch) => {
    const models = path.join(scratch, 'models');
    const folder = path.join(scratch, 'palettes');
    runPosepack(options.posepack, ['menagerie', models, '--only', ANIMAL]);
    bakeFloats(options.posepack, options.catalog, models, folder, {
        encoding: 'affine',
        texelOrder: 'bone-major',
        only: ANIMAL,
    });
    const animal = await ThreeAnimal.load(fs.readFileSync(path.join(models, `${ANIMAL}.glb`)));
    const good = readContainer(fs.readFileSync(path.join(folder, `${ANIMAL}.posepack`)));
    const clean = compareAnimal(animal, good).worst.error <= LIMIT;
    const missed = faults(good).filter((fault) => !isFound(animal, good, fault));
    if (!clean) console.log('expected no difference in the container as it was baked');
    for (const fault of missed) console.log(`not found, or at another place: ${fault.name}`);
    return clean && missed.length === 0 ? 0 : 1;
});
