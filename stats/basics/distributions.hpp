#pragma once

namespace ff::stats {

/// Tail probabilities and critical values. All are computed from the tail itself, never as 1 - cdf, so that they stay
/// accurate down to 1e-300.

/// z with P(Z > z) = tail. @pre 0 < tail < 1
double normal_critical(double tail);
/// P(Z > z).
double normal_tail(double z);
/// P(|Z| > |z|).
double normal_two_sided_p(double z);

/// t with P(T > t) = tail for `freedom` > 0 degrees of freedom. @pre 0 < tail < 1
double student_critical(double freedom, double tail);
/// P(T > t).
double student_tail(double t, double freedom);
/// P(|T| > |t|).
double student_two_sided_p(double t, double freedom);

/// x with P(X > x) = tail, X chi-squared. @pre 0 < tail < 1
double chi_squared_critical(double freedom, double tail);
/// P(X > x). @pre x >= 0, freedom > 0
double chi_squared_tail(double x, double freedom);
/// P(X > x), or P(X < x) where not `above`, of noncentral chi-squared with a mean of freedom + lambda. From a mean of
/// 1e4 on a power of it is taken for normal [sankaran1963]: tails of 1e-9 are less than 1 % too large then.
/// @pre x >= 0, freedom > 0, lambda >= 0
double noncentral_chi_squared_tail(double x, double freedom, double lambda, bool above);

/// P(F > f). @pre f >= 0
double fisher_tail(double f, double freedom_above, double freedom_below);
/// f with P(F > f) = tail. @pre 0 < tail < 1
double fisher_critical(double tail, double freedom_above, double freedom_below);

}  // namespace ff::stats
