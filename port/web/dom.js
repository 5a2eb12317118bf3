// SPDX-License-Identifier: MIT

export const $ = (id) => document.getElementById(id);

// Sets a text, and changes the page only if the text is different.
export function put(element, text) {
    if (element.textContent !== text) {
        element.textContent = text;
    }
}
