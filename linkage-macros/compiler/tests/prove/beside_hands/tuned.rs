//! The form that is tuned where it matters: everything behind a crank is affine in one product, divisions run beside
//! roots, and products are fused into sums where the number has the operation.

use super::forms::Form;
use super::plane::{Crank, Dyad, Link, Moving, Rail, Slide, Vector};
use crate::prove::computed::Float;

pub(super) struct Tuned {
    pub is_fused: bool,
}

impl Tuned {
    /// a·b + c
    fn fused<T: Float>(&self, a: T, b: T, c: T) -> T {
        if self.is_fused { a.fused_once(b, c) } else { a * b + c }
    }

    fn dot<T: Float>(&self, a: Vector<T>, b: Vector<T>) -> T {
        self.fused(a.x, b.x, a.y * b.y)
    }

    fn cross<T: Float>(&self, a: Vector<T>, b: Vector<T>) -> T {
        self.fused(a.x, b.y, -(a.y * b.x))
    }

    /// factor · r + other
    fn scaled_and<T: Float>(&self, r: Vector<T>, factor: T, other: Vector<T>) -> Vector<T> {
        Vector { x: self.fused(factor, r.x, other.x), y: self.fused(factor, r.y, other.y) }
    }

    /// A constant vector's product and cross product with another.
    fn parts<T: Float>(&self, [x, y]: [f64; 2], of: Vector<T>) -> [T; 2] {
        match y == 0.0 {
            true => [T::of(x) * of.x, T::of(x) * of.y],
            false => [
                self.fused(T::of(x), of.x, T::of(y) * of.y),
                self.fused(T::of(x), of.y, -(T::of(y) * of.x)),
            ],
        }
    }

    fn carried<T: Float>(&self, origin: Moving<T>, r: Vector<T>, link: Link<T>) -> Moving<T> {
        let centripetal = self.scaled_and(r, -(link.omega * link.omega), origin.acceleration);
        Moving {
            position: origin.position + r,
            velocity: self.scaled_and(r.normal(), link.omega, origin.velocity),
            acceleration: self.scaled_and(r.normal(), link.alpha, centripetal),
        }
    }

    /// Both bars from 1/h and r₂·r₃, their ω, and products of the first joint's acceleration with r₂ and r₃.
    fn bars<T: Float>(
        &self,
        Dyad { lengths: [l2, l3], .. }: Dyad,
        [r2, r3]: [Vector<T>; 2],
        [upright, between]: [T; 2],
        [omega2, omega3]: [T; 2],
        [with2, with3]: [T; 2],
    ) -> [Link<T>; 2] {
        let of = T::of;
        let (p, q) = (omega2 * omega2, omega3 * omega3);
        let inner2 = self.fused(-p, between, with3);
        let inner3 = self.fused(-p, of(l2 * l2), with2);
        let alpha2 = upright * self.fused(q, of(l3 * l3), inner2);
        let alpha3 = upright * self.fused(q, between, inner3);
        [
            Link { r: r2, length: l2, omega: omega2, alpha: alpha2 },
            Link { r: r3, length: l3, omega: omega3, alpha: alpha3 },
        ]
    }

    /// (q d + h d⊥)/d²
    fn second<T: Float>(&self, d: Vector<T>, [h, share, inverse]: [T; 3]) -> Vector<T> {
        let across = d.normal() * h;
        let sum = self.scaled_and(d, share, across);
        sum * inverse
    }
}

impl<T: Float> Form<T> for Tuned {
    fn pin(&self, Crank { length, input: [angle, omega, alpha] }: Crank<T>) -> Moving<T> {
        let (sin, cos) = angle.sin_cos();
        let r = Vector { x: cos, y: sin } * T::of(length);
        self.carried(Moving::still([0.0; 2]), r, Link { r, length, omega, alpha })
    }

