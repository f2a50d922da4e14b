// SPDX-License-Identifier: MIT
// Gives three.js's GLTFLoader what it needs for compressed files: MeshoptDecoder of its own package, and Draco
// through npm's draco3dgltf, since three.js's DRACOLoader works in web workers alone.
import draco3d from '../node/node_modules/draco3dgltf/draco3dgltf.js';
import * as THREE from '../node/node_modules/three/build/three.module.js';
import { MeshoptDecoder } from '../node/node_modules/three/examples/jsm/libs/meshopt_decoder.module.js';

const ARRAYS = { Float32Array, Int8Array, Uint8Array, Int16Array, Uint16Array, Uint32Array };

// A loader in the shape that GLTFLoader.setDRACOLoader asks for.
class DracoInProcess {
    constructor(draco) {
        this.draco = draco;
        this.types = {
            Float32Array: draco.DT_FLOAT32,
            Int8Array: draco.DT_INT8,
            Uint8Array: draco.DT_UINT8,
            Int16Array: draco.DT_INT16,
            Uint16Array: draco.DT_UINT16,
            Uint32Array: draco.DT_UINT32,
        };
    }

    preload() {
        return this;
    }

    // The attributes of one stream: `ids` by three.js's names, `types` of typed arrays by the same names.
    decodeDracoFile(buffer, callback, ids, types, _colorSpace, onError) {
        try {
            callback(this.geometry(new Int8Array(buffer), ids, types));
        } catch (error) {
            onError(error);
        }
    }

    geometry(bytes, ids, types) {
        const decoder = new this.draco.Decoder();
        const mesh = new this.draco.Mesh();
        const status = decoder.DecodeArrayToMesh(bytes, bytes.length, mesh);
        if (!status.ok()) throw new Error(`Draco: ${status.error_msg()}`);
        const geometry = new THREE.BufferGeometry();
        for (const [name, id] of Object.entries(ids)) {
            const attribute = decoder.GetAttributeByUniqueId(mesh, id);
            const values = this.values(decoder, mesh, attribute, types[name]);
            geometry.setAttribute(name, new THREE.BufferAttribute(values, attribute.num_components()));
        }
        this.draco.destroy(mesh);
        this.draco.destroy(decoder);
        return geometry;
    }

    values(decoder, mesh, attribute, type) {
        const count = mesh.num_points() * attribute.num_components();
        const size = count * ARRAYS[type].BYTES_PER_ELEMENT;
        const at = this.draco._malloc(size);
        decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, this.types[type], size, at);
        const values = new ARRAYS[type](this.draco.HEAPF32.buffer, at, count).slice();
        this.draco._free(at);
        return values;
    }
}

let draco;

// Makes `loader`, a GLTFLoader, read KHR_draco_mesh_compression and EXT_meshopt_compression.
export async function addDecoders(loader) {
    await MeshoptDecoder.ready;
    draco ??= await draco3d.createDecoderModule({});
    loader.setMeshoptDecoder(MeshoptDecoder);
    loader.setDRACOLoader(new DracoInProcess(draco));
    return loader;
}
