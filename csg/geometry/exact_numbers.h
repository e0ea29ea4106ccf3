// Numbers of exact values, from 0 in the order in which they come: equal values have one number.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "kernel/base/counts.h"
#include "kernel/base/limits.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// Of Rational or RationalPoint. Nothing is put in the order of hashes.
template <class Value>
class ExactNumbers {
 public:
  /// InputError where there are more than 32 bits tell; `what` they are.
  std::uint32_t of(const Value& value, const char* what) {
    const auto [it, fresh] = number_.try_emplace(value, next_number(values_.size(), what));
    if (fresh) values_.push_back(value);
    return it->second;
  }
  /// kNone if there is none.
  std::uint32_t find(const Value& value) const {
    const auto it = number_.find(value);
    return it == number_.end() ? kNone : it->second;
  }
  const Value& operator[](std::uint32_t number) const { return values_[number]; }
  const std::vector<Value>& all() const { return values_; }

 private:
  struct Hash {
    std::size_t operator()(const Rational& x) const {
      const mpz_srcptr n = x.get_num_mpz_t(), d = x.get_den_mpz_t();
      std::uint64_t hash = static_cast<std::uint64_t>(sgn(x) + 1);
      for (const mpz_srcptr part : {n, d}) {
        for (std::size_t i = 0; i < mpz_size(part); ++i)
          hash =
              (hash ^ mpz_getlimbn(part, static_cast<mp_size_t>(i))) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
        hash ^= hash >> 29;
      }
      return hash;
    }
    std::size_t operator()(const RationalPoint& p) const {
      return ((*this)(p[0]) * 31 + (*this)(p[1])) * 31 + (*this)(p[2]);
    }
  };
  std::unordered_map<Value, std::uint32_t, Hash> number_;
  std::vector<Value> values_;
};

}  // namespace cnrg
