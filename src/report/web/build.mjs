// SPDX-License-Identifier: GPL-3.0-or-later
// Makes bundle/ from the sources: node build.mjs [FOLDER]. The bundle is committed, so that abut builds without node.
import {build} from 'esbuild';
import {mkdir, readFile, writeFile} from 'node:fs/promises';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2] ?? join(here, 'bundle');

const result = await build({
    absWorkingDir: here,
    entryPoints: {report: 'main.js', live: 'live.js'},
    outdir: folder,
    bundle: true,
    minify: true,
    charset: 'utf8',
    target: 'es2020',
    format: 'iife',
    legalComments: 'none',  // the whole licences stand in front
    metafile: true,
    write: false,
});

// Whatever is bundled asks for its notice to go with every copy, and every report is one.
const packages = [...new Set(Object.keys(result.metafile.inputs)
    .map(file => /node_modules\/([^/]+)\//.exec(file)?.[1]).filter(Boolean))].sort();
const notices = [];
for (const name of packages) {
    const {version, license} = JSON.parse(await readFile(join(here, 'node_modules', name, 'package.json'), 'utf8'));
    const text = (await readFile(join(here, 'node_modules', name, 'LICENSE'), 'utf8')).trim();
    notices.push({title: `${name} ${version} (${license})`, text: text.replace(/\r/g, '')});
}
/// Packages under the same words stand together.
const groups = new Map();
for (const {title, text} of notices) groups.set(text, [...(groups.get(text) ?? []), title]);
const licences = [...groups].map(([text, titles]) => `${titles.join(', ')}\n\n${text}`).join('\n\n----\n\n');

await mkdir(folder, {recursive: true});
await writeFile(join(folder, 'LICENSES.txt'), `Bundled in the scripts and styles beside this:\n\n${licences}\n`);
for (const {path, text} of result.outputFiles) {
    const isScript = path.endsWith('.js');
    if (/]]>|<\/(script|style)/i.test(text)) throw new Error(`${path} holds what ends its element in a page`);
    const banner = isScript
        ? `/*! SPDX-License-Identifier: GPL-3.0-or-later\nThe instrument of abut's pages, with:\n\n${licences} */\n`
        : '/* SPDX-License-Identifier: GPL-3.0-or-later; with parts of uPlot (MIT), whose licence is in the script */\n';
    await writeFile(path, banner + text);
}
