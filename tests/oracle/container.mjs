// SPDX-License-Identifier: MIT
// A reader of posepack containers for this test, written from docs/format/posepack-1.md: tables, and one
// bone-row as a 3x4 matrix. It shares no code with the compiler or its loader. It checks what it relies on;
// whether a file keeps every rule of the format is for other tests.

const MAGIC = [0x8b, 0x50, 0x50, 0x4b, 0x0d, 0x0a, 0x1a, 0x0a];
const HEADER_BYTES = 128;
const ENTRY_BYTES = 48;
const ENCODING_TEXELS = { 1: 4, 2: 3, 3: 2 }; // mat4, affine, dualquat
const TEXEL_BYTES = { 1: 8, 2: 16 }; // RGBA16F, RGBA32F
const PLANAR = 1;
const WRAPS = ['loop', 'once', 'ping-pong'];

function expect(holds, text) {
    if (!holds) throw new Error(`container: expected ${text}`);
}

// The value of an IEEE 754 binary16.
function halfValue(bits) {
    const exponent = (bits >> 10) & 31;
    const fraction = bits & 1023;
    const sign = bits >> 15 ? -1 : 1;
    if (exponent === 0) return sign * fraction * 2 ** -24;
    return sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}

// Section 4 of the format: the bytes of each section by the four letters of its type.
function readSections(view) {
    const sections = {};
    const count = view.getUint32(24, true);
    for (let i = 0; i < count; ++i) {
        const entry = HEADER_BYTES + i * ENTRY_BYTES;
        const letters = [0, 1, 2, 3].map((k) => String.fromCharCode(view.getUint8(entry + k)));
        expect(view.getUint32(entry + 4, true) === 0, 'sections stored as they are');
        const offset = Number(view.getBigUint64(entry + 8, true));
        const size = Number(view.getBigUint64(entry + 16, true));
        sections[letters.join('')] = new DataView(view.buffer, view.byteOffset + offset, size);
    }
    return sections;
}

function readStrings(view) {
    const count = view.getUint32(0, true);
    const first = 8 + 4 * count;
    const offset = (i) => view.getUint32(4 + 4 * i, true);
    const decoder = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });
    const text = (i) =>
        decoder.decode(
            new Uint8Array(view.buffer, view.byteOffset + first + offset(i), offset(i + 1) - offset(i)),
        );
    return Array.from({ length: count }, (_, i) => text(i));
}

function readMatrix(view, offset) {
    return Float64Array.from({ length: 12 }, (_, i) => view.getFloat32(offset + 4 * i, true));
}

function readMesh(view, offset, strings) {
    const u32 = (at) => view.getUint32(offset + at, true);
    return {
        name: strings[u32(0)],
        node: u32(4),
        mesh: u32(8),
        skin: u32(12),
        firstJoint: u32(16),
        jointCount: u32(20),
        vertexCount: u32(24),
        paletteFromMesh: readMatrix(view, offset + 32),
    };
}

function readClip(view, offset, strings) {
    const u32 = (at) => view.getUint32(offset + at, true);
    const f32 = (at) => view.getFloat32(offset + at, true);
    return {
        name: strings[u32(0)],
        sourceName: strings[u32(4)],
        wrap: WRAPS[view.getUint8(offset + 11)],
        isOpen: view.getUint8(offset + 12) === 1,
        firstRow: u32(16),
        rowCount: u32(20),
        rateHz: f32(36),
        periodS: f32(40),
        startS: f32(44),
    };
}

// Numbers of the header that say how texels lie.
function readLayout(view) {
    const layout = {
        boneCount: view.getUint32(40, true),
        rowCount: view.getUint32(44, true),
        encoding: view.getUint8(52),
        texelFormat: view.getUint8(53),
        texelsPerBone: view.getUint8(54),
        texelOrder: view.getUint8(55),
        rowPitch: view.getUint32(68, true),
        rowsPerLine: view.getUint32(72, true),
        dualquatLength: view.getFloat32(80, true),
    };
    expect(ENCODING_TEXELS[layout.encoding] === layout.texelsPerBone, 'encoding mat4, affine or dualquat');
    expect(layout.texelFormat in TEXEL_BYTES, 'texel format RGBA16F or RGBA32F');
    return layout;
}

