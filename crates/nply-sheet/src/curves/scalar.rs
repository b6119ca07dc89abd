//! Numbers in binary: kinds, sizes, both orders of bytes.

/// What stands in a binary array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    Float(usize),
    Signed(usize),
    Unsigned(usize),
}

/// The largest whole number up to which every one is a double.
const EXACT: i128 = 1 << 53;

impl Scalar {
    /// Bytes of one number.
    pub(super) const fn size(self) -> usize {
        match self {
            Self::Float(size) | Self::Signed(size) | Self::Unsigned(size) => size,
        }
    }

    /// Of VTK XML: `Float32`, `Int64`, `UInt8`.
    pub(super) fn of_xml(name: &str) -> Option<Self> {
        let (kind, bits): (fn(usize) -> Self, _) = if let Some(bits) = name.strip_prefix("Float") {
            (Self::Float, bits)
        } else if let Some(bits) = name.strip_prefix("UInt") {
            (Self::Unsigned, bits)
        } else {
            (Self::Signed, name.strip_prefix("Int")?)
        };
        let size = match bits {
            "8" => 1,
            "16" => 2,
            "32" => 4,
            "64" => 8,
            _ => return None,
        };
        Some(kind(size)).filter(|scalar| !matches!(scalar, Self::Float(1 | 2)))
    }

    /// Of VTK legacy files: `float`, `vtktypeint64`.
    pub(super) fn of_legacy(name: &str) -> Option<Self> {
        Some(match name {
            "float" => Self::Float(4),
            "double" => Self::Float(8),
            "char" | "signed_char" => Self::Signed(1),
            "unsigned_char" => Self::Unsigned(1),
            "short" => Self::Signed(2),
            "unsigned_short" => Self::Unsigned(2),
            "int" | "vtkidtype" => Self::Signed(4),
            "unsigned_int" => Self::Unsigned(4),
            "long" | "vtktypeint64" => Self::Signed(8),
            "unsigned_long" | "vtktypeuint64" => Self::Unsigned(8),
            _ => return None,
        })
    }

    /// The number in exactly [`size`](Self::size) bytes, as a double; none where it is not finite or no double equals it.
    pub(super) fn double(self, bytes: &[u8], big_endian: bool) -> Option<f64> {
        let value = match self {
            Self::Float(4) => f64::from(f32::from_bits(u32::try_from(bits(bytes, big_endian)).ok()?)),
            Self::Float(_) => f64::from_bits(bits(bytes, big_endian)),
            _ => {
                let whole = self.whole(bytes, big_endian)?;
                // exact: not larger than 2⁵³
                if whole.abs() <= EXACT { whole as f64 } else { return None }
            }
        };
        value.is_finite().then_some(value)
    }

    /// The whole number in these bytes; none for a float.
    pub(super) fn whole(self, bytes: &[u8], big_endian: bool) -> Option<i128> {
        let bits = bits(bytes, big_endian);
        match self {
            Self::Float(_) => None,
            Self::Unsigned(_) => Some(i128::from(bits)),
            Self::Signed(size) => {
                let unused = 64 - 8 * u32::try_from(size).ok()?;
                Some(i128::from((bits << unused).cast_signed() >> unused))
            }
        }
    }
}

/// At most eight bytes as a number without sign.
fn bits(bytes: &[u8], big_endian: bool) -> u64 {
    let push = |bits: u64, byte: &u8| bits << 8 | u64::from(*byte);
    if big_endian { bytes.iter().fold(0, push) } else { bytes.iter().rev().fold(0, push) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_out_of_either_order_of_bytes() {
        for (scalar, little, value) in [
            (Scalar::Float(4), (-1.5_f32).to_le_bytes().to_vec(), Some(-1.5)),
            (Scalar::Float(8), 0.1_f64.to_le_bytes().to_vec(), Some(0.1)),
            (Scalar::Float(8), f64::NAN.to_le_bytes().to_vec(), None),
            (Scalar::Signed(2), (-3_i16).to_le_bytes().to_vec(), Some(-3.0)),
            (Scalar::Unsigned(2), 65_533_u16.to_le_bytes().to_vec(), Some(65_533.0)),
            (Scalar::Signed(8), i64::MIN.to_le_bytes().to_vec(), None),
            (Scalar::Signed(8), (-(1_i64 << 53)).to_le_bytes().to_vec(), Some(-9_007_199_254_740_992.0)),
            (Scalar::Unsigned(1), vec![200], Some(200.0)),
        ] {
            let big: Vec<u8> = little.iter().rev().copied().collect();
            assert_eq!(scalar.double(&little, false), value, "{scalar:?}");
            assert_eq!(scalar.double(&big, true), value, "{scalar:?}");
        }
    }
}
