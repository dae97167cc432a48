#include "fuzz/targets.H"
#include "primitives/error.H"

extern "C" int LLVMFuzzerTestOneInput(const char* data, const std::size_t size)
{
    try
    {
        sph::readAnyState({data, size});
    }
    catch (const sph::Error&)
    {}
    return 0;
}