// Section 10: the byte of texel k of a bone-row.
function texelOffset(layout, row, bone, k) {
    const { boneCount, texelsPerBone, rowsPerLine } = layout;
    const place = layout.texelOrder === PLANAR ? k * boneCount + bone : bone * texelsPerBone + k;
    const x = (row % rowsPerLine) * boneCount * texelsPerBone + place;
    return Math.floor(row / rowsPerLine) * layout.rowPitch + x * TEXEL_BYTES[layout.texelFormat];
}

function readTexel(pixels, layout, offset) {
    return [0, 1, 2, 3].map((c) =>
        layout.texelFormat === 2
            ? pixels.getFloat32(offset + 4 * c, true)
            : halfValue(pixels.getUint16(offset + 2 * c, true)),
    );
}

// Section 10: the matrix of a dual quaternion whose dual part carries a scale along the real part.
function dualquatMatrix([x, y, z, w], [dx, dy, dz, dw], length, out) {
    const square = x * x + y * y + z * z + w * w;
    const h = 2 / square;
    const s = 1 + (2 * (x * dx + y * dy + z * dz + w * dw)) / square / length;
    out.set([
        ...[1 - h * (y * y + z * z), h * (x * y - w * z), h * (x * z + w * y)].map((m) => s * m),
        h * (w * dx - dw * x + y * dz - z * dy),
        ...[h * (x * y + w * z), 1 - h * (x * x + z * z), h * (y * z - w * x)].map((m) => s * m),
        h * (w * dy - dw * y + z * dx - x * dz),
        ...[h * (x * z - w * y), h * (y * z + w * x), 1 - h * (x * x + y * y)].map((m) => s * m),
        h * (w * dz - dw * z + x * dy - y * dx),
    ]);
}

// Writes the matrix of a bone-row to `out` (12 numbers, a 3x4 matrix in rows).
function readBoneRow(pixels, layout, row, bone, out) {
    expect(row < layout.rowCount && bone < layout.boneCount, `row ${row} and bone ${bone} to be stored`);
    if (layout.encoding === 3) {
        const [real, dual] = [0, 1].map((k) => readTexel(pixels, layout, texelOffset(layout, row, bone, k)));
        dualquatMatrix(real, dual, layout.dualquatLength, out);
        return;
    }
    for (let k = 0; k < layout.texelsPerBone; ++k) {
        const texel = readTexel(pixels, layout, texelOffset(layout, row, bone, k));
        if (layout.encoding === 2) out.set(texel, 4 * k);
        else for (let r = 0; r < 3; ++r) out[4 * r + k] = texel[r];
    }
}

// Reads a container from a Buffer or Uint8Array. Throws an Error where it is not one that this reader knows.
export function readContainer(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    expect(
        bytes.length > HEADER_BYTES && MAGIC.every((byte, i) => bytes[i] === byte),
        'the magic of a .posepack',
    );
    expect(view.getUint16(8, true) === 1, 'major version 1');
    expect(Number(view.getBigUint64(16, true)) === bytes.length, 'file_bytes to be the size of the file');
    const sections = readSections(view);
    const strings = readStrings(sections.STRS);
    const layout = readLayout(view);
    const { BONE: bone, SPAC: space, CLIP: clip } = sections;
    const jointMap = 16 + 16 * layout.boneCount;
    return {
        radiusM: view.getFloat32(76, true),
        layout,
        boneOfJoint: (joint) => bone.getUint16(jointMap + 2 * joint, true),
        modelFromPalette: readMatrix(space, 0),
        metresPerUnit: space.getFloat32(52, true),
        meshes: Array.from({ length: space.getUint32(56, true) }, (_, i) =>
            readMesh(space, 64 + 80 * i, strings),
        ),
        clips: Array.from({ length: clip.getUint32(0, true) }, (_, i) =>
            readClip(clip, 16 + 192 * i, strings),
        ),
        readBoneRow: (row, boneIndex, out) => readBoneRow(sections.PIXL, layout, row, boneIndex, out),
    };
}
