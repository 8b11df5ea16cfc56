from chutecalc.core cimport flight, floats, guide_surface, joint, placement, records, solution_rows, state

cdef double MAX_FALL

cdef void solve_fall(records.ChuteState chute, records.Segment segment) noexcept nogil
cdef bint lands_on_next(records.Segment segment, records.Segment next_segment) noexcept nogil
cdef void fall_to_level(records.ChuteState chute, records.Segment segment) noexcept nogil
cdef void set_flight_end(records.ChuteState chute, double time) noexcept nogil
cdef void fall_onto_next(records.ChuteState chute, records.Segment segment, records.Segment next_segment, guide_surface.Guide guide) noexcept nogil
