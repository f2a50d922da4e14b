// SPDX-License-Identifier: MIT
// A skinned GLB as three.js sees it: GLTFLoader, AnimationMixer, Skeleton.update, without a browser.
//
// Where three.js 0.187 departs from glTF 2.0, found by comparing; in each case posepack follows glTF, so such
// files are not compared, or the adapter below sets three.js right:
// - Rotation keys are not normalised (8- and 16-bit keys are off unit length): bones are scaled by up to 1 %.
//   The adapter normalises linear ones: then three.js agrees to 4e-7 R on files that otherwise differ by 2e-2 R.
// - A node's matrix with shear is split into translation, rotation and scale, which loses the shear.
// - Matrices in sparse accessors are refused.
// - Several channels on one target are averaged. glTF forbids them; posepack takes the last, with a warning.
// - A STEP key that rounding to single precision moved behind its row's time is missed: see STEP_LEAD_S.
// - A clip begins at 0, not at its first key. Times here are those of the glTF, so nothing depends on it.
// - Rotations of neighbouring keys less than 3.6 degrees apart are mixed linearly and normalised, not by
//   slerp: below 1e-6 rad, and the reason why rows between keys differ more than rows on keys.
import * as THREE from '../node/node_modules/three/build/three.module.js';
import { GLTFLoader } from '../node/node_modules/three/examples/jsm/loaders/GLTFLoader.js';
import { addDecoders } from './three_decoders.mjs';

const GLB_MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;

// A STEP key counts from this long before its time on: key times are single precision, and a row that was
// meant for a key must not miss it because the key's time was rounded up.
const STEP_LEAD_S = 1e-6;

// The JSON of a GLB and whatever follows its chunk (glTF 2.0, section 4.4).
function splitGlb(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (view.getUint32(0, true) !== GLB_MAGIC || view.getUint32(16, true) !== JSON_CHUNK)
        throw new Error('expected a GLB with a JSON chunk first');
    const size = view.getUint32(12, true);
    return {
        json: JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + size))),
        rest: bytes.subarray(20 + size),
    };
}

function joinGlb(json, rest) {
    let text = JSON.stringify(json);
    while (Buffer.byteLength(text) % 4) text += ' ';
    const chunk = Buffer.from(text);
    const head = Buffer.alloc(20);
    [GLB_MAGIC, 2, 20 + chunk.length + rest.length, chunk.length, JSON_CHUNK].forEach((word, i) =>
        head.writeUInt32LE(word, 4 * i),
    );
    return Buffer.concat([head, chunk, rest]);
}

// The GLB without images, textures and materials, which three.js can only read in a browser.
function withoutMaterials(json) {
    for (const key of ['images', 'textures', 'samplers', 'materials']) delete json[key];
    for (const mesh of json.meshes ?? []) for (const primitive of mesh.primitives) delete primitive.material;
    const drawing = (name) => name.startsWith('KHR_materials_') || /texture/i.test(name);
    for (const key of ['extensionsUsed', 'extensionsRequired'])
        if (json[key]) json[key] = json[key].filter((name) => !drawing(name));
    return json;
}

function leadSteps(track) {
    if (track.getInterpolation() === THREE.InterpolateDiscrete)
        track.times = track.times.map((t) => t - STEP_LEAD_S);
}

// Makes the keys of a rotation unit length, as glTF 2.0 (section 3.11) asks of what a reader plays. Those of cubic
// splines stand between tangents and stay as they are.
function normalizeRotations(track) {
    if (!track.name.endsWith('.quaternion') || track.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline)
        return;
    const { values } = track;
    for (let k = 0; k + 3 < values.length; k += 4) {
        const length = Math.hypot(values[k], values[k + 1], values[k + 2], values[k + 3]);
        for (let c = 0; c < 4; ++c) values[k + c] /= length;
    }
}

export class ThreeAnimal {
    // Parses the GLB in `bytes` (a Buffer).
    static async load(bytes) {
        const { json, rest } = splitGlb(bytes);
        const glb = joinGlb(withoutMaterials(json), rest);
        const buffer = glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.length);
        const gltf = await (await addDecoders(new GLTFLoader())).parseAsync(buffer, '');
        const skins = json.skins?.length ?? 0;
        const skeletons = [];
        for (let s = 0; s < skins; ++s) skeletons.push(await gltf.parser.getDependency('skin', s));
        const nodes = [];
        for (let n = 0; n < (json.nodes?.length ?? 0); ++n)
            nodes.push(await gltf.parser.getDependency('node', n));
        return new ThreeAnimal(json, gltf, skeletons, nodes);
    }

    constructor(json, gltf, skeletons, nodes) {
        this.json = json;
        this.clips = gltf.animations; // in the order of the file
        this.skeletons = skeletons; // of each glTF skin; bones in the order of its joints
        this.nodes = nodes; // of each glTF node
        this.scenes = gltf.scenes;
        for (const clip of this.clips)
            for (const track of clip.tracks) {
                leadSteps(track);
                normalizeRotations(track);
            }
        this.root = new THREE.Group();
        // posepack reads the nodes of all scenes, and those of none.
        this.root.add(...gltf.scenes, ...nodes.filter((node) => node.parent === null));
        this.mixer = new THREE.AnimationMixer(this.root);
        this.rest = [];
        this.root.traverse((object) => {
            const { position, quaternion, scale } = object;
            this.rest.push({
                object,
                position: position.clone(),
                quaternion: quaternion.clone(),
                scale: scale.clone(),
            });
        });
    }

    // The skinned meshes of three.js (one a glTF primitive) that use a glTF skin.
    skinnedMeshes(skin) {
        const meshes = [];
        this.root.traverse((object) => {
            if (object.isSkinnedMesh && object.skeleton === this.skeletons[skin]) meshes.push(object);
        });
        return meshes;
    }

    // The meshes of three.js (one a glTF primitive) that a glTF node draws itself.
    rigidMeshes(node) {
        const object = this.nodes[node];
        const drawn = this.nodes.filter((other) => other !== object);
        return [object, ...object.children].filter((mesh) => mesh.isMesh && !drawn.includes(mesh));
    }

    // Makes one clip the only one that plays. Nodes that it has no channel for return to their rest pose.
    play(clipIndex) {
        this.mixer.stopAllAction();
        this.mixer.uncacheRoot(this.root);
        for (const { object, position, quaternion, scale } of this.rest) {
            object.position.copy(position);
            object.quaternion.copy(quaternion);
            object.scale.copy(scale);
        }
        const clip = this.clips[clipIndex];
        this.action = this.mixer.clipAction(clip);
        this.action.setLoop(THREE.LoopOnce, 1);
        this.action.clampWhenFinished = true;
        this.action.play();
    }

    // Poses all at glTF time `timeS`: skeleton.boneMatrices are then joint global x inverse bind, and matrixWorld of
    // nodes their global transforms.
    pose(timeS) {
        this.action.time = timeS;
        this.mixer.update(0);
        this.root.updateMatrixWorld();
        for (const skeleton of this.skeletons) skeleton.update();
    }
}
