// SPDX-License-Identifier: GPL-3.0-or-later
// The instrument of report.html. Without it the page shows pictures and tables, which is what is printed.
import {startCases} from './cases.js';
import {unpack} from './data.js';
import {start} from './instrument.js';

const root = document.getElementById('instrument'), source = document.getElementById('abut-data');
if (root && source) {
    try {
        document.documentElement.classList.add('js');
        const told = JSON.parse(source.textContent);
        window.abutReport = told.cases ? startCases(told, root) : start(unpack(told), root);
    } catch (error) {
        // The pictures say what the instrument cannot.
        document.documentElement.classList.remove('js');
        root.replaceChildren();
        console.error(error);
    }
}
