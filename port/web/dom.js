// SPDX-License-Identifier: MIT

export const $ = (id) => document.getElementById(id);

// Changes the page only if the text is different.
export function setText(element, text) {
    if (element.textContent !== text) {
        element.textContent = text;
    }
}
