//! Machines of which a page could stumble: names that are words of JavaScript or of the page itself, texts that
//! would end a script, and every function.

#![allow(non_snake_case, non_camel_case_types)]

use linkage_core::mechanism;

mechanism! {
    /// Ends early: </script><script>alert("1")</script> <!-- and `${x}` \ too.
    pub struct Function {
        /// An angle, </script>.
        input arguments: angle;
        param class = 80mm;
        param p = 632mm;
        param MACHINE: mode = right;
        ground function(0, 0), document(665.7mm, 0);
        crank var(function) -> window { length: class, angle: arguments }
        rrr   q(window), NaN(document) -> c { lengths: (p, 374mm), mode: MACHINE }
        point constructor on q at (500mm, -60mm);
        output this = constructor.x + c.x, constructor, c, q, var;
    }
}

mechanism! {
    /// Functions, compensated.
    pub struct Compensated {
        input theta: angle;
        input s: length;
        param l = 0.25m;
        numerics compensated;
        ground A(0, 0), D(0.6m, 0);
        crank AB(A) -> B { length: hypot(0.06m, 0.04m + s), angle: 2 * theta + atan2(s, 1m) }
        rrr BC(B), DC(D) -> C { lengths: (0.5m, l + 0.2m), mode: left }
        let bent = asin(0.3 * sin(theta)) + acos(0.2 * cos(theta)) + atan(tan(0.1 * theta));
        crank DE(D) -> E { length: sqrt(l * l), angle: bent }
        output C, E, bent, size = abs(C.y) + max(C.x, E.x);
    }
}
