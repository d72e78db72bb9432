# SPDX-License-Identifier: MIT
"""The equation and the unit of each quantity, as the paper has them, and what it is, in a line: what a table's header must say of the
numbers below it."""

SAID = {
    "westergaard.half_width": ("2.5", "lambda", "half-width a of a contact segment under a sine wave"),
    "westergaard.pressure": ("2.2, 2.4", "p*", "contact pressure at distance x from the peak; 0 outside the contact"),
    "westergaard.exceedance": ("2.11-2.18", "1", "share Q of the wavelength on which the pressure exceeds p"),
    "westergaard.density": ("2.15-2.20", "1/p*", "probability density q of the contact pressure, as q p*; 0 outside the support"),
    "hertz.half_width": ("2.7", "lambda", "half-width of the contact in the Hertzian limit"),
    "hertz.pressure": ("2.6", "p*", "contact pressure in the Hertzian limit; 0 outside the contact"),
    "westergaard.gap": ("from 2.4", "g", "gap between the surfaces at distance x from the peak; 0 in the contact"),
    "westergaard.mean_gap": ("from 2.4", "g", "mean gap over a wavelength; 0 from full contact on"),
    "westergaard.energy": ("from 2.4", "g p*",
                           "elastic energy per unit nominal area beyond that of uniform pressure; 1/4 from full contact on"),
    "hertz.gap": ("from 2.6", "g", "gap beside the contact in the Hertzian limit; 0 in the contact"),
    "weierstrass.profile": ("3.1", "g0", "height z of the Weierstrass profile, all scales summed, at x in lambda0"),
    "weierstrass.bound": ("3.4", "g0", "bound zhat of the height of the profile"),
    "peaks.f": ("5.4, 5.5", "1", "peak pressure p_n^max/p*_n over a region of mean pressure x p*_n"),
    "peaks.iterate": ("5.6", "1", "x_n = p_n^max/p*_{n+1} from x_{-1} = load"),
    "peaks.fixed_point": ("5.8, 5.9", "1", "x_P, the limit of the iteration (5.6)"),
    "contact.area": ("6.7", "lambda0", "total contact area at scale n in one wavelength of the largest scale"),
    "contact.exceedance": ("6.1", "1", "share of lambda_0 on which the pressure at scale n exceeds p (in p*_0)"),
    "contact.density": ("6.1", "1/p*_0", "density q_n of the pressure at scale n, at p (in p*_0)"),
    "segments.density": ("9.3", "1", "density of segments by half-width a (in lambda_n), N^_n lambda_n"),
    "segments.count": ("8.1", "1", "expected number of contact segments at scale n in one wavelength, A_{n-1}/lambda_n"),
    "archard.K": ("7.13", "1", "K_n of Archard's area law, by the recursion (7.13); (7.17) as printed is another number"),
    "archard.K_inf": ("7.20", "1", "limit of K_n as n grows"),
    "archard.delta": ("7.16", "1", "exponent of the load in the area law, 1 - 2^-(n+1)"),
    "archard.alpha": ("7.16", "1", "exponent of gamma in the area law, (1 - D)(n - 1 + 2^-n)"),
    "archard.area": ("7.18", "lambda0",
                     "contact area in the Hertzian approximation, K_n G^-(n-1+2^-n) load^(1-2^-(n+1)), with K_n of (7.13)"),
    "archard.segments": ("8.2", "1", "expected number of contact segments in the Hertzian approximation"),
    "archard.segments_limit": ("8.3", "1", "limiting form of the number of segments at large n"),
    "segments.max_half_width": ("9.4", "lambda_n",
                                "largest half-width of a segment at scale n (the paper's (9.4) gives its limit without the square "
                                "root)"),
    "limit.area_constant": ("7.21", "1",
                            "C(G) = lim A_n G^n/(lambda0 load) of the recursion (6.7), for any load; (7.21) takes K_inf G for it"),
    "limit.area_ratio": ("7.21", "1", "C(G)/(K_inf G): by what (7.21) and (8.3) are to be multiplied at large n"),
    "limit.scale": ("7.21", "1", "least n with |A_m/(C(G) G^-m load) - 1| <= tolerance for every m >= n: from where on the limit holds"),
    "limit.gap": ("7.21", "1",
                  "second eigenvalue of one wave's operator over its first, 1/G: by what, in general, the distance from"
                  " the limit shrinks at each scale"),
    "limit.exceedance": ("6.1", "1",
                         "share of the contact area where p_n > p, p in p*_n, as n tends to infinity; at p = x G, of the "
                         "contacts of the next scale of load ratio above x"),
    "limit.force": ("6.1", "1", "share of the force that is carried where p_n > p, p in p*_n, as n tends to infinity"),
    "limit.density": ("6.1", "1",
                      "density of p_n/p*_n in the contact area at p, as n tends to infinity: minus the slope of "
                      "limit.exceedance"),
    "limit.segments": ("9.2", "1",
                       "share of the contact segments whose half-width is above a, a in lambda_n, as n tends to infinity; at"
                       " a = 1/2, of full contacts"),
    "limit.distance": ("6.1", "1",
                       "share of the contact area at scale n where p_n > p, p in p*_n, less the share that this tends to "
                       "(limit.exceedance)"),
}
