//! A number that depends on two variables, with slopes and bends: formulas differentiate themselves.

use core::ops::{Add, Mul, Neg, Sub};

use super::jet::Jet;

/// A value with its first and second derivatives with respect to two variables, a and b.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Jet2 {
    pub(crate) value: f64,
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) aa: f64,
    pub(crate) ab: f64,
    pub(crate) bb: f64,
}

impl Jet2 {
    pub(crate) const fn constant(value: f64) -> Self {
        Self { value, a: 0.0, b: 0.0, aa: 0.0, ab: 0.0, bb: 0.0 }
    }

    /// A function of the first variable alone.
    pub(crate) const fn of_a(jet: Jet) -> Self {
        Self { value: jet.value, a: jet.slope, b: 0.0, aa: jet.bend, ab: 0.0, bb: 0.0 }
    }

    /// A function of the second variable alone.
    pub(crate) const fn of_b(jet: Jet) -> Self {
        Self { value: jet.value, a: 0.0, b: jet.slope, aa: 0.0, ab: 0.0, bb: jet.bend }
    }

    /// A function of this number, given by its value, slope and bend here.
    pub(crate) fn map(self, f: Jet) -> Self {
        let bend = |x: f64, y: f64, xy: f64| f.bend * x * y + f.slope * xy;
        Self {
            value: f.value,
            a: f.slope * self.a,
            b: f.slope * self.b,
            aa: bend(self.a, self.a, self.aa),
            ab: bend(self.a, self.b, self.ab),
            bb: bend(self.b, self.b, self.bb),
        }
    }

    /// The square root.
    pub(crate) fn sqrt(self) -> Self {
        let root = libm::sqrt(self.value);
        self.map(Jet::new(root, 0.5 / root, -0.25 / (root * self.value)))
    }

    pub(crate) fn recip(self) -> Self {
        let inverse = 1.0 / self.value;
        let square = inverse * inverse;
        let bend = |x: f64, y: f64, xy: f64| (2.0 * x * y * inverse - xy) * square;
        Self {
            value: inverse,
            a: -self.a * square,
            b: -self.b * square,
            aa: bend(self.a, self.a, self.aa),
            ab: bend(self.a, self.b, self.ab),
            bb: bend(self.b, self.b, self.bb),
        }
    }
}

impl Add for Jet2 {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            value: self.value + o.value,
            a: self.a + o.a,
            b: self.b + o.b,
            aa: self.aa + o.aa,
            ab: self.ab + o.ab,
            bb: self.bb + o.bb,
        }
    }
}

impl Neg for Jet2 {
    type Output = Self;
    fn neg(self) -> Self {
        -1.0 * self
    }
}

impl Sub for Jet2 {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Mul for Jet2 {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self {
            value: self.value * o.value,
            a: self.a * o.value + self.value * o.a,
            b: self.b * o.value + self.value * o.b,
            aa: self.aa * o.value + 2.0 * self.a * o.a + self.value * o.aa,
            ab: self.ab * o.value + self.a * o.b + self.b * o.a + self.value * o.ab,
            bb: self.bb * o.value + 2.0 * self.b * o.b + self.value * o.bb,
        }
    }
}

impl Mul<Jet2> for f64 {
    type Output = Jet2;
    fn mul(self, o: Jet2) -> Jet2 {
        Jet2 { value: self * o.value, a: self * o.a, b: self * o.b, aa: self * o.aa, ab: self * o.ab, bb: self * o.bb }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x³y/(1 + y) at (0.7, 0.4).
    #[test]
    fn derivatives_follow_the_rules() {
        let (p, q) = (0.7, 0.4);
        let x = Jet2::of_a(Jet::new(p, 1.0, 0.0));
        let y = Jet2::of_b(Jet::new(q, 1.0, 0.0));
        let z = x * x * x * y * (Jet2::constant(1.0) + y).recip();
        let (h, h1, h2) = (q / (1.0 + q), 1.0 / (1.0 + q) / (1.0 + q), -2.0 / (1.0 + q) / (1.0 + q) / (1.0 + q));
        let close = |got: f64, want: f64| assert!((got - want).abs() < 1e-15, "{got} {want}");
        close(z.value, p * p * p * h);
        close(z.a, 3.0 * p * p * h);
        close(z.b, p * p * p * h1);
        close(z.aa, 6.0 * p * h);
        close(z.ab, 3.0 * p * p * h1);
        close(z.bb, p * p * p * h2);
        // √(x²y²) = xy
        let product = (x * x * y * y).sqrt();
        close(product.value, p * q);
        close(product.a, q);
        close(product.ab, 1.0);
        close(product.aa, 0.0);
    }
}
