//! A ZIP archive of files as they are, without compression.

/// The signature of an entry.
const ENTRY: u32 = 0x0403_4b50;
/// The signature of an entry's line in the directory.
const DIRECTORY: u32 = 0x0201_4b50;

/// Appends a number, the last significant byte first.
fn put(bytes: &mut Vec<u8>, number: u32, count: usize) {
    bytes.extend(&number.to_le_bytes()[..count]);
}

/// The checksum of ISO 3309.
fn checksum(bytes: &[u8]) -> u32 {
    let step = |sum: u32| if sum & 1 == 1 { (sum >> 1) ^ 0xedb8_8320 } else { sum >> 1 };
    !bytes.iter().fold(!0, |sum, &byte| (0..8).fold(sum ^ u32::from(byte), |sum, _| step(sum)))
}

/// The properties that the entry and the directory repeat: version 2.0, names in UTF-8, stored, and the first day of 1980.
fn properties(name: &str, content: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for (number, count) in [(20, 2), (1 << 11, 2), (0, 2), (0, 2), (0x21, 2)] {
        put(&mut bytes, number, count);
    }
    let size = u32::try_from(content.len()).expect("a file is smaller than four gigabytes");
    put(&mut bytes, checksum(content), 4);
    put(&mut bytes, size, 4);
    put(&mut bytes, size, 4);
    put(&mut bytes, u32::try_from(name.len()).expect("a name is short"), 2);
    put(&mut bytes, 0, 2);
    bytes
}

/// The entry of a file: its properties, its name, and its content.
fn entry(name: &str, content: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    put(&mut bytes, ENTRY, 4);
    bytes.extend(properties(name, content));
    bytes.extend(name.as_bytes());
    bytes.extend(content);
    bytes
}

/// True if an archive holds these files first, as they are, and behind them those of one folder alone, or none.
pub(crate) fn begins(archive: &[u8], files: &[(String, Vec<u8>)], folder: &str) -> bool {
    let entries: Vec<u8> = files.iter().flat_map(|(name, content)| entry(name, content)).collect();
    let Some(rest) = archive.strip_prefix(&entries[..]) else { return false };
    // The name stands behind the signature and the properties.
    let name = rest.get(4 + properties("", b"").len()..).unwrap_or_default();
    rest.starts_with(&DIRECTORY.to_le_bytes())
        || rest.starts_with(&ENTRY.to_le_bytes()) && name.starts_with(folder.as_bytes())
}

/// The archive of these files, by their names.
pub(crate) fn archive(files: &[(String, Vec<u8>)]) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, content) in files {
        let start = u32::try_from(bytes.len()).expect("an archive is smaller than four gigabytes");
        bytes.extend(entry(name, content));
        put(&mut directory, DIRECTORY, 4);
        put(&mut directory, 20, 2);
        directory.extend(properties(name, content));
        // No comment, the first disk, no attributes.
        put(&mut directory, 0, 4);
        put(&mut directory, 0, 2);
        put(&mut directory, 0, 4);
        put(&mut directory, start, 4);
        directory.extend(name.as_bytes());
    }
    let (start, length) = (bytes.len() as u32, directory.len() as u32);
    bytes.extend(directory);
    put(&mut bytes, 0x0605_4b50, 4);
    put(&mut bytes, 0, 4);
    for _ in 0..2 {
        put(&mut bytes, files.len() as u32, 2);
    }
    put(&mut bytes, length, 4);
    put(&mut bytes, start, 4);
    put(&mut bytes, 0, 2);
    bytes
}
