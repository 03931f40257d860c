// Measures what a viewer costs a run, and the bytes of its states:
//   node tests/measure.mjs EXPERIMENT ROBOTS SECONDS [STATES A SECOND...]
// The environment variable ARGOS3 names the simulator. "none" in place of a rate: without a viewer. A rate that is
// followed by "x", such as 100x, runs in real time; otherwise as fast as it goes. One line of CSV for each.
import { WebSocket } from "ws";

import { readProcess, startLive } from "./start_live.mjs";

const [experiment, robots, seconds, ...rates] = process.argv.slice(2);
const arguments_ = [
  experiment,
  ...["--length", seconds, "--set", `//distribute/entity/@quantity=${robots}`, "--threads", "0"],
];

function readTicks(message) {
  return [message.readUInt32LE(8), message.readUInt32LE(4)];
}

async function measure(rate) {
  const { program, url } = await startLive(arguments_);
  const [base, token] = url.split("#");
  const socket = new WebSocket(`${base.replace("http", "ws")}live`, "argos-live.1", { origin: base.slice(0, -1) });
  const send = (message) => socket.send(JSON.stringify(message));
  let states = 0;
  let bytes = 0;
  let firstStates = 0;
  const start = { cpu: 0, time: 0 };
  const isReal = rate.endsWith("x");
  return new Promise((resolve) => {
    socket.on("open", () => {
      send({ hello: { token, name: "measure" } });
      send({ id: 1, do: "rate", fps: rate === "none" ? 0.1 : Number(rate.replace("x", "")) });
      send({ id: 2, do: "speed", factor: isReal ? 1 : 0 });
    });
    socket.on("message", (data, isBinary) => {
      if (isBinary) {
        const [tick, kind] = readTicks(data);
        if (kind === 3) {
          send({ ack: tick });
          if (firstStates++ > 0) {
            ++states;
            bytes += data.length;
          }
        }
        return;
      }
      const message = JSON.parse(String(data));
      if (message.re === 2) {
        start.cpu = readProcess(program.pid).cpu;
        start.time = performance.now();
        send({ id: 3, do: "play" });
      }
      if (message.status?.run === "ended") {
        const cpu = readProcess(program.pid).cpu - start.cpu;
        const wall = (performance.now() - start.time) / 1000;
        send({ id: 4, do: "end" });
        program.on("exit", () => resolve({ states, bytes, cpu, wall }));
      }
    });
  });
}

console.log("rate,states,bytes_per_robot_and_state,cpu_s,wall_s");
for (const rate of rates) {
  const { states, bytes, cpu, wall } = await measure(rate);
  const each = states > 0 ? (bytes / states / Number(robots)).toFixed(2) : "";
  console.log([rate, states, each, cpu.toFixed(2), wall.toFixed(2)].join(","));
}
