// judge.mjs FOLDER MODULES CHROMIUM -- what others think of the .glb files in FOLDER.
//
// Khronos' validator must find no error and no warning. three.js, in a browser without a screen, must put
// every vertex where NAME@PROGRESS.obj says, within 1e-4 of the fish's length, at each moment that is
// there, and no weight may leave [0, 1]. Keeps a picture of each. Speaks TAP.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createRequire } from 'node:module';

const [folder, modules, chromium] = process.argv.slice(2);
const need = createRequire(path.resolve(modules, 'x.js'));
const validator = need('gltf-validator');
const puppeteer = need('puppeteer-core');
const WRONG_MAX = 1e-4;
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

// Vertices in lengths, in glTF's direction: the file's fish faces +z, ours -z.
function read_obj(file, length_m) {
    const lines = fs.readFileSync(file, 'utf8').split('\n');
    return lines.filter((line) => line.startsWith('v ')).map((line) => {
        const [x, y, z] = line.split(' ').slice(1, 4).map(Number);
        return [-x / length_m, y / length_m, -z / length_m];
    });
}

function length_of(file) {
    const match = /([0-9.e+-]+) mm; kingyoctl/.exec(fs.readFileSync(file, 'utf8').slice(0, 400));
    return 1e-3 * Number(match[1]);
}

function farthest(ours, theirs, length_m) {
    let worst = 0, seen = 0;
    for (const [number, place] of Object.entries(theirs)) {
        const wanted = ours[number];
        const d = Math.hypot(...place.map((x, i) => x / length_m - wanted[i]));
        worst = Math.max(worst, d);
        seen++;
    }
    return { worst, seen };
}

async function compare(page, name) {
    const life = await page.evaluate((url) => window.open_glb(url), `/glb/${name}.glb`);
    let worst = 0, seen = 0, least = 0, most = 0, moments = 0;
    for (const file of fs.readdirSync(folder).filter((f) => f.startsWith(`${name}@`)).sort()) {
        const progress = Number(file.slice(name.length + 1, -4));
        const length_m = length_of(path.join(folder, file));
        const ours = read_obj(path.join(folder, file), length_m);
        const theirs = await page.evaluate((p) => window.vertices_at(p), progress);
        const far = farthest(ours, theirs.at, length_m);
        worst = Math.max(worst, far.worst);
        seen = far.seen;
        least = Math.min(least, theirs.weight_min);
        most = Math.max(most, theirs.weight_max);
        moments++;
    }
    check(`${name}: three.js moves ${seen} vertices as we do, at ${moments} moments, within `
        + `${worst.toExponential(1)} of its length`, worst <= WRONG_MAX && seen >= 20 && moments >= 5);
    check(`${name}: every weight lies in [0, 1]`, least >= -1e-6 && most <= 1 + 1e-6, `${least} ${most}`);
    for (const progress of [0, 0.5, 1]) {
        await page.evaluate((p) => window.draw_at(p), progress);
        await page.screenshot({ path: path.join(folder, `${name}_${progress}.png`) });
    }
    return life;
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
