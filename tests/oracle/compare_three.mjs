// SPDX-License-Identifier: MIT
// Bakes a catalog and compares every bone matrix with three.js.
//
//   node compare_three.mjs --posepack EXE --catalog FILE (--assets NAME | --menagerie)
//                          [--encoding NAME] [--space NAME] [--texel-order NAME] [--rate HZ] [--only IDS]
//                          [--limit R]
//
// --limit is the largest difference allowed, in parts of the radius R (default 1e-5, in RGBA32F).
//
// Models come from a folder of the assets ("animals"), or are generated first. Without the folder the test is
// skipped (exit code 77), but fails where CI=true. It fails when nothing was compared.
import fs from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { compareAnimal } from './compare.mjs';
import { readContainer } from './container.mjs';
import { animalsOf, assetsFolder, bakeFloats, runPosepack, withScratchFolder } from './posepack.mjs';
import { ThreeAnimal } from './three_animal.mjs';

const SKIPPED = 77;

// The bound, a fraction of R, is for RGBA32F. Dual quaternions leave out the last 1e-4 of a stretch that real files
// have between a bone's axes, so that they are given more.
const { values: options } = parseArgs({
    options: {
        posepack: { type: 'string' },
        catalog: { type: 'string' },
        assets: { type: 'string' },
        menagerie: { type: 'boolean', default: false },
        encoding: { type: 'string', default: 'affine' },
        'texel-order': { type: 'string', default: 'bone-major' },
        space: { type: 'string' },
        rate: { type: 'string' },
        only: { type: 'string' },
        limit: { type: 'string', default: '1e-5' },
    },
});
const LARGEST_ERROR = Number(options.limit);

function printAnimal(id, result) {
    const { error, clip, row, joint } = result.worst;
    const place = error > 0 ? `${clip} row ${row} joint ${joint}` : '';
    const counts = [result.clips, result.rows, result.matrices].map((n) => String(n).padStart(9)).join('');
    console.log(`${id.padEnd(22)}${counts}  ${error.toExponential(2)}  ${place}`);
}

// Compares every animal of the catalog with its container in `folder`, and adds up.
async function compareAll(models, folder) {
    const total = { files: 0, clips: 0, rows: 0, rowsLeftOut: 0, matrices: 0, largest: 0, faults: [] };
    console.log(`${'animal'.padEnd(22)}    clips     rows matrices  max / R   worst place`);
    for (const { id, model } of animalsOf(options.catalog, options.only)) {
        const animal = await ThreeAnimal.load(fs.readFileSync(path.join(models, model)));
        const container = readContainer(fs.readFileSync(path.join(folder, `${id}.posepack`)));
        const result = compareAnimal(animal, container);
        printAnimal(id, result);
        ++total.files;
        for (const key of ['clips', 'rows', 'rowsLeftOut', 'matrices']) total[key] += result[key];
        if (!(result.worst.error <= total.largest)) total.largest = result.worst.error;
        if (!(result.worst.error <= LARGEST_ERROR)) total.faults.push(id);
        if (result.matrices === 0) total.faults.push(`${id} (nothing compared)`);
    }
    return total;
}

// Prints the outcome and returns the exit code.
function judge(total) {
    console.log(
        `compared ${total.files} files, ${total.clips} clips, ${total.rows} rows, ${total.matrices} matrices ` +
            `(${options.encoding}, RGBA32F); largest difference ${total.largest.toExponential(2)} R` +
            (total.rowsLeftOut > 0
                ? `; ${total.rowsLeftOut} rows behind the last key of an open loop left out`
                : ''),
    );
    if (total.matrices === 0) console.log('expected matrices to compare, found none');
    if (total.faults.length > 0)
        console.log(`expected at most ${LARGEST_ERROR} R everywhere, not so in: ${total.faults.join(', ')}`);
    return total.matrices > 0 && total.faults.length === 0 ? 0 : 1;
}

async function bakeAndCompare(scratch) {
    const models = options.menagerie ? path.join(scratch, 'models') : assetsFolder(options.assets);
    const folder = path.join(scratch, 'palettes');
    if (options.menagerie) runPosepack(options.posepack, ['menagerie', models]);
    bakeFloats(options.posepack, options.catalog, models, folder, {
        ...options,
        texelOrder: options['texel-order'],
    });
    return judge(await compareAll(models, folder));
}

if (!options.menagerie && !fs.existsSync(assetsFolder(options.assets))) {
    console.log(`skipped: no folder ${assetsFolder(options.assets)}; POSEPACK_ASSETS names its parent`);
    process.exitCode = process.env.CI === 'true' ? 1 : SKIPPED;
} else {
    process.exitCode = await withScratchFolder(bakeAndCompare);
}
