// Recordings for the tests, made by argos3 (environment variable ARGOS3).

import { type ChildProcess, execFileSync, spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, afterEach } from "node:test";

export const repository = process.env.REPOSITORY ?? resolve(process.cwd(), "../../../../..");
export const argos3 = process.env.ARGOS3 ?? join(repository, "build/bin/argos3");
export const folder = mkdtempSync(join(tmpdir(), "argos3-page-"));

export function run(...args: string[]): string {
  return execFileSync(argos3, args, { cwd: folder, encoding: "utf8", stdio: "pipe" });
}

export function experiment(name: string): string {
  return join(repository, "experiments", `${name}.argos`);
}

/** Writes a changed copy of an experiment; returns its path. */
export function changedExperiment(name: string, change: (xml: string) => string): string {
  const path = join(folder, `${name}.changed.argos`);
  writeFileSync(path, change(readFileSync(experiment(name), "utf8")));
  return path;
}

/** The rows of a table, by column. */
export function readTable(path: string): Map<string, string>[] {
  const lines = readFileSync(path, "utf8")
    .split("\n")
    .filter((line) => line !== "" && !line.startsWith("#"));
  const names = lines[0]!.split(",");
  return lines.slice(1).map((line) => {
    const cells = line.split(",");
    return new Map(names.map((name, i) => [name, cells[i] ?? ""]));
  });
}

/** Records an experiment; returns the path of the recording. */
export function record(name: string, seconds: number, ...args: string[]): string {
  mkdirSync(folder, { recursive: true });
  const path = join(folder, `${name}.${seconds}.rec`);
  const source = existsSync(name) ? name : experiment(name);
  run("-zc", source, "--quiet", "--record", path, "--length", String(seconds), ...args);
  return path;
}

let sample: string | null = null;

/** Ten robots for eight seconds. */
export function sampleRecording(): string {
  sample ??= process.env.PAGE_RECORDING ?? record("diffusion_10", 8);
  return sample;
}

const programs: ChildProcess[] = [];

interface LiveRun {
  url: string;
  /** Resolves with the exit status. */
  ended: Promise<number | null>;
  /** Ends it as a fault would. */
  kill(): void;
}

/** Runs an experiment of the tree, or a file, with a live view. */
export function startRun(name: string, ...args: string[]): Promise<LiveRun> {
  return startLive(existsSync(name) ? name : experiment(name), "--live", ...args);
}

/** Runs argos3 with arguments that ask for a live view. */
export function startLive(...args: string[]): Promise<LiveRun> {
  const program = spawn(argos3, args, { cwd: folder });
  programs.push(program);
  const ended = new Promise<number | null>((resolve) => program.on("exit", resolve));
  return new Promise((resolve, reject) => {
    let text = "";
    const read = (data: Buffer): void => {
      text += String(data);
      const url = /Live view: (http:\S+)/.exec(text)?.[1];
      if (url !== undefined) {
        resolve({ url, ended, kill: () => void program.kill("SIGKILL") });
      }
    };
    program.stdout.on("data", read);
    program.stderr.on("data", read);
    program.on("exit", () => reject(new Error(`argos3 has ended: ${text}`)));
  });
}

afterEach(() => {
  programs.splice(0).forEach((program) => program.kill("SIGKILL"));
});
after(() => rmSync(folder, { recursive: true, force: true }));
