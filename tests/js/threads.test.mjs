// SPDX-License-Identifier: MIT
// The build with threads: the same bits as with one.
import assert from "node:assert/strict";
import test from "node:test";
import { load } from "hrbfnpr";

const two = await load({ threads: 2 });

function made(context) {
  const model = context.createCsg([{ kind: "torus", radius: 1, secondRadius: 0.4 }]);
  return model.generate({ layers: [{ budget: 8000 }] });
}

test("two threads give the bits of one", () => {
  const context = two.createContext();
  assert.equal(context.info().threadCount, 2);
  assert.equal(context.info().threadBackend, "pool");
  const serial = two.createContext({ threadCount: 1 });
  assert.deepEqual(made(context).save(), made(serial).save());
});

test("progress and cancel with threads", () => {
  const context = two.createContext();
  const model = context.createCsg([{ kind: "sphere" }]);
  assert.throws(() => model.generate({}, { onProgress: (progress) => progress < 0.3 }), { statusName: "CANCELLED" });
});

test("the process ends though threads wait", () => setTimeout(() => process.exit(process.exitCode ?? 0), 50).unref());
