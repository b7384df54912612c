//! Maps and sets of what the compiler numbers itself.
//!
//! The macro is built without optimisation where nobody asks for it. There a small table of indices
//! takes a quarter of the time of the standard library's, whose groups of slots are compared by
//! functions that are calls then, and the standard hash as much again; nobody chooses these keys to
//! collide. What is iterated over comes in the order in which it was inserted.

use std::hash::{Hash, Hasher};
use std::ops::Index;

/// Values by keys.
#[derive(Clone, Debug)]
pub struct Map<K, V> {
    entries: Vec<(K, V)>,
    /// An entry's number plus one and the upper half of its key's hash, at the first free slot from
    /// where that hash points; zero where nothing is. A power of two in number, at most half of
    /// them taken.
    pub slots: Vec<u64>,
}

impl<K: Hash + Eq, V> Map<K, V> {
    /// An empty map with room for so many entries.
    pub fn with_room(entries: usize) -> Self {
        let slots = vec![0; (2 * entries + 2).next_power_of_two()];
        Self { entries: Vec::with_capacity(entries), slots }
    }

    pub fn get(&self, key: &K) -> Option<&V> {
        match self.find(key, hash(key)) {
            Bucket::Taken(entry) => Some(&self.entries[entry].1),
            Bucket::Free(_) => None,
        }
    }

    pub fn contains(&self, key: &K) -> bool {
        matches!(self.find(key, hash(key)), Bucket::Taken(_))
    }

    /// Puts the value in the place of what the key had; whether it had nothing.
    pub fn insert(&mut self, key: K, value: V) -> bool {
        let hash = hash(&key);
        match self.find(&key, hash) {
            Bucket::Taken(entry) => {
                self.entries[entry].1 = value;
                false
            }
            Bucket::Free(slot) => {
                self.add(key, value, hash, slot);
                true
            }
        }
    }

    /// Value of the key; inserts the given value if the key is new.
    pub fn or_insert(&mut self, key: K, value: V) -> &mut V {
        let hash = hash(&key);
        let entry = match self.find(&key, hash) {
            Bucket::Taken(entry) => entry,
            Bucket::Free(slot) => self.add(key, value, hash, slot),
        };
        &mut self.entries[entry].1
    }

    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &(K, V)> {
        self.entries.iter()
    }

    pub fn keys(&self) -> impl Iterator<Item = &K> {
        self.iter().map(|(key, _)| key)
    }

    pub fn values(&self) -> impl Iterator<Item = &V> {
        self.iter().map(|(_, value)| value)
    }

    fn find(&self, key: &K, hash: u64) -> Bucket {
        // A slice is indexed without a call.
        let (slots, entries): (&[u64], &[(K, V)]) = (&self.slots, &self.entries);
        if slots.is_empty() {
            return Bucket::Free(0);
        }
        let last = slots.len() - 1;
        let mut slot = hash as usize & last;
        loop {
            let taken = slots[slot];
            if taken == 0 {
                return Bucket::Free(slot);
            }
            let entry = (taken as u32 - 1) as usize;
            if taken >> 32 == hash >> 32 && entries[entry].0 == *key {
                return Bucket::Taken(entry);
            }
            slot = (slot + 1) & last;
        }
    }

    /// Adds an entry, whose number it answers with; the slot is the one that `find` gave.
    fn add(&mut self, key: K, value: V, hash: u64, slot: usize) -> usize {
        let entry = self.entries.len();
        self.entries.push((key, value));
        if 2 * (entry + 1) > self.slots.len() {
            self.grow();
        } else {
            self.slots[slot] = numbered(entry, hash);
        }
        entry
    }

    fn grow(&mut self) {
        let mut slots = vec![0; (4 * self.entries.len()).next_power_of_two().max(8)];
        let last = slots.len() - 1;
        for (entry, (key, _)) in self.entries.iter().enumerate() {
            let hash = hash(key);
            let mut slot = hash as usize & last;
            while slots[slot] != 0 {
                slot = (slot + 1) & last;
            }
            slots[slot] = numbered(entry, hash);
        }
        self.slots = slots;
    }
}

