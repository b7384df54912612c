#if LINKAGE_RUN_TIME != OWN_HASH
#error "linkage_run.h was printed by another version than this file: print both anew, or one supplier's with a prefix"
#endif
