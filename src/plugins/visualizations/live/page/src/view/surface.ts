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

/**
 * Only a context knows what draws, and whether its edges are smoothed cannot be changed later. Where the processor draws,
 * they are not, and a second context would delay the first picture: so the first one is without.
 */
export function openSurface(makeCanvas: () => HTMLCanvasElement): Surface {
  const canvas = makeCanvas();
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
  const smooth = makeCanvas();
  return { canvas: smooth, gl: open(smooth, true), rendererName, isSoftware };
}
