// SPDX-License-Identifier: MIT
// Checks every catalog of catalogs/ and tests/data, the cases of catalog_cases.json, the manifest that the first
// program given prints, what `posepack doctor` says of a good and of two refused models, and what `posepack report`
// says of a good one and `posepack stress` of some cases, against the schemas.
// node check_schemas.mjs SAMPLE_MANIFEST_PROGRAM POSEPACK [MANIFEST...]
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '..', '..');
const modules = join(root, 'tests', 'node');

if (!existsSync(join(modules, 'node_modules', 'ajv'))) {
    console.log('ajv is not installed: run npm ci in tests/node, or ./dev test');
    process.exit(process.env.CI ? 1 : 77);
}
const { default: Ajv } = createRequire(join(modules, 'package.json'))('ajv');

const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'));
const compile = (name) => new Ajv({ allErrors: true }).compile(readJson(join(root, 'schemas', name)));

let failures = 0;
let checks = 0;

function expectValidity(validate, label, json, isValid) {
    ++checks;
    if (validate(json) === isValid) return;
    ++failures;
    console.log(`${label}: expected ${isValid ? 'no fault' : 'a fault'}, found`, validate.errors ?? 'none');
}

// A key that no schema knows must be refused at every level of a good file.
function expectStrictObjects(validate, label, json) {
    const visit = (value, place) => {
        if (value === null || typeof value !== 'object') return;
        for (const [key, member] of Object.entries(value)) visit(member, `${place}/${key}`);
        const isFree = /\/(keywords|animals)$/.test(place);
        if (Array.isArray(value) || isFree) return;
        value.unknown_key = 1;
        expectValidity(validate, `${label}: ${place}/unknown_key`, json, false);
        delete value.unknown_key;
    };
    visit(json, '');
}

// Calls `look(object, place)` with every object inside `value`.
function visitObjects(value, look, place = '') {
    if (value === null || typeof value !== 'object') return;
    for (const [key, member] of Object.entries(value)) visitObjects(member, look, `${place}/${key}`);
    if (!Array.isArray(value)) look(value, place);
}

function jsonFilesIn(folder) {
    if (!existsSync(folder)) return [];
    return readdirSync(folder).filter((name) => name.endsWith('.json')).map((name) => join(folder, name));
}

const isCatalog = (json) => json !== null && typeof json === 'object' && 'animals' in json;
const validateCatalog = compile('catalog-1.schema.json');
const validateManifest = compile('manifest-1.schema.json');

const catalogs = [...jsonFilesIn(join(root, 'catalogs')), ...jsonFilesIn(join(root, 'tests', 'data'))]
    .map((path) => [relative(root, path), readJson(path)])
    .filter(([, json]) => isCatalog(json));
for (const [label, json] of catalogs) {
    expectValidity(validateCatalog, label, json, true);
    expectStrictObjects(validateCatalog, label, json);
}

const cases = readJson(join(here, 'catalog_cases.json'));
for (const { name, valid, schema_cannot_say: beyond, catalog } of cases) {
    expectValidity(validateCatalog, name, catalog, valid || beyond === true);
}

const [sampleProgram, posepack, ...manifestPaths] = process.argv.slice(2);
const manifests = manifestPaths.map((path) => [path, readJson(path)]);
if (sampleProgram) manifests.push(['sample manifest', JSON.parse(execFileSync(sampleProgram, { encoding: 'utf8' }))]);
for (const [label, json] of manifests) {
    expectValidity(validateManifest, label, json, true);
    expectStrictObjects(validateManifest, label, json);
}

// A generated animal, measured and not; the same cut off, so that nothing of it can be read; and without its
// animations, so that it is refused after its glTF was read.
function diagnoses(program) {
    const folder = mkdtempSync(join(tmpdir(), 'posepack-schemas-'));
    try {
        execFileSync(program, ['menagerie', folder, '--only', 'goat'], { stdio: 'ignore' });
        const goat = readFileSync(join(folder, 'goat.glb'));
        const still = Buffer.from(goat);
        const key = still.indexOf('"animations"');
        if (key < 0) throw new Error('expected the goat to have animations');
        still.write('"animationz"', key);
        writeFileSync(join(folder, 'cut.glb'), goat.subarray(0, 1000));
        writeFileSync(join(folder, 'still.glb'), still);
        const examine = (name, exitCode, ...options) => {
            const run = spawnSync(program, ['doctor', join(folder, name), '--format', 'json', ...options],
                { encoding: 'utf8' });
            if (run.status !== exitCode) throw new Error(`${name}: expected ${exitCode}, found ${run.status}`);
            return [`doctor ${name} ${options.join(' ')}`, JSON.parse(run.stdout)];
        };
        return [examine('goat.glb', 0), examine('goat.glb', 0, '--no-measure'), examine('cut.glb', 3),
            examine('still.glb', 5)];
    } finally {
        rmSync(folder, { recursive: true });
    }
}

