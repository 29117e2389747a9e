// SPDX-License-Identifier: GPL-3.0-or-later

/// An element with attributes (functions: listeners) and children (texts or elements).
export function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (typeof value === 'function') made.addEventListener(name, value);
        else if (value !== null && value !== undefined && value !== false) made.setAttribute(name, value === true ? '' : value);
    }
    made.append(...children.filter(child => child !== null && child !== undefined));
    return made;
}

/// Puts a text on the clipboard, also where pages from files may not.
export async function copy(words) {
    try {
        await navigator.clipboard.writeText(words);
    } catch {
        const area = element('textarea', {style: 'position:fixed;opacity:0'});
        area.value = words;
        document.body.append(area);
        area.select();
        document.execCommand('copy');
        area.remove();
    }
}

/// A table whose columns sort by a click: columns {name, number, value(row), show(row)}, a row's element made by decorate. Its
/// refill() takes what rows() then gives.
export function sortableTable(columns, rows, decorate, label) {
    const body = element('tbody'), table = element('table', {class: 'sortable', 'aria-label': label});
    let by = -1, direction = 1;
    const heads = columns.map((column, k) => element('th', {class: column.number ? 'n' : null, scope: 'col'},
        element('button', {type: 'button', click: () => sort(k)}, column.name)));
    const fill = () => {
        const sorted = by < 0 ? rows() : [...rows()].sort((a, b) => {
            const p = columns[by].value(a), q = columns[by].value(b);
            return direction * (typeof p === 'string' ? p.localeCompare(q) : p - q);
        });
        body.replaceChildren(...sorted.map(row => decorate(row, element('tr', {}, ...columns.map(column => {
            const cell = element('td', {class: column.number ? 'n' : null});
            cell.append(column.show ? column.show(row) : column.value(row));
            return cell;
        })))));
        heads.forEach((head, k) => head.setAttribute('aria-sort', k !== by ? 'none' : direction > 0 ? 'ascending' : 'descending'));
    };
    const sort = k => {
        direction = k === by ? -direction : columns[k].number && k > 0 ? -1 : 1;
        by = k;
        fill();
    };
    table.append(element('thead', {}, element('tr', {}, ...heads)), body);
    table.refill = fill;
    fill();
    return table;
}
