//! Unpacks the compiler of the playground in a browser, which knows no format as small.
//!
//! `room(bytes) → address` makes room for an archive, `unpacked(address, bytes) → address` consumes it and answers with as
//! many bytes as its head says, or with zero where it is damaged. There are no imports, and nothing is freed: a page
//! unpacks once.

use std::io::Read;

use lzma_rust2::LzmaReader;

/// The most memory that a dictionary may take, in kilobytes.
const MOST: u32 = 64 << 10;

/// Room for an archive.
#[unsafe(no_mangle)]
pub extern "C" fn room(bytes: usize) -> *mut u8 {
    Box::into_raw(vec![0_u8; bytes].into_boxed_slice()).cast()
}

/// The bytes that an archive in the format of `.lzma` holds.
///
/// # Safety
/// It stands in room that [`room`] has made for as many bytes, and is given once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn unpacked(archive: *mut u8, bytes: usize) -> *mut u8 {
    // SAFETY: by the contract.
    let archive = unsafe { Box::from_raw(core::ptr::slice_from_raw_parts_mut(archive, bytes)) };
    let mut found = Vec::new();
    let read = LzmaReader::new_mem_limit(&archive[..], MOST, None)
        .is_ok_and(|mut reader| reader.read_to_end(&mut found).is_ok());
    match read {
        true => Box::into_raw(found.into_boxed_slice()).cast(),
        false => core::ptr::null_mut(),
    }
}
