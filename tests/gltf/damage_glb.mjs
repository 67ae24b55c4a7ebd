// damage_glb.mjs FILE.glb FOLDER -- writes copies of a valid file, each with one fault that check_glb.mjs must detect.
import fs from 'node:fs';
import path from 'node:path';

const [file, folder] = process.argv.slice(2);
const good = fs.readFileSync(file);
const json_size = good.readUInt32LE(12);
const gltf = JSON.parse(good.subarray(20, 20 + json_size).toString());
const { channels, samplers } = gltf.animations[0];

function floats_of(index) { // Where an accessor's numbers lie in the file.
    const view = gltf.bufferViews[gltf.accessors[index].bufferView];
    return { first: 28 + json_size + view.byteOffset, count: view.byteLength / 4 };
}

const output = (way) => samplers[channels.find((c) => c.target.path === way).sampler].output;
const body = gltf.meshes[0].primitives[0];
const changes = {
    'a bound that is not kept': [body.attributes.POSITION, (x, i) => (i === 0 ? 9 : x)],
    'a target that is 0.05 % too long': [body.targets[0].POSITION, (x) => 1.0005 * x + 2e-4],
    'size 0.1 % too large': [output('scale'), (x) => 1.001 * x],
    'roots 0.0002 beside the skin': [output('translation'), (x) => x + 2e-4],
    'eyes that turn the other way': [output('rotation'), (x, i) => (i % 4 === 2 ? -x : x)],
    'a weight below 0': [output('weights'), (x, i) => (i === 0 ? -0.01 : x)],
    'normals that point inward': [body.attributes.NORMAL, (x) => -x],
    'colours a hundredth too bright': [body.attributes.COLOR_0, (x) => Math.min(1, x + 0.01)],
};
for (const [name, [accessor, change]] of Object.entries(changes)) {
    const bytes = Buffer.from(good), { first, count } = floats_of(accessor);
    for (let i = 0; i < count; i++) {
        bytes.writeFloatLE(change(bytes.readFloatLE(first + 4 * i), i), first + 4 * i);
    }
    fs.writeFileSync(path.join(folder, `${name}.glb`), bytes);
}
