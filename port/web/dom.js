// SPDX-License-Identifier: MIT

export const $ = (id) => document.getElementById(id);

// Sets a text, and touches the page only if it is another one.
export function put(element, text) {
    if (element.textContent !== text) {
        element.textContent = text;
    }
}
