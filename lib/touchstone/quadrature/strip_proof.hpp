// SPDX-License-Identifier: MIT
/// \file
/// The proof of a panel: how high a strip it is analytic on, with which exponents, and bounds of it there (tanh_sinh.md, sections 2 and 3).
#pragma once

#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/tanh_sinh.hpp"

namespace touchstone::quadrature::detail {

/// One end of the strip: what holds for |Re t| >= edge, 0 <= Im t <= d.
struct End {
    double edge = 0;
    Ball depth;         // A: |distance| <= exp(-A)/(1 - exp(-A))
    Exponent here, far; // F = c pi cosh t here^... : exponents at this end and at the other
    Ball bound;         // |c|: finite where proved

    bool is_proved() const { return bound.is_finite(); }
    bool is_integrable() const { return is_proved() && Exponent(0) < here; }
};

class StripProof {
public:
    StripProof(const PanelFunction<ComplexBall>& f, long budget, Transformation transformation = Transformation::tanh_sinh)
        : f_(f)
        , budget_(budget)
        , transformation_(transformation)
    {
    }

    /// Fill alpha, beta, strip, bounds, strip_integral, scale. False if nothing was proved.
    /// `cost_of_nodes`: against that of endpoint numbers; the proof is to cost no more than the nodes that it saves.
    bool run(Panel& panel, double bits, double cost_of_nodes = 1);

    std::string reason;
    double failure_u = 0.5; // fraction of the panel where the proof stopped; negative: at an end
    long pieces = 0;
    End left, right; // the ends at the chosen height

private:
    EndpointNumber<ComplexBall> value(const StripPiece& p)
    {
        ++pieces;
        return f_(p);
    }
    StripPiece piece(Side side, double x1, double x2, double y1, double y2) const
    {
        return StripPiece::at(side, x1, x2, y1, y2, transformation_);
    }
    StripPiece endless(Side side, double x1, double d) const { return piece(side, x1, std::numeric_limits<double>::infinity(), 0, d); }
    End end(Side side, double d);
    End end_at(Side side, double depth, double d);
    bool layer(Side side, double x1, double x2, double y1, double y2, double smallest);
    Ball line(Side side, double edge, double d);
    Ball piece_bound(Side side, double x1, double x2, double d);
    Ball tail(const End& e, double d) const;
    Ball strip_integral(double d, const End& left, const End& right);
    Ball strip_integral_by_pieces(double d, const End& left, const End& right);
    void fail(const StripPiece& piece, const char* what);

    const PanelFunction<ComplexBall>& f_;
    long budget_;
    Transformation transformation_;
    bool is_constant_ = false;
    Side failed_side_ = Side::left;
    double failed_from_ = 0, failed_to_ = 0; // Re t, where the last strip was not proved
    double pieces_per_bit_ = 1; // as many values of f cost what one bit of the tolerance costs at the nodes
    EndpointNumber<ComplexBall> constant_;
};

} // namespace touchstone::quadrature::detail
