"""The formulas: pure functions of arrays in SI and radians, one for each cited equation.

They know nothing of specs, solvers or tables. ``Paper Eq n`` means equation n of P. J. Munzenberger,
A. W. Roberts and C. A. Wheeler, *Lumped mass continuum modelling of chamfered transfer chutes*; ``Roberts (2003)``
means A. W. Roberts, *Chute performance and design for rapid flow conditions*, Chemical Engineering and Technology.
"""
