// SPDX-License-Identifier: GPL-3.0-or-later
// The bundle that is committed is what its sources make: node bundle_test.mjs SOURCES
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, readdirSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

const web = join(process.argv[2], 'src/report/web'), made = mkdtempSync(join(tmpdir(), 'abut_bundle_'));
execFileSync('node', [join(web, 'build.mjs'), made], {stdio: 'inherit'});
const files = readdirSync(made).sort(), committed = readdirSync(join(web, 'bundle')).sort();
let faults = files.join() === committed.join() ? [] : [`files are ${files}, not ${committed}`];
for (const file of files)
    if (committed.includes(file) && !readFileSync(join(made, file)).equals(readFileSync(join(web, 'bundle', file))))
        faults.push(`${file} is not what the sources make; run npm run build in src/report/web`);
rmSync(made, {recursive: true});
faults.forEach(fault => console.error(fault));
process.exit(faults.length ? 1 : 0);
