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
const result = await build({
  absWorkingDir: folder,
  nodePaths: [join(modules, "node_modules")],
  entryPoints: { page: "src/main.ts", style: "src/style.css" },
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome100", "firefox100"],
  outdir: "unused",
  write: false,
  legalComments: "none",
  logLevel: "warning",
});
const textOf = (name) => result.outputFiles.find((file) => file.path.endsWith(name)).text;
// what CodeMirror needs has the same authors and licence
const licences = ["three", "uplot", "zstddec", "@codemirror/view", "@lezer/common"]
  .map((name) => {
    const text = readFileSync(join(modules, "node_modules", name, "LICENSE"), "utf8");
    return `This page contains ${name}:\n\n${text.trim()}`;
  })
  .join("\n\n");
const parts = {
  "/* style */": textOf("style.css"),
  "/* script */": textOf("page.js").replaceAll("</script", "<\\/script"),
  "licences": licences.replaceAll("--", "- -"),
};
const page = readFileSync(join(folder, "src/index.html"), "utf8").replace(
  /\/\* style \*\/|\/\* script \*\/|(?<=<!-- )licences(?= -->)/g,
  (name) => parts[name],
);
mkdirSync(dirname(output), { recursive: true });
writeFileSync(output, page);
// what the server sends to browsers
writeFileSync(`${output}.gz`, gzipSync(page, { level: 9 }));
