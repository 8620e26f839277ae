//! inari's operations over arrays, for C: `graze_inari_add(n, x, y, r)` writes r[i] = x[i] + y[i].
//! An interval is 16 bytes, aligned to 16, and opaque; `graze_inari_make` and `graze_inari_ends`
//! convert. Pointers are to n elements that live; r overlaps no operand.
use inari::Interval;

/// # Safety
/// See the file's head; `ends` holds lower, upper, lower, upper, ...
#[no_mangle]
pub unsafe extern "C" fn graze_inari_make(n: usize, ends: *const f64, r: *mut Interval) {
    for i in 0..n {
        let (lower, upper) = (*ends.add(2 * i), *ends.add(2 * i + 1));
        r.add(i).write(Interval::try_from((lower, upper)).unwrap_or(Interval::EMPTY));
    }
}

/// The empty set gives two NaNs.
/// # Safety
/// See the file's head.
#[no_mangle]
pub unsafe extern "C" fn graze_inari_ends(n: usize, x: *const Interval, ends: *mut f64) {
    for i in 0..n {
        let x = *x.add(i);
        let empty = x.is_empty();
        *ends.add(2 * i) = if empty { f64::NAN } else { x.inf() };
        *ends.add(2 * i + 1) = if empty { f64::NAN } else { x.sup() };
    }
}

macro_rules! unary {
    ($($name:ident($x:ident) = $value:expr;)*) => {$(
        /// # Safety
        /// See the file's head.
        #[no_mangle]
        pub unsafe extern "C" fn $name(n: usize, x: *const Interval, r: *mut Interval) {
            for i in 0..n {
                let $x = *x.add(i);
                r.add(i).write($value);
            }
        }
    )*};
}
macro_rules! binary {
    ($($name:ident($x:ident, $y:ident) = $value:expr;)*) => {$(
        /// # Safety
        /// See the file's head.
        #[no_mangle]
        pub unsafe extern "C" fn $name(n: usize, x: *const Interval, y: *const Interval,
                                       r: *mut Interval) {
            for i in 0..n {
                let ($x, $y) = (*x.add(i), *y.add(i));
                r.add(i).write($value);
            }
        }
    )*};
}

unary! {
    graze_inari_sqr(x) = x.sqr();
    graze_inari_sqrt(x) = x.sqrt();
    graze_inari_exp(x) = x.exp();
    graze_inari_log(x) = x.ln();
    graze_inari_sin(x) = x.sin();
    graze_inari_cos(x) = x.cos();
    graze_inari_tan(x) = x.tan();
    graze_inari_asin(x) = x.asin();
    graze_inari_acos(x) = x.acos();
    graze_inari_atan(x) = x.atan();
    graze_inari_sinh(x) = x.sinh();
    graze_inari_cosh(x) = x.cosh();
    graze_inari_tanh(x) = x.tanh();
    graze_inari_fourth_power(x) = x.powi(4);
}
binary! {
    graze_inari_add(x, y) = x + y;
    graze_inari_sub(x, y) = x - y;
    graze_inari_mul(x, y) = x * y;
    graze_inari_div(x, y) = x / y;
    graze_inari_atan2(x, y) = x.atan2(y);
    graze_inari_pow(x, y) = x.pow(y);
}
