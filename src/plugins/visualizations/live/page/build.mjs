// Builds the page: one file, with script, style and licences in it.
//   node build.mjs [output file]      the environment variable PAGE_MODULES has the folder of node_modules
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const folder = dirname(fileURLToPath(import.meta.url));
const modules = resolve(process.env.PAGE_MODULES ?? folder);
const { build } = createRequire(join(modules, "package.json"))("esbuild");
const output = resolve(process.argv[2] ?? join(folder, "dist/index.html"));
// Shaders of three.js make an eighth of the page, which has its own.
const withoutShaders = {
  name: "without-shaders",
  setup(builder) {
    builder.onResolve({ filter: /^three$/ }, ({ resolveDir, kind }) =>
      builder.resolve("three/src/Three.js", { resolveDir, kind }),
    );
    builder.onLoad({ filter: /three[\\/]src[\\/]renderers[\\/]shaders[\\/]ShaderChunk[\\/].*\.glsl\.js$/ }, () => ({
      contents: 'export default "";',
    }));
    builder.onLoad({ filter: /three[\\/]src[\\/]renderers[\\/]shaders[\\/]ShaderLib[\\/].*\.glsl\.js$/ }, () => ({
      contents: 'export const vertex = "", fragment = "";',
    }));
  },
};
async function bundle(entry, options = {}) {
  const { outputFiles } = await build({
    absWorkingDir: folder,
    nodePaths: [join(modules, "node_modules")],
    entryPoints: [entry],
    bundle: true,
    minify: true,
    format: "iife",
    target: ["chrome100", "firefox100"],
    outdir: "unused",
    write: false,
    legalComments: "none",
    plugins: [withoutShaders],
    logLevel: "warning",
    ...options,
  });
  return outputFiles[0].text.replaceAll("</script", "<\\/script");
}
// what is run later: see src/first.ts and src/parts.ts
const partOf = (name, entry) => bundle(entry, { globalName: `argosPart_${name}` });
// what CodeMirror needs has the same authors and licence
const licences = ["three", "uplot", "zstddec", "@codemirror/view", "@lezer/common"]
  .map((name) => {
    const text = readFileSync(join(modules, "node_modules", name, "LICENSE"), "utf8");
    return `This page contains ${name}:\n\n${text.trim()}`;
  })
  .join("\n\n");
const parts = {
  "/* style */": await bundle("src/style.css"),
  "/* first */": await bundle("src/first.ts"),
  "/* page */": await partOf("page", "src/main.ts"),
  "/* editor */": await partOf("editor", "src/ui/editor.ts"),
  "/* plots */": await partOf("plots", "src/ui/charts.ts"),
  "licences": licences.replaceAll("--", "- -"),
};
const page = readFileSync(join(folder, "src/index.html"), "utf8").replace(
  /\/\* (style|first|page|editor|plots) \*\/|(?<=<!-- )licences(?= -->)/g,
  (name) => parts[name],
);
mkdirSync(dirname(output), { recursive: true });
writeFileSync(output, page);
// what the server sends to browsers
writeFileSync(`${output}.gz`, gzipSync(page, { level: 9 }));
