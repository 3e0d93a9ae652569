// Pixels of the page's canvas, and how far two pictures are apart.

import { inflateSync } from "node:zlib";

/** Takes a picture of the canvas: its PNG, its size and its bytes, four a pixel. */
export async function pixels(page) {
  const png = await page.locator("#canvas").screenshot();
  return { png, ...decoded(png) };
}

/** Pixels of a PNG with 8 bits a channel, with or without alpha, not interlaced; always four bytes a pixel. */
export function decoded(png) {
  const [width, height, channels] = [png.readUInt32BE(16), png.readUInt32BE(20), png[25] === 6 ? 4 : 3];
  const parts = [];
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + length));
    at += length + 12;
  }
  const [rows, stride] = [inflateSync(Buffer.concat(parts)), width * channels];
  const rgba = new Uint8Array(width * height * 4).fill(255);
  let above = new Uint8Array(stride);
  for (let y = 0; y < height; y++) {
    const line = unfiltered(rows.subarray(y * (stride + 1), (y + 1) * (stride + 1)), above, channels);
    for (let x = 0; x < width; x++) rgba.set(line.subarray(x * channels, x * channels + 3), (y * width + x) * 4);
    above = line;
  }
  return { width, height, rgba };
}

function unfiltered(row, above, channels) {
  const [kind, line] = [row[0], new Uint8Array(row.length - 1)];
  for (let i = 0; i < line.length; i++) {
    const [a, b, c] = [i < channels ? 0 : line[i - channels], above[i], i < channels ? 0 : above[i - channels]];
    line[i] = row[i + 1] + [0, a, b, (a + b) >> 1, paeth(a, b, c)][kind];
  }
  return line;
}

function paeth(a, b, c) {
  const p = a + b - c;
  const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
  if (pa <= pb && pa <= pc) return a;
  return pb <= pc ? b : c;
}

/** Half the side of the square over which a picture is blurred before it is compared [pixels]. */
const BLUR = 2;

/**
 * Colour differences (ΔE, CIE 1976) of two pictures of one size after a slight blur: mean, the value that 99 % stay below,
 * and the share of pixels that differ by more than 5.
 */
export function difference(one, other) {
  const deltas = new Float32Array(one.width * one.height);
  for (const at of touched(one, other)) {
    const [a, b] = [blurredLab(one, at), blurredLab(other, at)];
    deltas[at] = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  const sorted = deltas.slice().sort();
  const mean = deltas.reduce((sum, delta) => sum + delta, 0) / deltas.length;
  const changed = deltas.reduce((sum, delta) => sum + (delta > 5), 0) / deltas.length;
  return { mean, p99: sorted[Math.floor(0.99 * (sorted.length - 1))], most: sorted.at(-1), changed, deltas };
}

/** Places of the pixels that the blur of a difference reaches; elsewhere the pictures are equal. */
function touched({ width, height, rgba }, other) {
  const near = new Uint8Array(width * height);
  for (let at = 0; at < near.length; at++) {
    const byte = 4 * at;
    if ([0, 1, 2].every((k) => rgba[byte + k] === other.rgba[byte + k])) continue;
    const [x, y] = [at % width, Math.floor(at / width)];
    for (let v = Math.max(0, y - BLUR); v <= Math.min(height - 1, y + BLUR); v++) {
      near.fill(1, v * width + Math.max(0, x - BLUR), v * width + Math.min(width - 1, x + BLUR) + 1);
    }
  }
  return [...near.keys()].filter((at) => near[at]);
}

function blurredLab({ width, height, rgba }, at) {
  const [x, y, sum] = [at % width, Math.floor(at / width), [0, 0, 0]];
  let count = 0;
  for (let v = Math.max(0, y - BLUR); v <= Math.min(height - 1, y + BLUR); v++) {
    for (let u = Math.max(0, x - BLUR); u <= Math.min(width - 1, x + BLUR); u++, count++) {
      for (let k = 0; k < 3; k++) sum[k] += rgba[(v * width + u) * 4 + k];
    }
  }
  return lab(sum.map((value) => value / count / 255)).map(Math.fround);
}

function lab(srgb) {
  const [r, g, b] = srgb.map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  const x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047;
  const y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  const z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883;
  const [fx, fy, fz] = [x, y, z].map((t) => (t > 216 / 24389 ? Math.cbrt(t) : (t * 24389 / 27 + 16) / 116));
  return [116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)];
}
