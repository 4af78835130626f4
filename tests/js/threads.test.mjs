// SPDX-License-Identifier: MIT
// The build with threads gives the same bits as the build without.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import test, { after } from "node:test";
import { load } from "hrbfnpr";

const two = await load({ threads: 2 });
after(() => setTimeout(() => process.exit(), 500)); // node:test would wait for idle threads

function made(context) {
  const model = context.createCsg([{ kind: "torus", radius: 1, secondRadius: 0.4 }]);
  return model.generate({ layers: [{ budget: 8000 }] });
}

test("two threads give the bits of one", () => {
  const context = two.createContext();
  assert.equal(context.info().threadCount, 2);
  assert.equal(context.info().threadBackend, "pool");
  const serial = two.createContext({ threadCount: 1 });
  const [one, other] = [made(context), made(serial)];
  for (const attribute of ["position", "normal", "rank"]) // the file also holds times
    assert.equal(Buffer.compare(Buffer.from(one.view(0, attribute).buffer), Buffer.from(other.view(0, attribute).buffer)), 0);
});

test("progress and cancel with threads", () => {
  const context = two.createContext();
  const model = context.createCsg([{ kind: "sphere" }]);
  assert.throws(() => model.generate({}, { onProgress: (progress) => progress < 0.3 }), { statusName: "CANCELLED" });
});

test("a process with idle threads ends by itself", () => {
  const text = `const { load } = await import("hrbfnpr"); const library = await load({ threads: 2 });
                library.createContext().createCsg([{ kind: "sphere" }]).generate({ layers: [{ budget: 5000 }] });`;
  const { status, signal } = spawnSync(process.execPath, ["--input-type=module", "-e", text], { timeout: 60000 });
  assert.deepEqual([status, signal], [0, null]);
});
