// The canvas of the picture, and what draws on it.

export interface Surface {
  canvas: HTMLCanvasElement;
  /** Null: this browser has no WebGL 2. */
  gl: WebGL2RenderingContext | null;
  rendererName: string;
  /** The processor draws. */
  isSoftware: boolean;
}

function open(canvas: HTMLCanvasElement, antialias: boolean): WebGL2RenderingContext | null {
  return canvas.getContext("webgl2", { antialias, alpha: false, powerPreference: "high-performance" });
}

function nameOf(gl: WebGL2RenderingContext): string {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return String(gl.getParameter(info === null ? gl.RENDERER : info.UNMASKED_RENDERER_WEBGL));
}

const kSoftwarePixels = 700_000;

/**
 * Pixels across and down of the picture in its place on the page.
 * @param share  of the pixels that the processor draws.
 */
export function pixelsOf(canvas: HTMLCanvasElement, isSoftware: boolean, share = 1): [number, number] {
  const width = Math.max(1, canvas.clientWidth);
  const height = Math.max(1, canvas.clientHeight);
  // where the processor draws, fewer pixels keep it fluid
  const factor = isSoftware
    ? Math.min(1, Math.sqrt((kSoftwarePixels * share) / (width * height)))
    : Math.min(window.devicePixelRatio, 2);
  return [Math.round(width * factor), Math.round(height * factor)];
}

/**
 * Only a context knows what draws, and whether its edges are smoothed cannot be changed later. Where the processor draws,
 * they are not, and a second context would delay the first picture: so the first one is without.
 * @param canvas  in the page; replaced by a copy of it if a second context is needed.
 */
export function openSurface(canvas: HTMLCanvasElement): Surface {
  [canvas.width, canvas.height] = pixelsOf(canvas, true); // a context would make another memory for another size
  const gl = open(canvas, false);
  if (gl === null) {
    return { canvas, gl, rendererName: "", isSoftware: false };
  }
  const rendererName = nameOf(gl);
  // "?detail=full" or "?detail=low" in the address overrides what the renderer is
  const detail = new URLSearchParams(location.search).get("detail");
  const isSoftware =
    detail === "low" || (detail !== "full" && /llvmpipe|swiftshader|software|basic render/i.test(rendererName));
  if (isSoftware) {
    return { canvas, gl, rendererName, isSoftware };
  }
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  const smooth = canvas.cloneNode() as HTMLCanvasElement;
  canvas.replaceWith(smooth);
  [smooth.width, smooth.height] = pixelsOf(smooth, isSoftware);
  return { canvas: smooth, gl: open(smooth, true), rendererName, isSoftware };
}
