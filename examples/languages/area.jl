# SPDX-License-Identifier: MIT
# touchstone.h from Julia: julia area.jl. Untested here: Debian 12 has no Julia.
function touchstone(quantity, inputs, digits)
    value, why = Ref{Ptr{Cvoid}}(C_NULL), zeros(UInt8, 256)
    code = @ccall "libtouchstone.so.1".touchstone_eval(quantity::Cstring, inputs::Cstring, digits::Clong, "nearest"::Cstring,
                                                       value::Ref{Ptr{Cvoid}}, why::Ptr{UInt8}, 256::Csize_t)::Cint
    code == 0 || error(unsafe_string(pointer(why)))
    text = unsafe_string(@ccall "libtouchstone.so.1".touchstone_decimal(value[]::Ptr{Cvoid})::Cstring)
    @ccall "libtouchstone.so.1".touchstone_free(value[]::Ptr{Cvoid})::Cvoid
    return text
end

println(touchstone("contact.area", "n=3 load=1/8 G=5/2", 30))
