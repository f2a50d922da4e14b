// SPDX-License-Identifier: MIT
// Bakes GLBs as one would with three.js: every clip, frame by frame, bone matrices as half floats in one array.
// Nothing is written. Prints one line of JSON: {"rows", "matrices", "bytes"}.
//
//   node three_bake.mjs FILE.glb...
import fs from 'node:fs';
import * as THREE from '../node/node_modules/three/build/three.module.js';
import { GLTFLoader } from '../node/node_modules/three/examples/jsm/loaders/GLTFLoader.js';

const MATRIX_NUMBERS = 16;

// Frames a second of the clip's own keys.
function keyRateHz(clip) {
    let longest = clip.tracks[0].times;
    for (const { times } of clip.tracks) if (times.length > longest.length) longest = times;
    const seconds = longest[longest.length - 1] - longest[0];
    return seconds > 0 ? (longest.length - 1) / seconds : 1;
}

// The skeletons of a scene, each once.
function skeletonsOf(scene) {
    const skeletons = new Set();
    scene.traverse((object) => {
        if (object.isSkinnedMesh) skeletons.add(object.skeleton);
    });
    return [...skeletons];
}

function clipRows(clip) {
    const first = Math.min(...clip.tracks.map((track) => track.times[0]));
    const rows = Math.round((clip.duration - first) * keyRateHz(clip)) + 1;
    return Array.from(
        { length: rows },
        (_, row) => first + (rows > 1 ? (row * (clip.duration - first)) / (rows - 1) : 0),
    );
}

// Half floats of every bone at every row of every clip.
function bakePalette(scene, clips) {
    const skeletons = skeletonsOf(scene);
    const boneCount = skeletons.reduce((sum, skeleton) => sum + skeleton.bones.length, 0);
    const times = clips.map(clipRows);
    const rowCount = times.reduce((sum, rows) => sum + rows.length, 0);
    const palette = new Uint16Array(rowCount * boneCount * MATRIX_NUMBERS);
    const mixer = new THREE.AnimationMixer(scene);
    let next = 0;
    clips.forEach((clip, index) => {
        const action = mixer.clipAction(clip).setLoop(THREE.LoopOnce, 1);
        action.clampWhenFinished = true;
        action.play();
        for (const time of times[index]) {
            action.time = time;
            mixer.update(0);
            scene.updateMatrixWorld();
            for (const skeleton of skeletons) {
                skeleton.update();
                for (let i = 0; i < skeleton.bones.length * MATRIX_NUMBERS; ++i)
                    palette[next++] = THREE.DataUtils.toHalfFloat(skeleton.boneMatrices[i]);
            }
        }
        action.stop();
    });
    return { rows: rowCount, matrices: rowCount * boneCount, bytes: palette.byteLength };
}

const total = { rows: 0, matrices: 0, bytes: 0 };
for (const file of process.argv.slice(2)) {
    const bytes = fs.readFileSync(file);
    const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
    const gltf = await new GLTFLoader().parseAsync(buffer, '');
    const made = bakePalette(gltf.scene, gltf.animations);
    for (const key of Object.keys(total)) total[key] += made[key];
}
console.log(JSON.stringify(total));