enum Bucket {
    Taken(usize),
    Free(usize),
}

fn numbered(entry: usize, hash: u64) -> u64 {
    let number = u32::try_from(entry + 1).expect("a map has fewer than 2^32 entries");
    hash >> 32 << 32 | u64::from(number)
}

fn hash(key: &impl Hash) -> u64 {
    let mut mixer = Mixer(0);
    key.hash(&mut mixer);
    mixer.finish()
}

impl<K, V> Default for Map<K, V> {
    fn default() -> Self {
        Self { entries: Vec::new(), slots: Vec::new() }
    }
}

impl<K: Hash + Eq, V> Extend<(K, V)> for Map<K, V> {
    fn extend<I: IntoIterator<Item = (K, V)>>(&mut self, entries: I) {
        for (key, value) in entries {
            self.insert(key, value);
        }
    }
}

impl<K: Hash + Eq, V> FromIterator<(K, V)> for Map<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        let mut map = Self::default();
        map.extend(entries);
        map
    }
}

impl<K: Hash + Eq, V> Index<&K> for Map<K, V> {
    type Output = V;

    fn index(&self, key: &K) -> &V {
        self.get(key).expect("the key has been inserted")
    }
}

/// Keys alone.
#[derive(Clone, Debug)]
pub struct Set<K>(Map<K, ()>);

impl<K: Hash + Eq> Set<K> {
    pub fn contains(&self, key: &K) -> bool {
        self.0.contains(key)
    }

    /// The number of the key in the order of insertion; inserts it if it is new.
    pub(crate) fn number(&mut self, key: K) -> u32 {
        let hash = hash(&key);
        let entry = match self.0.find(&key, hash) {
            Bucket::Taken(entry) => entry,
            Bucket::Free(slot) => self.0.add(key, (), hash, slot),
        };
        entry as u32
    }

    /// The key of this number.
    pub(crate) fn by_number(&self, number: u32) -> &K {
        &self.0.entries[number as usize].0
    }

    /// Inserts the key; true if it is new.
    pub(crate) fn insert(&mut self, key: K) -> bool {
        self.0.insert(key, ())
    }
}

impl<K> Default for Set<K> {
    fn default() -> Self {
        Self(Map::default())
    }
}

impl<K: Hash + Eq + Copy> Set<K> {
    /// The keys that are none of the others.
    pub(crate) fn without(&self, others: &Self) -> Self {
        self.0.keys().copied().filter(|key| !others.contains(key)).collect()
    }
}

impl<K: Hash + Eq> FromIterator<K> for Set<K> {
    fn from_iter<I: IntoIterator<Item = K>>(keys: I) -> Self {
        Self(keys.into_iter().map(|key| (key, ())).collect())
    }
}

/// Hashes a few small numbers.
struct Mixer(u64);

impl Mixer {
    fn mix(&mut self, number: u64) {
        // Two to the 64th over the golden ratio.
        self.0 = (self.0 << 5 ^ self.0 >> 59 ^ number).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }
}

impl Hasher for Mixer {
    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.mix(u64::from_le_bytes(word));
        }
    }

    fn write_u8(&mut self, number: u8) {
        self.mix(number as u64);
    }

    fn write_u32(&mut self, number: u32) {
        self.mix(number as u64);
    }

    fn write_usize(&mut self, number: usize) {
        self.mix(number as u64);
    }

    fn write_isize(&mut self, number: isize) {
        self.mix(number as u64);
    }

    fn write_u64(&mut self, number: u64) {
        self.mix(number);
    }

    fn finish(&self) -> u64 {
        // A slot is taken from the low bits, which multiplication mixes least.
        self.0.rotate_left(26)
    }
}
