// The connection to a run.

export const kProtocol = "argos-live.1";

export interface FirstConnection {
  url: string;
  token: string;
  socket: WebSocket;
  /** What came before the page could read it. */
  messages: MessageEvent<string | ArrayBuffer>[];
}

/** Connects and, once the connection is open, sends the secret of the run. */
export function connect(url: string, token: string): FirstConnection {
  const socket = new WebSocket(url, kProtocol);
  socket.binaryType = "arraybuffer";
  const messages: FirstConnection["messages"] = [];
  socket.onopen = () => socket.send(JSON.stringify({ hello: { token, name: "" } }));
  socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => messages.push(event);
  return { url, token, socket, messages };
}
