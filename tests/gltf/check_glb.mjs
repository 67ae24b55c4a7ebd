// check_glb.mjs FOLDER MODULES CHROMIUM -- checks the .glb files in FOLDER with other programs.
//
// Khronos' validator must find no error and no warning. three.js, in a browser without a screen, must put
// every vertex where NAME@PROGRESS.obj says, within 1e-4 of the fish's length, at each moment that is
// there, with its normal and, at both ends of life, its colour; no weight may leave [0, 1]. Keeps
// pictures of each. Speaks TAP.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createRequire } from 'node:module';

const [folder, modules, chromium] = process.argv.slice(2);
const need = createRequire(path.resolve(modules, 'x.js'));
const validator = need('gltf-validator');
const puppeteer = need('puppeteer-core');
const WRONG_MAX = 1e-4;  // Of the fish's length.
const NORMAL_MAX = 2e-3; // A tenth of a degree.
const COLOUR_MAX = 2e-3; // Half a step of 256, where the steps are widest.
let count = 0, failed = 0;

function check(title, good, more = '') {
    count++;
    failed += !good;
    console.log(`${good ? 'ok' : 'not ok'} ${count} - ${title}`);
    if (more && !good) {
        console.log(String(more).replace(/^/gm, '# '));
    }
}

async function validate(name, bytes) {
    const report = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: 20 });
    const { numErrors, numWarnings, messages } = report.issues;
    check(`${name}: the validator has ${numErrors} errors and ${numWarnings} warnings`,
        numErrors === 0 && numWarnings === 0,
        messages.filter((m) => m.severity < 2).map((m) => `${m.code} ${m.pointer}: ${m.message}`).join('\n'));
}

// In lengths and glTF's direction (the file's fish faces +z, ours -z), colours made linear.
function read_obj(file) {
    const text = fs.readFileSync(file, 'utf8');
    const length_m = 1e-3 * Number(/([0-9.e+-]+) mm; kingyoctl/.exec(text)[1]);
    const rows = (word) => text.split('\n').filter((line) => line.startsWith(`${word} `))
        .map((line) => line.split(' ').slice(1).map(Number));
    const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    const normals = rows('vn');
    return { length_m, vertices: rows('v').map(([x, y, z, ...rgb], i) => ({
        place: [-x, y, -z].map((c) => c / length_m),
        normal: [-normals[i][0], normals[i][1], -normals[i][2]],
        colour: rgb.map(linear),
    })) };
}

const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

// The worst of all vertices at one moment. Colours are the drawing's where a key stands alone: at both ends.
function hold_against(ours, theirs, is_end, worst) {
    for (const [number, got] of Object.entries(theirs)) {
        const expected = ours.vertices[number];
        worst.place = Math.max(worst.place, distance(got.place.map((x) => x / ours.length_m), expected.place));
        worst.normal = Math.max(worst.normal, distance(got.normal, expected.normal));
        worst.colour = Math.max(worst.colour, is_end ? distance(got.colour, expected.colour) : 0);
    }
}

async function compare(page, name) {
    await page.evaluate((url) => window.open_glb(url), `/glb/${encodeURIComponent(name)}.glb`);
    const worst = { place: 0, normal: 0, colour: 0 };
    let seen = 0, least = 0, most = 0, moments = 0;
    for (const file of fs.readdirSync(folder).filter((f) => f.startsWith(`${name}@`)).sort()) {
        const progress = Number(file.slice(name.length + 1, -4));
        const theirs = await page.evaluate((p) => window.vertices_at(p), progress);
        hold_against(read_obj(path.join(folder, file)), theirs.at, progress === 0 || progress === 1, worst);
        seen = Object.keys(theirs.at).length;
        least = Math.min(least, theirs.weight_min);
        most = Math.max(most, theirs.weight_max);
        moments++;
    }
    check(`${name}: three.js moves ${seen} vertices as we do, at ${moments} moments, within `
        + `${worst.place.toExponential(1)} of its length`, worst.place <= WRONG_MAX && seen >= 20 && moments >= 5);
    check(`${name}: and turns their normals, within ${worst.normal.toExponential(1)}`, worst.normal <= NORMAL_MAX);
    check(`${name}: and paints them, within ${worst.colour.toExponential(1)}`, worst.colour <= COLOUR_MAX);
    check(`${name}: every weight lies in [0, 1]`, least >= -1e-6 && most <= 1 + 1e-6, `${least} ${most}`);
    for (const progress of [0, 0.5, 1]) {
        await page.evaluate((p) => window.draw_at(p), progress);
        await page.screenshot({ path: path.join(folder, `${name}_${progress}.png`) });
    }
}

function serve() {
    const kinds = { '.html': 'text/html', '.js': 'text/javascript', '.glb': 'model/gltf-binary' };
    const roots = { three: path.join(modules, 'node_modules/three'), glb: folder,
                    page: path.dirname(fileURLToPath(import.meta.url)) };
    const server = http.createServer((request, response) => {
        const [, root, ...rest] = decodeURIComponent(request.url).split('/');
        if (root === 'favicon.ico') {
            response.writeHead(204).end();
            return;
        }
        const file = path.join(roots[root] ?? '/nowhere', rest.join('/'));
        fs.readFile(file, (error, bytes) => {
            response.writeHead(error ? 404 : 200, { 'Content-Type': kinds[path.extname(file)] ?? 'text/plain' });
            response.end(error ? '' : bytes);
        });
    });
    return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

const names = fs.readdirSync(folder).filter((f) => f.endsWith('.glb')).map((f) => f.slice(0, -4)).sort();
for (const name of names) {
    await validate(name, fs.readFileSync(path.join(folder, `${name}.glb`)));
}
const server = await serve();
const browser = await puppeteer.launch({
    executablePath: chromium,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--window-size=960,540'],
});
const page = await browser.newPage();
const complaints = [];
page.on('console', (message) => {
    if (['error', 'warn'].includes(message.type()) && !/GPU stall|ReadPixels|favicon/.test(message.text())) {
        complaints.push(message.text());
    }
});
page.on('pageerror', (error) => complaints.push(String(error)));
await page.setViewport({ width: 960, height: 540 });
await page.goto(`http://127.0.0.1:${server.address().port}/page/page.html`);
await page.waitForFunction('window.ready');
for (const name of names) {
    try {
        await compare(page, name);
    } catch (error) {
        check(`${name}: three.js loads it`, false, error);
    }
}
check('three.js has nothing to complain of', complaints.length === 0, complaints.join('\n'));
await browser.close();
server.close();
console.log(`1..${count}`);
process.exitCode = failed > 0 ? 1 : 0;
