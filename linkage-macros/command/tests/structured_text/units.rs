//! The numbers of a unit, by the names of its variables and of their parts.

use super::reader::{Field, Unit};

/// True if a path leads to a variable of this name or into it.
pub(crate) fn is_part(path: &str, name: &str) -> bool {
    path.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

impl Unit {
    /// Declares a variable of these numbers: its place and their count.
    pub(crate) fn add(&mut self, name: &str, fields: Vec<Field>) -> (usize, usize) {
        let (at, count) = (self.fields.len(), fields.len());
        for (nth, field) in fields.iter().enumerate() {
            // Every part that begins here, and all that belongs to it.
            let signs = field.path.char_indices().filter(|&(_, sign)| sign == '.' || sign == '[');
            for end in signs.map(|(end, _)| end).chain([field.path.len()]) {
                let part = &field.path[..end];
                let of_part = fields.iter().filter(|other| is_part(&other.path, part)).count();
                self.places.entry(part.to_string()).or_insert((at + nth, of_part));
            }
        }
        let is_new = self.fields.iter().all(|field| !is_part(&field.path, name));
        assert!(is_new, "`{name}` is declared twice in {}", self.name);
        self.fields.extend(fields);
        (at, count)
    }

    pub(crate) fn place(&self, path: &str) -> (usize, usize) {
        *self.places.get(path).unwrap_or_else(|| panic!("no variable `{path}` in {}", self.name))
    }
}