    fn crank_dyad(&self, crank: Crank<T>, dyad: Dyad) -> (Moving<T>, [Link<T>; 2]) {
        let (of, Dyad { pivot: [gx, gy], lengths: [l2, l3], side }) = (T::of, dyad);
        let (pin, [_, omega, alpha], a) = (self.pin(crank), crank.input, crank.length);
        let arm = pin.position;
        let mean = gx * gx + gy * gy + a * a;
        // G·a by its slope, and G × a.
        let (sin, cos) = crank.input[0].sin_cos();
        let (along, slope) = match gy == 0.0 {
            true => (cos, a * gx),
            false => (self.fused(of(gx), cos, of(gy) * sin), a),
        };
        let [_, e] = self.parts([gx, gy], arm);
        let affine = |slope: f64, from: f64| self.fused(of(slope), along, of(from));
        let (one, inverse) = (of(1.0), of(1.0) / affine(-2.0 * slope, mean));
        let x = affine(slope, ((l2 + l3) * (l2 + l3) - mean) / 2.0)
            * affine(-slope, (mean - (l2 - l3) * (l2 - l3)) / 2.0);
        let h = of(side) * x.sqrt();
        let share = affine(-slope, (mean + l2 * l2 - l3 * l3) / 2.0);
        let between = affine(slope, (l2 * l2 + l3 * l3 - mean) / 2.0);
        let d = Vector::of([gx, gy]) - arm;
        let r2 = self.second(d, [h, share, inverse]);
        let f = affine(slope, -(a * a));
        // a·r₂ and a × r₂, then those of r₃.
        let dot = inverse * self.fused(h, e, share * f);
        let cross = inverse * self.fused(h, f, -(share * e));
        let (dot3, cross3) = (dot - f, cross + e);
        let upright = -h * (one / x);
        let rates = [upright * omega * cross3, upright * omega * cross];
        let square = omega * omega;
        let with = [
            self.fused(alpha, cross, -(square * dot)),
            self.fused(alpha, cross3, -(square * dot3)),
        ];
        (pin, self.bars(dyad, [r2, r2 - d], [upright, between], rates, with))
    }

    fn dyad(&self, pin: Moving<T>, dyad: Dyad) -> [Link<T>; 2] {
        let (of, Dyad { pivot, lengths: [l2, l3], side }) = (T::of, dyad);
        let d = Vector::of(pivot) - pin.position;
        let square = self.dot(d, d);
        let (one, half) = (of(1.0), of(0.5));
        let inverse = one / square;
        let x = self.fused(-half, square, of((l2 + l3) * (l2 + l3) / 2.0))
            * self.fused(half, square, of(-((l2 - l3) * (l2 - l3) / 2.0)));
        let h = of(side) * x.sqrt();
        let share = self.fused(half, square, of((l2 * l2 - l3 * l3) / 2.0));
        let between = self.fused(-half, square, of((l2 * l2 + l3 * l3) / 2.0));
        let r2 = self.second(d, [h, share, inverse]);
        let upright = -h * (one / x);
        // The products of v or a with r₂ and r₃.
        let products = |w: Vector<T>| {
            let (along, aside) = (self.dot(w, d), self.cross(d, w));
            let with2 = inverse * self.fused(h, aside, share * along);
            [with2, with2 - along]
        };
        let [v2, v3] = products(pin.velocity);
        let with = products(pin.acceleration);
        self.bars(dyad, [r2, r2 - d], [upright, between], [upright * v3, upright * v2], with)
    }

    fn block(&self, crank: Crank<T>, pivot: [f64; 2], e: f64) -> (Link<T>, Slide<T>) {
        if e == 0.0 {
            return self.centric(crank, pivot);
        }
        let pin = self.pin(crank);
        self.eccentric(pin, pin.position - Vector::of(pivot), e)
    }

