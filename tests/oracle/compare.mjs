// SPDX-License-Identifier: MIT
// The bone matrices of a container against those of three.js, at every row of every clip: of a skin its
// boneMatrices, of a rigid mesh the matrixWorld of its node.
//
// The difference of two matrices is what it does to the body: the largest distance between M_three p and
// M_pack p over the corners and the centre of the box of the vertices that the joint moves (in bind space,
// any weight above zero), as a fraction of the radius R. A difference is affine in p, so no vertex inside the
// box is further off than its corners. A joint that moves no vertex is compared at the box of all vertices
// of its skin, as if it moved them all.

const CORNERS = 8;
const NONE = 0xffffffff;

const emptyBox = () => ({ low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] });

function grow(box, point) {
    for (let c = 0; c < 3; ++c) {
        box.low[c] = Math.min(box.low[c], point[c]);
        box.high[c] = Math.max(box.high[c], point[c]);
    }
}

// The box of a rigid mesh as nine points.
function rigidPoints(animal, node) {
    const box = emptyBox();
    for (const mesh of animal.rigidMeshes(node)) {
        const { position } = mesh.geometry.attributes;
        for (let v = 0; v < position.count; ++v)
            grow(box, [position.getX(v), position.getY(v), position.getZ(v)]);
    }
    if (!(box.low[0] <= box.high[0])) throw new Error(`expected vertices at node ${node}, found none`);
    return boxPoints(box);
}

// Boxes as nine points a joint: 27 numbers each, joint by joint.
function jointPoints(animal, skin, jointCount) {
    const boxes = Array.from({ length: jointCount }, emptyBox);
    const whole = emptyBox();
    for (const mesh of animal.skinnedMeshes(skin)) {
        const { position, skinIndex, skinWeight } = mesh.geometry.attributes;
        for (let v = 0; v < position.count; ++v) {
            const point = [position.getX(v), position.getY(v), position.getZ(v)];
            grow(whole, point);
            for (let i = 0; i < 4; ++i)
                if (skinWeight.getComponent(v, i) > 0) grow(boxes[skinIndex.getComponent(v, i)], point);
        }
    }
    if (!(whole.low[0] <= whole.high[0])) throw new Error(`expected vertices with skin ${skin}, found none`);
    return boxes.map((box) => boxPoints(box.low[0] <= box.high[0] ? box : whole));
}

function boxPoints({ low, high }) {
    const points = new Float64Array(3 * (CORNERS + 1));
    for (let corner = 0; corner < CORNERS; ++corner)
        for (let c = 0; c < 3; ++c) points[3 * corner + c] = (corner >> c) & 1 ? high[c] : low[c];
    for (let c = 0; c < 3; ++c) points[3 * CORNERS + c] = (low[c] + high[c]) / 2;
    return points;
}

// a x b, both 3x4 in rows.
function product(a, b) {
    const out = new Float64Array(12);
    for (let r = 0; r < 3; ++r)
        for (let c = 0; c < 4; ++c)
            out[4 * r + c] =
                a[4 * r] * b[c] +
                a[4 * r + 1] * b[4 + c] +
                a[4 * r + 2] * b[8 + c] +
                (c === 3 ? a[4 * r + 3] : 0);
    return out;
}

// The square of the largest distance that two matrices put between images of one point.
//   columns  4x4 in columns, from `at` on      rows  3x4 in rows
function largestSquare(columns, at, rows, points) {
    const d = new Float64Array(12);
    for (let r = 0; r < 3; ++r)
        for (let c = 0; c < 4; ++c) d[4 * r + c] = columns[at + 4 * c + r] - rows[4 * r + c];
    let largest = 0;
    for (let i = 0; i < points.length; i += 3) {
        let square = 0;
        for (let r = 0; r < 12; r += 4) {
            const along = d[r] * points[i] + d[r + 1] * points[i + 1] + d[r + 2] * points[i + 2] + d[r + 3];
            square += along * along;
        }
        if (!(square <= largest)) largest = square; // NaN is largest of all
    }
    return largest;
}

