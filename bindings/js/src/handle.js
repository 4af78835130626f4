// SPDX-License-Identifier: MIT

const registry = new FinalizationRegistry(({ library, kind, pointer }) => library.raw[`${kind}_release`](pointer));

/** An object of the library.  free() or `using` frees it, or the garbage collector at some time after its last use. */
export class Handle {
  #pointer;

  constructor(library, kind, pointer) {
    this.library = library;
    this.kind = kind;
    this.#pointer = pointer;
    registry.register(this, { library, kind, pointer }, this);
  }

  /** The address of the object, for Library.raw. */
  get pointer() {
    if (this.#pointer === 0) throw new Error(`this ${this.kind.replace("hrbfnpr_", "")} has been freed`);
    return this.#pointer;
  }

  get isFreed() {
    return this.#pointer === 0;
  }

  /** Frees the object.  Objects that were made from it stay alive. */
  free() {
    if (this.#pointer === 0) return;
    registry.unregister(this);
    this.library.raw[`${this.kind}_release`](this.#pointer);
    this.#pointer = 0;
  }
}

if (Symbol.dispose)
  Object.defineProperty(Handle.prototype, Symbol.dispose, { value() { this.free(); } });
