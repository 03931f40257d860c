// A link of limited rate, with a delay, to a server on this computer.

import { type AddressInfo, type Server, type Socket, connect, createServer } from "node:net";

export class SlowLink {
  private readonly server: Server;
  private readonly sockets = new Set<Socket>();

  private constructor(port: number, bytesPerSecond: number, delay: number) {
    this.server = createServer((near) => {
      const far = connect(port, "127.0.0.1");
      for (const [from, to] of [
        [near, far],
        [far, near],
      ] as const) {
        this.sockets.add(from);
        from.setNoDelay(true);
        let isFreeAt = 0; // when all that was taken has been sent, ms
        const later = (bytes: number, action: () => void): void => {
          isFreeAt = Math.max(isFreeAt, performance.now()) + (1000 * bytes) / bytesPerSecond;
          setTimeout(action, isFreeAt + delay - performance.now());
        };
        from.on("data", (chunk) => later(chunk.length, () => to.writable && to.write(chunk)));
        from.on("error", () => from.destroy());
        from.on("close", () => later(1, () => to.destroy()));
      }
    });
  }

  /** To a port, from another one or any; the delay, ms, is that of one way. */
  static async open(port: number, bytesPerSecond: number, delay: number, ownPort = 0): Promise<SlowLink> {
    const link = new SlowLink(port, bytesPerSecond, delay);
    await new Promise<void>((resolve) => link.server.listen(ownPort, "127.0.0.1", resolve));
    return link;
  }

  get port(): number {
    return (this.server.address() as AddressInfo).port;
  }

  close(): void {
    this.server.close();
    this.sockets.forEach((socket) => socket.destroy());
  }
}
