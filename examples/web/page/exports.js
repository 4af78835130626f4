// SPDX-License-Identifier: MIT
// Downloads, and the clipboard.

function download(name, blob) {
  const address = URL.createObjectURL(blob);
  const link = Object.assign(document.createElement("a"), { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

export const save = {
  png({ width, height, data }) {
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    canvas.getContext("2d").putImageData(new ImageData(data, width, height), 0, 0);
    canvas.toBlob((blob) => download("drawing.png", blob), "image/png");
  },
  svg(text) {
    download("drawing.svg", new Blob([text], { type: "image/svg+xml" }));
  },
};

/** Copies the text to the clipboard; tells whether it could. */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
