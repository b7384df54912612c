/* linkage_run.h: the arithmetic of solvers that linkage has printed.
 *
 * Answers and refusals are those of the solver in Rust, bit for bit where both are compiled with a
 * fused multiplication and addition or both without. Nothing is allocated, nothing is kept between
 * calls, and nothing but <math.h> is called.
 *
 * This text is yours: use, change and pass it on under any terms, with or without this notice. It comes
 * without any warranty. */
#ifndef LINKAGE_RUN_H
#define LINKAGE_RUN_H

/* A hash of the whole run-time: sources that were printed with another one do not compile with it. */
#define LINKAGE_RUN_TIME OWN_HASH

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* A header of yours that names functions of the target: sines, square roots, fused products. */
#if defined(LINKAGE_HOOKS)
#include LINKAGE_HOOKS
#endif

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || defined(__ASSOCIATIVE_MATH__) \
    || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "a refusal rests on NaN and on exact rounding: compile without -ffast-math"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "a refusal rests on exact rounding: compile without excess precision, as with -msse2 -mfpmath=sse"
#endif

/* Numbers by which the slow path decides. With LINKAGE_NO_DOUBLE these are float as well, and decisions are made in sums of
 * them: refusals are the same, and no double is computed with. */
#if defined(LINKAGE_NO_DOUBLE)
typedef float LinkageWide;
#elif defined(DBL_MANT_DIG) && DBL_MANT_DIG < 53
#error "double has fewer than 64 bits here: define LINKAGE_NO_DOUBLE for decisions in float, or as for avr-gcc 10 ask for -mdouble=64"
#else
typedef double LinkageWide;
#endif

/* No product is contracted into a sum but where a fused operation is written. gcc 12 contracts vectors of sums and
 * differences whatever it is told, so it makes none. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-vectorize")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#else
#pragma STDC FP_CONTRACT OFF
#endif

#if defined(__GNUC__)
#define LINKAGE_COLD __attribute__((cold, noinline))
#else
#define LINKAGE_COLD
#endif

/* A fast path becomes part of the function that calls it, so that results stay in registers until they are known to be
 * answers. */
#if !defined(LINKAGE_INLINE)
#if defined(__GNUC__)
#define LINKAGE_INLINE inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define LINKAGE_INLINE __forceinline
#else
#define LINKAGE_INLINE inline
#endif
#endif

/* Defined where one instruction multiplies and adds with one rounding. */
#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__) || defined(LINKAGE_FMA_F64)
#define LINKAGE_FUSES 1
#endif
#if defined(FP_FAST_FMAF) || defined(__FMA__) || defined(__aarch64__) || defined(LINKAGE_FMA_F32)
#define LINKAGE_FUSESF 1
#endif

#ifdef __cplusplus
extern "C" {
#endif

