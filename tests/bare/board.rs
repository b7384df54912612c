//! QEMU's mps2-an386 as far as it is needed: reset, a clock that counts instructions, and a
//! console.

use core::arch::{asm, global_asm};
use core::fmt::{self, Write};

// Initial stack pointer, reset; no interrupt is ever enabled. Reset turns the floating-point unit
// on before any code may use it.
global_asm!(
    ".section .vectors, \"a\"",
    ".word 0x20400000",
    ".word reset",
    ".text",
    ".thumb_func",
    ".global reset",
    "reset:",
    "ldr r0, =0xE000ED88",
    "ldr r1, [r0]",
    "orr r1, r1, #0xF00000",
    "str r1, [r0]",
    "dsb",
    "isb",
    "bl main",
    "b .",
);

const SYST_CSR: *mut u32 = 0xE000_E010 as *mut u32;
const SYST_RVR: *mut u32 = 0xE000_E014 as *mut u32;
const SYST_CVR: *mut u32 = 0xE000_E018 as *mut u32;

/// Instructions that pass between two ticks of the clock: the board's runs at 25 MHz, and QEMU's
/// `-icount shift=0` gives every instruction a nanosecond.
const INSTRUCTIONS_PER_TICK: u32 = 40;

/// The instructions of a piece of work, in units of the clock.
pub(crate) fn instructions(work: impl FnOnce()) -> u32 {
    // SAFETY: the registers of the system timer, which every Cortex-M has.
    let now = || unsafe { SYST_CVR.read_volatile() };
    // SAFETY: as above.
    unsafe {
        SYST_RVR.write_volatile(0x00ff_ffff);
        SYST_CVR.write_volatile(0);
        SYST_CSR.write_volatile(5);
    }
    let begin = now();
    work();
    // It counts downwards, in 24 bits.
    (begin.wrapping_sub(now()) & 0x00ff_ffff) * INSTRUCTIONS_PER_TICK
}

fn semihosting(operation: u32, argument: u32) {
    // SAFETY: the debugger's call; what it reads is null-terminated.
    unsafe { asm!("bkpt 0xab", inout("r0") operation => _, in("r1") argument) };
}

/// The emulator's standard output.
pub(crate) struct Console;

impl Write for Console {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for &byte in text.as_bytes() {
            let text = [byte, 0];
            semihosting(4, text.as_ptr() as u32);
        }
        Ok(())
    }
}

/// Ends the emulation.
pub(crate) fn exit() -> ! {
    semihosting(0x18, 0x20026);
    loop {}
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
    let _ = writeln!(Console, "{info}");
    exit()
}