// What is compared: of each skin or rigid node its mesh, the points of each joint, and where three.js has the
// matrices: `matrices` gives 4x4 ones in columns, one behind the other. Meshes of one skin share its matrices; a
// mesh with a space of its own does not.
function usesOf(animal, container) {
    const uses = new Map();
    for (const mesh of container.meshes) {
        if (mesh.vertexCount === 0) continue; // nothing drawn: no place to compare at
        const isRigid = mesh.skin === NONE;
        const key = [isRigid ? `node ${mesh.node}` : mesh.skin, mesh.firstJoint, ...mesh.paletteFromMesh].join();
        if (uses.has(key)) continue;
        uses.set(key, {
            mesh,
            points: isRigid
                ? [rigidPoints(animal, mesh.node)]
                : jointPoints(animal, mesh.skin, mesh.jointCount),
            matrices: isRigid
                ? () => animal.nodes[mesh.node].matrixWorld.elements
                : () => animal.skeletons[mesh.skin].boneMatrices,
        });
    }
    return [...uses.values()];
}

// The glTF animation of each clip: the name says which, and of equal names the order.
export function animationsOfClips(json, container) {
    const moves = (animation) =>
        animation.channels.some(
            (c) => c.target.node !== undefined && /^(translation|rotation|scale)$/.test(c.target.path),
        );
    const animations = json.animations
        .map((animation, index) => ({
            index,
            name: animation.name || `clip_${index}`,
            moves: moves(animation),
        }))
        .filter((animation) => animation.moves);
    const taken = new Set();
    return container.clips.map((clip) => {
        const found = animations.find((a) => a.name === clip.sourceName && !taken.has(a.index));
        if (!found)
            throw new Error(`clip ${clip.name}: the GLB has no animation '${clip.sourceName}' left for it`);
        taken.add(found.index);
        return found.index;
    });
}

// glTF time of the last key that moves a node.
function lastKeyS(clip) {
    const moving = clip.tracks.filter((track) => /\.(position|quaternion|scale)$/.test(track.name));
    return Math.max(...moving.map((track) => track.times[track.times.length - 1]));
}

// Compares one animal. Returns counts, and the worst place: {error, clip, row, joint}, error in parts of R.
// Rows of an open loop behind the last key are left out: glTF says nothing about them.
export function compareAnimal(animal, container) {
    const radius = container.radiusM / container.metresPerUnit;
    const uses = usesOf(animal, container);
    const result = { clips: 0, rows: 0, rowsLeftOut: 0, matrices: 0, worst: { error: 0 } };
    const animations = animationsOfClips(animal.json, container);
    container.clips.forEach((clip, c) => {
        animal.play(animations[c]);
        const endS = lastKeyS(animal.clips[animations[c]]);
        const intervals = clip.wrap === 'loop' ? clip.rowCount : clip.rowCount - 1;
        ++result.clips;
        for (let row = 0; row < clip.rowCount; ++row) {
            const timeS = clip.startS + (intervals > 0 ? (row * clip.periodS) / intervals : 0);
            if (clip.isOpen && timeS > endS + 1e-6) {
                ++result.rowsLeftOut;
                continue;
            }
            animal.pose(timeS);
            ++result.rows;
            for (const use of uses) compareRow(container, clip, row, use, radius, result);
        }
    });
    return result;
}

const stored = new Float64Array(12);

function compareRow(container, clip, row, { mesh, points, matrices }, radius, result) {
    const expected = matrices();
    for (let joint = 0; joint < mesh.jointCount; ++joint) {
        container.readBoneRow(clip.firstRow + row, container.boneOfJoint(mesh.firstJoint + joint), stored);
        const inModel = product(product(container.modelFromPalette, stored), mesh.paletteFromMesh);
        const error = Math.sqrt(largestSquare(expected, 16 * joint, inModel, points[joint])) / radius;
        ++result.matrices;
        if (!(error <= result.worst.error)) result.worst = { error, clip: clip.name, row, joint };
    }
}