    fn rod(
        &self,
        crank: Crank<T>,
        Rail { origin: [x0, y0], direction: [ux, uy] }: Rail,
        [l, e]: [f64; 2],
    ) -> (Moving<T>, Link<T>, Slide<T>) {
        let (of, pin, [_, omega, alpha]) = (T::of, self.pin(crank), crank.input);
        let ((sin, cos), a) = (crank.input[0].sin_cos(), crank.length);
        let [along, across] = match uy == 0.0 {
            true => [pin.position.x, pin.position.y],
            false => self.parts([a * ux, a * uy], Vector { x: cos, y: sin }),
        };
        let start = [ux * x0 + uy * y0, ux * y0 - uy * x0];
        let square = omega * omega;
        let (v, w) = (-(omega * across), omega * along);
        let f = self.fused(-square, along, -(alpha * across));
        let g = self.fused(alpha, along, -(square * across));
        let t = of(e) - (across - of(start[1]));
        let left = (of(l) - t) * (of(l) + t);
        let x = left.sqrt();
        let inverse = x * (of(1.0) / left);
        let turning = -(w * inverse);
        let p = turning * turning;
        let second = self.fused(p, t, -g) * inverse;
        let slide = [
            (along - of(start[0])) + x,
            self.fused(-turning, t, v),
            self.fused(-p, x, self.fused(-second, t, f)),
        ];
        let r = match uy == 0.0 {
            true => Vector { x, y: t },
            false => Vector {
                x: self.fused(x, of(ux), -(t * of(uy))),
                y: self.fused(x, of(uy), t * of(ux)),
            },
        };
        (pin, Link { r, length: l, omega: turning, alpha: second }, slide)
    }

    fn point(&self, origin: Moving<T>, link: Link<T>, [x, y]: [f64; 2]) -> Moving<T> {
        let [along, aside] = [x / link.length, y / link.length].map(T::of);
        let r = match y == 0.0 {
            true => link.r * along,
            false => Vector {
                x: self.fused(along, link.r.x, -(aside * link.r.y)),
                y: self.fused(along, link.r.y, aside * link.r.x),
            },
        };
        self.carried(origin, r, link)
    }

    fn direction(&self, link: Link<T>) -> Vector<T> {
        link.r * T::of(1.0 / link.length)
    }
}

impl Tuned {
    /// A block without an offset: b² and the products of the arm with b are affine in two products.
    fn centric<T: Float>(&self, crank: Crank<T>, pivot: [f64; 2]) -> (Link<T>, Slide<T>) {
        let ([gx, gy], [_, omega, alpha], a) = (pivot, crank.input, crank.length);
        let (of, arm) = (T::of, self.pin(crank).position);
        let [along, aside] = self.parts(pivot, arm);
        let square = self.fused(of(-2.0), along, of(gx * gx + gy * gy + a * a));
        let value = square.sqrt();
        let inverse = value * (of(1.0) / square);
        let u = (arm - Vector::of(pivot)) * inverse;
        let [dot, cross] = [(of(a * a) - along) * inverse, aside * inverse];
        let turning = omega * dot * inverse;
        let rate = omega * cross;
        let square_rate = omega * omega;
        let across = self.fused(alpha, dot, square_rate * cross);
        let outward = self.fused(alpha, cross, -(square_rate * dot));
        let second = self.fused(-(turning + turning), rate, across) * inverse;
        let slide = [value, rate, self.fused(turning * turning, value, outward)];
        (Link { r: u, length: 1.0, omega: turning, alpha: second }, slide)
    }

    /// A block at an offset.
    fn eccentric<T: Float>(&self, pin: Moving<T>, b: Vector<T>, e: f64) -> (Link<T>, Slide<T>) {
        let (of, square, offset) = (T::of, self.dot(b, b), T::of(e));
        let left = self.fused(-offset, offset, square);
        let (value, one) = (left.sqrt(), of(1.0));
        let (inverse, share) = (value * (one / left), one / square);
        let (s, e_share) = (value * share, offset * share);
        let u = Vector {
            x: self.fused(s, b.x, e_share * b.y),
            y: self.fused(s, b.y, -(e_share * b.x)),
        };
        let (v, a) = (pin.velocity, pin.acceleration);
        let omega = self.cross(u, v) * inverse;
        let rate = self.dot(v, b) * inverse;
        let p = omega * omega;
        let across = self.fused(p, offset, self.cross(u, a));
        let alpha = self.fused(-(omega + omega), rate, across) * inverse;
        let second = self.fused(alpha, offset, self.fused(p, value, self.dot(a, u)));
        (Link { r: u, length: 1.0, omega, alpha }, [value, rate, second])
    }
}
