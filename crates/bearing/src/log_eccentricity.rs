//! The logarithmic eccentricity, in which the logarithm of the load is nearly linear from the centre to contact.

/// `s = ln eps - 3/2 ln(1 - eps)`.
pub(crate) fn log_eccentricity(eps: f64) -> f64 {
    eps.ln() - 1.5 * (1.0 - eps).ln()
}

/// The eccentricity at a logarithmic one, by bisection: of `ln eps` where that is small, of `ln(1 - eps)` where it is
/// large.
pub(crate) fn eccentricity_at(s: f64) -> f64 {
    let (mut low, mut high) = (f64::MIN_POSITIVE, 1.0 - f64::EPSILON);
    for _ in 0..200 {
        let middle = match low < 0.5 && high <= 0.5 {
            true => (low * high).sqrt(),
            false if low >= 0.5 => 1.0 - ((1.0 - low) * (1.0 - high)).sqrt(),
            false => 0.5,
        };
        match log_eccentricity(middle) < s {
            true => low = middle,
            false => high = middle,
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn log_eccentricity_is_inverted() {
        for eps in [1e-6, 0.01, 0.3, 0.5, 0.9, 0.9999] {
            assert!((eccentricity_at(log_eccentricity(eps)) / eps - 1.0).abs() < 1e-12);
        }
    }
}
