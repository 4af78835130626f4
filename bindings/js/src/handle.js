// SPDX-License-Identifier: MIT

const registry = new FinalizationRegistry(({ library, kind, pointer }) => library.raw[`${kind}_release`](pointer));

/** What the library keeps until it is freed: by free(), by `using`, or some time after nothing refers to it any more. */
export class Handle {
  #pointer;

  constructor(library, kind, pointer) {
    this.library = library;
    this.kind = kind;
    this.#pointer = pointer;
    registry.register(this, { library, kind, pointer }, this);
  }

  /** Its address, for Library.raw. */
  get pointer() {
    if (this.#pointer === 0) throw new Error(`this ${this.kind.replace("hrbfnpr_", "")} has been freed`);
    return this.#pointer;
  }

  get isFreed() {
    return this.#pointer === 0;
  }

  /** Gives it back; what was made from it lives on. */
  free() {
    if (this.#pointer === 0) return;
    registry.unregister(this);
    this.library.raw[`${this.kind}_release`](this.#pointer);
    this.#pointer = 0;
  }
}

if (Symbol.dispose)
  Object.defineProperty(Handle.prototype, Symbol.dispose, { value: Handle.prototype.free });
