/// One channel of a picture, row by row from the top.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    pub(super) width: usize,
    pub(super) values: Vec<f64>,
}

impl Plane {
    pub(super) fn height(&self) -> usize {
        self.values.len() / self.width.max(1)
    }

    /// The sum over the neighbours, weighted by the product of a weight for their column and one for their row: first along the
    /// rows, then along the columns. Either kernel has an odd number of weights, the middle one for the pixel itself.
    pub(super) fn filtered(&self, along_x: &[f64], along_y: &[f64]) -> Self {
        self.filtered_along_x(along_x).filtered_along_y(along_y)
    }

    fn filtered_along_x(&self, kernel: &[f64]) -> Self {
        let radius = kernel.len() / 2;
        let mut values = vec![0.0; self.values.len()];
        let mut padded = vec![0.0; self.width + 2 * radius];
        let rows = self.values.chunks_exact(self.width.max(1));
        for (row, filtered) in rows.zip(values.chunks_exact_mut(self.width.max(1))) {
            padded[..radius].fill(row[0]);
            padded[radius..radius + row.len()].copy_from_slice(row);
            padded[radius + row.len()..].fill(row[row.len() - 1]);
            for (offset, &weight) in kernel.iter().enumerate() {
                add_weighted(filtered, weight, &padded[offset..]);
            }
        }
        Self { width: self.width, values }
    }

    fn filtered_along_y(&self, kernel: &[f64]) -> Self {
        let radius = kernel.len() / 2;
        let mut values = vec![0.0; self.values.len()];
        let last = self.height().saturating_sub(1);
        for (y, filtered) in values.chunks_exact_mut(self.width.max(1)).enumerate() {
            for (offset, &weight) in kernel.iter().enumerate() {
                let row = (y + offset).saturating_sub(radius).min(last);
                add_weighted(filtered, weight, &self.values[row * self.width..]);
            }
        }
        Self { width: self.width, values }
    }
}

/// Row by row and not pixel by pixel: so the compiler can take several pixels at once, without changing the order of any sum.
fn add_weighted(sums: &mut [f64], weight: f64, values: &[f64]) {
    for (sum, value) in sums.iter_mut().zip(values) {
        *sum += weight * value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kernel_s_weights_stand_around_the_pixel_and_borders_go_on() {
        let plane = Plane { width: 3, values: vec![1.0, 2.0, 3.0, 10.0, 20.0, 30.0] };
        // Each row becomes left + 100 right; then each pixel itself + 10000 below.
        let filtered = plane.filtered(&[1.0, 0.0, 100.0], &[0.0, 1.0, 10_000.0]);
        let first = [201.0, 301.0, 302.0];
        let second = [2010.0, 3010.0, 3020.0];
        let expected: Vec<f64> =
            (0..3).map(|x| first[x] + 10_000.0 * second[x]).chain((0..3).map(|x| 10_001.0 * second[x])).collect();
        assert_eq!(filtered.values, expected);
    }
}