const validateDoctor = compile('doctor-1.schema.json');
const diagnosed = posepack ? diagnoses(posepack) : [];
for (const [label, json] of diagnosed) {
    expectValidity(validateDoctor, label, json, true);
    expectStrictObjects(validateDoctor, label, json);
    for (const key of Object.keys(json)) {
        const { [key]: _, ...less } = json;
        expectValidity(validateDoctor, `${label}: without ${key}`, less, false);
    }
}

// A generated animal with its heat map, and another without.
function reports(program) {
    const folder = mkdtempSync(join(tmpdir(), 'posepack-schemas-'));
    try {
        execFileSync(program, ['menagerie', folder, '--only', 'goat,viper'], { stdio: 'ignore' });
        const catalog = join(root, 'catalogs', 'menagerie.json');
        const report = (id, ...options) => [`report ${id}`, JSON.parse(execFileSync(program,
            ['report', catalog, '--models', folder, '--only', id, '--rates', 'keys', '--format', 'json', ...options],
            { encoding: 'utf8', maxBuffer: 1 << 26 }))];
        return [report('goat', '--heat-map'), report('viper')];
    } finally {
        rmSync(folder, { recursive: true });
    }
}

// An animal that could not have a form: the same report with a refusal of the shape that the program writes.
function withRefusal([label, json]) {
    const { form, rows } = json.animals[0].rows[0];
    const issue = { code: 'E-LIM-SIMILARITY', severity: 'error', where: 'goat', detail: 'expected a, found b',
        advice: 'another encoding', exit_code: 6 };
    const refused = [{ form, rows, issue }];
    return [`${label} with a refusal`, { ...json, animals: [{ ...json.animals[0], refused }] }];
}

const validateReport = compile('report-1.schema.json');
const reported = posepack ? reports(posepack) : [];
for (const [label, json] of reported.flatMap((report) => [report, withRefusal(report)])) {
    expectValidity(validateReport, label, json, true);
    // One of each kind is enough, and a heat map has thousands of numbers.
    const animal = json.animals[0];
    const heat = animal.heat_map && { bones: animal.heat_map.bones,
        clips: animal.heat_map.clips.slice(0, 1).map((clip) => ({ ...clip, errors: clip.errors.slice(0, 2) })) };
    const small = { ...json, totals: json.totals.slice(0, 1), animals: [{ ...animal, rows: animal.rows.slice(0, 1),
        clips: animal.clips.slice(0, 1), heat_map: heat }] };
    expectValidity(validateReport, `${label}, cut`, small, true);
    visitObjects(small, (object, place) => {
        for (const key of Object.keys(object)) {
            const value = object[key];
            delete object[key];
            expectValidity(validateReport, `${label}: without ${place}/${key}`, small, false);
            object[key] = value;
        }
        object.unknown_key = 1;
        expectValidity(validateReport, `${label}: ${place}/unknown_key`, small, false);
        delete object.unknown_key;
    });
}

// Cases that are met, that switch form, that are refused before and after they were read; and one that differs.
function stressed(program) {
    const run = (exitCode, ...options) => {
        const found = spawnSync(program, ['stress', '--format', 'json', ...options], { encoding: 'utf8' });
        if (found.status !== exitCode) throw new Error(`stress: expected ${exitCode}, found ${found.status}`);
        return [`stress ${options.join(' ')}`, JSON.parse(found.stdout)];
    };
    return [run(0, '--only', 'shear,falling_keys,step_off_the_grid'),
        run(8, '--only', 'one_metre', '--bound-factor', '0.000001')];
}

const validateStress = compile('stress-1.schema.json');
const stressResults = posepack ? stressed(posepack) : [];
for (const [label, json] of stressResults) {
    expectValidity(validateStress, label, json, true);
    expectStrictObjects(validateStress, label, json);
    for (const key of Object.keys(json)) {
        const { [key]: _, ...less } = json;
        expectValidity(validateStress, `${label}: without ${key}`, less, false);
    }
}

console.log(`${catalogs.length} catalogs, ${cases.length} cases, ${manifests.length} manifests, ` +
    `${diagnosed.length} diagnoses, ${reported.length} reports, ${stressResults.length} runs of stress: ` +
    `${checks} checks, ${failures} failures`);
const sawAll = catalogs.length > 0 && cases.length > 0 && manifests.length > 0 &&
    diagnosed.length > 0 && reported.length > 0 && stressResults.length > 0;
if (!sawAll) console.log('expected at least one of each');
process.exit(failures === 0 && sawAll ? 0 : 1);
