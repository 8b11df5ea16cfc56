"""The formulas: pure functions of arrays in SI and radians, one for each cited equation.

They know nothing of specs, solvers or tables. Sources:

* ``Paper Eq n`` is equation n of P. J. Munzenberger, A. W. Roberts and C. A. Wheeler, *Lumped Mass Continuum Modelling
  of Chamfered Transfer Chutes*.
* ``Roberts (2003)`` is A. W. Roberts, *Chute Performance and Design for Rapid Flow Conditions*, Chemical Engineering
  and Technology, Wiley-VCH, Weinheim, 2003.
"""
