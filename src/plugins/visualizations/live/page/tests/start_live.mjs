// Starts argos3 for measurements. The environment variable ARGOS3 names the program.
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";

/** Runs argos3 with --live; resolves with the process and the URL of its page. */
export async function startLive(arguments_) {
  const program = spawn(process.env.ARGOS3 ?? "argos3", [...arguments_, "--live"]);
  const url = await new Promise((resolve, reject) => {
    let text = "";
    const read = (data) => {
      text += String(data);
      const found = /Live view: (http:\S+)/.exec(text);
      if (found !== null) {
        resolve(found[1]);
      }
    };
    program.stdout.on("data", read);
    program.stderr.on("data", read);
    program.on("exit", () => reject(new Error(text)));
  });
  return { program, url };
}

/** The parent of a process, and the processor time of all its threads, s. */
export function readProcess(pid) {
  const fields = readFileSync(`/proc/${pid}/stat`, "utf8").replace(/^.*\) /, "").split(" ");
  return { parent: Number(fields[1]), cpu: (Number(fields[11]) + Number(fields[12])) / 100 };
}
