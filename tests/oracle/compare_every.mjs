// SPDX-License-Identifier: MIT
// Bakes every GLB of some folders of the assets and compares the bone matrices of all that are accepted and that
// three.js loads: each row of each clip, joints by boneMatrices, rigid meshes by the matrixWorld of their nodes.
//
//   node compare_every.mjs --posepack EXE --exceptions FILE --assets NAME[,NAME...]
//
// The exceptions say of a file (as "features/name.glb") why three.js does not load it, or where the two differ
// and what the glTF text says: {"loads": false | "differs": true | "limit": R, "because": sentence}. An exception
// that is none any more is a fault, as is a difference beyond 1e-5 R that is none. Without the folders the test is
// skipped (exit code 77), but fails where CI=true. It fails when nothing was compared.
import fs from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { compareAnimal } from './compare.mjs';
import { readContainer } from './container.mjs';
import { assetsFolder, bakeFloats, withScratchFolder } from './posepack.mjs';
import { ThreeAnimal } from './three_animal.mjs';

const SKIPPED = 77;
const LARGEST_ERROR = 1e-5; // of R, in RGBA32F
const { values: options } = parseArgs({
    options: {
        posepack: { type: 'string' },
        exceptions: { type: 'string' },
        assets: { type: 'string' },
    },
});
const folders = options.assets.split(',');
const exceptions = JSON.parse(fs.readFileSync(options.exceptions, 'utf8'));

// The animals of a catalog of all GLBs in a folder, each by an id that a catalog takes.
function animalsIn(folder) {
    const files = fs
        .readdirSync(assetsFolder(folder))
        .filter((name) => name.endsWith('.glb'))
        .sort();
    return files.map((model) => ({ id: path.basename(model, '.glb').replace(/[^A-Za-z0-9_-]/g, '_'), model }));
}

// The container of every animal that is accepted: id -> path.
function bakeAll(folder, animals, scratch) {
    const catalog = path.join(scratch, `${folder}.json`);
    const entries = Object.fromEntries(animals.map(({ id, model }) => [id, { model }]));
    fs.writeFileSync(catalog, JSON.stringify({ schema: 1, animals: entries }));
    const palettes = path.join(scratch, folder);
    bakeFloats(options.posepack, catalog, assetsFolder(folder), palettes, {
        encoding: 'affine',
        texelOrder: 'bone-major',
        keepGoing: true,
    });
    const containers = animals.map(({ id }) => [id, path.join(palettes, `${id}.posepack`)]);
    return new Map(containers.filter(([, file]) => fs.existsSync(file)));
}

// What became of one file: {fault, note, result}; the fault is empty where all is as it should be.
async function examine(name, glb, container) {
    const exception = exceptions[name] ?? {};
    let animal;
    try {
        animal = await ThreeAnimal.load(glb);
    } catch (error) {
        const isKnown = exception.loads === false;
        return { fault: isKnown ? '' : `three.js does not load it: ${error.message}`, note: exception.because };
    }
    if (exception.loads === false) return { fault: 'three.js loads it, the exceptions say otherwise' };
    if (exception.differs) {
        const isSame = await isWithin(animal, container);
        return { fault: isSame ? 'no difference is left, the exceptions say otherwise' : '', note: exception.because };
    }
    let result;
    try {
        result = compareAnimal(animal, container);
    } catch (error) {
        return { fault: `cannot be compared: ${error.message}` };
    }
    const limit = exception.limit ?? LARGEST_ERROR;
    if (result.matrices === 0) return { fault: 'nothing to compare', result };
    if (!(result.worst.error <= limit)) return { fault: `more than ${limit} R`, result };
    const isNeedless = exception.limit && result.worst.error <= LARGEST_ERROR;
    return { fault: isNeedless ? 'needs no limit of its own' : '', note: exception.because, result };
}

async function isWithin(animal, container) {
    try {
        return compareAnimal(animal, container).worst.error <= LARGEST_ERROR;
    } catch {
        return false; // what the container has is not there at all
    }
}

function line(name, { fault, note, result }) {
    const counts = result
        ? [result.clips, result.rows, result.matrices].map((n) => String(n).padStart(8)).join('')
        : ' '.repeat(24);
    const error = result ? result.worst.error.toExponential(2) : '-';
    const place = result && result.worst.error > 0 ? `${result.worst.clip} row ${result.worst.row}` : '';
    return `${name.padEnd(46)}${counts}  ${error.padStart(8)}  ${fault ? `<- ${fault} ${place}` : note ?? ''}`;
}

async function compareFolder(folder, scratch, total) {
    const animals = animalsIn(folder);
    const containers = bakeAll(folder, animals, scratch);
    for (const { id, model } of animals) {
        const name = `${folder}/${model}`;
        ++total.files;
        if (!containers.has(id)) {
            ++total.refused;
            if (exceptions[name]) total.faults.push(`${name}: refused, but among the exceptions`);
            continue;
        }
        const glb = fs.readFileSync(path.join(assetsFolder(folder), model));
        const outcome = await examine(name, glb, readContainer(fs.readFileSync(containers.get(id))));
        console.log(line(name, outcome));
        if (outcome.fault) total.faults.push(`${name}: ${outcome.fault}`);
        if (!outcome.result) {
            ++total.excepted;
            continue;
        }
        ++total.compared;
        for (const key of ['clips', 'rows', 'rowsLeftOut', 'matrices']) total[key] += outcome.result[key];
    }
    for (const name of Object.keys(exceptions))
        if (name.startsWith(`${folder}/`) && !animals.some(({ model }) => name === `${folder}/${model}`))
            total.faults.push(`${name}: among the exceptions, but no such file`);
}

async function compareAll(scratch) {
    const total = { files: 0, refused: 0, excepted: 0, compared: 0, clips: 0, rows: 0, rowsLeftOut: 0, matrices: 0 };
    total.faults = [];
    console.log(`${'file'.padEnd(46)}   clips    rows matrices   max / R`);
    for (const folder of folders) await compareFolder(folder, scratch, total);
    console.log(
        `${total.files} files: ${total.compared} compared, ${total.excepted} not (sentences above), ` +
            `${total.refused} refused by posepack; ${total.clips} clips, ${total.rows} rows, ` +
            `${total.matrices} matrices; ${total.rowsLeftOut} rows behind the last key of an open loop left out`,
    );
    for (const fault of total.faults) console.log(`fault: ${fault}`);
    return total.matrices > 0 && total.faults.length === 0 ? 0 : 1;
}

if (folders.some((folder) => !fs.existsSync(assetsFolder(folder)))) {
    console.log(`skipped: no folder ${assetsFolder(folders[0])}; POSEPACK_ASSETS names its parent`);
    process.exitCode = process.env.CI === 'true' ? 1 : SKIPPED;
} else {
    process.exitCode = await withScratchFolder(compareAll);
}
