// Bundles the tests and runs them in node: node test.mjs [names of test files without .test.ts]
// They are one program, so that all of them use one browser and its pages.
import { spawnSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

const folder = dirname(fileURLToPath(import.meta.url));
const wanted = process.argv.slice(2);
const names = readdirSync(join(folder, "tests"))
  .filter((name) => name.endsWith(".test.ts"))
  .map((name) => name.slice(0, -".test.ts".length))
  .filter((name) => wanted.length === 0 || wanted.includes(name));
const out = join(process.env.PAGE_OUT ?? join(folder, "out"), "tests.mjs");
await build({
  stdin: { contents: names.map((name) => `import "./tests/${name}.test";`).join("\n"), resolveDir: folder },
  bundle: true,
  platform: "node",
  format: "esm",
  target: "node18",
  packages: "external",
  outfile: out,
  logLevel: "warning",
});
const result = spawnSync(process.execPath, ["--test", out], { stdio: "inherit", cwd: folder });
process.exit(result.status ?? 1);
