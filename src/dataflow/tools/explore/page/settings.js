// What is changed against the recorded run, and what was before.

const key_rows = new Map(data.keys.map((row) => [row.key, row]));

/// "a.b.c=value"; without a value what a link has instead of a setting.
function setting_of(key, value) {
  return value === null ? key : `${key}=${value}`;
}

/// The settings of all keys that differ from the recorded run, in the order of the keys; what a link has besides, of
/// which the server will say what it is, comes last.
function overrides_of(changes) {
  const known = data.keys.map(({ key }) => key).filter((key) => changes.has(key));
  const others = [...changes.keys()].filter((key) => !key_rows.has(key));
  return [...known, ...others].map((key) => setting_of(key, changes.get(key)));
}

function changes_of(overrides) {
  const changes = new Map();
  for (const setting of overrides) {
    const equals = setting.indexOf("=");
    const [key, value] = equals < 0 ? [setting, null] : [setting.slice(0, equals), setting.slice(equals + 1)];
    const row = key_rows.get(key);
    if (!row || row.value !== value) changes.set(key, value);
  }
  return changes;
}

/// What stands behind the # of the address: all overrides.
function hash_of(changes) {
  return "#" + overrides_of(changes).map((setting) => encodeURIComponent(setting).replaceAll("%3D", "=")).join("&");
}

/// Null: it is a place in the page.
function changes_of_hash(hash) {
  const text = hash.replace(/^#/, "");
  if (by_id(text)) return null;
  return changes_of(text === "" ? [] : text.split("&").map(decoded));
}

/// As it is, if it is not encoded as an address is.
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/// Keys with different values.
function differing(changes, others) {
  return [...new Set([...changes.keys(), ...others.keys()])].filter((key) => changes.get(key) !== others.get(key));
}

/// Configurations in the order in which they were chosen, with a place among them.
class History {
  constructor() {
    this.entries = [new Map()];
    this.at = 0;
  }

  get now() {
    return this.entries[this.at];
  }

  put(changes) {
    if (overrides_of(changes).join() === overrides_of(this.now).join()) return;
    this.entries = [...this.entries.slice(0, this.at + 1), new Map(changes)];
    this.at = this.entries.length - 1;
  }

  can_go(by) {
    return this.at + by >= 0 && this.at + by < this.entries.length;
  }

  go(by) {
    if (this.can_go(by)) this.at += by;
    return this.now;
  }
}
