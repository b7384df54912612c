/* The start of a program on QEMU's mps2-an386, and its end by semihosting. */
#include <stdint.h>

int main(void);
void reset(void);

/* The end of the first 4 MB of data. */
#define STACK_TOP ((const void *)0x20400000)

__attribute__((section(".vectors"), used)) static const void *const vectors[2] = { STACK_TOP, (const void *)reset };

void reset(void)
{
    static const uint32_t exited[2] = { 0x20026u, 0u };
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* the floating-point unit */
    __asm__ volatile("dsb; isb");
    main();
    __asm__ volatile("mov r0, #0x20\nmov r1, %0\nbkpt 0xab" : : "r"(exited) : "r0", "r1");
    for (;;) {
    }
}
